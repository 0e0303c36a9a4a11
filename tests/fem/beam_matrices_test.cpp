// Beams as matrices of finite elements: the modes of tests/reference/beams.py, which tests of
// structure hold against scenes of the same beams.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "graze/fem/structural_modes.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "support/beam_matrices.hpp"
#include "support/reference.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

constexpr double kPlaces[] = {0.13, 0.55, 0.71};
constexpr const char* kColumns[] = {"at_013", "at_055", "at_071"};

using Cases = std::map<std::string, std::vector<support::TableRow>>;

// The beams among the cases of the table.
Cases beam_cases() {
  Cases cases;
  for (const auto& row : support::read_table("beams.csv")) {
    const std::string& name = row.at("case");
    if (!name.starts_with("string") && !name.starts_with("bar")) cases[name].push_back(row);
  }
  return cases;
}

// The table has no rigid motions.
int rigid_count(const std::string& name) { return name == "free_free" ? 2 : 0; }

support::BeamMatrices matrices_of(const std::string& name, support::BeamMesh mesh = {}) {
  mesh.nodes.assign(std::begin(kPlaces), std::end(kPlaces));
  // The tip's own solutions change over its distance from the apex, a ten thousandth of the length.
  if (name == "sharp_wedge")
    for (double left = 0.03; left > 5e-5; left /= 3.0) mesh.nodes.push_back(0.8 - left);
  return support::beam_matrices_of(*support::reference_scene("beams/" + name).beam(), mesh);
}

// `shapes`: of the three places, up to the sign of each mode.
void expect_modes(const std::vector<support::TableRow>& rows, const Vector& omega, int rigid,
                  const Matrix& shapes, double tolerance, double shape_tolerance) {
  EXPECT_TRUE(omega.head(rigid).isZero(0.0));
  for (Eigen::Index j = rigid; j < omega.size(); ++j) {
    const auto& row = rows[static_cast<std::size_t>(j - rigid)];
    EXPECT_NEAR(omega[j] / support::number(row, "omega"), 1.0, tolerance) << j;
    Vector expected(3);
    for (int k = 0; k < 3; ++k) expected[k] = support::number(row, kColumns[k]);
    const double sign = expected.dot(shapes.col(j)) < 0.0 ? -1.0 : 1.0;
    const double size = expected.cwiseAbs().maxCoeff();
    EXPECT_LE((sign * shapes.col(j) - expected).cwiseAbs().maxCoeff(), shape_tolerance * size) << j;
  }
}

Matrix at_places(const support::BeamMatrices& beam, const StructuralMatrices& structure,
                 const StructuralModes& modes) {
  Matrix shapes(3, modes.count());
  for (int k = 0; k < 3; ++k)
    shapes.row(k) = modes.shapes.row(structure.find(beam.displacement(kPlaces[k])).value());
  return shapes;
}

TEST(BeamMatrices, HaveTheModesOfTheClosedSolutions) {
  const Cases cases = beam_cases();
  EXPECT_EQ(cases.size(), 14u);
  for (const auto& [name, rows] : cases) {
    SCOPED_TRACE(name);
    const support::BeamMatrices beam = matrices_of(name);
    const StructuralMatrices structure = beam.structure();
    const StructuralModes modes = lowest_modes(structure, 8);
    ASSERT_TRUE(modes.is_dense);
    EXPECT_EQ(modes.rigid, rigid_count(name));
    expect_modes(rows, modes.omega, modes.rigid, at_places(beam, structure, modes), 1e-11, 1e-9);
  }
}

// Enough of them for Lanczos' iteration. Entries of the stiffness grow as the cube of the number of
// elements, and so does their rounding.
TEST(BeamMatrices, HaveTheModesOfTheClosedSolutionsByTheIteration) {
  for (const auto& [name, rows] : beam_cases()) {
    SCOPED_TRACE(name);
    const support::BeamMatrices beam = matrices_of(name, {{}, 0.01, 6});
    const StructuralMatrices structure = beam.structure();
    const StructuralModes modes = lowest_modes(structure, 8);
    ASSERT_FALSE(modes.is_dense);
    EXPECT_EQ(modes.rigid, rigid_count(name));
    ASSERT_TRUE(modes.counted);
    expect_modes(rows, modes.omega, modes.rigid, at_places(beam, structure, modes), 1e-8, 1e-7);
  }
}

