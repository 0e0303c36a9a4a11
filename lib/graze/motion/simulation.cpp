#include "graze/motion/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/base/detail/stop_poll.hpp"
#include "graze/contact/detail/impulse.hpp"
#include "graze/motion/detail/amplitude_meter.hpp"
#include "graze/motion/detail/energy_changes.hpp"
#include "graze/motion/detail/event_crowd.hpp"
#include "graze/motion/detail/friction_tally.hpp"
#include "graze/motion/detail/motion_walk.hpp"
#include "graze/motion/detail/run_end.hpp"
#include "graze/motion/detail/sampler.hpp"
#include "graze/motion/detail/smallest_gap.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

class Run {
 public:
  Run(const System& system, const RunState& state, const SimulationOptions& options,
      const RunListeners& listeners)
      : system_(system),
        options_(options),
        listeners_(listeners),
        motion_(system, state.motion, options.steps),
        walk_(system, motion_, state.closure_speed, Tails::kTold, state.tail),
        state_(state),
        end_(options.duration ? later<double>({}, *options.duration, system.period())
                              : Instant<double>{options.periods, 0.0}),
        sampler_(system, listeners, options.energy),
        meter_(system, options.measure) {
    motion_.stop_on(options.stop);
    if (!state_.started) note_gaps();  // else they are known
    if (options.energy && !state_.keeps_balance)
      state_.balance = {structure_energy(system_, {motion_.q(), motion_.qdot()}, phase()), 0.0, {}, 0.0};
    state_.keeps_balance = options.energy;
  }

  Simulation finish() {
    while (proceed()) {
    }
    // A run that was stopped while an arc's samples were handed out ends where that arc began.
    const MotionState<double>& last = stopped_in_arc_ ? motion_.departure() : motion_.state();
    result_.end_time = stopped_in_arc_.value_or(time());
    result_.final = {last.q, last.qdot};
    result_.phase = motion_.flow().phase(last.instant);
    std::tie(result_.stuck, result_.forces, result_.frictions) =
        holders(system_, motion_, walk_, result_.outcome);
    result_.totals = state_.totals;
    result_.evaluations += motion_.step_evaluations();
    if (options_.energy) {
      state_.balance.now = structure_energy(system_, result_.final, result_.phase);
      result_.energy = state_.balance;
    }
    result_.amplitudes = meter_.result();
    // An arc cut by the end of the run is flown again, as a whole, by a run that goes on from it.
    state_.tail = walk_.tail();
    result_.state = is_cut_ ? cut_arc_ : state_;
    result_.state.motion = is_cut_ ? motion_.departure() : motion_.state();
    result_.state.samples = state_.samples;
    return result_;
  }

 private:
  int stops() const { return static_cast<int>(system_.stops.size()); }
  const Stop& stop(int i) const { return system_.stops[static_cast<std::size_t>(i)]; }

  // False when the run is over.
  bool proceed() {
    switch (walk_.next(end_)) {
      case WalkStep::kDeparture:
        return depart();
      case WalkStep::kFlight:
        return walk_.is_at_once() ? decided() : flown();
      case WalkStep::kImpact:
        enter_impact();
        return true;
      case WalkStep::kChatter:
        enter_chatter();
        return true;
      case WalkStep::kStick:
        enter_stick(walk_.stop());
        return true;
      case WalkStep::kRelease:
        emit(event_at(EventKind::kRelease, walk_.stop()));
        return true;
      case WalkStep::kEntry:
        balance_entry(walk_.stop());
        return true;
      case WalkStep::kSeparation:
        enter_separation(walk_.stop(), walk_.arrival().below);
        return true;
      case WalkStep::kLeft:
        enter_contacts(walk_.stop());
        return true;
      case WalkStep::kTouch:
        // A touched spring is compressed or left next: no impact is missed.
        if (!stop(walk_.stop()).is_compliant()) ++state_.totals.undecided_touches;
        return true;
      case WalkStep::kFriction:
        if (state_.started) emit(friction_event(walk_.arrival(), system_, motion_, state_.totals));
        return true;
      case WalkStep::kFailure:
        return fail();
      case WalkStep::kEnd:
        break;
    }
    return false;
  }

