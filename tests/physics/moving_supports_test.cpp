// Supports of matrices that move: what is held moves by itself and drives what is free by
// stiffness, damping and mass.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <fstream>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/system_family.hpp"
#include "graze/base/errors.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "support/differences.hpp"
#include "support/scratch_folder.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::RecordedRun;

// Elements with a consistent mass in a row, a dashpot in one of them; both ends are held.
const Matrix kElementMass{
    {2.0, 1.0, 0.0, 0.0}, {1.0, 5.0, 1.5, 0.0}, {0.0, 1.5, 4.0, 0.5}, {0.0, 0.0, 0.5, 1.0}};
const Matrix kElementStiffness{{90.0, -90.0, 0.0, 0.0},
                               {-90.0, 160.0, -70.0, 0.0},
                               {0.0, -70.0, 120.0, -50.0},
                               {0.0, 0.0, -50.0, 50.0}};
const Matrix kElementDamping{
    {0.9, -0.9, 0.0, 0.0}, {-0.9, 1.1, -0.2, 0.0}, {0.0, -0.2, 0.6, -0.4}, {0.0, 0.0, -0.4, 0.4}};
constexpr double kOfEnds = 3.1;

std::string rows_of(const Matrix& matrix) {
  std::string text;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    text += i > 0 ? ", [" : "[";
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      text += fmt::format("{}{}", j > 0 ? ", " : "", matrix(i, j));
    text += "]";
  }
  return "[" + text + "]";
}

std::string in_scene() {
  return fmt::format("[matrices]\nmass = {}\nstiffness = {}\ndamping = {}\n", rows_of(kElementMass),
                     rows_of(kElementStiffness), rows_of(kElementDamping)) +
         "constraints = [\"1\", \"4\"]\n";
}

std::string in_files(const std::filesystem::path& folder) {
  const auto write = [&](const char* name, const Matrix& matrix) {
    std::ofstream file(folder / name);
    file << "%%MatrixMarket matrix coordinate real general\n4 4 16\n";
    for (Eigen::Index j = 0; j < 4; ++j)
      for (Eigen::Index i = 0; i < 4; ++i)
        file << fmt::format("{} {} {}\n", i + 1, j + 1, matrix(i, j));
  };
  write("m.mtx", kElementMass);
  write("k.mtx", kElementStiffness);
  write("c.mtx", kElementDamping);
  return "[matrices]\nmass = \"m.mtx\"\nstiffness = \"k.mtx\"\ndamping = \"c.mtx\"\nmodes = 2\n"
         "constraints = [\"1\", \"4\"]\n";
}

// One end moves by 0.1 cos(w t + 0.3), the other by 0.04 cos(2 w t - 1).
const std::string kEndsMove = fmt::format(
    "[[forcing]]\nkind = \"support\"\nnode = \"1\"\namplitude = 0.1\nphase = 0.3\nfrequency = {}\n"
    "[[forcing]]\nkind = \"support\"\nnode = \"4\"\namplitude = 0.04\nphase = -1.0\norder = 2\n",
    kOfEnds);

// Amplitudes of the free ones as the modes have it, and by the whole matrices.
void expect_response(const Scene& scene) {
  const System system = assemble(scene);
  const Matrix& shapes = scene.discrete()->solved->modes.shapes;
  const auto n = system.omega.size();
  double largest = 0.0;
  for (const Harmonic& harmonic : system.forcing()->harmonics) {
    const double w = harmonic.order * kOfEnds;
    Eigen::MatrixXcd modal = Eigen::MatrixXcd::Zero(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
      modal(j, j) = Complex(std::pow(system.omega[j], 2) - w * w, 2.0 * w * system.delta()[j]);
    if (system.coupling()) modal += Complex(0.0, w) * *system.coupling();
    // cos(k (theta)) with theta counted from the phase of the first load.
    const double behind = harmonic.order * system.forcing()->phase;
    const ComplexVector force =
        (harmonic.cosine.cast<Complex>() - Complex(0.0, 1.0) * harmonic.sine.cast<Complex>()) *
        std::polar(1.0, behind);
    const ComplexVector moved = shapes * modal.lu().solve(force);
    const Eigen::MatrixXcd whole = (kElementStiffness - w * w * kElementMass).cast<Complex>() +
                                   Complex(0.0, w) * kElementDamping.cast<Complex>();
    const ComplexVector ends = harmonic.order == 1.0
                                   ? ComplexVector{{std::polar(0.1, 0.3), Complex(0.0)}}
                                   : ComplexVector{{Complex(0.0), std::polar(0.04, -1.0)}};
    Eigen::MatrixXcd held(2, 2);
    held << whole(1, 0), whole(1, 3), whole(2, 0), whole(2, 3);
    const ComplexVector expected = -whole.block(1, 1, 2, 2).lu().solve(held * ends);
    EXPECT_LE((moved - expected).norm(), 1e-13 * expected.norm()) << harmonic.order;
    largest = std::max(largest, expected.norm());
  }
  EXPECT_EQ(system.forcing()->harmonics.size(), 2u);
  EXPECT_GT(largest, 0.05);
}

TEST(MovingSupports, OfMatricesDriveByStiffnessDampingAndMass) {
  const ScratchFolder folder;
  expect_response(parse_scene(in_scene() + kEndsMove, "scene"));
  expect_response(parse_scene(in_files(folder / "") + kEndsMove, (folder / "scene.toml").string()));
}

// C = 0.03 M + 0.01 K, as Rayleigh's and as a matrix.
TEST(MovingSupports, DriveByRayleighsDampingToo) {
  const auto scene = [](const Matrix& damping, const std::string& rayleigh) {
    return parse_scene(
        fmt::format("[matrices]\nmass = {}\nstiffness = {}\n{}constraints = [\"1\", \"4\"]\n",
                    rows_of(kElementMass), rows_of(kElementStiffness),
                    damping.size() > 0 ? "damping = " + rows_of(damping) + "\n" : "") +
            rayleigh + kEndsMove,
        "scene");
  };
  const System one = assemble(scene(0.03 * kElementMass + 0.01 * kElementStiffness, ""));
  const System other =
      assemble(scene({}, "[damping]\nrayleigh = { mass = 0.03, stiffness = 0.01 }\n"));
  ASSERT_EQ(one.forcing()->harmonics.size(), other.forcing()->harmonics.size());
  for (std::size_t k = 0; k < one.forcing()->harmonics.size(); ++k) {
    const Harmonic &a = one.forcing()->harmonics[k], &b = other.forcing()->harmonics[k];
    EXPECT_LE((a.cosine - b.cosine).norm() + (a.sine - b.sine).norm(), 1e-13 * a.cosine.norm());
  }
}

void expect_derivatives(const Scene& scene, const std::vector<std::string>& names) {
  const auto forces = [](const System& system) {
    std::vector<double> list;
    for (const Harmonic& harmonic : system.forcing()->harmonics)
      for (const Vector* part : {&harmonic.cosine, &harmonic.sine})
        list.insert(list.end(), part->begin(), part->end());
    return Vector(Eigen::Map<Vector>(list.data(), static_cast<Eigen::Index>(list.size())));
  };
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const SystemFamily family(scene, name);
    const double value = family.value(), h = 1e-4 * std::abs(value);
    const Vector tangent = forces(*family.tangent_at(value));
    const Vector difference =
        support::central_difference([&](double p) { return forces(*family.at(p)); }, value, h);
    EXPECT_GT(difference.norm(), 0.0);
    EXPECT_LE((tangent - difference).norm(), 1e-9 * (1.0 + difference.norm()));
  }
}

