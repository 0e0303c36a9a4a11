// Forces, inertia and powers of a structure on a hub, against each other and against differences.
#include "graze/flow/turning/detail/turning.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include <cmath>
#include <random>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "support/hub_scene.hpp"

namespace graze {
namespace {

System strip(bool weight = true) {
  Scene scene = support::strip_on_hub(3);
  scene.damping = RayleighDamping{0.5, 1e-4};
  if (weight) scene.gravity = Gravity{9.81};
  scene.hub->torque = TorqueTable{{0.0, 1.0}, {0.2, 0.7}};
  return assemble(scene);
}

struct Somewhere {
  Vector y, velocity;
};

Somewhere somewhere(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Somewhere at{Vector(4), Vector(4)};
  for (int j = 0; j < 4; ++j) {
    at.y[j] = (j == 0 ? 0.1 : 0.005) * normal(random);
    at.velocity[j] = (j == 0 ? 1.0 : 0.3) * normal(random);
  }
  return at;
}

// d/dt (kinetic + elastic + weight's energy) = torque's power - dissipation, at any state.
TEST(TurningStructure, PowersBalance) {
  const System system = strip();
  TurningStructure structure(system);
  structure.begin(0.3);
  std::mt19937_64 random(7);
  for (int i = 0; i < 50; ++i) {
    const Somewhere s = somewhere(random);
    const TurningMotion at{s.y, s.velocity};
    const Vector a = structure.accelerated(structure.force(at, 0.1), s.y);
    const double rate = structure.rate(s.velocity);
    const double growth = s.velocity.dot(a) +
                          structure.added_inertia(s.y) * rate * structure.rate(a) +
                          0.5 * structure.added_inertia_rate(at) * rate * rate +
                          s.y.dot(system.omega.cwiseAbs2().cwiseProduct(s.velocity));
    const double powers =
        structure.torque_power(at, 0.1) + structure.weight_power(at) - structure.dissipation(at);
    const double size = structure.force_size(at, 0.1).dot(s.velocity.cwiseAbs());
    EXPECT_NEAR(growth, powers, 1e-13 * size);
    // The torque is on its way from 0.2 to 0.7 N m.
    EXPECT_NEAR(structure.torque_power(at, 0.1), (0.2 + 0.5 * 0.4) * rate, 1e-14 * std::abs(rate));
  }
}

// M^-1 is that of the matrix itself.
TEST(TurningStructure, InverseOfOneDyad) {
  const System system = strip();
  const TurningStructure structure(system);
  std::mt19937_64 random(3);
  const Somewhere s = somewhere(random);
  const Vector& e = system.rotation()->angle;
  const Matrix mass = Matrix::Identity(4, 4) + structure.added_inertia(s.y) * e * e.transpose();
  const Vector f = Vector::LinSpaced(4, -1.0, 2.0);
  EXPECT_LT((mass * structure.accelerated(f, s.y) - f).norm(), 1e-14 * f.norm());
  EXPECT_NEAR(mobility(*system.rotation(), f, s.y), f.dot(LuFactors(mass).solve(f)),
              1e-14 * f.squaredNorm());
}

// Rates along the motion against central differences of the values, extrapolated once.
TEST(TurningStructure, RatesAreThoseOfTheMotion) {
  const System system = strip();
  TurningStructure structure(system);
  structure.begin(0.0);
  std::mt19937_64 random(11);
  for (int i = 0; i < 10; ++i) {
    const Somewhere s = somewhere(random);
    const TurningMotion at{s.y, s.velocity};
    const Vector a = structure.accelerated(structure.force(at, 0.5), s.y);
    const auto force_at = [&](double h) {
      const Vector y = s.y + h * s.velocity + 0.5 * h * h * a, v = s.velocity + h * a;
      return structure.force({y, v}, 0.5 + h);
    };
    const auto slope = [&](double h) { return Vector((force_at(h) - force_at(-h)) / (2.0 * h)); };
    const double h = 1e-5;
    const Vector expected = (4.0 * slope(0.5 * h) - slope(h)) / 3.0;
    const Vector found = structure.force_rate(at, a);
    EXPECT_LT((found - expected).norm(), 1e-7 * found.norm());
  }
}

// Held at two places the free coordinates obey M y'' = h - B f with B.y'' = 0.
TEST(TurningStructure, HoldsHoldWhatTheyHold) {
  Scene scene = support::strip_on_hub(4);
  scene.gravity = Gravity{9.81};
  scene.stops = {support::stop_at(0.3, 0.0, 0.0), support::stop_at(0.6, 0.0, 0.0)};
  const System system = assemble(scene);
  Matrix rows(5, 2);
  rows << system.stops[0].row, system.stops[1].row;
  const Matrix q = Eigen::HouseholderQR<Matrix>(rows).householderQ() * Matrix::Identity(5, 5);
  const Turning turning{TurningStructure(system), Vector::Zero(5), q.rightCols(3),
                        LuFactors(rows.transpose() * rows).inverse() * rows.transpose()};
  const Vector y = q.rightCols(3) * Vector::LinSpaced(3, 0.001, 0.01);
  const Vector v = q.rightCols(3) * Vector::LinSpaced(3, -0.3, 1.0);
  const Vector force = turning.structure.force({y, v}, 0.0);
  const Vector a = turning.acceleration(force, y), f = turning.hold_forces(force, y);
  EXPECT_LT((rows.transpose() * a).norm(), 1e-13 * a.norm());
  const Vector inertial =
      a + turning.structure.added_inertia(y) * turning.structure.rate(a) * system.rotation()->angle;
  EXPECT_LT((inertial - force + rows * f).norm(), 1e-12 * force.norm());
}

}  // namespace
}  // namespace graze