  bool depart() {
    // One instant may have as many changes as stops, and each costs a loop over all stops.
    work_ += stops();
    if (walk_.is_at_once()) {
      if (options_.energy) before_ = motion_.qdot();
      return goes_on();
    }
    if (!within_budget()) return false;
    is_cut_ = walk_.is_cut() || listeners_.sample;
    if (is_cut_) {
      cut_arc_ = state_;
      cut_arc_.tail = walk_.tail();
    }
    // Until the first contact the smallest gap is not known to be zero and has to be searched for.
    untouched_ =
        state_.totals.impacts == 0 && !motion_.is_closed_anywhere() && !motion_.is_sprung();
    if (untouched_ && !options_.steps && !system_.turns())
      for (int i = 0; i < stops(); ++i)
        note_minimum(motion_.gap_ahead(i, walk_.until() - walk_.departure().local), state_.totals);
    motion_.tell_depths_beyond(-std::min(state_.totals.smallest_gap.value_or(0.0), 0.0));
    return true;
  }

  // What stands still within rounding was put to rest.
  bool decided() {
    if (options_.energy)
      state_.balance.impacts += kinetic_change(system_, motion_.q(), before_, motion_.qdot());
    note_progress();
    return true;
  }

  bool flown() {
    const Arrival<double>& arrival = walk_.arrival();
    work_ += (1 + arrival.evaluations) * system_.modes();
    if (arrival.kind == ArrivalKind::kUndecided && !within_budget(true)) return false;
    if (untouched_ && arrival.lowest && std::isfinite(*arrival.lowest))
      note_gap(std::max(*arrival.lowest, 0.0), state_.totals);
    if (!options_.steps) result_.evaluations += arrival.evaluations;
    // A motion that cannot be followed has no samples, whichever run finds out.
    if (arrival.kind == ArrivalKind::kRefused && arrival.flight == 0.0) return true;
    const double start_time = seconds_at(walk_.departure(), motion_.flow().period());
    if (!follow(start_time, arrival.flight)) {
      stopped_in_arc_ = start_time;
      result_.message = "stopped at " + moment_text(start_time, system_.units);
      return false;
    }
    if (!walk_.is_cut()) is_cut_ = false;
    note_progress();
    return true;
  }

  void note_progress() {
    const ArrivalKind kind = walk_.arrival().kind;
    if (kind != ArrivalKind::kTime && kind != ArrivalKind::kJoint && kind != ArrivalKind::kLeft)
      return;
    if (listeners_.progress) listeners_.progress(fraction());
    note_gaps();
  }

  bool follow(double start_time, double flight) {
    if (flight > 0.0) state_.started = true;
    const auto within = [this] {
      work_ += system_.modes();
      return within_budget();
    };
    const double theta = motion_.flow().phase(walk_.departure());
    if (listeners_.sample && !sampler_.hand_out(motion_, theta, start_time, flight, state_.balance,
                                                state_.samples, within))
      return false;
    if (options_.energy && flight > 0.0)
      state_.balance.work = state_.balance.work + work_along(system_, motion_.flown(), flight, theta);
    meter_.add_flight(motion_.flown(), theta, start_time, flight);
    const double deepest = graze::follow(state_.contacts, motion_.flown(), flight);
    if (deepest > 0.0) note_gap(-deepest, state_.totals);
    const std::vector<int>& closed = motion_.flown().closed();
    const auto is_shut = [&](int i) { return !system_.is_friction(i) && !walk_.is_in_tail(i); };
    if (std::any_of(closed.begin(), closed.end(), is_shut)) state_.totals.stuck_time += flight;
    count_sticking(motion_.flown(), flight, state_.totals);
    return true;
  }

  bool within_budget(bool reads_clock = false) {
    if (state_.totals.impacts >= options_.max_impacts)
      return spent(RunOutcome::kEventBudget, fmt::format("{} impacts", options_.max_impacts));
    return goes_on(reads_clock);
  }

