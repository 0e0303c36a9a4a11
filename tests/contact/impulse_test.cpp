// The impulse laws: their identities, their energy, and what they do to the collocation points.
#include "graze/contact/detail/impulse.hpp"
#include "graze/assembly/assembly.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

#include "graze/structure/modal_model.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::Dice;

Vector after(const Vector& row, const Vector& direction, const Vector& before, double r) {
  return before - (1.0 + r) * row.dot(before) * direction;
}

TEST(Impulse, TurnsTheApproachSpeedRound) {
  Dice dice(1);
  for (int i = 0; i < 1000; ++i) {
    const int n = 1 + dice.pick(8);
    const Vector row = dice.vector(n, -2.0, 2.0), before = dice.vector(n, -1.0, 1.0);
    const double r = dice.uniform(0.0, 1.0);
    const Vector direction = momentum_direction(row);
    EXPECT_NEAR(row.dot(direction), 1.0, 1e-15);
    EXPECT_NEAR(row.dot(after(row, direction, before, r)), -r * row.dot(before), 1e-14);
    // What the contact does not touch goes on: a velocity with row.q' = 0.
    const Vector along = before - row.dot(before) * direction;
    EXPECT_LE((after(row, direction, along, r) - along).norm(), 1e-14);
  }
}

TEST(Impulse, MomentumLawLosesItsShareOfEnergy) {
  // -(1 - r^2) v^2 m_eff/2 with m_eff = 1/(b.b), in 1e5 random states.
  Dice dice(2);
  for (int i = 0; i < 100'000; ++i) {
    const int n = 1 + dice.pick(8);
    const Vector row = dice.vector(n, -2.0, 2.0), before = dice.vector(n, -1.0, 1.0);
    const double r = dice.uniform(0.0, 1.0), v = row.dot(before);
    const double expected = -0.5 * (1.0 - r * r) * v * v / row.squaredNorm();
    const double change = impact_energy_change(row, momentum_direction(row), before, r);
    EXPECT_NEAR(change, expected, 1e-14 * std::max(1.0, before.squaredNorm()));
  }
}

TEST(Impulse, EnergyChangeIsThatOfTheVelocities) {
  Dice dice(3);
  for (int i = 0; i < 10'000; ++i) {
    const Vector row = dice.vector(4, -2.0, 2.0), before = dice.vector(4, -1.0, 1.0);
    Vector direction = momentum_direction(row) + dice.vector(4, -0.2, 0.2);
    direction /= row.dot(direction);
    const double r = dice.uniform(0.0, 1.0);
    const Vector velocities = after(row, direction, before, r);
    const double change = 0.5 * (velocities.squaredNorm() - before.squaredNorm());
    EXPECT_NEAR(impact_energy_change(row, direction, before, r), change,
                1e-14 * (1.0 + velocities.squaredNorm()));
  }
}

Scene collocated(int modes, const std::string& side, const std::string& more = "") {
  return support::shipped_scene(
      "01_wagg_2004", {"beam.modes=" + std::to_string(modes), "stop.side=" + side + more});
}

// Phi q' are the velocities of the points: the law reverses that of the stop's point with the
// factor r and keeps all others, on either side.
TEST(Impulse, CollocationLawIsPhiInverseRPhi) {
  Dice dice(4);
  for (const char* side : {"\"above\"", "\"below\""}) {
    for (int modes = 1; modes <= 12; ++modes) {
      const Scene scene = collocated(modes, side);
      const Matrix phi = modal_model(scene).collocation;
      const System system = assemble(scene);
      const Stop& stop = system.stops[0];
      EXPECT_NEAR(stop.row.dot(stop.direction()), 1.0, 1e-14);
      for (int i = 0; i < 100; ++i) {
        const Vector before = dice.vector(modes, -1.0, 1.0);
        Vector points = phi * before;
        points[modes - 1] *= -stop.restitution().at_rest();
        const Vector moved =
            phi * after(stop.row, stop.direction(), before, stop.restitution().at_rest());
        EXPECT_LE((moved - points).norm(), 1e-13 * points.norm());
      }
    }
  }
}

