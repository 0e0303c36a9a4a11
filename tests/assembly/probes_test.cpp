// Probes against the static beam: Euler and Bernoulli's closed forms for a force at the tip.
#include "graze/assembly/probes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/scene/reader.hpp"
#include "graze/structure/modal_model.hpp"

namespace graze {
namespace {

constexpr double kLength = 0.3, kModulus = 205e9, kMoment = 24.4e-14, kDensity = 8500.0,
                 kArea = 12.4e-6, kThickness = 4.86e-4;

Scene beam_scene(const std::string& more) {
  return parse_scene(
      "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\ndensity = 8500\n"
      "area = 12.4e-6\nmodes = 300\nthickness = 4.86e-4\n"
      "[[stop]]\nposition = 0.3\ngap = 0.01\nrestitution = 1\n" +
          more,
      "s");
}

std::string probe(double position, const std::string& quantity) {
  return "[[probe]]\nposition = " + std::to_string(position) + "\nquantity = \"" + quantity +
         "\"\n";
}

// At rest under the force P at the tip: q_j = phi_j(L) P/w_j^2.
State under_tip_force(const Scene& scene, double force) {
  const ModalModel model = modal_model(scene);
  const Vector q = force * model.shapes[0].array() / model.omega.array().square();
  return {q, Vector::Zero(q.size())};
}

TEST(Probes, ShowTheDeflectionOfAForceAtTheTip) {
  const double force = 1e-3;
  for (const double x : {0.1, 0.2, 0.3}) {
    const Scene scene = beam_scene(probe(x, "displacement") + probe(x, "deflection"));
    const State state = under_tip_force(scene, force);
    const double expected = force * x * x * (3.0 * kLength - x) / (6.0 * kModulus * kMoment);
    for (const ProbeRow& row : probe_rows(scene)) {
      EXPECT_NEAR(row.value(state) / expected, 1.0, 1e-7) << x;
      EXPECT_FALSE(row.of_velocity);
      EXPECT_EQ(row.angle, 0.0);
    }
  }
}

// Bent towards +u the fibre on that side is pressed: M = P (L - x), strain = -h/2 M/(E I). The sum
// over the modes falls with 1/b^2 and changes its sign.
TEST(Probes, ShowTheStrainOfAForceAtTheTip) {
  const double force = 1e-3;
  for (const double x : {0.0, 0.1, 0.25}) {
    const Scene scene = beam_scene(probe(x, "strain"));
    const double expected = -0.5 * kThickness * force * (kLength - x) / (kModulus * kMoment);
    EXPECT_NEAR(probe_rows(scene)[0].value(under_tip_force(scene, force)) / expected, 1.0, 1e-4)
        << x;
  }
}

// u' at the tip is phi(L).q' with phi_j(L) = 2 (-1)^(j+1)/sqrt(rho A L).
// A wedge under a force at its tip, height h(x) = h_L + (h_0 - h_L)(1 - x/L): M = P (L - x), strain
// -h/2 M/(E b h^3/12) = -6 P (L - x)/(E b h^2), of which h is that of the section at the probe.
TEST(Probes, ShowTheStrainOfATaper) {
  const double force = 1e-3;
  for (const double x : {0.0, 0.1, 0.2}) {
    const Scene scene = parse_scene(
        "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\ndensity = 8500\nmodes = 60\n"
        "section = { shape = \"rectangle\", width = 0.025, height = [1e-3, 5e-4] }\n"
        "[[stop]]\nposition = 0.3\ngap = 0.01\nrestitution = 1\n" +
            probe(x, "strain") + probe(x, "displacement"),
        "taper");
    const double height = 1e-3 - 5e-4 * x / kLength;
    const double expected = -6.0 * force * (kLength - x) / (kModulus * 0.025 * height * height);
    const std::vector<ProbeRow> rows = probe_rows(scene);
    EXPECT_NEAR(rows[0].value(under_tip_force(scene, force)) / expected, 1.0, 3e-3) << x;
  }
}

// A bar that is drawn at its end: u = F x/(E A), strain F/(E A); a string pushed in its middle
// bends into two straight lines, u = F L/(4 T) there.
TEST(Probes, OfABarAndOfAString) {
  const Scene bar = parse_scene(
      "[bar]\nlength = 2\nyoungs_modulus = 2e11\ndensity = 7800\narea = 1e-4\nmodes = 400\n"
      "[[stop]]\nposition = 2\ngap = 1\nrestitution = 1\n" +
          probe(0.5, "displacement") + probe(0.5, "strain"),
      "bar");
  const std::vector<ProbeRow> rows = probe_rows(bar);
  const State drawn = under_tip_force(bar, 1000.0);
  EXPECT_NEAR(rows[0].value(drawn) / (1000.0 * 0.5 / 2e7), 1.0, 1e-4);
  EXPECT_NEAR(rows[1].value(drawn) / (1000.0 / 2e7), 1.0, 3e-3);
  const Scene string = parse_scene(
      "[string]\nlength = 2\ntension = 80\nmass_per_length = 0.01\nmodes = 2000\n"
      "[[stop]]\nposition = 1\ngap = 1\nrestitution = 1\n" +
          probe(1.0, "displacement"),
      "string");
  // The sum misses about 2/(pi^2 N) of it.
  EXPECT_NEAR(probe_rows(string)[0].value(under_tip_force(string, 3.0)) / (3.0 * 2.0 / 320.0), 1.0,
              5e-4);
}

TEST(Probes, ShowTheVelocityOfAPoint) {
  const Scene scene = beam_scene(probe(0.3, "velocity"));
  const std::vector<ProbeRow> rows = probe_rows(scene);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_TRUE(rows[0].of_velocity);
  State state{Vector::Constant(300, 7.0), Vector::Zero(300)};
  EXPECT_EQ(rows[0].value(state), 0.0);
  state.qdot[0] = 0.25;
  state.qdot[1] = 0.125;
  EXPECT_NEAR(rows[0].value(state), 0.25 / std::sqrt(kDensity * kArea * kLength), 1e-12);
}

TEST(Probes, OfModesAreTheirShapes) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1, 2]\n[[probe]]\nshape = [1, -2]\n"
      "[[probe]]\nshape = [0.5, 0]\nquantity = \"velocity\"\n",
      "s");
  const std::vector<ProbeRow> rows = probe_rows(scene);
  State state{Vector(2), Vector(2)};
  state.q << 3.0, 1.0;
  state.qdot << 4.0, 9.0;
  EXPECT_EQ(rows[0].value(state), 1.0);
  EXPECT_EQ(rows[1].value(state), 2.0);
}

