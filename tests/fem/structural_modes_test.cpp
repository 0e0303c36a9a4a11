// Modes of matrices against closed forms.
#include "graze/fem/structural_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/base/errors.hpp"
#include "graze/fem/modal_damping.hpp"
#include "support/elastic_solid.hpp"

namespace graze {
namespace {

constexpr double kPi = 3.141592653589793;

// n equal masses m between equal springs k, fixed at both ends or free.
StructuralMatrices chain(int n, double m, double k, bool is_free) {
  StructuralMatrices result;
  std::vector<Eigen::Triplet<double>> mass, stiffness;
  for (int i = 0; i < n; ++i) {
    result.labels.push_back({i + 1, 1});
    mass.emplace_back(i, i, m);
    const bool at_end = i == 0 || i == n - 1;
    stiffness.emplace_back(i, i, is_free && at_end ? k : 2.0 * k);
    if (i + 1 < n) {
      stiffness.emplace_back(i, i + 1, -k);
      stiffness.emplace_back(i + 1, i, -k);
    }
  }
  result.mass.resize(n, n);
  result.mass.setFromTriplets(mass.begin(), mass.end());
  result.stiffness.resize(n, n);
  result.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  result.mass_file = "mass";
  result.stiffness_file = "stiffness";
  return result;
}

// w_k = 2 sqrt(k/m) sin(k pi/(2 (n + 1))), phi_k(i) = sqrt(2/(m (n + 1))) sin(i k pi/(n + 1)).
void expect_fixed_chain(int n, int count) {
  const double m = 0.3, k = 250.0;
  const StructuralModes modes = lowest_modes(chain(n, m, k, false), count);
  EXPECT_EQ(modes.rigid, 0);
  for (int j = 1; j <= count; ++j) {
    const double exact = 2.0 * std::sqrt(k / m) * std::sin(j * kPi / (2.0 * (n + 1)));
    EXPECT_NEAR(modes.omega[j - 1] / exact, 1.0, 1e-10) << j;
    EXPECT_LE(modes.residuals[j - 1], 1e-13) << j;
  }
  // Up to its sign, which has the largest entry positive.
  Vector first(n);
  for (int i = 1; i <= n; ++i)
    first[i - 1] = std::sqrt(2.0 / (m * (n + 1))) * std::sin(i * kPi / (n + 1));
  EXPECT_LE((modes.shapes.col(0) - first).cwiseAbs().maxCoeff(), 1e-9 * first.maxCoeff());
}

TEST(StructuralModes, FixedChainIsItsClosedForm) {
  expect_fixed_chain(1, 1);
  expect_fixed_chain(40, 40);
  expect_fixed_chain(3000, 30);
}

// Half of them move both sides alike, half one against the other: the side that comes first is
// positive, whatever rounding makes of the other.
TEST(StructuralModes, TheFirstOfTheLargestDisplacementsIsPositive) {
  for (const int n : {40, 41, 700}) {
    const StructuralModes modes = lowest_modes(chain(n, 0.3, 250.0, false), 20);
    for (int j = 1; j <= 20; ++j) {
      const auto phi = [&](int i) { return std::sin(i * j * kPi / (n + 1)); };
      double largest = 0.0;
      for (int i = 1; i <= n; ++i) largest = std::max(largest, std::abs(phi(i)));
      int first = 1;
      while (std::abs(phi(first)) < (1.0 - 1e-9) * largest) ++first;
      EXPECT_GT(modes.shapes(first - 1, j - 1), 0.0) << n << " " << j;
    }
  }
}

TEST(StructuralModes, CountsThemBySylvestersLaw) {
  const StructuralModes modes = lowest_modes(chain(3000, 1.0, 1.0, false), 30);
  ASSERT_FALSE(modes.is_dense);
  ASSERT_TRUE(modes.counted);
  // Of the closed form, as many lie below.
  int below = 0;
  for (int j = 1; j <= 3000; ++j)
    below += 2.0 * std::sin(j * kPi / (2.0 * 3001)) < modes.counted_below;
  EXPECT_EQ(*modes.counted, below);
  EXPECT_GE(below, 30);
}

// A mass on a spring and a body that only stops will meet: w = sqrt(k/m), and shapes of one body
// each.
TEST(StructuralModes, BodyWithoutStiffnessIsARigidBodyModeOfItsOwn) {
  const auto two_bodies = [](double m, double k) {
    StructuralMatrices bodies = chain(2, m, 0.0, false);
    bodies.mass.coeffRef(1, 1) = 0.06;
    bodies.stiffness.coeffRef(0, 0) = k;
    return bodies;
  };
  const StructuralModes modes = lowest_modes(two_bodies(4.0, 1e4), 2);
  EXPECT_EQ(modes.rigid, 1);
  EXPECT_EQ(modes.omega[0], 0.0);
  EXPECT_NEAR(modes.omega[1], 50.0, 1e-12 * 50.0);
  EXPECT_EQ(modes.residuals[0], 0.0);
  Matrix exact(2, 2);
  exact << 0.0, 0.5, 1.0 / std::sqrt(0.06), 0.0;
  EXPECT_LE((modes.shapes - exact).cwiseAbs().maxCoeff(), 1e-14);
  // Nothing holds either body.
  EXPECT_EQ(lowest_modes(two_bodies(4.0, 0.0), 2).rigid, 2);
}

// A body a that no stiffness holds, joined to a chain by its mass alone: M = [a c; c m + c^2/a] at
// the body and the first mass. Eliminated, it leaves the fixed chain of equal masses; in its
// rigid-body mode the chain rests.
TEST(StructuralModes, BodyJoinedByItsMassAloneIsARigidBodyMode) {
  for (const int n : {2, 30, 700})
    for (const double k : {1e-6, 250.0, 1e12}) {
      SCOPED_TRACE(testing::Message() << n << " masses, k = " << k);
      const double m = 0.3, a = 0.07, c = 0.05;
      StructuralMatrices joined = chain(n + 1, m, k, false);
      joined.stiffness.coeffRef(0, 0) = joined.stiffness.coeffRef(0, 1) = 0.0;
      joined.stiffness.coeffRef(1, 0) = 0.0;
      joined.mass.coeffRef(0, 0) = a;
      joined.mass.coeffRef(0, 1) = joined.mass.coeffRef(1, 0) = c;
      joined.mass.coeffRef(1, 1) = m + c * c / a;
      const int count = std::min(n + 1, 12);
      const StructuralModes modes = lowest_modes(joined, count);
      EXPECT_EQ(modes.rigid, 1);
      EXPECT_EQ(modes.omega[0], 0.0);
      EXPECT_NEAR(modes.shapes(0, 0) * std::sqrt(a), 1.0, 1e-12);
      EXPECT_EQ(modes.shapes.col(0).tail(n).cwiseAbs().maxCoeff(), 0.0);
      EXPECT_LE(modes.residuals.maxCoeff(), 1e-12);
      for (int j = 1; j < count; ++j) {
        const double exact = 2.0 * std::sqrt(k / m) * std::sin(j * kPi / (2.0 * (n + 1)));
        EXPECT_NEAR(modes.omega[j] / exact, 1.0, 1e-9) << j;
      }
    }
}

// The same of a body of two masses on a soft spring, which is rigid as a whole.
TEST(StructuralModes, SoftBodyJoinedToAStiffStructureByItsMassIsRigid) {
  for (const double soft : {1e-6, 1.0, 1e6}) {
    StructuralMatrices joined = chain(5, 1.0, 1e9, false);
    for (int i = 0; i < 2; ++i) {
      joined.stiffness.coeffRef(i, i) = soft;
      joined.stiffness.coeffRef(i, 1 - i) = -soft;
    }
    joined.stiffness.coeffRef(1, 2) = joined.stiffness.coeffRef(2, 1) = 0.0;
    joined.mass.coeffRef(1, 2) = joined.mass.coeffRef(2, 1) = 0.2;
    const StructuralModes modes = lowest_modes(joined, 5);
    EXPECT_EQ(modes.rigid, 1) << soft;
    EXPECT_NEAR(modes.shapes(0, 0) * std::sqrt(2.0), 1.0, 1e-9) << soft;
    EXPECT_NEAR(modes.shapes(1, 0) * std::sqrt(2.0), 1.0, 1e-9) << soft;
    EXPECT_GT(modes.omega[1], 0.1 * std::sqrt(soft)) << soft;
  }
}

// A frequency far below the rounding of the others is one where no rounding enters it.
TEST(StructuralModes, SlowBodyOfItsOwnKeepsItsFrequency) {
  StructuralMatrices apart = chain(3, 1.0, 0.0, false);
  for (const int i : {0, 1, 2}) apart.stiffness.coeffRef(i, i) = i == 1 ? 1e-24 : 1e6;
  const StructuralModes modes = lowest_modes(apart, 3);
  EXPECT_EQ(modes.rigid, 0);
  EXPECT_NEAR(modes.omega[0] / 1e-12, 1.0, 1e-12);
}

// w_k = 2 sqrt(k/m) sin(k pi/(2 n)), k = 0 .. n - 1.
TEST(StructuralModes, FreeChainHasOneRigidBodyMode) {
  for (const int n : {30, 2000}) {
    const StructuralModes modes = lowest_modes(chain(n, 2.0, 7.0, true), 12);
    EXPECT_EQ(modes.rigid, 1);
    EXPECT_EQ(modes.omega[0], 0.0);
    EXPECT_LE((modes.shapes.col(0).array() * std::sqrt(2.0 * n) - 1.0).abs().maxCoeff(), 1e-9);
    for (int j = 1; j < 12; ++j)
      EXPECT_NEAR(modes.omega[j] / (2.0 * std::sqrt(3.5) * std::sin(j * kPi / (2.0 * n))), 1.0,
                  1e-9)
          << n << " " << j;
  }
}

// Cubic Hermite elements of a cantilever, L = EI = rho A = 1: w_j = (b L)^2 with cos b cosh b = -1
// (Blevins, Formulas for Natural Frequency and Mode Shape, table 8-1). The elements are above it by
// about (b h)^4/720.
StructuralMatrices cantilever(int elements) {
  const double h = 1.0 / elements, h2 = h * h;
  Eigen::Matrix4d k, m;
  k << 12, 6 * h, -12, 6 * h, 6 * h, 4 * h2, -6 * h, 2 * h2, -12, -6 * h, 12, -6 * h, 6 * h, 2 * h2,
      -6 * h, 4 * h2;
  m << 156, 22 * h, 54, -13 * h, 22 * h, 4 * h2, 13 * h, -3 * h2, 54, 13 * h, 156, -22 * h, -13 * h,
      -3 * h2, -22 * h, 4 * h2;
  k /= h * h2;
  m *= h / 420.0;
  LabelledMatrix mass{"mass", {}, {}, true, {}}, stiffness{"stiffness", {}, {}, true, {}};
  for (int node = 1; node <= elements + 1; ++node)
    for (const int direction : {2, 6}) mass.labels.push_back({node, direction});
  stiffness.labels = mass.labels;
  const int n = 2 * (elements + 1);
  mass.matrix.resize(n, n);
  stiffness.matrix.resize(n, n);
  for (int e = 0; e < elements; ++e)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        mass.matrix.coeffRef(2 * e + i, 2 * e + j) += m(i, j);
        stiffness.matrix.coeffRef(2 * e + i, 2 * e + j) += k(i, j);
      }
  return join_matrices(mass, stiffness, nullptr, {{1, 2}, {1, 6}});
}

TEST(StructuralModes, HermiteCantileverIsNearItsClosedForm) {
  const double exact[] = {1.875104068711961, 4.694091132974175, 7.854757438237613,
                          10.99554073487547};
  for (const int elements : {40, 400}) {
    const StructuralModes modes = lowest_modes(cantilever(elements), 4);
    const double h = 1.0 / elements;
    for (int j = 0; j < 4; ++j) {
      const double b = exact[j], error = modes.omega[j] / (b * b) - 1.0;
      // Half the error of the square; rounding is that of the stiffness, which grows as h^-4.
      const double rounding = 2e-16 / std::pow(b * h, 4.0);
      EXPECT_NEAR(error, std::pow(b * h, 4.0) / 1440.0,
                  0.2 * std::pow(b * h, 4.0) / 1440.0 + rounding)
          << elements << " " << j;
    }
    // Static deflection of the tip under a unit force, 1/3, exact by these elements.
    Matrix load = Matrix::Zero(2 * elements, 1);
    load(2 * elements - 2, 0) = 1.0;
    const StructuralModes loaded = lowest_modes(cantilever(elements), 4, load);
    EXPECT_NEAR(loaded.static_displacements(2 * elements - 2, 0), 1.0 / 3.0,
                1e-16 * std::pow(elements, 4.0));
  }
}

// A unit acceleration of the whole loads the held end too: M r is that of the whole matrix.
TEST(StructuralModes, InertiaLoadsHoldTheMassOfTheHeldEnd) {
  const StructuralMatrices structure = cantilever(10);
  EXPECT_NEAR(structure.total_masses.at(2), 1.0, 1e-14);
  // Effective masses of a cantilever: 0.6131, 0.1883, 0.0647 of the whole (Blevins).
  const StructuralModes modes = lowest_modes(structure, 3);
  const Vector gamma = modes.shapes.transpose() * structure.inertia_loads.at(2);
  EXPECT_NEAR(gamma[0] * gamma[0], 0.6131, 1e-4);
  EXPECT_NEAR(gamma[1] * gamma[1], 0.1883, 1e-4);
  EXPECT_NEAR(gamma[2] * gamma[2], 0.0647, 1e-4);
}

TEST(StructuralModes, SolidInFreeFlightHasSixRigidBodyModes) {
  const StructuralMatrices structure = solid::block(7, 8, 9, 0.125, false);
  const StructuralModes modes = lowest_modes(structure, 20);
  ASSERT_FALSE(modes.is_dense);
  EXPECT_EQ(modes.rigid, 6);
  EXPECT_GT(modes.omega[6], 0.1);
  EXPECT_LE(modes.residuals.maxCoeff(), 1e-12);
  const Matrix gram = modes.shapes.transpose() * (structure.mass * modes.shapes);
  EXPECT_LE((gram - Matrix::Identity(20, 20)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(structure.mass.sum(), 3.0 * 6 * 7 * 8 * std::pow(0.125, 3.0), 1e-12);
}

// The flexibility of a free chain with inertia relief is the sum over its elastic modes.
TEST(StructuralModes, FreeStructureHasTheFlexibilityOfItsElasticModes) {
  for (const int n : {20, 700}) {
    const StructuralMatrices structure = chain(n, 2.0, 7.0, true);
    Matrix load = Matrix::Zero(n, 1);
    load(0, 0) = 1.0;
    const StructuralModes modes = lowest_modes(structure, 6, load);
    double sum = 0.0;
    for (int j = 1; j < n; ++j) {
      const double w = 2.0 * std::sqrt(3.5) * std::sin(j * kPi / (2.0 * n));
      const double phi = std::sqrt(2.0 / (2.0 * n)) * std::cos(j * kPi / (2.0 * n));
      sum += phi * phi / (w * w);
    }
    EXPECT_NEAR(modes.static_displacements(0, 0) / sum, 1.0, 1e-9) << n;
  }
}

TEST(StructuralModes, WhatIsNoStructureIsRefused) {
  const auto said = [](const StructuralMatrices& structure, int count) -> std::string {
    try {
      lowest_modes(structure, count);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  for (const int n : {20, 800}) {
    StructuralMatrices indefinite = chain(n, 1.0, 1.0, false);
    indefinite.stiffness.coeffRef(n / 2, n / 2) = -0.5;
    EXPECT_EQ(said(indefinite, 3).substr(0, 41), "stiffness: the stiffness matrix is indefi") << n;
    StructuralMatrices massless = chain(n, 1.0, 1.0, false);
    massless.mass.coeffRef(3, 4) = massless.mass.coeffRef(4, 3) = 2.0;
    EXPECT_EQ(said(massless, 3).substr(0, 46), "mass: the mass matrix is not positive definite")
        << n;
  }
  EXPECT_EQ(said(chain(3, 1.0, 1.0, false), 4),
            "stiffness: 4 modes are asked for, the structure has 3 degrees of freedom that are not "
            "held");
}

TEST(ModalDamping, ProportionalDampingIsRecognised) {
  StructuralMatrices structure = chain(30, 2.0, 7.0, true);
  structure.damping = SparseMatrix(0.3 * structure.mass + 0.02 * structure.stiffness);
  const StructuralModes modes = lowest_modes(structure, 5);
  const ModalDamping damping = modal_damping(structure, modes);
  ASSERT_TRUE(damping.is_proportional);
  EXPECT_NEAR(damping.mass, 0.3, 1e-12);
  EXPECT_NEAR(damping.stiffness, 0.02, 1e-13);
  for (int j = 0; j < 5; ++j)
    EXPECT_NEAR(damping.delta[j], 0.5 * (0.3 + 0.02 * modes.omega[j] * modes.omega[j]), 1e-12);
}

// One dashpot c at an end of a fixed chain: Phi^T C Phi = c phi phi^T, whose entries beside the
// diagonal are as large as the geometric mean of those on it.
TEST(ModalDamping, OneDashpotCouplesAllModes) {
  StructuralMatrices structure = chain(5, 2.0, 7.0, false);
  structure.damping = SparseMatrix(5, 5);
  structure.damping->coeffRef(0, 0) = 0.4;
  const StructuralModes modes = lowest_modes(structure, 5);
  const ModalDamping damping = modal_damping(structure, modes);
  EXPECT_FALSE(damping.is_proportional);
  ASSERT_EQ(damping.coupling.cols(), 5);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      EXPECT_NEAR(std::abs(damping.coupling(i, j)),
                  i == j ? 0.0 : 2.0 * std::sqrt(damping.delta[i] * damping.delta[j]), 1e-13);
  for (int j = 1; j <= 5; ++j)
    EXPECT_NEAR(damping.delta[j - 1], 0.2 * std::pow(std::sin(j * kPi / 6.0), 2.0) / 6.0, 1e-12);
}

}  // namespace
}  // namespace graze
