#include "graze/study/cost/reference_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "graze/contact/detail/impulse.hpp"
#include "graze/flow/exact/extended.hpp"
#include "graze/motion/detail/motion_walk.hpp"
#include "graze/study/cost/detail/extended_contact.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

constexpr double kReferenceSamplesPerPeriod = 16.0;
// Closure speed relative to the speed of the motion. Summing the tail of a chatter has an error of
// its square: beyond double precision, and far from the last digit of the reference.
constexpr double kClosure = 1e-16;

// Flights are those of the same structure against rigid stops: each ends where a stop is reached.
System with_rigid_stops(System system) {
  for (Stop& stop : system.stops) {
    if (stop.is_compliant()) stop.law = ImpactLaw{momentum_direction(stop.row)};
  }
  return system;
}

class Reference {
 public:
  Reference(const System& system, const State& start, const ReferenceOptions& options)
      : system_(system),
        flying_(with_rigid_stops(system)),
        options_(options),
        motion_(std::in_place, flying_, Instant<Extended>{}, start.q.cast<Extended>(),
                start.qdot.cast<Extended>()),
        closure_(kClosure * speed_scale(system, start)),
        walk_(std::in_place, flying_, *motion_, closure_),
        piece_((system.forcing() ? std::min(system.period(), options.longest) : options.longest) /
               kReferenceSamplesPerPeriod),
        end_(options.longest),
        next_sample_(piece_) {
    motion_->stop_on(options.stop);
    for (const Stop& stop : system.stops)
      if (stop.is_compliant() && stop.row.dot(start.q) > stop.gap)
        run_.message = "the motion starts on a compressed spring";
  }

  ReferenceRun finish() {
    run_.sample_interval = piece_;
    while (time() < end_ && run_.message.empty() && !over_ && !options_.stop.requested())
      take(walk_->next(next_stop()));
    if (over_) return run_;
    run_.end_time = time();
    run_.end = state();
    // A run that ends at an impact may count it or not.
    if (!run_.message.empty())
      std::erase_if(run_.impacts, [this](const ReferenceImpact& impact) {
        return !(impact.time < run_.end_time);
      });
    return run_;
  }

 private:
  Extended exact_time() const {
    const Instant<Extended>& now = motion_->instant();
    if (now.period == 0) return now.local;
    return Extended(now.period) * motion_->flow().period() + now.local;
  }
  double time() const { return static_cast<double>(exact_time()); }
  State state() const {
    return {motion_->q().template cast<double>(), motion_->qdot().template cast<double>()};
  }

  // The next sample, or the end of the run, but no later than the end of the forcing period.
  Instant<Extended> next_stop() {
    while (next_sample_ <= time()) next_sample_ += piece_;
    const Instant<Extended>& now = motion_->instant();
    const Extended left = Extended(std::min(next_sample_, end_)) - exact_time();
    return {now.period, std::min<Extended>(now.local + left, motion_->flow().period())};
  }

  void take(WalkStep step) {
    switch (step) {
      case WalkStep::kDeparture:
        enough_ = met_ >= options_.impacts;
        return;
      case WalkStep::kFlight:
        return take_flight(walk_->arrival());
      case WalkStep::kImpact:
        return take_impact();
      case WalkStep::kStick:
        if (is_compliant(walk_->stop())) run_.message = "a compliant stop is reached at rest";
        return;
      case WalkStep::kFailure:
        // A run that was stopped has not failed.
        if (!options_.stop.requested()) run_.message = walk_->failure();
        return;
      default:
        return;
    }
  }

  void take_flight(const Arrival<Extended>& arrival) {
    if (arrival.fails()) return;
    const double before =
        static_cast<double>(seconds_at(walk_->departure(), motion_->flow().period()));
    if (enough_ && time() > before) {
      fly_back(before);
      over_ = true;
    } else if (arrival.kind == ArrivalKind::kContact && is_compliant(arrival.stop)) {
      take_contact(arrival.stop);
    } else if (arrival.kind == ArrivalKind::kTime && time() >= next_sample_ * (1.0 - 1e-12)) {
      run_.samples.push_back(state());
      next_sample_ = piece_ * static_cast<double>(run_.samples.size() + 1);
    }
  }