// A point at x goes (radius + x) along its arc per unit of the angle; what is told from the line
// that turns with the hub does not.
TEST(Probes, KnowHowTheyGoWithTheHub) {
  const Scene scene =
      beam_scene("[hub]\nradius = 0.02\ninertia = 1e-3\n" + probe(0.25, "displacement") +
                 probe(0.25, "velocity") + probe(0.25, "deflection") + probe(0.25, "strain"));
  const std::vector<ProbeRow> rows = probe_rows(scene);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_DOUBLE_EQ(rows[0].angle, 0.27);
  EXPECT_DOUBLE_EQ(rows[1].angle, 0.27);
  EXPECT_EQ(rows[2].angle, 0.0);
  EXPECT_EQ(rows[3].angle, 0.0);
  EXPECT_EQ(rows[0].row, rows[2].row);
  EXPECT_EQ(rows[0].row, rows[1].row);
}

TEST(Probes, HaveTheUnitOfTheirQuantity) {
  EXPECT_EQ(probe_unit(ProbeQuantity::kDisplacement), "m");
  EXPECT_EQ(probe_unit(ProbeQuantity::kVelocity), "m/s");
  EXPECT_EQ(probe_unit(ProbeQuantity::kDeflection), "m");
  EXPECT_EQ(probe_unit(ProbeQuantity::kStrain), "");
}

}  // namespace
}  // namespace graze
