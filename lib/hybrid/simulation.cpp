#include "graze/hybrid/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/contact/impulse.hpp"
#include "graze/hybrid/clearance.hpp"
#include "graze/hybrid/motion.hpp"

namespace graze {
namespace {

// Without forcing nothing divides time; flights are cut after a number of the slowest oscillations,
// so that a search neither runs out of its evaluations nor lets the phase's rounding grow.
double longest_free_flight(const System& system) {
  constexpr double kOscillations = 64.0;
  double slowest = std::numeric_limits<double>::infinity();
  for (const double omega : system.omega)
    if (omega > 0.0) slowest = std::min(slowest, omega);
  return std::isfinite(slowest) ? kOscillations * kTurn / slowest : slowest;
}

class Run {
 public:
  Run(const System& system, const State& start, const SimulationOptions& options,
      const RunListeners& listeners)
      : system_(system),
        options_(options),
        listeners_(listeners),
        motion_(system, {}, start.q, start.qdot) {
    if (options.duration) {
      end_.local = *options.duration;
      if (system.forcing) {
        const double periods = std::floor(*options.duration / system.period());
        end_.period = static_cast<long long>(periods);
        end_.local =
            std::clamp(*options.duration - periods * system.period(), 0.0, system.period());
      }
    } else {
      end_.period = options.periods;
    }
    if (!system.forcing) longest_flight_ = longest_free_flight(system);
    for (std::size_t i = 0; i < system.stops.size(); ++i)
      note_gap(motion_.gap(static_cast<int>(i)));
  }

  Simulation finish() {
    while (proceed()) {
    }
    result_.end_time = time();
    result_.final = {motion_.q(), motion_.qdot()};
    return result_;
  }

 private:
  // One arc; false when the run is over.
  bool proceed() {
    const Instant<double> start = motion_.instant();
    if (start.period > end_.period || (start.period == end_.period && start.local >= end_.local))
      return false;
    if (!within_budget()) return false;
    double until = start.period == end_.period ? end_.local : motion_.flow().period();
    if (until - start.local > longest_flight_) until = start.local + longest_flight_;
    const double start_time = time();
    // Until the first contact the smallest gap is not known to be zero and has to be looked for.
    if (result_.totals.impacts == 0) note_minima(until - start.local);
    const Arrival<double> arrival = motion_.fly(until);
    if (listeners_.sample && !hand_out_samples(start_time, arrival.flight)) return false;
    return receive(arrival);
  }

  bool receive(const Arrival<double>& arrival) {
    switch (arrival.kind) {
      case ArrivalKind::kTime:
        if (listeners_.progress) listeners_.progress(fraction());
        for (std::size_t i = 0; i < system_.stops.size(); ++i)
          note_gap(motion_.gap(static_cast<int>(i)));
        return true;
      case ArrivalKind::kTouch:
        ++result_.totals.undecided_touches;
        return true;
      case ArrivalKind::kContact:
        book_impact(arrival);
        return true;
      case ArrivalKind::kRest:
        result_.resting_stop = arrival.stop;
        return stop(RunOutcome::kEventBudget, rest_sentence(arrival.stop));
      case ArrivalKind::kUndecided:
        return stop(RunOutcome::kEventBudget,
                    fmt::format("the search for the next contact with stop {} used up its "
                                "evaluations at t = {:.9g} s",
                                arrival.stop + 1, time()));
      case ArrivalKind::kNotFinite:
        return stop(
            RunOutcome::kNotFinite,
            fmt::format("the motion left the range of double precision at t = {:.9g} s", time()));
    }
    return false;
  }

  std::string rest_sentence(int stop) const {
    const long long impacts = result_.totals.impacts;
    if (impacts == 0)
      return fmt::format(
          "the motion rests against stop {} at t = {:.9g} s; sticking is not "
          "available in this version",
          stop + 1, time());
    return fmt::format(
        "the motion came to rest on stop {} at t = {:.9g} s after {} impact{}; "
        "sticking is not available in this version",
        stop + 1, time(), impacts, impacts == 1 ? "" : "s");
  }