// The beam as a scene whose matrices are files, with a stop and probes at the three places.
Scene scene_of_files(const support::BeamMatrices& beam, const ScratchFolder& folder) {
  std::string text = support::matrices_table(beam, folder) +
                     "[[stop]]\ngap = 0.01\nrestitution = 0.6\nnode = " +
                     support::quoted(beam.displacement(kPlaces[1])) + "\n";
  for (const double x : kPlaces)
    text += "[[probe]]\nnode = " + support::quoted(beam.displacement(x)) + "\n";
  return parse_scene(text, (folder / "scene.toml").string());
}

TEST(BeamMatrices, InFilesAreTheStructureOfAScene) {
  Cases cases = beam_cases();
  for (const char* name :
       {"clamped_clamped", "free_free", "tip_mass", "two_spans", "stepped", "on_springs", "cone"}) {
    SCOPED_TRACE(name);
    const ScratchFolder folder;
    const Scene scene = scene_of_files(matrices_of(name), folder);
    const std::vector<double>& frequencies = scene.modal()->frequencies;
    Matrix shapes(3, 8);
    for (int k = 0; k < 3; ++k)
      shapes.row(k) = Eigen::Map<const Vector>(scene.probes[k].shape.data(), 8).transpose();
    EXPECT_EQ(scene.stops[0].shape, scene.probes[1].shape);
    expect_modes(cases.at(name), Eigen::Map<const Vector>(frequencies.data(), 8), rigid_count(name),
                 shapes, 1e-11, 1e-9);
  }
}

// A unit force on a cantilever bends the place x where it acts by x^3/(3 EI), a mass at its end or
// not.
TEST(BeamMatrices, HaveTheFlexibilityOfTheCantilever) {
  const ScratchFolder folder;
  const Scene scene = scene_of_files(matrices_of("tip_mass"), folder);
  const double bending = 2e11 * 0.02 * std::pow(0.004, 3.0) / 12.0;
  EXPECT_NEAR(scene.matrices()->solved->flexibility(0, 0) * 3.0 * bending / std::pow(0.55, 3.0),
              1.0, 1e-11);
}

// Entries grow as the cube of the number of elements and so does their rounding, which the bounds
// that come with modes and static displacements hold: what the modes leave out of the flexibility
// is the same on 20 elements and on 200, up to these.
TEST(BeamMatrices, KnowHowFarTheyAreRounded) {
  const auto left_out = [](double element) {
    const support::BeamMatrices beam = matrices_of("tip_mass", {{}, element, 2});
    const StructuralMatrices structure = beam.structure();
    Matrix load = Matrix::Zero(structure.size(), 1);
    load(*structure.find(beam.displacement(kPlaces[1])), 0) = 1.0;
    const StructuralModes modes = lowest_modes(structure, 12, load);
    const double whole = load.col(0).dot(modes.static_displacements.col(0));
    double left = whole, bound = modes.static_roundings[0];
    for (Eigen::Index j = 0; j < modes.count(); ++j) {
      const double square = modes.omega[j] * modes.omega[j];
      const double share = std::pow(load.col(0).dot(modes.shapes.col(j)), 2.0) / square;
      left -= share;
      bound += share * modes.square_roundings[j] / square;
    }
    return std::array<double, 3>{left, 8.0 * bound, whole};
  };
  const auto coarse = left_out(0.05), fine = left_out(0.005);
  EXPECT_GT(fine[1], 100.0 * coarse[1]);
  EXPECT_LT(coarse[1], 1e-9 * coarse[2]);
  // Elements of two bubbles miss some of the twelfth mode where they are coarse.
  EXPECT_NEAR(fine[0], coarse[0], fine[1] + 1e-3 * coarse[0]);
}

}  // namespace
}  // namespace graze
