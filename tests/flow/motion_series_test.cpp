// Power series of many modes, free and held: against closed forms, the motion in modes and the
// search of single gaps.
#include "graze/flow/series/detail/motion_series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "graze/contact/detail/impulse.hpp"
#include "graze/flow/held/detail/flight_search.hpp"
#include "graze/flow/held/detail/held_exactly.hpp"
#include "graze/flow/held/detail/series_phase.hpp"
#include "graze/flow/variation/arc_work.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

using support::Dice;

// A string of many modes over stops: frequencies nearly harmonic, losses of their own.
System string_over(Dice& dice, int modes, int stops, bool forced) {
  System system{Vector(modes), NaturalModes{Vector(modes)}, {}};
  for (int j = 0; j < modes; ++j) {
    const double n = j + 1.0, w = system.omega[j] = n * std::sqrt(1.0 + 1e-4 * n * n);
    system.modal().delta[j] = dice.uniform(1e-4, 1e-2) * w;
  }
  if (forced) system.modal().forcing = HarmonicForcing{1.3, 0.4, dice.vector(modes, -0.2, 0.2)};
  for (int i = 0; i < stops; ++i) {
    Vector row(modes);
    const double x = std::numbers::pi * (i + 1.0) / (stops + 1.5);
    for (int j = 0; j < modes; ++j) row[j] = std::sin((j + 1.0) * x);
    system.stops.push_back({row, 0.3, ImpactLaw{momentum_direction(row), 0.9}});
  }
  return system;
}

// Rounds off like the string does: by the cube of the mode.
State plucked(Dice& dice, const System& system) {
  State state{dice.vector(system.modes(), -1.0, 1.0), dice.vector(system.modes(), -1.0, 1.0)};
  for (int j = 0; j < system.modes(); ++j) {
    state.q[j] *= 0.4 * std::pow(j + 1.0, -2.0);
    state.qdot[j] *= 0.4 * std::pow(j + 1.0, -1.0);
  }
  return state;
}

double energy(const System& system, const Vector& q, const Vector& qdot) {
  return 0.5 * (qdot.squaredNorm() + system.omega.cwiseProduct(q).squaredNorm());
}

TEST(FirstZero, OfTheCosineIsAQuarterTurn) {
  std::vector<double> cosine(17, 0.0);
  double factorial = 1.0;
  for (int k = 0; k <= 16; ++k) {
    if (k > 0) factorial *= k;
    if (k % 2 == 0) cosine[static_cast<std::size_t>(k)] = (k % 4 == 0 ? 1.0 : -1.0) / factorial;
  }
  const BoundedSeries series{cosine, 1.0 / (factorial * 17.0), 1e-16};
  const SeriesZero zero = first_zero(series, 2.0, 1e-3);
  ASSERT_TRUE(zero.crosses);
  EXPECT_NEAR(zero.zero, std::numbers::pi / 2.0, 1e-11);  // what the series leaves out: 2e-12
  EXPECT_LE(zero.clear, std::numbers::pi / 2.0);
  EXPECT_GE(zero.clear, std::numbers::pi / 2.0 - 2.0 * 2e-3);
  EXPECT_EQ(first_zero(series, 1.5, 1e-3).clear, 1.5);
}

// (t - 1)^2 is never negative, but nothing tells that it does not touch zero.
TEST(FirstZero, OfATouchIsNoCrossing) {
  const std::vector<double> square{1.0, -2.0, 1.0};
  const SeriesZero zero = first_zero({square, 0.0, 1e-16}, 2.0, 1e-16);
  EXPECT_FALSE(zero.crosses);
  EXPECT_NEAR(zero.clear, 1.0, 1e-7);
}

TEST(MotionSeries, IsTheFreeMotion) {
  Dice dice(5);
  for (const bool forced : {false, true}) {
    const System system = string_over(dice, 90, 3, forced);
    const State start = plucked(dice, system);
    const LinearSystem<double> modes = linear_system<double>(system);
    const ExactFlow<double> flow(modes);
    Arc<double> arc(flow);
    arc.start(0.7, start.q, start.qdot);
    MotionSeries series(modes, Matrix(90, 0), 24);
    series.expand(0.7, start.q, start.qdot);
    const double step = series.step(1e-16);
    EXPECT_GT(step, 1.5);
    Vector q, qdot, q_exact(90), qdot_exact(90);
    for (const double part : {0.1, 0.6, 1.0}) {
      series.state(part * step, q, qdot);
      arc.state(part * step * series.unit(), q_exact, qdot_exact);
      EXPECT_LE((q - q_exact).norm(), 1e-15);
      EXPECT_LE((qdot - qdot_exact).norm(), 1e-14);
    }
    // The bound on what is left out holds far beyond the step that it allows.
    const MotionSeries coarse = [&] {
      MotionSeries made(modes, Matrix(90, 0), 6);
      made.expand(0.7, start.q, start.qdot);
      return made;
    }();
    const Vector row = system.stops[1].row;
    for (const double tau : {1.0, 3.0, 7.9}) {
      double sum = 0.0;
      for (int k = 6; k >= 0; --k) sum = sum * tau + row.dot(coarse.coefficients().col(k));
      arc.state(tau * coarse.unit(), q_exact, qdot_exact);
      EXPECT_LE(std::abs(sum - row.dot(q_exact)),
                row.norm() * coarse.remainder() * std::pow(tau, 7.0) + 1e-15);
    }
  }
}