TEST(MovingSupports, OfMatricesHaveDerivatives) {
  expect_derivatives(parse_scene(in_scene() + kEndsMove, "scene"),
                     {"forcing.frequency", "forcing.amplitude", "forcing.2.amplitude",
                      "forcing.2.phase", "matrices.stiffness.1.2", "matrices.stiffness.2.2",
                      "matrices.damping.3.4", "matrices.mass.1.2", "matrices.mass.3.3"});
  expect_derivatives(
      parse_scene(fmt::format("[matrices]\nmass = {}\nstiffness = {}\n"
                              "constraints = [\"1\", \"4\"]\n[damping]\nrayleigh = {{ mass = "
                              "0.03, stiffness = 0.01 }}\n",
                              rows_of(kElementMass), rows_of(kElementStiffness)) +
                      kEndsMove,
                  "scene"),
      {"damping.rayleigh.stiffness", "damping.rayleigh.mass", "matrices.stiffness.1.2",
       "matrices.mass.1.2"});
}

// The ground of masses and springs as a row of matrices that is held, and moves.
TEST(MovingSupports, OfMatricesAreThoseOfMasses) {
  const std::string moves = "amplitude = 0.2\nfrequency = 3.7\nphase = 0.4\n";
  const std::string stop = "gap = 0.02\nrestitution = 0.6\n";
  const std::string masses =
      "[lumped]\nmasses = [2, 1]\n"
      "[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 50\ndamping = 0.7\n"
      "[[lumped.spring]]\nbetween = [1, 2]\nstiffness = 20\ndamping = 0.1\n"
      "[forcing]\nkind = \"support\"\nmass = 1\n" +
      moves + "[[stop]]\nmass = 1\nagainst = 2\n" + stop;
  const std::string matrices =
      "[matrices]\nmass = [[2, 0, 0], [0, 1, 0], [0, 0, 0]]\n"
      "stiffness = [[70, -20, -50], [-20, 20, 0], [-50, 0, 50]]\n"
      "damping = [[0.8, -0.1, -0.7], [-0.1, 0.1, 0], [-0.7, 0, 0.7]]\nconstraints = [\"3\"]\n"
      "[forcing]\nkind = \"support\"\nnode = \"3\"\n" +
      moves + "[[stop]]\nnode = \"1\"\nagainst = \"2\"\n" + stop;
  const auto run = [](const std::string& text) {
    const Scene scene = parse_scene(text, "scene");
    const System system = assemble(scene);
    SimulationOptions options = support::for_seconds(15.0);
    options.energy = true;
    RecordedRun done = support::record_run(system, initial_state(scene, system), options);
    EXPECT_LE(std::abs(done.result.energy->defect()), 1e-10 * done.result.energy->size());
    return done;
  };
  const RecordedRun first = run(masses), second = run(matrices);
  ASSERT_GT(first.events.size(), 5u);
  ASSERT_EQ(first.events.size(), second.events.size());
  for (std::size_t i = 0; i < first.events.size(); ++i)
    EXPECT_NEAR(first.events[i].time, second.events[i].time, 1e-11);
}

TEST(MovingSupports, OfMatricesSayWhatIsWrong) {
  const auto refusal = [](const std::string& forcing) -> std::string {
    try {
      (void)parse_scene(
          in_scene() + "[forcing]\nkind = \"support\"\namplitude = 0.1\nfrequency = 2\n" + forcing,
          "scene");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const struct {
    const char *forcing, *message;
  } cases[] = {{"", "node: the key is missing"},
               {"node = \"2\"\n", "2 is free, a support must be held"},
               {"node = \"7\"\n", "no degree of freedom 7"},
               {"node = \"1\"\nagainst = \"2\"\n", "against: a support moves in space"}};
  for (const auto& one : cases)
    EXPECT_NE(refusal(one.forcing).find(one.message), std::string::npos) << refusal(one.forcing);
}

}  // namespace
}  // namespace graze
