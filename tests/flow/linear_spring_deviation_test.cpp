// Derivatives by parameters over an arc on linear springs in closed form, against those that are
// integrated with a motion over springs of the exponent 1 + eps, which are not linear.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "graze/flow/sprung/detail/linear_spring_phase.hpp"
#include "graze/flow/sprung/detail/sprung_phase.hpp"
#include "graze/flow/variation/detail/sprung_deviation.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

// Rates of every number, with the exponents left alone.
System random_tangent(const System& system, support::Dice& dice) {
  const int n = system.modes();
  System tangent{dice.vector(n, -1.0, 1.0), NaturalModes{dice.vector(n, -0.1, 0.1)}, {}};
  tangent.modal().forcing =
      HarmonicForcing{dice.uniform(-1.0, 1.0), 0.0, dice.vector(n, -1.0, 1.0)};
  tangent.modal().load = dice.vector(n, -1.0, 1.0);
  for (const Stop& stop : system.stops) {
    ContactForce rate = stop.force();
    rate.exponent = 0.0;
    rate.stiffness *= dice.uniform(-1.0, 1.0);
    rate.coefficient *= dice.uniform(-1.0, 1.0);
    tangent.stops.push_back({dice.vector(n, -1.0, 1.0), dice.uniform(-1.0, 1.0), rate});
  }
  return tangent;
}

TEST(LinearSpringDeviation, ByParametersIsThatOfSteps) {
  support::Dice dice(35);
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 1 + dice.pick(5);
    System system = support::random_system(dice, n, 0.1);
    system.modal().load = dice.vector(n, -1.0, 1.0);
    system.stops.push_back(system.stops[0]);
    system.stops[1].row = dice.vector(n, -1.0, 1.0);
    for (Stop& stop : system.stops) {
      ContactForce law;
      law.stiffness = std::pow(10.0, dice.uniform(1.0, 4.0));
      if (dice.pick(2) == 0) {
        law.damping = ContactDamping::kConstant;
        law.coefficient = dice.uniform(0.0, 0.5) * std::sqrt(law.stiffness);
      }
      stop.law = law;
    }
    const System tangent = random_tangent(system, dice);
    System bent = system;
    for (Stop& stop : bent.stops)
      stop.force().exponent = 1.0 + std::numeric_limits<double>::epsilon();
    const PhaseKey key{{}, {trial % 2 == 0 ? std::vector<int>{0, 1} : std::vector<int>{1}, {}}};
    // Beyond the surfaces of both, so that they act.
    State start{dice.vector(n, -1.0, 1.0), dice.vector(n, -1.0, 1.0)};
    for (const Stop& stop : system.stops)
      start.q += stop.row * (0.2 - stop.row.dot(start.q)) / stop.row.squaredNorm();
    const double theta = dice.uniform(0.0, 6.0), s = dice.uniform(0.001, 0.2);
    LinearSpringPhase exact(system, key);
    SprungPhase steps(bent, key, {});
    exact.start(theta, start.q, start.qdot);
    steps.start(theta, start.q, start.qdot);
    const Deviations column{dice.vector(n, -1.0, 1.0), dice.vector(n, -1.0, 1.0),
                            Eigen::RowVectorXd::Zero(1)};
    const std::optional<Deviations> closed = linear_spring_parameter_deviation(
        system, tangent, *exact.sprung(), start, theta, s, column);
    ASSERT_TRUE(closed) << trial;
    EXPECT_FALSE(
        linear_spring_parameter_deviation(bent, tangent, *steps.sprung(), start, theta, s, column));
    const Deviations other =
        sprung_parameter_deviation(bent, tangent, *steps.sprung(), start, theta, s, column);
    const double size = other.q.norm() + other.qdot.norm();
    EXPECT_LT((closed->q - other.q).norm(), 1e-9 * size) << trial;
    EXPECT_LT((closed->qdot - other.qdot).norm(), 1e-9 * size) << trial;
  }
}

}  // namespace
}  // namespace graze
