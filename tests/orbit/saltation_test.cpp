// Saltation and monodromy matrices: determinant, central differences of the simulated map, fold.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/base/angle.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/detail/saltation.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "graze/system/scale.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

Vector stacked(const State& state) {
  Vector y(2 * state.q.size());
  y << state.q, state.qdot;
  return y;
}

// Simulates from forcing phase `theta` over `turn` of phase; counts the impacts.
Vector simulated(const System& system, const Vector& y, double theta, double turn, int* impacts) {
  const Eigen::Index n = system.modes();
  const double frequency = system.forcing()->frequency;
  // The clock starts anew at `theta`, so that the section may stand anywhere in a period.
  System shifted = system;
  shifted.modal().forcing->phase = theta;
  Motion<double> motion(shifted, {}, y.head(n), y.tail(n));
  const double end = turn / frequency, period = motion.flow().period();
  *impacts = 0;
  while (true) {
    const double passed = static_cast<double>(motion.instant().period) * period;
    const double until = std::min(period, end - passed);
    if (!(motion.instant().local < until)) break;
    const Arrival<double> arrival = motion.fly(until);
    if (arrival.kind == ArrivalKind::kContact) {
      motion.impact();
      ++*impacts;
    } else if (arrival.kind != ArrivalKind::kTime) {
      ADD_FAILURE() << "no impact and no flight";
      break;
    }
    if (static_cast<double>(motion.instant().period) * period + motion.instant().local >=
        end * (1.0 - 1e-15))
      break;
  }
  return stacked({motion.q(), motion.qdot()});
}

// From a section a little before the impact, over the whole orbit to the same phase: the product
// of flow to the impact, saltation and flow, against differences of the simulation.
void expect_monodromy(const System& system, int period, const ImpactPoint& point) {
  const double lead = 0.25;  // rad before the impact
  const double frequency = system.forcing()->frequency;
  const ExactFlow<double> flow(system);
  const Transition back = transition(system, flow, point.before, point.theta, -lead / frequency);
  const Eigen::Index n = system.modes();
  const Matrix identity = Matrix::Identity(2 * n, 2 * n);
  const Transition to_impact =
      transition(system, flow, back.end, point.theta - lead, lead / frequency);
  const Matrix m = monodromy_matrix(system, {period, {0}}, {point});
  // M acts from impact to impact: M_section = E^-1 M E.
  const Matrix expected = back.flow.times(m * to_impact.flow.times(identity));

  const MotionScale scale = motion_scale(system);
  Vector unit(2 * n);
  unit << Vector::Constant(n, scale.displacement), scale.velocity;
  const Vector y = stacked(back.end);
  int impacts = 0;
  const Vector end = simulated(system, y, point.theta - lead, kTurn * period, &impacts);
  ASSERT_EQ(impacts, 1);
  EXPECT_LE((end - y).cwiseQuotient(unit).norm(), 1e-10 * (1.0 + m.norm()));
  const Matrix differences = support::central_jacobian(
      [&](const Vector& scaled) {
        return Vector(simulated(system, scaled.cwiseProduct(unit), point.theta - lead,
                                kTurn * period, &impacts)
                          .cwiseQuotient(unit));
      },
      y.cwiseQuotient(unit), Vector::Constant(2 * n, 1e-5));
  const Matrix scaled = unit.cwiseInverse().asDiagonal() * expected * unit.asDiagonal();
  EXPECT_LE((differences - scaled).cwiseAbs().maxCoeff() / scaled.cwiseAbs().maxCoeff(), 1e-7);
}

TEST(Saltation, MonodromyIsTheDerivativeOfTheSimulatedMap) {
  int compared = 0;
  const auto clearances = support::read_table("closed_form_clearances.csv");
  const auto orbits = support::read_table("closed_form_orbits.csv");
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    const std::string& clearance = clearances[i].at("clearance");
    if (!clearance.empty() && std::stod(clearance) < 0.0) continue;
    const double speed = support::number(orbits[i], "speed");
    if (speed < 1e-3) continue;
    SCOPED_TRACE(orbits[i].at("case") + " at " + orbits[i].at("phase"));
    const System system = assemble(support::reference_scene("orbits/" + orbits[i].at("case")));
    const int period = std::stoi(orbits[i].at("period"));
    for (const ImpactPoint& point :
         closed_form(system, 0, period).form->solutions(system.stops[0].gap)) {
      if (std::abs(point.theta - support::number(orbits[i], "phase")) > 1e-6) continue;
      ++compared;
      expect_monodromy(system, period, point);
    }
  }
  EXPECT_GE(compared, 9);
}

