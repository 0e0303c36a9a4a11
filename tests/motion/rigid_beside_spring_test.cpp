// A rigid stop that the structure leaves while it compresses a linear spring: against the closed
// forms of q'' = L - (W^2 + k c c^T) q + k h c, with spring row c, and of what the stop leaves of
// it.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "graze/motion/simulation.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

constexpr double kStiffness = 50.0, kSpringGap = -0.3;

System rigid_beside_spring(double load) {
  System system{Eigen::Vector2d(1.0, 2.0), NaturalModes{Vector::Zero(2)}, {}};
  system.modal().load = Eigen::Vector2d(load, 0.0);
  const Vector row = Eigen::Vector2d(1.0, 0.4), spring = Eigen::Vector2d(0.5, -1.0);
  system.stops.push_back({row, 0.16, ImpactLaw{momentum_direction(row), 0.5}});
  system.stops.push_back({spring, kSpringGap, ContactForce{kStiffness}});
  return system;
}

struct Stiffened {
  Matrix stiffness;
  Vector load;
};

Stiffened stiffened(const System& system) {
  const Vector& c = system.stops[1].row;
  return {Matrix(system.omega.cwiseAbs2().asDiagonal()) + kStiffness * c * c.transpose(),
          *system.load() + kStiffness * kSpringGap * c};
}

State after(const Stiffened& structure, const State& start, double t) {
  const Eigen::SelfAdjointEigenSolver<Matrix> modes(structure.stiffness);
  const Matrix& v = modes.eigenvectors();
  const Vector rest = structure.stiffness.inverse() * structure.load;
  const Vector a = v.transpose() * (start.q - rest), b = v.transpose() * start.qdot;
  Vector q(a.size()), qdot(a.size());
  for (Eigen::Index j = 0; j < a.size(); ++j) {
    const double w = std::sqrt(modes.eigenvalues()[j]);
    q[j] = a[j] * std::cos(w * t) + b[j] / w * std::sin(w * t);
    qdot[j] = b[j] * std::cos(w * t) - w * a[j] * std::sin(w * t);
  }
  return {rest + v * q, v * qdot};
}

void expect_end(const System& system, const State& start, double t, const State& expected) {
  const Simulation run = simulate(system, start, support::for_seconds(t));
  ASSERT_EQ(run.outcome, RunOutcome::kReachedEnd) << run.message;
  EXPECT_EQ(run.totals.impacts, 0);
  EXPECT_LE((run.final.q - expected.q).norm(), 1e-12);
  EXPECT_LE((run.final.qdot - expected.qdot).norm(), 1e-11);
}

// Without the spring it would be pressed on the stop.
TEST(RigidBesideSpring, LeavesFromRestWhereTheSpringPushes) {
  const System system = rigid_beside_spring(1.0);
  const State start{Eigen::Vector2d(0.2, -0.1), Eigen::Vector2d(0.0, 0.0)};
  ASSERT_NEAR(system.stops[0].row.dot(start.q), system.stops[0].gap, 1e-15);
  const Vector& row = system.stops[0].row;
  ASSERT_GT(row.dot(*system.load() - system.omega.cwiseAbs2().cwiseProduct(start.q)), 0.5);
  const Stiffened structure = stiffened(system);
  ASSERT_LT(row.dot(structure.load - structure.stiffness * start.q), -0.5);
  expect_end(system, start, 0.1, after(structure, start, 0.1));
}

// Held on the stop it slides along u, u.b = 0, further into the spring, until that lifts it off.
TEST(RigidBesideSpring, IsReleasedWhereTheSpringLiftsItOff) {
  const System system = rigid_beside_spring(3.0);
  const Vector& row = system.stops[0].row;
  const Vector along = Eigen::Vector2d(0.4, -1.0) / row.norm();
  const State start{Eigen::Vector2d(0.2, -0.1), 4.0 * along};
  const Stiffened structure = stiffened(system);
  const auto push = [&](const State& at) {
    return row.dot(structure.load - structure.stiffness * at.q);
  };
  const double stiffness = along.dot(structure.stiffness * along), w = std::sqrt(stiffness);
  const double a = along.dot(structure.stiffness * start.q - structure.load) / stiffness;
  const auto held = [&](double t) {
    const double y = a * (std::cos(w * t) - 1.0) + 4.0 / w * std::sin(w * t);
    const double rate = -w * a * std::sin(w * t) + 4.0 * std::cos(w * t);
    return State{start.q + y * along, rate * along};
  };
  double from = 0.0, to = 0.5 / w;
  ASSERT_GT(push(held(from)), 0.1);
  ASSERT_LT(push(held(to)), -0.1);
  for (int i = 0; i < 100; ++i)
    (push(held(0.5 * (from + to))) > 0.0 ? from : to) = 0.5 * (from + to);
  expect_end(system, start, from + 0.05, after(structure, held(from), 0.05));
}

}  // namespace
}  // namespace graze