struct HeldCase {
  System system;
  std::vector<int> closed;
  State start;
};

HeldCase held_case(Dice& dice, bool forced) {
  HeldCase made{string_over(dice, 70, 6, forced), {1, 4}, {}};
  made.start = plucked(dice, made.system);
  // At rest on the stops that hold.
  Matrix rows(70, 2);
  Vector gaps(2);
  for (int i = 0; i < 2; ++i) {
    rows.col(i) =
        made.system.stops[static_cast<std::size_t>(made.closed[static_cast<std::size_t>(i)])].row;
    gaps[i] = 0.3;
  }
  const Matrix inverse = (rows.transpose() * rows).inverse();
  made.start.q -= rows * inverse * (rows.transpose() * made.start.q - gaps);
  made.start.qdot -= rows * inverse * (rows.transpose() * made.start.qdot);
  return made;
}

TEST(SeriesPhase, IsTheMotionInModes) {
  Dice dice(6);
  for (const bool forced : {false, true}) {
    const HeldCase held = held_case(dice, forced);
    ASSERT_TRUE(suits_series(held.system, held.closed));
    SeriesPhase series(held.system, PhaseKey{held.closed});
    const std::unique_ptr<ExactPhase<double>> modes =
        exact_phase(held.system, PhaseKey{held.closed});
    series.start(0.2, held.start.q, held.start.qdot);
    modes->start(0.2, held.start.q, held.start.qdot);
    MotionState<double> now{{},
                            held.start.q,
                            held.start.qdot,
                            std::vector<Contact>(6, Contact::kClear),
                            std::vector<int>(6, 0)};
    for (const int i : held.closed) now.contacts[static_cast<std::size_t>(i)] = Contact::kClosed;
    const std::vector<int> nothing;
    const StopSignal never;
    series.first_event(now, {0.9, 0.9, nothing, never});
    Vector q, qdot, q_modes, qdot_modes;
    const double whole = energy(held.system, held.start.q, held.start.qdot);
    for (const double s : {0.001, 0.05, 0.4, 0.9}) {
      series.state(s, q, qdot);
      modes->state(s, q_modes, qdot_modes);
      // The modes that are held are known to the condition of their decomposition.
      EXPECT_LE((q - q_modes).norm(), 1e-11) << s;
      EXPECT_LE((qdot - qdot_modes).norm(), 1e-10) << s;
      for (const int i : held.closed)
        EXPECT_NEAR(held.system.stops[static_cast<std::size_t>(i)].row.dot(q), 0.3, 1e-14);
      const double force = modes->force_at(1, s, q_modes, qdot_modes);
      EXPECT_NEAR(series.force_at(1, s, q, qdot), force, 1e-8 * std::abs(force) + 1e-8);
      // N roundings of the energy. What the stops do is no work: it is what damping and forcing
      // make of it.
      const Work work = work_along(held.system, series, s);
      EXPECT_NEAR(energy(held.system, q, qdot) - energy(held.system, held.start.q, held.start.qdot),
                  work.forcing - work.dissipation,
                  70 * std::numeric_limits<double>::epsilon() * whole);
      EXPECT_NEAR(work.dissipation, work_along(held.system, *modes, s).dissipation, 1e-11);
    }
    for (int order = 1; order <= 3; ++order) {
      const CurvePoint<double> a = series.gap_rate(2, order), b = modes->gap_rate(2, order);
      EXPECT_NEAR(a.value, b.value, 1e-9 * std::pow(70.0, order - 1));
      EXPECT_GE(a.bound, std::abs(a.curvature));
    }
  }
}