TEST(Impulse, WorstGainsOfTheCollocationLawAreThePrintedOnes) {
  // The catalogue of hard cases: r = .8, stop at the tip.
  const auto gain = [](int modes) {
    const Stop stop = assemble(collocated(modes, "\"below\"")).stops[0];
    return worst_energy_gain(stop.row, stop.direction(), stop.restitution().at_rest());
  };
  EXPECT_NEAR(gain(1), 1.0, 1e-14);
  EXPECT_NEAR(gain(2), 1.664358, 5e-7);
  EXPECT_NEAR(gain(5), 1.725385, 5e-7);
}

TEST(Impulse, WorstGainIsTheLargestEigenvalueOfTheJump) {
  Dice dice(5);
  for (int i = 0; i < 500; ++i) {
    const int n = 2 + dice.pick(6);
    const Vector row = dice.vector(n, -2.0, 2.0);
    Vector direction = momentum_direction(row) + dice.vector(n, -0.3, 0.3);
    direction /= row.dot(direction);
    const double r = dice.uniform(0.0, 1.0);
    const Matrix jump = Matrix::Identity(n, n) - (1.0 + r) * direction * row.transpose();
    const double expected =
        (jump.transpose() * jump).eval().selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
    EXPECT_NEAR(worst_energy_gain(row, direction, r) / expected, 1.0, 1e-12);
  }
}

TEST(Impulse, WorstGainIsReachedAndNotExceeded) {
  Dice dice(6);
  const Stop stop = assemble(collocated(4, "\"below\"")).stops[0];
  const double worst = worst_energy_gain(stop.row, stop.direction(), stop.restitution().at_rest());
  const Matrix jump = Matrix::Identity(4, 4) - (1.0 + stop.restitution().at_rest()) *
                                                   stop.direction() * stop.row.transpose();
  const Eigen::JacobiSVD<Matrix> svd(jump, Eigen::ComputeFullV);
  const Vector worst_state = svd.matrixV().col(0);
  EXPECT_NEAR((jump * worst_state).squaredNorm(), worst, 1e-13);
  for (int i = 0; i < 1000; ++i) {
    const Vector before = dice.vector(4, -1.0, 1.0);
    EXPECT_LE((jump * before).squaredNorm(), worst * before.squaredNorm() * (1.0 + 1e-14));
  }
}

TEST(Impulse, MomentumLawNeverGains) {
  Dice dice(7);
  for (int i = 0; i < 1000; ++i) {
    const Vector row = dice.vector(1 + dice.pick(8), -2.0, 2.0);
    EXPECT_NEAR(worst_energy_gain(row, momentum_direction(row), dice.uniform(0.0, 1.0)), 1.0,
                1e-7);  // a double eigenvalue: the square root of rounding
  }
}

TEST(Impulse, DirectionRatesAreDerivatives) {
  Dice dice(8);
  for (int i = 0; i < 50; ++i) {
    const Vector row = dice.vector(4, 0.5, 2.0), row_rate = dice.vector(4, -1.0, 1.0);
    const Vector difference = support::central_difference(
        [&](double h) { return momentum_direction(row + h * row_rate); }, 0.0, 1e-3);
    EXPECT_LE((momentum_direction_rate(row, row_rate) - difference).norm(), 1e-9);

    const Matrix phi = Matrix::Identity(4, 4) * 2.0 + dice.vector(16, -0.4, 0.4).reshaped(4, 4);
    const Matrix phi_rate = dice.vector(16, -1.0, 1.0).reshaped(4, 4);
    for (int point = 0; point < 4; ++point) {
      const Vector slope = support::central_difference(
          [&](double h) { return collocation_direction(phi + h * phi_rate, point, -1.0); }, 0.0,
          1e-3);
      const Vector direction = collocation_direction(phi, point, -1.0);
      EXPECT_LE((collocation_direction_rate(phi, phi_rate, direction) - slope).norm(), 1e-9);
    }
  }
}

}  // namespace
}  // namespace graze