  bool within_budget() {
    if (result_.totals.impacts >= options_.max_impacts)
      return stop(RunOutcome::kEventBudget,
                  fmt::format("the budget of {} impacts was spent at t = {:.9g} s",
                              options_.max_impacts, time()));
    if (options_.stop.is_interrupted())
      return stop(RunOutcome::kInterrupted, fmt::format("stopped at t = {:.9g} s", time()));
    // The clock costs as much as an arc of a small system: it is read once in 256 times.
    if ((++polls_ & 255) == 0 && options_.stop.is_late())
      return stop(RunOutcome::kTimeBudget,
                  fmt::format("the budget of computing time was spent at t = {:.9g} s", time()));
    return true;
  }

  bool stop(RunOutcome outcome, std::string message) {
    result_.outcome = outcome;
    result_.message = std::move(message);
    return false;
  }

  void book_impact(const Arrival<double>& arrival) {
    const RigidStop& stop = system_.stops[static_cast<std::size_t>(arrival.stop)];
    Event event;
    event.time = time();
    event.period_index = motion_.instant().period;
    event.stop = arrival.stop;
    event.speed = arrival.speed;
    event.energy_change =
        impact_energy_change(stop.row, stop.direction, motion_.qdot(), stop.restitution);
    if (system_.forcing) event.phase = wrapped(motion_.flow().phase(motion_.instant()));
    note_gap(motion_.gap(arrival.stop));
    ++result_.totals.impacts;
    (event.energy_change > 0.0 ? result_.totals.energy_added : result_.totals.energy_lost) +=
        std::abs(event.energy_change);
    motion_.impact(arrival.stop);
    if (listeners_.event) listeners_.event(event);
  }

  void note_gap(double gap) {
    std::optional<double>& smallest = result_.totals.smallest_gap;
    if (!smallest || gap < *smallest) smallest = gap;
  }

  void note_minima(double window) {
    for (std::size_t i = 0; i < system_.stops.size(); ++i) {
      const GapCurve<double> curve = motion_.gap_ahead(static_cast<int>(i), window);
      // A minimum beyond the first contact is not part of the motion; the contact itself is zero.
      if (const auto gap = smallest_minimum(curve)) note_gap(std::max(*gap, 0.0));
    }
  }

  // False when the run has to stop: an arc can hold any number of samples.
  bool hand_out_samples(double start_time, double flight) {
    Sample sample{0.0, {Vector(system_.modes()), Vector(system_.modes())}};
    for (;;) {
      sample.time = static_cast<double>(samples_) / listeners_.sample_rate;
      const double s = std::max(sample.time - start_time, 0.0);
      if (s > flight) return true;
      if (!within_budget()) return false;
      motion_.arc().state(s, sample.state.q, sample.state.qdot);
      listeners_.sample(sample);
      ++samples_;
    }
  }

  double time() const {
    const Instant<double>& now = motion_.instant();
    return now.period == 0 ? now.local
                           : static_cast<double>(now.period) * motion_.flow().period() + now.local;
  }

  double fraction() const {
    const double end =
        end_.period == 0 ? end_.local
                         : static_cast<double>(end_.period) * motion_.flow().period() + end_.local;
    return end > 0.0 ? std::min(time() / end, 1.0) : 1.0;
  }

  const System& system_;
  const SimulationOptions& options_;
  const RunListeners& listeners_;
  Motion<double> motion_;
  Instant<double> end_;
  double longest_flight_ = std::numeric_limits<double>::infinity();  // s
  long long polls_ = 0;
  long long samples_ = 0;
  Simulation result_;
};

}  // namespace

Simulation simulate(const System& system, const State& start, const SimulationOptions& options,
                    const RunListeners& listeners) {
  return Run(system, start, options, listeners).finish();
}

}  // namespace graze