// Whatever comes first: a release, or another stop.
TEST(SeriesPhase, FindsTheFirstEventOfTheMotionInModes) {
  Dice dice(7);
  int releases = 0, contacts = 0;
  for (int k = 0; k < 12; ++k) {
    const HeldCase held = held_case(dice, k % 2 == 1);
    SeriesPhase series(held.system, PhaseKey{held.closed});
    const std::unique_ptr<ExactPhase<double>> modes =
        exact_phase(held.system, PhaseKey{held.closed});
    series.start(0.2, held.start.q, held.start.qdot);
    modes->start(0.2, held.start.q, held.start.qdot);
    MotionState<double> now{{},
                            held.start.q,
                            held.start.qdot,
                            std::vector<Contact>(6, Contact::kClear),
                            std::vector<int>(6, 0)};
    std::vector<int> order;
    // Only what is positive at the start is there to be watched.
    for (int i = 0; i < 6; ++i) {
      const bool closed = i == 1 || i == 4;
      if (closed) now.contacts[static_cast<std::size_t>(i)] = Contact::kClosed;
      const Stop& stop = held.system.stops[static_cast<std::size_t>(i)];
      const double value = closed ? modes->force_at(i, 0.0, held.start.q, held.start.qdot)
                                  : stop.gap - stop.row.dot(held.start.q);
      if (value > 1e-6) order.push_back(i);
    }
    const StopSignal never;
    const Flight<double> flight{0.5, 0.5, order, never};
    const Arrival<double> a = series.first_event(now, flight), b = modes->first_event(now, flight);
    EXPECT_EQ(a.kind, b.kind) << k;
    EXPECT_EQ(a.stop, b.stop) << k;
    EXPECT_NEAR(a.flight, b.flight, 1e-10) << k;
    releases += b.kind == ArrivalKind::kRelease;
    contacts += b.kind == ArrivalKind::kContact;
  }
  EXPECT_GT(releases, 0);
  EXPECT_GT(contacts, 0);
}

// Stops side by side give the contact that is found stop by stop, for a part of the evaluations.
TEST(FlightSearch, FindsWhatTheSearchOfSingleGapsFinds) {
  Dice dice(8);
  int contacts = 0;
  long long evaluations = 0, evaluations_alone = 0;
  for (int k = 0; k < 40; ++k) {
    const System system = string_over(dice, 80 + 10 * (k % 3), 20, k % 4 == 3);
    const State start = plucked(dice, system);
    FreePhase<double> phase(system, PhaseKey{});
    phase.start(0.1, start.q, start.qdot, 0.0);
    MotionState<double> now{{},
                            start.q,
                            start.qdot,
                            std::vector<Contact>(20, Contact::kClear),
                            std::vector<int>(20, 0)};
    std::vector<int> order;
    for (int i = 0; i < 20; ++i)
      if (phase.gap(i, 1.0, false).at(0.0, 0).value > 0.0) order.push_back(i);
    const StopSignal never;
    const Flight<double> flight{3.0, 3.0, order, never};
    const Arrival<double> a = phase.first_event(now, flight);
    const Arrival<double> b = phase.ExactPhase<double>::first_event(now, flight);
    EXPECT_EQ(a.kind, b.kind) << k;
    EXPECT_EQ(a.stop, b.stop) << k;
    EXPECT_NEAR(a.flight, b.flight, 1e-13) << k;
    contacts += b.kind == ArrivalKind::kContact;
    evaluations += a.evaluations;
    evaluations_alone += b.evaluations;
  }
  EXPECT_GT(contacts, 10);
  EXPECT_LT(4 * evaluations, evaluations_alone);
}

// A stop that no speed can bridge is not evaluated at all.
TEST(FlightSearch, DoesNotLookAtWhatNoSpeedCanBridge) {
  Dice dice(9);
  System system = string_over(dice, 100, 50, false);
  const State start = plucked(dice, system);
  const double speed = std::sqrt(2.0 * energy(system, start.q, start.qdot));
  for (Stop& stop : system.stops) stop.gap = stop.row.dot(start.q) + 1.01 * stop.row.norm() * speed;
  FreePhase<double> phase(system, PhaseKey{});
  phase.start(0.0, start.q, start.qdot, 0.0);
  const MotionState<double> now{
      {}, start.q, start.qdot, std::vector<Contact>(50, Contact::kClear), std::vector<int>(50, 0)};
  std::vector<int> order(50);
  for (int i = 0; i < 50; ++i) order[static_cast<std::size_t>(i)] = i;
  const StopSignal never;
  const Arrival<double> arrival = phase.first_event(now, {1.0, 1.0, order, never});
  EXPECT_EQ(arrival.kind, ArrivalKind::kTime);
  EXPECT_EQ(arrival.flight, 1.0);
  EXPECT_EQ(arrival.evaluations, 0);
}

}  // namespace
}  // namespace graze
