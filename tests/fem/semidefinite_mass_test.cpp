// Modes where reduced integration leaves the mass matrix semidefinite.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "graze/base/errors.hpp"
#include "graze/fem/structural_modes.hpp"

namespace graze {
namespace {

// Bars of elements with two nodes and one point of integration, rho A = EA = 1, one behind the
// other and not joined, free at their ends, with a bedding `ground` (1/s^2) that is integrated
// likewise. An element has the stiffness [1 -1; -1 1]/h and the mass [1 1; 1 1] h/4, so that what
// alternates from node to node has no mass. With u_i = cos(i t), t = k pi/(n - 1), both ends
// included,
//
//   K u = (2 - 2 cos t)/h u,  M u = (2 + 2 cos t) h/4 u,  w_k = 2/h tan(k pi/(2 (n - 1))).
StructuralMatrices bars(int nodes, const std::vector<double>& lengths, double ground) {
  const int n = nodes * static_cast<int>(lengths.size());
  StructuralMatrices result;
  result.mass.resize(n, n);
  result.stiffness.resize(n, n);
  std::vector<Eigen::Triplet<double>> mass, stiffness;
  int first = 0;
  for (const double length : lengths) {
    const double h = length / (nodes - 1);
    for (int e = first; e + 1 < first + nodes; ++e)
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
          mass.emplace_back(e + i, e + j, 0.25 * h);
          stiffness.emplace_back(e + i, e + j, (i == j ? 1.0 : -1.0) / h + ground * 0.25 * h);
        }
    first += nodes;
  }
  for (int i = 0; i < n; ++i) result.labels.push_back({i + 1, 1});
  result.mass.setFromTriplets(mass.begin(), mass.end());
  result.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  result.mass_file = "mass";
  result.stiffness_file = "stiffness";
  return result;
}

std::vector<double> exact_frequencies(int nodes, const std::vector<double>& lengths,
                                      double ground) {
  std::vector<double> all;
  for (const double length : lengths)
    for (int k = 0; k + 1 < nodes; ++k) {
      const double w =
          2.0 * (nodes - 1) / length * std::tan(0.5 * k * std::numbers::pi / (nodes - 1));
      all.push_back(std::sqrt(ground + w * w));
    }
  std::sort(all.begin(), all.end());
  return all;
}

// Dense and by the iteration, held and free.
TEST(SemidefiniteMass, BarsOfOnePointElementsHaveTheirClosedForm) {
  struct Case {
    int nodes, count;
    std::vector<double> lengths;
  };
  for (const Case& given :
       {Case{5, 4, {1.0}}, Case{12, 33, {1.0, 1.3, 1.7}}, Case{200, 30, {1.0, 1.3, 1.7}}})
    for (const double ground : {0.0, 3.0}) {
      SCOPED_TRACE(testing::Message() << given.lengths.size() << " bars on " << ground);
      const int bars_count = static_cast<int>(given.lengths.size());
      const StructuralModes modes =
          lowest_modes(bars(given.nodes, given.lengths, ground), given.count);
      const std::vector<double> exact = exact_frequencies(given.nodes, given.lengths, ground);
      EXPECT_EQ(modes.massless, bars_count);
      EXPECT_EQ(modes.massless_motions, bars_count);
      EXPECT_EQ(modes.idle, 0);
      EXPECT_EQ(modes.rigid, ground == 0.0 ? std::min(bars_count, given.count) : 0);
      EXPECT_LE(modes.residuals.maxCoeff(), 1e-12);
      for (int j = 0; j < given.count; ++j)
        EXPECT_NEAR(modes.omega[j], exact[static_cast<std::size_t>(j)],
                    1e-10 * exact[static_cast<std::size_t>(j)])
            << j;
    }
}

TEST(SemidefiniteMass, NoMoreModesThanItsRankAreFound) {
  try {
    lowest_modes(bars(5, {1.0, 2.0}, 1.0), 9);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "stiffness: 9 modes are asked for, the structure has 8, the rank of its mass "
                 "matrix");
  }
}

// The bending of a cantilever against its closed form is that of rows without mass; here a unit
// force on an end of a bar on its bedding, whose massless motion yields as well: K^-1 in all.
TEST(SemidefiniteMass, StaticDisplacementsHoldWhatHasNoMass) {
  const StructuralMatrices structure = bars(6, {1.0, 1.4}, 2.0);
  const Matrix load = Matrix::Identity(12, 1);
  const StructuralModes modes = lowest_modes(structure, 10, load);
  const Vector exact = Matrix(structure.stiffness).ldlt().solve(load);
  EXPECT_LE((modes.static_displacements - exact).cwiseAbs().maxCoeff(), 1e-13 * exact.maxCoeff());
  // All modes of a structure have less of it: what has no mass is in none.
  const Vector seen = modes.shapes.row(0).transpose().cwiseQuotient(modes.omega);
  EXPECT_LT(seen.squaredNorm(), (1.0 - 1e-3) * exact[0]);
}

// Two degrees of freedom with k and m between them alone: their common motion has neither, as an
// hourglass. w^2 = k/m; a unit force on one of them leaves what does not move both, 1/(4 k).
TEST(SemidefiniteMass, AMotionWithoutMassAndStiffnessIsLeftOut) {
  for (const int nodes : {4, 300}) {
    StructuralMatrices structure = bars(nodes, {1.0, 1.2}, 2.0);
    const int n = structure.size();
    const double k = 7.0, m = 7e-2;
    structure.mass.conservativeResize(n + 2, n + 2);
    structure.stiffness.conservativeResize(n + 2, n + 2);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        structure.mass.coeffRef(n + i, n + j) = i == j ? m : -m;
        structure.stiffness.coeffRef(n + i, n + j) = i == j ? k : -k;
      }
    structure.labels.push_back({n + 1, 1});
    structure.labels.push_back({n + 2, 1});
    Matrix load = Matrix::Zero(n + 2, 1);
    load(n, 0) = 1.0;
    const int count = std::min(n - 1, 12);
    const StructuralModes modes = lowest_modes(structure, count, load);
    EXPECT_EQ(modes.idle, 1);
    EXPECT_EQ(modes.rigid, 0);
    std::vector<double> exact = exact_frequencies(nodes, {1.0, 1.2}, 2.0);
    exact.push_back(10.0);
    std::sort(exact.begin(), exact.end());
    for (int j = 0; j < count; ++j)
      EXPECT_NEAR(modes.omega[j], exact[static_cast<std::size_t>(j)],
                  1e-9 * exact[static_cast<std::size_t>(j)])
          << j;
    const auto at = std::find_if(modes.omega.begin(), modes.omega.end(),
                                 [](double w) { return std::abs(w - 10.0) < 1e-6; });
    ASSERT_NE(at, modes.omega.end());
    const Vector shape = modes.shapes.col(at - modes.omega.begin());
    EXPECT_NEAR(std::abs(shape[n]), 0.5 / std::sqrt(m), 1e-9);
    EXPECT_NEAR(shape[n] + shape[n + 1], 0.0, 1e-9);
    EXPECT_NEAR(modes.static_displacements(n, 0), 0.25 / k, 1e-12);
    EXPECT_NEAR(modes.static_displacements(n + 1, 0), -0.25 / k, 1e-12);
  }
}

}  // namespace
}  // namespace graze
