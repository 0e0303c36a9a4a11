#include "graze/fit/detail/observed_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "graze/motion/detail/motion_walk.hpp"

namespace graze {
namespace {

Instant<double> instant_at(const System& system, double seconds) {
  if (!system.forcing()) return {0, seconds};
  const double period = system.period(), periods = std::floor(seconds / period);
  return {static_cast<long long>(periods), std::clamp(seconds - periods * period, 0.0, period)};
}

class Follower {
 public:
  Follower(const System& system, const State& start, const Observation& observation)
      : system_(system),
        observation_(observation),
        motion_(system, {}, start.q, start.qdot),
        walk_(system, motion_, observation.closure_speed),
        end_(instant_at(system, observation.end)) {
    motion_.stop_on(observation.stop);
  }

  std::string follow() {
    while (proceed()) {
    }
    if (!failure_.empty() || ended_) return failure_;
    // Instants left over by the rounding of the end.
    while (next_ < observation_.times.size()) hand_out_now();
    return "";
  }

 private:
  bool proceed() {
    switch (walk_.next(end_)) {
      case WalkStep::kDeparture:
        return walk_.is_at_once() || !observation_.stop.requested() || fail("it was stopped");
      case WalkStep::kFlight:
        if (!walk_.is_at_once()) hand_out_along(walk_.arrival());
        return true;
      case WalkStep::kImpact:
        return std::all_of(walk_.shares().begin(), walk_.shares().end(),
                           [&](const auto& share) { return !share.hit || report(share.stop); });
      case WalkStep::kEntry:
        return report(walk_.stop());
      case WalkStep::kChatter:
      case WalkStep::kStick:
      case WalkStep::kRelease:
      case WalkStep::kSeparation:
      case WalkStep::kLeft:
      case WalkStep::kTouch:
      case WalkStep::kFriction:
        return true;
      case WalkStep::kFailure:
        return fail(walk_.failure());
      case WalkStep::kEnd:
        break;
    }
    return false;
  }

  void hand_out_along(const Arrival<double>& arrival) {
    if (arrival.kind == ArrivalKind::kRefused && arrival.flight == 0.0) return;
    const double from = seconds_at(walk_.departure(), motion_.flow().period());
    while (next_ < observation_.times.size() && observation_.times[next_] - from <= arrival.flight)
      hand_out(motion_.flown(), observation_.times[next_] - from);
  }

  bool report(int stop) {
    if (++impacts_ > observation_.max_impacts)
      return fail(fmt::format("the budget of {} impacts was spent", observation_.max_impacts));
    ended_ = observation_.impact && !observation_.impact(stop, time());
    return !ended_;
  }

  bool fail(const std::string& why) {
    failure_ = fmt::format("at t = {:.9g} s {}", time(), why);
    return false;
  }

  // `s` seconds after the start of the last arc.
  void hand_out(const ContactPhase<double>& phase, double s) {
    observed_.index = next_++;
    observed_.q.resize(system_.modes());
    observed_.qdot.resize(system_.modes());
    s = std::max(s, 0.0);
    phase.state(s, observed_.q, observed_.qdot);
    if (observation_.forces) note_forces(phase, s);
    observation_.state(observed_);
  }

  void hand_out_now() {
    observed_ = {next_++, motion_.q(), motion_.qdot(), {}};
    if (observation_.forces) {
      observed_.forces.setZero(static_cast<Eigen::Index>(system_.stops.size()));
      for (int i = 0; i < observed_.forces.size(); ++i)
        observed_.forces[i] = motion_.contact_force(i);
    }
    observation_.state(observed_);
  }

  void note_forces(const ContactPhase<double>& phase, double s) {
    observed_.forces.setZero(static_cast<Eigen::Index>(system_.stops.size()));
    for (const int i : phase.closed())
      observed_.forces[i] = phase.force_at(i, s, observed_.q, observed_.qdot);
    for (const int i : phase.springs().loaded) {
      const Stop& stop = system_.stops[static_cast<std::size_t>(i)];
      observed_.forces[i] =
          stop.force().at(stop.row.dot(observed_.q) - stop.gap, stop.row.dot(observed_.qdot));
    }
  }

  double time() const { return seconds_at(motion_.instant(), motion_.flow().period()); }

  const System& system_;
  const Observation& observation_;
  Motion<double> motion_;
  MotionWalk<double> walk_;
  const Instant<double> end_;
  Observed observed_;
  std::size_t next_ = 0;  // of the instants
  long long impacts_ = 0;
  bool ended_ = false;
  std::string failure_;
};

}  // namespace

std::string observe(const System& system, const State& start, const Observation& observation) {
  return Follower(system, start, observation).follow();
}

}  // namespace graze