TEST(Saltation, DeterminantIsThatOfTheImpactLaw) {
  support::Dice dice(11);
  for (int i = 0; i < 1000; ++i) {
    const int n = 1 + dice.pick(5);
    System system{dice.vector(n, 0.5, 9.0), NaturalModes{dice.vector(n, 0.0, 1.0)}, {}};
    system.modal().forcing = HarmonicForcing{1.7, 0.3, dice.vector(n, -1.0, 1.0)};
    const Vector row = dice.vector(n, -2.0, 2.0);
    const double r = dice.uniform(0.1, 1.0);
    // Any direction with row.direction = 1, oblique ones included.
    Vector direction = momentum_direction(row) + dice.vector(n, -0.3, 0.3);
    direction /= row.dot(direction);
    const State before{dice.vector(n, -1.0, 1.0), dice.vector(n, -1.0, 1.0)};
    const double v = row.dot(before.qdot);
    if (std::abs(v) < 0.1 || direction.norm() > 5.0) continue;
    const Matrix s = saltation_matrix(system, {row, 0.5, ImpactLaw{direction, r}}, before, 0.9);
    // det J = -r, and a change of clock multiplies it by (c f+)/(c f-) = -r.
    EXPECT_NEAR(s.determinant(), r * r, 1e-15 * std::pow(s.norm(), 2) + 1e-12);
  }
}

TEST(Saltation, DeterminantOfARestitutionThatDependsOnTheSpeed) {
  // det S = r (r + v r'(v))
  support::Dice dice(13);
  for (int i = 0; i < 200; ++i) {
    const int n = 1 + dice.pick(4);
    System system{dice.vector(n, 0.5, 9.0), NaturalModes{dice.vector(n, 0.0, 1.0)}, {}};
    system.modal().forcing = HarmonicForcing{1.7, 0.3, dice.vector(n, -1.0, 1.0)};
    const Vector row = dice.vector(n, -2.0, 2.0);
    const double a0 = dice.uniform(0.7, 1.0), a1 = dice.uniform(0.0, 0.2);
    const State before{dice.vector(n, -1.0, 1.0), dice.vector(n, -1.0, 1.0)};
    const double v = row.dot(before.qdot);
    if (v < 0.1) continue;
    const Stop stop{row, 0.5,
                    ImpactLaw{momentum_direction(row), Restitution(std::vector<double>{a0, a1})}};
    const Matrix s = saltation_matrix(system, stop, before, 0.9);
    const double r = a0 - a1 * v;
    EXPECT_NEAR(s.determinant(), r * (r - v * a1), 1e-15 * std::pow(s.norm(), 2) + 1e-12);
  }
}

TEST(Saltation, CarriesTheVectorFieldAcross) {
  // A shift in time along the motion before becomes the same shift along the motion after.
  support::Dice dice(12);
  const Vector row = dice.vector(3, -2.0, 2.0);
  System system{dice.vector(3, 0.5, 9.0), NaturalModes{dice.vector(3, 0.0, 1.0)}, {}};
  system.modal().forcing = HarmonicForcing{1.7, 0.0, dice.vector(3, -1.0, 1.0)};
  const Stop stop{row, 0.5, ImpactLaw{momentum_direction(row), 0.6}};
  const State before{dice.vector(3, -1.0, 1.0), dice.vector(3, -1.0, 1.0)};
  const Matrix s = saltation_matrix(system, stop, before, 2.1);
  const Vector from = stacked(vector_field(system, before, 2.1));
  const Vector to = stacked(vector_field(system, after_impact(stop, before), 2.1));
  EXPECT_LE((s * from - to).norm(), 1e-12 * s.norm() * from.norm());
}

}  // namespace
}  // namespace graze
