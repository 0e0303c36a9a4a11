// The modal model of beams and of given modes: projections, damping, derivatives.
#include "graze/structure/modal_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "graze/scene/parameter.hpp"
#include "graze/structure/detail/cantilever.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

// The strip of Wagg (2004).
constexpr double kLength = 0.3, kModulus = 205e9, kSecond = 24.4e-14, kDensity = 8500.0,
                 kArea = 12.4e-6;
constexpr double kB[] = {1.8751040687119611664, 4.6940911329741745764, 7.8547574382376125649,
                         10.995540734875466991};

TEST(ModalModel, FrequenciesOfTheBeam) {
  const ModalModel model = modal_model(support::shipped_scene("02_wagg_momentum"));
  const double unit = std::sqrt(kModulus * kSecond / (kDensity * kArea)) / (kLength * kLength);
  for (int j = 0; j < 4; ++j) EXPECT_NEAR(model.omega[j] / (kB[j] * kB[j] * unit), 1.0, 1e-15);
  // The scene's own words: 4.28, 26.8, 75.2 and 147 Hz.
  EXPECT_NEAR(model.omega[0] / 6.283185307, 4.28, 0.005);
  EXPECT_NEAR(model.omega[3] / 6.283185307, 147.0, 0.5);
}

TEST(ModalModel, ViscousDampingIsTheSameDecayForEveryMode) {
  const ModalModel model = modal_model(support::shipped_scene("02_wagg_momentum"));
  for (int j = 0; j < 4; ++j)
    EXPECT_NEAR(model.delta[j] / (0.005 / (2.0 * kDensity * kArea)), 1.0, 1e-15);
}

TEST(ModalModel, RatiosAndRayleighDamping) {
  const ModalModel ratios = modal_model(support::shipped_scene(
      "05_wagg_one_mode", {"beam.modes=2", "damping={ ratios = [0.01, 0.04] }"}));
  EXPECT_DOUBLE_EQ(ratios.delta[0], 0.01 * ratios.omega[0]);
  EXPECT_DOUBLE_EQ(ratios.delta[1], 0.04 * ratios.omega[1]);
  const ModalModel rayleigh = modal_model(support::reference_scene("H"));
  for (int j = 0; j < 4; ++j)
    EXPECT_DOUBLE_EQ(rayleigh.delta[j], 0.5 * (0.5 + 1e-5 * rayleigh.omega[j] * rayleigh.omega[j]));
}

TEST(ModalModel, TipShapeIsThatOfTheMass) {
  const ModalModel model = modal_model(support::shipped_scene("02_wagg_momentum"));
  const double tip = 2.0 / std::sqrt(kDensity * kArea * kLength);
  for (int j = 0; j < 4; ++j) EXPECT_NEAR(model.shapes[0][j] / tip, j % 2 == 0 ? 1.0 : -1.0, 1e-14);
}

TEST(ModalModel, GalerkinParticipationIsTheIntegral) {
  // integral of rho A phi_j dx by Simpson's rule on 2000 pieces: error below 1e-10 relative.
  const ModalModel model = modal_model(support::shipped_scene("02_wagg_momentum"));
  for (int j = 1; j <= 4; ++j) {
    double sum = 0.0;
    constexpr int kPieces = 2000;
    for (int i = 0; i <= kPieces; ++i) {
      const double weight = i == 0 || i == kPieces ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
      sum += weight * cantilever_shape(j, static_cast<double>(i) / kPieces);
    }
    const double integral = sum / (3.0 * kPieces) * std::sqrt(kDensity * kArea * kLength);
    EXPECT_NEAR(model.participations[0][j - 1] / integral, 1.0, 1e-9) << j;
  }
}

TEST(ModalModel, DistributedForceIsAnAccelerationOverTheMassPerLength) {
  const ModalModel base = modal_model(support::shipped_scene("02_wagg_momentum"));
  const ModalModel force =
      modal_model(support::shipped_scene("02_wagg_momentum", {"forcing.kind=\"distributed\""}));
  EXPECT_LE((force.participations[0] * (kDensity * kArea) - base.participations[0]).norm(),
            1e-15 * base.participations[0].norm());
}

TEST(ModalModel, CollocationParticipationReproducesTheUniformLoadAtThePoints) {
  for (const int modes : {1, 2, 4, 10, 40}) {
    const ModalModel model = modal_model(
        support::shipped_scene("01_wagg_2004", {"beam.modes=" + std::to_string(modes)}));
    // Phi G = 1
    const Vector load = model.collocation * model.participations[0];
    EXPECT_LE((load - Vector::Ones(modes)).cwiseAbs().maxCoeff(), 1e-13) << modes;
  }
}

