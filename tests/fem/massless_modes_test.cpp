// Degrees of freedom without mass follow the others statically.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "graze/base/errors.hpp"
#include "graze/fem/detail/shift_invert.hpp"
#include "graze/fem/modal_damping.hpp"
#include "graze/fem/structural_modes.hpp"

namespace graze {
namespace {

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

// Cubic Hermite elements of length h of a beam without mass, EI = 1, with masses on displacements
// alone, one each node; node.2 is the displacement, node.6 the slope. Exact in what is static.
StructuralMatrices massless_beam(double h, const std::vector<double>& masses,
                                 const std::vector<DofLabel>& held) {
  const auto nodes = static_cast<long>(masses.size());
  Eigen::Matrix4d k;
  k << 12, 6 * h, -12, 6 * h, 6 * h, 4 * h * h, -6 * h, 2 * h * h, -12, -6 * h, 12, -6 * h, 6 * h,
      2 * h * h, -6 * h, 4 * h * h;
  k /= h * h * h;
  LabelledMatrix mass{"mass", SparseMatrix(2 * nodes, 2 * nodes), {}, true, {}};
  LabelledMatrix stiffness{"stiffness", SparseMatrix(2 * nodes, 2 * nodes), {}, true, {}};
  for (long node = 1; node <= nodes; ++node) {
    for (const int direction : {2, 6}) mass.labels.push_back({node, direction});
    if (masses[node - 1] > 0.0) mass.matrix.coeffRef(2 * node - 2, 2 * node - 2) = masses[node - 1];
  }
  stiffness.labels = mass.labels;
  for (long e = 0; e + 1 < nodes; ++e)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) stiffness.matrix.coeffRef(2 * e + i, 2 * e + j) += k(i, j);
  return join_matrices(mass, stiffness, nullptr, held);
}

int row_of(const StructuralMatrices& structure, long node, int direction) {
  return structure.find({node, direction}).value();
}

Matrix unit_load(const StructuralMatrices& structure, int row) {
  Matrix load = Matrix::Zero(structure.size(), 1);
  load(row, 0) = 1.0;
  return load;
}

const std::vector<DofLabel> kClamp = {{1, 2}, {1, 6}};

// A cantilever of length 1 whose nodes have the masses h, the last one h/2.
StructuralMatrices lumped_cantilever(int elements) {
  std::vector<double> masses(static_cast<std::size_t>(elements + 1), 1.0 / elements);
  masses.front() = masses.back() = 0.5 / elements;
  return massless_beam(1.0 / elements, masses, kClamp);
}

// w^2 = 3 EI/(m L^3): a mass at the end of a beam without any, however the beam is divided. A force
// on the end bends the place x by x^2 (3 L - x)/(6 EI).
TEST(MasslessModes, MassAtTheEndOfABeamWithoutAny) {
  const double m = 0.7, length = 1.3;
  for (const int elements : {1, 2, 40, 300}) {
    SCOPED_TRACE(elements);
    std::vector<double> masses(static_cast<std::size_t>(elements + 1), 0.0);
    masses.back() = m;
    const StructuralMatrices beam = massless_beam(length / elements, masses, kClamp);
    const int tip = row_of(beam, elements + 1, 2), tip_slope = row_of(beam, elements + 1, 6);
    const int middle_node = elements / 2 + 1;
    const StructuralModes modes = lowest_modes(beam, 1, unit_load(beam, tip_slope));
    // Rounding of the entries of the stiffness, which the curvature of the shape sees.
    const double rounding = 1e-15 * std::pow(elements, 4.0) + 1e-14;
    EXPECT_NEAR(modes.omega[0] / std::sqrt(3.0 / (m * std::pow(length, 3.0))), 1.0, rounding);
    EXPECT_EQ(modes.massless, 2 * elements - 1);
    EXPECT_TRUE(modes.is_dense);
    EXPECT_EQ(modes.counted, 1);
    EXPECT_NEAR(modes.shapes(tip, 0) * std::sqrt(m), 1.0, 1e-13);
    EXPECT_NEAR(modes.shapes(tip_slope, 0) * std::sqrt(m), 1.5 / length, rounding);
    // A unit moment on the end turns it by L/EI, of which the mode has 3/4.
    EXPECT_NEAR(modes.static_displacements(tip_slope, 0), length, length * rounding);
    EXPECT_NEAR(std::pow(modes.shapes(tip_slope, 0) / modes.omega[0], 2.0), 0.75 * length,
                4.0 * length * rounding);
    if (elements == 1) continue;
    const double x = length * (middle_node - 1) / elements;
    EXPECT_NEAR(modes.shapes(row_of(beam, middle_node, 2), 0) * std::sqrt(m),
                x * x * (3.0 * length - x) / (2.0 * std::pow(length, 3.0)), rounding);
  }
}

// K_mm - K_ms K_ss^-1 K_sm with a diagonal mass, in long double.
struct Condensed {
  explicit Condensed(const StructuralMatrices& structure) {
    std::vector<int> slaves;
    const Vector m = structure.mass.diagonal();
    for (int i = 0; i < structure.size(); ++i) (m[i] > 0.0 ? masters : slaves).push_back(i);
    const LongMatrix k = Matrix(structure.stiffness).cast<long double>();
    const LongMatrix roots = m(masters).cast<long double>().cwiseSqrt().cwiseInverse().asDiagonal();
    const LongMatrix k_sm = k(slaves, masters);
    const LongMatrix follow = -Eigen::LLT<LongMatrix>(k(slaves, slaves)).solve(k_sm);
    const LongMatrix stiffness = k(masters, masters) + k_sm.transpose() * follow;
    const Eigen::SelfAdjointEigenSolver<LongMatrix> solver(roots * stiffness * roots);
    squares = solver.eigenvalues().cast<double>();
    LongMatrix all(structure.size(), squares.size());
    const LongMatrix moved = roots * solver.eigenvectors();
    all(masters, Eigen::all) = moved;
    all(slaves, Eigen::all) = follow * moved;
    shapes = all.cast<double>();
  }

