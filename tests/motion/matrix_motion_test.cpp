// A structure of matrices moves as the same one whose modes are typed by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/mode_table.hpp"
#include "graze/assembly/system_family.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/reader.hpp"
#include "support/beam_matrices.hpp"
#include "support/reference.hpp"
#include "support/scratch_folder.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// Three masses of 2 kg between four springs of 50 N/m: w_k = 2 sqrt(k/m) sin(k pi/8),
// phi_k(i) = sqrt(2/(4 m)) sin(i k pi/4).
constexpr double kPi = 3.141592653589793;
double shape(int mode, int mass) { return 0.5 * std::sin(mass * mode * kPi / 4.0); }

class MatrixMotion : public testing::Test {
 protected:
  MatrixMotion() {
    write("m.mtx", "1,1,1,1,2.\n2,1,2,1,2.\n3,1,3,1,2.\n");
    write("k.mtx", "1,1,1,1,100.\n2,1,1,1,-50.\n2,1,2,1,100.\n3,1,2,1,-50.\n3,1,3,1,100.\n");
    std::ofstream dashpots(folder_ / "c.mtx");
    dashpots << "1,1,1,1,1.6\n2,1,1,1,-.5\n2,1,2,1,1.6\n3,1,2,1,-.5\n3,1,3,1,1.6\n";
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }
  Scene of_matrices(const std::string& keys, const std::string& rest) {
    return parse_scene(
        "[matrices]\nmass = \"m.mtx\"\nstiffness = \"k.mtx\"\nmodes = 3\n" + keys + rest,
        (folder_ / "scene.toml").string());
  }
  // Of a force on the first mass.
  static std::string participation() {
    return "participation = " +
           fmt_list({3.0 * shape(1, 1), 3.0 * shape(2, 1), 3.0 * shape(3, 1)}) + "\n";
  }
  // The same by its closed form; stops stand at the third mass, and between the first and it.
  static Scene of_modes(const std::string& keys, const std::string& rest) {
    const auto list = [](auto&& entry) { return fmt_list({entry(1), entry(2), entry(3)}); };
    std::string text =
        "[modal]\nfrequencies = " + list([](int k) { return 10.0 * std::sin(k * kPi / 8.0); }) +
        "\ninertia = " +
        list([](int k) { return 2.0 * (shape(k, 1) + shape(k, 2) + shape(k, 3)); }) + "\n" + keys +
        rest;
    text.replace(text.find("THIRD"), 5, list([](int k) { return shape(k, 3); }));
    text.replace(text.find("BETWEEN"), 7, list([](int k) { return shape(k, 1) - shape(k, 3); }));
    return parse_scene(text, "modes");
  }
  static std::string fmt_list(const std::vector<double>& values) {
    std::string text = "[";
    for (const double value : values) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.17e", value);
      text += (text.size() > 1 ? ", " : "") + std::string(digits);
    }
    return text + "]";
  }
  static support::RecordedRun run(const Scene& scene) {
    const System system = assemble(scene);
    return support::record_run(system, initial_state(scene, system), support::for_seconds(40.0));
  }

  ScratchFolder folder_;
};

std::string surroundings(const char* kind, const char* third, const char* between) {
  return std::string("[forcing]\nkind = \"") + kind +
         "\"\namplitude = 0.6\nfrequency = 4.0\n[[stop]]\ngap = 0.05\nrestitution = 0.7\n" + third +
         "\n[[stop]]\ngap = 0.08\nrestitution = 0.5\n" + between + "\n";
}

TEST_F(MatrixMotion, IsThatOfItsModes) {
  for (const bool is_based : {false, true}) {
    const Scene by_modes =
        of_modes(is_based ? "" : participation(),
                 "[damping]\nratios = [0.01, 0.02, 0.03]\n" +
                     surroundings(is_based ? "base" : "modal", "shape = THIRD", "shape = BETWEEN"));
    const Scene by_matrices =
        of_matrices(is_based ? "direction = 1\n" : "load = [\"1.1\"]\nload_values = [3.0]\n",
                    "[damping]\nratios = [0.01, 0.02, 0.03]\n" +
                        surroundings(is_based ? "base" : "load", "node = \"3.1\"",
                                     "node = \"1.1\"\nagainst = \"3.1\""));
    const auto expected = run(by_modes), found = run(by_matrices);
    ASSERT_GT(expected.events.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i) {
      EXPECT_NEAR(found.events[i].time, expected.events[i].time, 1e-9) << i;
      EXPECT_EQ(found.events[i].stop, expected.events[i].stop) << i;
    }
  }
}