TEST(ModalModel, CollocationMatrixHoldsTheShapesAtEvenPoints) {
  const ModalModel model = modal_model(support::shipped_scene("01_wagg_2004"));
  const double scale = 1.0 / std::sqrt(kDensity * kArea * kLength);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      EXPECT_NEAR(model.collocation(i, j), scale * cantilever_shape(j + 1, (i + 1) / 4.0),
                  1e-14 * scale);
}

// Gravity is the uniform acceleration that base forcing is.
TEST(ModalModel, InertiaOfTheBeamIsItsBaseParticipation) {
  for (const char* name : {"01_wagg_2004", "02_wagg_momentum"}) {
    const ModalModel base = modal_model(support::shipped_scene(name));
    const ModalModel both = modal_model(
        support::shipped_scene(name, {"gravity.acceleration=9.81", "forcing.kind=distributed"}));
    EXPECT_EQ(base.inertia.size(), 0);
    EXPECT_EQ(both.inertia, base.participations[0]) << name;
    EXPECT_LE((both.participations[0] * (kDensity * kArea) - both.inertia).norm(),
              1e-15 * both.inertia.norm());
  }
}

// Per unit of acceleration the tip of a cantilever sinks by rho A L^4/(8 EI) under its own weight.
TEST(ModalModel, WeightBendsTheBeamAsStaticsSays) {
  const Scene scene = parse_scene(
      "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\n"
      "density = 8500.0\narea = 12.4e-6\nmodes = 40\n[gravity]\nacceleration = 2\n"
      "[[stop]]\nposition = 0.3\ngap = 1\nrestitution = 0\n",
      "weight.toml");
  const ModalModel model = modal_model(scene);
  EXPECT_TRUE(model.participations.empty());
  const Vector q = model.inertia.cwiseQuotient(model.omega.cwiseAbs2());
  const double sag = kDensity * kArea * std::pow(kLength, 4) / (8.0 * kModulus * kSecond);
  // The terms are +-32/b_j^5 of the sum: what lies beyond 40 modes is less than the next, 9.6e-10.
  EXPECT_NEAR(model.shapes[0].dot(q) / sag, 1.0, 1e-9);
}

TEST(ModalModel, InertiaOfGivenModesIsTheirs) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [0.0, 6.0]\ninertia = [1.0, -0.5]\n[gravity]\nacceleration = 3\n",
      "given.toml");
  EXPECT_EQ(modal_model(scene).inertia, (Vector(2) << 1.0, -0.5).finished());
}

TEST(ModalModel, OnlyWhatIsCalledForIsComputed) {
  EXPECT_EQ(modal_model(support::shipped_scene("02_wagg_momentum")).collocation.size(), 0);
  EXPECT_FALSE(uses_collocation(support::shipped_scene("02_wagg_momentum")));
  EXPECT_TRUE(uses_collocation(support::shipped_scene("01_wagg_2004")));
  EXPECT_TRUE(uses_collocation(support::reference_scene("C")));
  const std::string beam =
      "[beam]\nlength = 1\nyoungs_modulus = 1\nsecond_moment = 1\ndensity = 1\narea = 1\n"
      "modes = 3\ndiscretisation = \"collocation\"\n";
  EXPECT_FALSE(uses_collocation(parse_scene(beam, "beam.toml")));
  EXPECT_TRUE(uses_collocation(parse_scene(beam, "beam.toml", {"gravity.acceleration=1"})));
  EXPECT_FALSE(uses_collocation(
      parse_scene(beam, "beam.toml", {"gravity.acceleration=1", "beam.discretisation=galerkin"})));
}

// All numbers of a model in one vector.
Vector numbers(const ModalModel& model) {
  std::vector<double> list;
  const auto add = [&](const auto& v) {
    for (Eigen::Index i = 0; i < v.size(); ++i) list.push_back(v.reshaped()[i]);
  };
  add(model.omega);
  add(model.delta);
  for (const Vector& load : model.participations) add(load);
  add(model.inertia);
  for (const Vector& shape : model.shapes) add(shape);
  add(model.collocation);
  return Eigen::Map<const Vector>(list.data(), static_cast<Eigen::Index>(list.size()));
}

// Every parameter that can be moved both ways; returns how many.
int expect_derivatives(const Scene& scene) {
  int moved = 0;
  for (const std::string& name : parameter_names(scene)) {
    const double value = *find_parameter(scene, name);
    const double h = 1e-4 * (value == 0.0 ? 1.0 : std::abs(value));
    const auto at = [&](double p) { return numbers(modal_model(with_parameter(scene, name, p))); };
    Vector difference;
    try {
      difference = support::central_difference(at, value, h);
    } catch (const InputError&) {
      continue;  // at the edge of its range
    }
    ++moved;
    const ModalModel model = modal_model(scene);
    const Vector rate = numbers(modal_tangent(scene, model, parameter_direction(scene, name)));
    const Vector here = numbers(model);
    EXPECT_EQ(rate.size(), difference.size());
    for (Eigen::Index i = 0; i < std::min(rate.size(), difference.size()); ++i)
      EXPECT_NEAR(rate[i], difference[i],
                  1e-9 * std::abs(difference[i]) + 1e-14 * std::abs(here[i]) / h + 1e-12)
          << name << ", number " << i;
  }
  return moved;
}