  bool is_compliant(int stop) const {
    return stop >= 0 && system_.stops[static_cast<std::size_t>(stop)].is_compliant();
  }

  void take_contact(int stop) {
    ++met_;
    const Extended began = exact_time();
    run_.impacts.push_back(
        {time(), stop, static_cast<double>(motion_->approach_speed(stop)), false});
    if (motion_->is_closed_anywhere()) {
      run_.message = "a compliant stop is reached while another holds the structure";
      return;
    }
    const ExtendedContact contact = follow_contact(
        system_, stop, motion_->q(), motion_->qdot(),
        {motion_->flow().phase(motion_->instant()), options_.longest, options_.stop});
    run_.message = contact.message;
    if (!run_.message.empty()) return;
    const Stop& left = system_.stops[static_cast<std::size_t>(stop)];
    const RealVector<Extended> row = left.row.cast<Extended>();
    run_.impacts.push_back({static_cast<double>(began + contact.separation), stop,
                            static_cast<double>(-row.dot(contact.qdot)), true});
    // Moves the state onto the surface to all digits: a start beyond a stop is not allowed.
    const RealVector<Extended> on_it =
        contact.q + (Extended(left.gap) - row.dot(contact.q)) / row.squaredNorm() * row;
    const Instant<Extended> now =
        later(motion_->instant(), contact.end, Extended(motion_->flow().period()));
    motion_.emplace(flying_, now, on_it, contact.qdot);
    motion_->stop_on(options_.stop);
    walk_.emplace(flying_, *motion_, closure_);
    // The run ends somewhat after the contact in any case, so that the contact's end is within the
    // run.
    end_ = std::max(end_, time() + 0.5 * piece_);
  }

  void take_impact() {
    const std::size_t before = run_.impacts.size();
    for (const ImpactShare<Extended>& share : walk_->shares())
      if (share.hit && static_cast<double>(share.speed) > options_.slowest)
        run_.impacts.push_back({time(), share.stop, static_cast<double>(share.speed), false});
    met_ += run_.impacts.size() - before;
    std::sort(run_.impacts.begin() + static_cast<std::ptrdiff_t>(before), run_.impacts.end(),
              [](const auto& a, const auto& b) { return a.stop < b.stop; });
  }

  // Goes half the way along the last arc.
  void fly_back(double from) {
    RealVector<Extended> q = motion_->q(), qdot = motion_->qdot();
    const double half = 0.5 * (time() - from);
    motion_->flown().state(Extended(half), q, qdot);
    run_.end_time = from + half;
    run_.end = {q.cast<double>(), qdot.cast<double>()};
  }

  const System& system_;
  const System flying_;
  const ReferenceOptions& options_;
  std::optional<Motion<Extended>> motion_;
  Extended closure_;
  std::optional<MotionWalk<Extended>> walk_;
  double piece_, end_, next_sample_;  // s
  std::size_t met_ = 0;               // impacts that are recorded, and contacts
  bool enough_ = false;               // there were enough of them as the flight began
  bool over_ = false;
  ReferenceRun run_;
};

}  // namespace

bool is_followed_by_steps(const System& system) {
  return system.turns() || !system.has_closed_forms() ||
         std::any_of(system.stops.begin(), system.stops.end(), [](const Stop& stop) {
           return stop.is_compliant() && !stop.force().is_of_one_piece();
         });
}

ReferenceRun reference_run(const System& system, const State& start,
                           const ReferenceOptions& options) {
  if (is_followed_by_steps(system)) {
    ReferenceRun run;
    run.message = fmt::format("{} is followed in double precision only",
                              system.turns()      ? "a structure on a hub"
                              : system.coupling() ? "a structure whose damping couples modes"
                              : system.harmonics() ? "a structure under several harmonic loads"
                                                  : "a stop whose law changes during a contact");
    return run;
  }
  return Reference(system, start, options).finish();
}

}  // namespace graze