// A beam with a mass at its end, shaken against a stop, and its matrices by other elements, brought
// in as files: the clamp's acceleration, the modes and the stop are the same.
TEST_F(MatrixMotion, OfABeamIsThatOfTheBeam) {
  const std::string shaken =
      "[damping]\nrayleigh = { mass = 4.0, stiffness = 1e-5 }\n"
      "[forcing]\namplitude = 2e-3\nfrequency = 18.0\n"
      "[[stop]]\ngap = 3e-3\nrestitution = 0.6\n";
  std::string text = write_scene(support::reference_scene("beams/tip_mass"));
  const Scene beam = parse_scene(text + shaken + "position = 0.55\n", "beam");
  const support::BeamMatrices matrices = support::beam_matrices_of(*beam.beam(), {{0.55}});
  const Scene by_matrices =
      parse_scene(support::matrices_table(matrices, folder_) + shaken +
                      "node = " + support::quoted(matrices.displacement(0.55)) + "\n",
                  (folder_ / "beam.toml").string());
  const auto expected = run(beam), found = run(by_matrices);
  ASSERT_GT(expected.events.size(), 20u);
  ASSERT_GT(found.events.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i)
    EXPECT_NEAR(found.events[i].time, expected.events[i].time, 1e-9) << i;
}

// C = 0.3 M + 0.01 K, and decay rates of (0.3 + 0.01 w^2)/2.
TEST_F(MatrixMotion, DampingMatrixIsThatOfRayleigh) {
  const System by_file = assemble(of_matrices("damping = \"c.mtx\"\n", ""));
  for (int k = 1; k <= 3; ++k) {
    const double w = 10.0 * std::sin(k * kPi / 8.0);
    EXPECT_NEAR(by_file.delta()[k - 1], 0.5 * (0.3 + 0.01 * w * w), 1e-13);
  }
}

// A family of systems finds no modes of its own: every scene of it has those that were read.
TEST_F(MatrixMotion, SweepsShareOneDecomposition) {
  const Scene scene =
      of_matrices("load = [\"1.1\"]\n", surroundings("load", "node = \"3.1\"", "node = \"1.1\""));
  std::filesystem::remove(folder_ / "k.mtx");
  const SystemFamily family(scene, "stop.gap");
  const std::optional<System> moved = family.at(0.03);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->stops[0].gap, 0.03);
  EXPECT_EQ(family.scene_at(0.03)->matrices()->solved.get(), scene.matrices()->solved.get());
  SystemCursor cursor(scene, {"forcing.frequency", "stop.gap"});
  const double values[] = {4.5, 0.04};
  ASSERT_TRUE(cursor.at(values));
  const System* tangent = cursor.tangent_at(values, 1);
  EXPECT_EQ(tangent->stops[0].gap, 1.0);
  EXPECT_EQ(tangent->stops[0].row, Vector::Zero(3));
  EXPECT_EQ(tangent->omega, Vector::Zero(3));
}

TEST_F(MatrixMotion, EffectiveMassesOfAllModesAreTheWhole) {
  const ModeTable table = mode_table(of_matrices("direction = 1\n", ""));
  ASSERT_EQ(table.directions.size(), 1u);
  EXPECT_NEAR(*table.directions[0].total_mass, 6.0, 1e-14);
  EXPECT_NEAR(table.directions[0].inertia.squaredNorm(), 6.0, 1e-13);
}

TEST_F(MatrixMotion, ShapesAreComparedByModalAssurance) {
  const NamedShapes own = *named_shapes(of_matrices("", ""));
  const ModalAssurance same = modal_assurance(own, own);
  EXPECT_EQ(same.common, 3);
  EXPECT_LE((same.values - Matrix::Identity(3, 3)).cwiseAbs().maxCoeff(), 1e-13);
  write("shapes.txt", "# two shapes at two places\n1.1 1 1\n3.1 1 -1\n");
  const ModalAssurance other = modal_assurance(own, read_shapes((folder_ / "shapes.txt").string()));
  EXPECT_EQ(other.common, 2);
  EXPECT_NEAR(other.values(0, 0), 1.0, 1e-13);  // the first mode is symmetric
  EXPECT_NEAR(other.values(1, 1), 1.0, 1e-13);
  EXPECT_NEAR(other.values(0, 1), 0.0, 1e-13);
}

}  // namespace
}  // namespace graze