  std::vector<int> masters;
  Vector squares;
  Matrix shapes;
};

TEST(MasslessModes, AreThoseOfTheCondensedStructure) {
  const StructuralMatrices beam = lumped_cantilever(20);
  const Condensed condensed(beam);
  const StructuralModes modes = lowest_modes(beam, 20);
  EXPECT_EQ(modes.massless, 20);
  EXPECT_LE(modes.residuals.maxCoeff(), 1e-14);
  for (int j = 0; j < 20; ++j) {
    EXPECT_NEAR(modes.omega[j] / std::sqrt(condensed.squares[j]), 1.0, 1e-11) << j;
    const Vector expected = condensed.shapes.col(j);
    const double sign = expected.dot(modes.shapes.col(j)) < 0.0 ? -1.0 : 1.0;
    EXPECT_LE((sign * modes.shapes.col(j) - expected).cwiseAbs().maxCoeff(),
              1e-10 * expected.cwiseAbs().maxCoeff())
        << j;
  }
}

// A unit force at x_j bends a cantilever at x_i <= x_j by x_i^2 (3 x_j - x_i)/6, and turns it there
// by x_i (2 x_j - x_i)/2, beyond x_j by x_j^2/2. Modes are those of this flexibility.
TEST(MasslessModes, OfTheIterationAreThoseOfTheFlexibility) {
  const int n = 300;
  const StructuralMatrices beam = lumped_cantilever(n);
  const double h = 1.0 / n;
  Vector m = Vector::Constant(n, h);
  m[n - 1] = 0.5 * h;
  Matrix bends(n, n), turns(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = h * (std::min(i, j) + 1), b = h * (std::max(i, j) + 1);
      bends(i, j) = a * a * (3.0 * b - a) / 6.0;
      turns(i, j) = i <= j ? a * (2.0 * b - a) / 2.0 : a * a / 2.0;
    }
  const Vector roots = m.cwiseSqrt();
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(roots.asDiagonal() * bends *
                                                     roots.asDiagonal());
  const StructuralModes modes = lowest_modes(beam, 8);
  ASSERT_FALSE(modes.is_dense);
  EXPECT_EQ(modes.massless, n);
  ASSERT_TRUE(modes.counted);
  EXPECT_GE(*modes.counted, 8);
  EXPECT_LE(modes.residuals.maxCoeff(), 1e-14);
  for (int j = 0; j < 8; ++j) {
    const double w = 1.0 / std::sqrt(solver.eigenvalues()[n - 1 - j]);
    // The rounding of the stiffness, whose entries grow as h^-4 beside w^2.
    const double rounding = 1e-16 / std::pow(h, 4.0) / (w * w) + 1e-13;
    EXPECT_NEAR(modes.omega[j] / w, 1.0, rounding) << j;
    const Vector phi = solver.eigenvectors().col(n - 1 - j).cwiseQuotient(roots);
    const Vector slopes = turns * (w * w * m.asDiagonal() * phi);
    const double sign = phi[n - 1] * modes.shapes(row_of(beam, n + 1, 2), j) < 0.0 ? -1.0 : 1.0;
    for (const int i : {40, 151, 300}) {
      EXPECT_NEAR(sign * modes.shapes(row_of(beam, i + 1, 2), j), phi[i - 1],
                  10.0 * rounding * phi.cwiseAbs().maxCoeff())
          << i << " " << j;
      EXPECT_NEAR(sign * modes.shapes(row_of(beam, i + 1, 6), j), slopes[i - 1],
                  10.0 * rounding * slopes.cwiseAbs().maxCoeff())
          << i << " " << j;
    }
  }
}

// A mass m behind every `stride` springs k of a chain between walls.
StructuralMatrices sparse_chain(int masses, int stride, double m, double k) {
  const int n = stride * (masses + 1) - 1;
  StructuralMatrices chain;
  chain.mass.resize(n, n);
  chain.stiffness.resize(n, n);
  for (int i = 0; i < n; ++i) {
    chain.labels.push_back({i + 1, 1});
    if (i % stride == stride - 1) chain.mass.insert(i, i) = m;
    chain.stiffness.insert(i, i) = 2.0 * k;
    if (i > 0) chain.stiffness.insert(i - 1, i) = chain.stiffness.insert(i, i - 1) = -k;
  }
  return chain;
}

// Springs k/stride are between masses.
void expect_sparse_chain(int masses, int stride, int count) {
  SCOPED_TRACE(testing::Message() << masses << " " << stride << " " << count);
  const int n = stride * (masses + 1) - 1;
  const double k = 250.0, m = 0.3;
  const StructuralMatrices chain = sparse_chain(masses, stride, m, k);
  // One spring behind a mass.
  const int before = masses / 3, loaded = stride * before;
  const StructuralModes modes = lowest_modes(chain, count, unit_load(chain, loaded));
  EXPECT_EQ(modes.is_dense, count == masses);
  EXPECT_EQ(modes.massless, n - masses);
  for (int j = 1; j <= count; ++j) {
    const double w =
        2.0 * std::sqrt(k / (stride * m)) * std::sin(j * std::numbers::pi / (2.0 * (masses + 1)));
    EXPECT_NEAR(modes.omega[j - 1] / w, 1.0, 1e-10) << j;
    const double size = std::sqrt(2.0 / (m * (masses + 1)));
    const auto phi = [&](int mass) {
      return size * std::sin(mass * j * std::numbers::pi / (masses + 1));
    };
    // Straight between two masses.
    const double expected = phi(before) + (phi(before + 1) - phi(before)) / stride;
    EXPECT_NEAR(std::abs(modes.shapes(loaded, j - 1)), std::abs(expected), 1e-9 * size) << j;
  }
  const double x = loaded + 1.0;
  EXPECT_NEAR(modes.static_displacements(loaded, 0) / (x * (n + 1.0 - x) / ((n + 1.0) * k)), 1.0,
              1e-11);
}

TEST(MasslessModes, OfAChainWithoutMostOfItsMasses) {
  expect_sparse_chain(999, 3, 12);
  // Hardly more masses than the iteration keeps vectors, and all modes of them.
  expect_sparse_chain(kFewMasses + 1, 12, 20);
  expect_sparse_chain(kFewMasses, 12, kFewMasses);
}

// What is looked for where inertia cannot be counted.
TEST(MasslessModes, TheNextOneAndAMissingOneAreMet) {
  const StructuralMatrices chain = sparse_chain(200, 4, 1.0, 4.0);
  SparseCholesky factors(chain.stiffness);
  ASSERT_TRUE(factors.factorise(chain.stiffness));
  const Matrix shapes = lowest_modes(chain, 6).shapes;
  const auto square = [](int j) {
    return std::pow(2.0 * std::sin(j * std::numbers::pi / 402.0), 2.0);
  };
  const auto next = nearest_other(factors, chain.mass, 200, shapes, 0.0);
  ASSERT_TRUE(next);
  EXPECT_NEAR(*next / square(7), 1.0, 1e-5);
  const auto missing =
      nearest_other(factors, chain.mass, 200, shapes(Eigen::all, std::vector{0, 1, 3, 4, 5}), 0.0);
  ASSERT_TRUE(missing);
  EXPECT_NEAR(*missing / square(3), 1.0, 1e-5);
}

// Three masses m on a free beam without any, h apart: besides two rigid-body modes one in which the
// middle moves against both ends, w^2 = 48 EI/(2 h)^3 (1/m + 1/(2 m)) = 9 EI/(m h^3). With inertia
// relief the middle gives 2 h^3/(27 EI) under a unit force, all of it by that mode.
TEST(MasslessModes, OfAFreeBeam) {
  for (const int between : {1, 8, 200}) {
    SCOPED_TRACE(between);
    const double m = 2.0, h = 0.5;
    std::vector<double> masses(static_cast<std::size_t>(2 * between + 1), 0.0);
    masses.front() = masses[static_cast<std::size_t>(between)] = masses.back() = m;
    const StructuralMatrices beam = massless_beam(h / between, masses, {});
    const int middle = row_of(beam, between + 1, 2);
    const StructuralModes modes = lowest_modes(beam, 3, unit_load(beam, middle));
    const double rounding = 1e-15 * std::pow(between, 4.0) + 1e-13;
    EXPECT_EQ(modes.rigid, 2);
    EXPECT_NEAR(modes.omega[2] / std::sqrt(9.0 / (m * h * h * h)), 1.0, rounding);
    EXPECT_NEAR(std::abs(modes.shapes(middle, 2)), std::sqrt(2.0 / (3.0 * m)), rounding);
    EXPECT_NEAR(modes.static_displacements(middle, 0) / (2.0 * h * h * h / 27.0), 1.0,
                4.0 * rounding);
  }
}

// The mass of a Hermite cantilever without its rotary part, times a damping of the same kind.
TEST(MasslessModes, ProportionalDampingStaysSo) {
  StructuralMatrices beam = lumped_cantilever(12);
  beam.damping = SparseMatrix(0.4 * beam.mass + 0.001 * beam.stiffness);
  const StructuralModes modes = lowest_modes(beam, 6);
  const ModalDamping damping = modal_damping(beam, modes);
  ASSERT_TRUE(damping.is_proportional);
  for (int j = 0; j < 6; ++j)
    EXPECT_NEAR(damping.delta[j] / (0.2 + 0.0005 * modes.omega[j] * modes.omega[j]), 1.0, 1e-9);
}

std::string refusal(const StructuralMatrices& structure, int count) {
  try {
    lowest_modes(structure, count);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MasslessModes, WhatMovesFreelyWithoutMassIsRefused) {
  for (const int n : {4, 400}) {
    SCOPED_TRACE(n);
    // A free beam with one mass: the turning about it has no inertia.
    std::vector<double> masses(static_cast<std::size_t>(n), 0.0);
    masses[1] = 1.0;
    EXPECT_EQ(refusal(massless_beam(1.0 / n, masses, {}), 1).substr(0, 105),
              "stiffness: degrees of freedom without mass can move without strain energy while all "
              "with mass rest, which");
  }
  // Two joined by a spring, which nothing else holds, beside an oscillator.
  StructuralMatrices pair;
  pair.labels = {{1, 1}, {2, 1}, {3, 1}};
  pair.mass_file = "mass";
  pair.stiffness_file = "stiffness";
  pair.mass = SparseMatrix(3, 3);
  pair.mass.insert(0, 0) = 1.0;
  Matrix k = Matrix::Identity(3, 3);
  k(1, 2) = k(2, 1) = -1.0;
  pair.stiffness = k.sparseView();
  EXPECT_EQ(refusal(pair, 1).find("stiffness: degrees of freedom without mass can move"), 0u);
  EXPECT_NE(refusal(pair, 1).find("at 3.1: give them mass"), std::string::npos) << refusal(pair, 1);
  pair.stiffness.coeffRef(2, 2) = 2.0;
  EXPECT_EQ(refusal(pair, 1), "");
  EXPECT_EQ(refusal(pair, 2),
            "stiffness: 2 modes are asked for, the structure has 1 degree of freedom that is not "
            "held and has mass");
}

}  // namespace
}  // namespace graze
