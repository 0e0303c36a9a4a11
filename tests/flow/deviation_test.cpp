// Growth of deviations along free and held arcs, against central differences in 50 digits; they are
// accurate relative to themselves, however short the flight.
#include "graze/flow/variation/detail/deviation.hpp"
#include "graze/flow/detail/phase_choice.hpp"

#include <gtest/gtest.h>

#include "graze/flow/exact/extended.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

using Real = Extended;
using support::Dice;

struct Start {
  double theta = 0.0;
  Vector q, qdot;
};

// (d end/d start - 1) x + (d end/d start instant) delay by central differences of error 1e-24.
Deviations differenced(const System& system, const std::vector<int>& closed, const Start& start,
                       double s, const Deviations& deviations) {
  const Eigen::Index n = system.modes();
  const auto phase = make_contact_phase<Real>(system, {closed});
  Deviations change{Matrix(n, deviations.count()), Matrix(n, deviations.count()),
                    Eigen::RowVectorXd::Zero(deviations.count())};
  const Real h = 1e-12;
  for (Eigen::Index i = 0; i < deviations.count(); ++i) {
    const RealVector<Real> dq = deviations.q.col(i).cast<Real>(),
                           dqdot = deviations.qdot.col(i).cast<Real>();
    const auto end = [&](const Real& step) {
      const RealVector<Real> q = start.q.cast<Real>() + step * dq,
                             qdot = start.qdot.cast<Real>() + step * dqdot;
      phase->start(start.theta + Real(system.forcing()->frequency) * step * deviations.delay[i], q,
                   qdot);
      RealVector<Real> state(2 * n), end_q(n), end_qdot(n);
      phase->state(Real(s), end_q, end_qdot);
      state << end_q, end_qdot;
      return state;
    };
    const RealVector<Real> rate = (end(h) - end(-h)) / (2 * h);
    change.q.col(i) = RealVector<Real>(rate.head(n) - dq).cast<double>();
    change.qdot.col(i) = RealVector<Real>(rate.tail(n) - dqdot).cast<double>();
  }
  return change;
}

// Deviations of displacement, of velocity and of the instant apart: each has its own size.
Deviations unit_deviations(Dice& dice, int modes) {
  Deviations d{Matrix::Zero(modes, 3), Matrix::Zero(modes, 3), Eigen::RowVectorXd::Zero(3)};
  d.q.col(0) = dice.vector(modes, -1.0, 1.0);
  d.qdot.col(1) = dice.vector(modes, -1.0, 1.0);
  d.delay[2] = 1.0;
  return d;
}

double miss(const Matrix& a, const Matrix& b) {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    if (b.col(i).norm() > 0.0)
      worst = std::max(worst, (a.col(i) - b.col(i)).norm() / b.col(i).norm());
  return worst;
}

TEST(Deviation, GrowsAsIn50DigitsOverAnyFlight) {
  Dice dice(3);
  for (int draw = 0; draw < 40; ++draw) {
    SCOPED_TRACE(draw);
    const bool held = draw % 2 == 1;
    const int modes = (held ? 2 : 1) + dice.pick(3);
    System system = support::random_system(dice, modes, 0.3);
    // Real modes while held, so that the extended scalar can follow.
    if (held) system.modal().delta.setConstant(dice.uniform(0.0, 0.3));
    const std::vector<int> closed = held ? std::vector<int>{0} : std::vector<int>{};
    Start start{dice.uniform(0.0, 6.0), dice.vector(modes, -1.0, 1.0),
                dice.vector(modes, -1.0, 1.0)};
    Deviations deviations = unit_deviations(dice, modes);
    hold(system, closed, deviations);
    const auto made = make_contact_phase<double>(system, {closed});
    made->start(start.theta, start.q, start.qdot);
    const ExactPhase<double>& phase = *made->exact();
    for (const double s : {1e-9, 1e-6, 1e-3, 0.1, 0.7, 3.0}) {
      const Deviations found = growth(phase, s, deviations);
      Deviations expected = differenced(system, closed, start, s, deviations);
      // The start fits the closed stop to double rounding only, which is no growth.
      hold(system, closed, expected);
      // A long flight meets a mode 1e-4 off resonance by its harmonic response, 1e4 of its force.
      const double tolerance = s <= 0.1 ? 1e-12 : 1e-10;
      EXPECT_LE(miss(found.q, expected.q), tolerance) << "s " << s;
      EXPECT_LE(miss(found.qdot, expected.qdot), tolerance) << "s " << s;
    }
  }
}

// Damping ratios of their own: complex modes while held. Two halves make the whole.
TEST(Deviation, GrowsThroughComplexModesInSteps) {
  Dice dice(5);
  for (int draw = 0; draw < 10; ++draw) {
    System system = support::random_system(dice, 4, 0.3);
    system.omega = (Vector(4) << 1.0, 2.3, 4.1, 6.0).finished();
    system.modal().delta = 0.2 * dice.vector(4, 0.0, 1.0).cwiseProduct(system.omega);
    const auto made = make_contact_phase<double>(system, {{0}});
    const ExactPhase<double>& phase = *made->exact();
    Deviations start = unit_deviations(dice, 4);
    hold(system, {0}, start);
    const Vector zero = Vector::Zero(4);
    for (const double s : {1e-6, 0.4, 2.0}) {
      made->start(0.3, zero, zero);
      const Deviations whole = growth(phase, s, start);
      Deviations half = start;
      for (const double begun : {0.0, 0.5 * s}) {
        made->start(0.3 + system.forcing()->frequency * begun, zero, zero);
        const Deviations change = growth(phase, 0.5 * s, half);
        half.q += change.q;
        half.qdot += change.qdot;
      }
      EXPECT_LE((half.q - start.q - whole.q).norm(), 1e-13 * (1.0 + whole.q.norm()));
      EXPECT_LE((half.qdot - start.qdot - whole.qdot).norm(), 1e-13 * (1.0 + whole.qdot.norm()));
    }
  }
}

// Moving the instant along the motion is what a later start amounts to.
TEST(Deviation, OfTheInstantIsAlongTheMotion) {
  Dice dice(9);
  const System system = support::random_system(dice, 3, 0.3);
  const Start start{0.4, dice.vector(3, -1.0, 1.0), dice.vector(3, -1.0, 1.0)};
  for (const std::vector<int>& closed : {std::vector<int>{}, std::vector<int>{0}}) {
    const auto made = make_contact_phase<double>(system, {closed});
    made->start(start.theta, start.q, start.qdot);
    const ExactPhase<double>& phase = *made->exact();
    State begin{Vector(3), Vector(3)}, end = begin;
    phase.state(0.0, begin.q, begin.qdot);
    phase.state(1.7, end.q, end.qdot);
    Deviations moved{Matrix::Zero(3, 1), Matrix::Zero(3, 1), Eigen::RowVectorXd::Zero(1)};
    move_instant(moved, held_rate(system, closed, begin, start.theta), Eigen::RowVectorXd::Ones(1));
    const Deviations change = growth(phase, 1.7, moved);
    const State rate =
        held_rate(system, closed, end, start.theta + 1.7 * system.forcing()->frequency);
    EXPECT_LE((moved.q + change.q - rate.q).norm(), 1e-12 * (1.0 + rate.q.norm()));
    EXPECT_LE((moved.qdot + change.qdot - rate.qdot).norm(), 1e-12 * (1.0 + rate.qdot.norm()));
  }
}

}  // namespace
}  // namespace graze