  bool goes_on(bool reads_clock = false) {
    if (options_.stop.is_interrupted())
      return stop_run(RunOutcome::kInterrupted, "stopped at " + moment_text(time(), system_.units));
    // An arc whose work is integrated may be long.
    if ((poll_.is_due(std::exchange(work_, 0)) || options_.energy || reads_clock) &&
        options_.stop.is_late())
      return spent(RunOutcome::kTimeBudget, "computing time");
    return true;
  }

  bool spent(RunOutcome outcome, const std::string& budget) {
    result_.crowd = crowd_.sentence(system_.repeats() ? system_.period() : longest_flight(system_),
                                    system_.units);
    return stop_run(
        outcome, "the budget of " + budget + " was spent at " + moment_text(time(), system_.units));
  }

  bool fail() {
    const ArrivalKind kind = walk_.arrival().kind;
    if (kind == ArrivalKind::kUndecided && !within_budget(true)) return false;
    if (kind == ArrivalKind::kRefused) note_gaps();
    return stop_run(outcome_of(kind),
                    fmt::format("at {} {}", moment_text(time(), system_.units), walk_.failure()));
  }

  bool stop_run(RunOutcome outcome, std::string message) {
    result_.outcome = outcome;
    result_.message = std::move(message);
    return false;
  }

  double phase() const { return motion_.flow().phase(motion_.instant()); }  // of the forcing, rad

  Event event_at(EventKind kind, int i) const {
    return {kind, time(), motion_.instant().period, i};
  }
  Event arrival_at(EventKind kind, int i, double speed) {
    Event event = event_at(kind, i);
    event.speed = speed;
    if (system_.has_phase()) event.phase = wrapped(phase());
    note_gap_at(i);
    return event;
  }

  void emit(const Event& event) {
    state_.started = true;
    crowd_.add(event);
    if (listeners_.event) listeners_.event(event);
  }

  // `balance`: of impacts; contacts at compliant stops are counted as they go.
  void enter_energy(double change, bool balance = true) {
    (change > 0.0 ? state_.totals.energy_added : state_.totals.energy_lost) += std::abs(change);
    if (balance) state_.balance.impacts += change;
  }

  void enter_impact() {
    impact_energy(system_, walk_.shares(), motion_.q(), walk_.qdot_before(), motion_.qdot(),
                  impact_energy_);
    enter_energy(impact_energy_.total);
    add_impact_work(system_, phase(), walk_.qdot_before(), motion_.qdot(), state_.balance.work);
    meter_.add_impact(walk_.shares(), time());
    for (const ImpactEnergy::Hit& hit : impact_energy_.hits) enter_hit(hit.share, hit.change);
  }

  void enter_hit(const ImpactShare<double>& share, double energy_change) {
    Event event = arrival_at(EventKind::kImpact, share.stop, share.speed);
    event.energy_change = energy_change;
    ++state_.totals.impacts;
    if (stop(share.stop).restitution().clamps_at(share.speed)) ++state_.totals.clamped_restitutions;
    state_.streaks[static_cast<std::size_t>(share.stop)].add(share.speed);
    emit(event);
  }

  SpringContact& contact_at(int i) { return state_.contacts[static_cast<std::size_t>(i)]; }

  void balance_entry(int i) {
    const Event event = arrival_at(EventKind::kContact, i, motion_.approach_speed(i));
    // A spring that grips again below the surface, on its way out, is no new impact.
    if (event.speed >= 0.0) ++state_.totals.impacts;
    if (event.speed >= 0.0) meter_.add_contact(i, event.time);
    SpringContact& contact = contact_at(i);
    contact = {time(), event.speed, 0.0, 0.0, motion_.spring_energy(i), contact.change_before};
    emit(event);
  }

  // `below` the surface the spring keeps the energy that it may give back if it grips again.
  void enter_separation(int i, bool below) {
    Event event = event_at(EventKind::kSeparation, i);
    event.speed = -motion_.approach_speed(i);
    end_contact(contact_at(i), motion_.spring_energy(i), event);
    if (!below) enter_contacts(i);
    emit(event);
  }