TEST(ModalTangent, OfBeamsUnderBothProjections) {
  EXPECT_EQ(expect_derivatives(support::shipped_scene("02_wagg_momentum", {"stop.position=0.27"})),
            12);
  EXPECT_EQ(expect_derivatives(support::shipped_scene(
                "01_wagg_2004", {"stop.impulse=\"momentum\"", "stop.position=0.27"})),
            12);
  EXPECT_EQ(expect_derivatives(support::shipped_scene(
                "01_wagg_2004", {"stop.impulse=\"momentum\"", "stop.position=0.27",
                                 "beam.points=[0.07, 0.14, 0.22, 0.29]"})),
            16);
}

TEST(ModalTangent, OfEveryKindOfDampingAndForcing) {
  EXPECT_EQ(expect_derivatives(support::reference_scene("H", {"stop.position=0.27"})), 13);
  EXPECT_EQ(expect_derivatives(support::reference_scene(
                "orbits/beam_n2_40", {"damping={ ratios = [0.01, 0.03] }", "stop.position=0.2"})),
            13);
  EXPECT_EQ(expect_derivatives(support::reference_scene(
                "orbits/beam_n2_40", {"stop.position=0.2", "forcing.kind=\"distributed\"",
                                      "beam.discretisation=\"collocation\""})),
            12);
}

TEST(ModalTangent, OfGravityUnderBothProjections) {
  // Twelve numbers of a beam and the acceleration.
  for (const std::string kind : {"base", "distributed"})
    for (const std::string projection : {"galerkin", "collocation"})
      EXPECT_EQ(
          expect_derivatives(support::shipped_scene(
              "02_wagg_momentum", {"stop.position=0.27", "gravity.acceleration=-9.81",
                                   "forcing.kind=" + kind, "beam.discretisation=" + projection})),
          13);
  // Without damping and forcing: five of the beam, the acceleration, three of the stop.
  EXPECT_EQ(expect_derivatives(parse_scene(
                "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\n"
                "density = 8500.0\narea = 12.4e-6\nmodes = 3\ndiscretisation = \"collocation\"\n"
                "[gravity]\nacceleration = 9.81\n"
                "[[stop]]\nposition = 0.2\ngap = 0.1\nrestitution = 0.8\n",
                "gravity.toml")),
            9);
}

// Six of the string, three of the damping, two of the forcing, three of the stop: frequencies that
// are given move with nothing else, the shapes with length and mass.
TEST(ModalTangent, OfAStringWithMeasuredFrequencies) {
  EXPECT_EQ(expect_derivatives(parse_scene(
                "[string]\nlength = 0.863\nfrequencies = [615.6, 1234.4, 1851.3]\n"
                "mass_per_length = 0.0067\nmodes = 3\n[damping]\nratios = [3e-4, 1e-4, 9e-4]\n"
                "[forcing]\namplitude = 1e-4\nfrequency = 600.0\n"
                "[[stop]]\nposition = 0.2\ngap = 1e-3\nrestitution = 0.9\n",
                "string.toml")),
            14);
}

TEST(ModalTangent, OfSeveralStops) {
  EXPECT_EQ(expect_derivatives(support::shipped_scene(
                "02_wagg_momentum",
                {"stop.position=0.27", "stop.2={position=0.1, gap=1e-3, restitution=[0.8, 0.1]}"})),
            16);
}

TEST(ModalTangent, OfGivenModes) {
  EXPECT_EQ(expect_derivatives(support::reference_scene("orbits/three_modes_2_1")), 17);
  EXPECT_EQ(expect_derivatives(
                parse_scene("[modal]\nfrequencies = [1.0, 6.0]\ninertia = [1.0, 0.5]\n"
                            "[damping]\nrayleigh = { mass = 0.1, stiffness = 0.01 }\n"
                            "[forcing]\nkind = \"base\"\namplitude = 1.0\nfrequency = 2.0\n"
                            "[[stop]]\nshape = [1.0, -1.0]\ngap = 0.1\nrestitution = 0.8\n",
                            "given.toml")),
            13);
  EXPECT_EQ(expect_derivatives(parse_scene("[modal]\nfrequencies = [1.0, 6.0]\n"
                                           "inertia = [1.0, 0.5]\n[gravity]\nacceleration = 2.0\n",
                                           "gravity.toml")),
            5);
}

}  // namespace
}  // namespace graze