  void enter_contacts(int i) {
    if (!stop(i).is_compliant()) return;
    enter_energy(contact_at(i).change_before, false);
    contact_at(i).change_before = 0.0;
  }

  void enter_chatter() {
    const std::vector<ImpactShare<double>>& shares = walk_.shares();
    const double change = closure_energy_change(
        system_, walk_.closed().closed, phase(),
        {walk_.closed().q_before, walk_.closed().qdot_before}, {motion_.q(), motion_.qdot()},
        state_.balance.work);
    enter_energy(change);
    meter_.add_closure(walk_.closed().closed, walk_.closed().qdot_before - motion_.qdot(), time());
    const auto last =
        std::max_element(shares.begin(), shares.end(),
                         [](const auto& a, const auto& b) { return a.speed < b.speed; });
    for (const int i : walk_.closed().stops) {
      Event event = chatter_event(i);
      if (i == last->stop) event.energy_change = change;
      ++state_.totals.chatters;
      emit(event);
    }
  }

  Event chatter_event(int i) {
    Event event = event_at(EventKind::kChatter, i);
    event.impacts = state_.streaks[static_cast<std::size_t>(i)].impacts;
    event.closure_speed = state_.closure_speed;
    state_.streaks[static_cast<std::size_t>(i)] = {};
    return event;
  }

  void enter_stick(int i) {
    if (!state_.started) return;  // it starts there
    // A chatter that could not be summed and was followed down to the rounding of its speeds.
    const RunState::Streak& streak = state_.streaks[static_cast<std::size_t>(i)];
    if (streak.impacts > 1 && streak.speed <= state_.closure_speed &&
        stop(i).restitution().at(streak.speed) > 0.0) {
      ++state_.totals.chatters;
      emit(chatter_event(i));
    }
    Event event = event_at(EventKind::kStick, i);
    // The stop holds because its force is not negative; a value below zero is rounding.
    event.force = std::fmax(motion_.force(i), 0.0);
    emit(event);
  }

  void note_gaps() {
    for (int i = 0; i < stops(); ++i) note_gap_at(i);
  }
  void note_gap_at(int i) { graze::note_gap_at(stop(i), motion_.q(), state_.totals); }

  double time() const { return seconds_at(motion_.instant(), motion_.flow().period()); }
  double fraction() const {
    const double end = seconds_at(end_, motion_.flow().period());
    return end > 0.0 ? std::min(time() / end, 1.0) : 1.0;
  }

  const System& system_;
  const SimulationOptions& options_;
  const RunListeners& listeners_;
  Motion<double> motion_;
  MotionWalk<double> walk_;
  RunState state_;
  std::optional<double> stopped_in_arc_;  // s, where that arc began
  RunState cut_arc_;                      // before the arc that the end of the run cuts
  bool is_cut_ = false;                   // whether there is one
  const Instant<double> end_;
  bool untouched_ = false;      // before the first contact
  Vector before_;               // velocities before an instant is decided
  ImpactEnergy impact_energy_;  // kept for the memory
  Sampler sampler_;
  AmplitudeMeter meter_;
  EventCrowd crowd_;
  StopPoll poll_;
  long long work_ = 0;  // since it was asked last
  Simulation result_;
};

}  // namespace

Simulation simulate(const System& system, const State& start, const SimulationOptions& options,
                    const RunListeners& listeners) {
  RunState state;
  state.motion = Motion<double>(system, {}, start.q, start.qdot).state();
  state.streaks.resize(system.stops.size());
  state.contacts.resize(system.stops.size());
  state.closure_speed = options.closure_speed.value_or(default_closure_speed(system, start));
  return Run(system, state, options, listeners).finish();
}

Simulation resume(const System& system, const RunState& from, const SimulationOptions& options,
                  const RunListeners& listeners) {
  RunState state = from;
  if (options.closure_speed) state.closure_speed = *options.closure_speed;
  return Run(system, state, options, listeners).finish();
}

}  // namespace graze
