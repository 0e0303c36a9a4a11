#include "graze/orbit/problem/detail/trajectory_segment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/detail/stop_poll.hpp"
#include "graze/motion/detail/clearance.hpp"
#include "graze/motion/detail/motion_walk.hpp"
#include "graze/motion/spring_contact.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

constexpr const char* kStopped = "stopped before the orbit was found";

void note_smallest(std::optional<double>& smallest, const std::optional<double>& value) {
  if (value && (!smallest || *value < *smallest)) smallest = value;
}

class Follower {
 public:
  Follower(const System& system, Motion<double>& motion, const Instant<double>& end,
           const SegmentOptions& options, Deviations* deviations, ParameterDeviation* parameter)
      : system_(system),
        end_(end),
        options_(options),
        motion_(motion),
        walk_(system, motion_, options.closure_speed),
        carried_(system, motion_, deviations, parameter),
        contacts_(system.stops.size()) {
    motion_.stop_on(options.stop);
    const MotionState<double> start = motion.state();
    start_ = start.instant;
    for (std::size_t i = 0; i < system.stops.size(); ++i) {
      if (start.contacts[i] == Contact::kClosed)
        open_sticking(static_cast<int>(i), start.instant, true);
      if (start.contacts[i] == Contact::kCompressed) open_contact(static_cast<int>(i), 0.0, true);
    }
  }

  TrajectorySegment follow() {
    if (options_.left_out) follow_without(*options_.left_out);
    if (segment_.failure.empty()) reach(end_);
    for (SegmentSticking& sticking : holding_) {
      sticking.to = motion_.instant();
      sticking.to_end = true;
      segment_.sticking.push_back(sticking);
    }
    while (!in_contact_.empty()) {
      if (!in_contact_.front().parted) part(in_contact_.front().stop, 0.0, true);
      close_contact(in_contact_.front().stop);
    }
    segment_.end = motion_.state();
    if (carried_.any() && segment_.failure.empty()) carried_.project_to_fixed_time();
    return std::move(segment_);
  }

 private:
  const Stop& stop(int i) const { return system_.stops[static_cast<std::size_t>(i)]; }

  bool fail(std::string sentence) {
    segment_.failure = std::move(sentence);
    return false;
  }

  State state_now() const { return {motion_.q(), motion_.qdot()}; }

  bool reach(const Instant<double>& end) {
    while (proceed(end)) {
    }
    return segment_.failure.empty();
  }

  // Follows up to the end of that time, or of the segment.
  bool follow_without(const LeftOut& one) {
    const Instant<double> start = motion_.instant();
    const auto within = [&](double seconds) {
      const Instant<double> at = later(start, seconds, system_.period());
      return not_before(at, end_) ? end_ : at;
    };
    const auto is_open = [&] {
      return motion_.state().contacts[static_cast<std::size_t>(one.stop)] == Contact::kClear &&
             motion_.gap(one.stop) > 0.0;
    };
    const Instant<double> to = within(one.to);
    if (!reach(within(one.from))) return false;
    if (!is_open()) return fail("the structure is on the stop that is left out");
    motion_.leave_out(one.stop);
    if (!reach(to)) return false;
    motion_.leave_out({});
    return not_before(to, end_) || is_open() ||
           fail("the structure has not come back from beyond the stop that was left out");
  }

  // False when `end` is reached.
  bool proceed(const Instant<double>& end) {
    switch (walk_.next(end)) {
      case WalkStep::kDeparture:
        return depart();
      case WalkStep::kFlight:
        flown();
        return true;
      case WalkStep::kImpact:
        return impact();
      case WalkStep::kChatter:
        if (options_.closure)
          options_.closure(walk_.closed().closed, walk_.closed().qdot_before - motion_.qdot());
        carried_.close(walk_.closed().closed,
                       {walk_.closed().q_before, walk_.closed().qdot_before});
        return true;
      case WalkStep::kStick:
        open_sticking(walk_.stop(), motion_.instant(), false);
        return true;
      case WalkStep::kEntry:
        return enter(walk_.stop());
      case WalkStep::kSeparation:
        separate(walk_.stop(), walk_.arrival().below);
        return true;
      case WalkStep::kLeft:
        close_contact(walk_.stop());
        return true;
      case WalkStep::kRelease:
        close_sticking(walk_.stop());
        return true;
      case WalkStep::kFriction:
        rub(walk_.stop());
        return true;
      case WalkStep::kTouch:
        return true;
      case WalkStep::kFailure:
        return fail(walk_.arrival().kind == ArrivalKind::kUndecided && options_.stop.requested()
                        ? kStopped
                        : walk_.failure());
      case WalkStep::kEnd:
        break;
    }
    return false;
  }

  void rub(int i) {
    // What is at rest where the segment begins was so before.
    if (not_before(start_, motion_.instant())) return;
    if (options_.minima) note_turning_points();
    const Contact now = motion_.state().contacts[static_cast<std::size_t>(i)];
    segment_.rubbing.push_back({i - static_cast<int>(system_.stops.size()), motion_.instant(),
                                now == Contact::kForward    ? Rubs::kForward
                                : now == Contact::kBackward ? Rubs::kBackward
                                                            : Rubs::kSticks,
                                fall_});
  }

  bool depart() {
    // One instant may have as many changes as stops, and each costs a loop over all stops.
    work_ += static_cast<long long>(system_.stops.size());
    if (poll_.is_due(std::exchange(work_, 0)) && options_.stop.requested()) return fail(kStopped);
    if (walk_.is_at_once() || !motion_.is_sprung() || !carried_.any()) return true;
    if (motion_.is_closed_anywhere() && system_.turns())
      return fail(
          "what a compliant stop does to small deviations of a structure that turns while another "
          "one holds it is not followed");
    if (carried_.by_parameter() &&
        (carried_.closed_now().size() > closed_count() || rubs_at_a_spring()))
      return fail("how a parameter moves what rubs while springs are compressed is not followed");
    carried_.project_to_fixed_time();
    return true;
  }

  bool rubs_at_a_spring() const {
    return std::ranges::any_of(system_.frictions, [](const auto& one) { return one.stop >= 0; });
  }

  std::size_t closed_count() const {
    std::size_t count = 0;
    for (int i = 0; i < static_cast<int>(system_.stops.size()); ++i) count += motion_.is_closed(i);
    return count;
  }

  void flown() {
    const Arrival<double>& arrival = walk_.arrival();
    if (arrival.kind == ArrivalKind::kStandstill) {
      const Friction& friction = system_.friction(arrival.stop);
      fall_ = std::abs(friction.row.dot(carried_.rate_flown().qdot)) /
              (friction.sliding * friction.row.squaredNorm());
    } else if (!walk_.is_at_once()) {
      fall_ = 0.0;
    }
    if (walk_.is_at_once()) {
      if (arrival.kind == ArrivalKind::kContact) carried_.meet_at_once(arrival);
      return;
    }
    work_ += (1 + arrival.evaluations) * system_.modes();
    if (arrival.kind == ArrivalKind::kNotFinite || arrival.kind == ArrivalKind::kRefused) return;
    if (options_.flight) options_.flight(motion_.flown(), walk_.departure(), arrival.flight);
    if (!motion_.flown().springs().empty()) {
      graze::follow(contacts_, motion_.flown(), arrival.flight);
    } else if (arrival.flight > 0.0) {
      if (options_.minima) note_minima(arrival.flight);
      if (options_.along) note_approaches(arrival.flight);
    }
    carried_.carry(arrival);
  }

  Contact contact_at_departure(int i) const {
    return motion_.departure().contacts[static_cast<std::size_t>(i)];
  }

  bool departed_from(int i) const { return contact_at_departure(i) != Contact::kClear; }

  // The open stops from which the last flight moved clear.
  std::vector<int> open_stops() const {
    std::vector<int> open;
    for (int i = 0; i < static_cast<int>(system_.stops.size()); ++i)
      if (contact_at_departure(i) != Contact::kClosed &&
          contact_at_departure(i) != Contact::kLocked)
        open.push_back(i);
    return open;
  }

  int multiplicity(int i) const {
    return motion_.departure().multiplicities[static_cast<std::size_t>(i)];
  }

  void note_minima(double flight) {
    const ExactPhase<double>& phase = *motion_.flown().exact();
    for (const int i : open_stops()) {
      const std::optional<GapMinimum> least =
          lowest_minimum(phase.gap(i, flight, departed_from(i)), multiplicity(i));
      if (least && (!segment_.lowest || least->gap < segment_.lowest->gap))
        segment_.lowest = {i, later(motion_.departure().instant, least->s, system_.period()),
                           least->gap};
    }
    for (SegmentSticking& sticking : holding_)
      if (contact_at_departure(sticking.stop) == Contact::kClosed)
        note_smallest(sticking.smallest_force,
                      smallest_minimum(phase.force(sticking.stop, flight)));
  }

  // Where friction comes to rest a gap at its place turns back between two flights.
  void note_turning_points() {
    // The instant is known to its rounding, in which the speed changes.
    const double located = std::numeric_limits<double>::epsilon() * motion_.instant().local *
                           carried_.rate_now(carried_.closed_now()).qdot.norm();
    for (const int i : open_stops()) {
      const double rounding =
          speed_rounding<double>(stop(i).row, motion_.qdot()) + located * stop(i).row.norm();
      if (motion_.state().contacts[static_cast<std::size_t>(i)] != Contact::kClear ||
          std::abs(motion_.approach_speed(i)) > rounding)
        continue;
      const double gap = motion_.gap(i);
      if (!segment_.lowest || gap < segment_.lowest->gap)
        segment_.lowest = {i, motion_.instant(), gap};
    }
  }

  // The approaches of a flight to the open stops. To first order the gap at a minimum does not
  // depend on its time, nor on the delays of the deviations there.
  void note_approaches(double flight) {
    const ExactPhase<double>& phase = *motion_.flown().exact();
    for (const int i : open_stops())
      for (const GapMinimum& minimum :
           minima_below(phase.gap(i, flight, departed_from(i)), multiplicity(i),
                        std::numeric_limits<double>::infinity()))
        segment_.approaches.push_back({i, segment_.impacts.size(), minimum.s, minimum.gap,
                                       carried_.gap_rate(*options_.along, i, minimum.s)});
  }

  void separate(int i, bool below) {
    if (!below && stop(i).force().separation == Separation::kAtZeroDepth)
      carried_.cross_surface(i, -1.0);
    part(i, -motion_.approach_speed(i), false);
    if (!below) close_contact(i);
  }

  // A spring that grips again below the surface does so smoothly, and continues its contact.
  bool enter(int i) {
    const GapValue<double> gap = gap_value<double>(stop(i).row, motion_.q(), stop(i).gap);
    const auto open = contact_of(i);
    if (std::abs(gap.value) > gap.rounding) {
      if (open == in_contact_.end()) open_contact(i, 0.0, true);
      contact_of(i)->parted = false;
      return true;
    }
    if (open != in_contact_.end()) close_contact(i);
    carried_.cross_surface(i, 1.0);
    open_contact(i, motion_.approach_speed(i), false);
    return ++impacts_ <= options_.max_impacts || out_of_impacts();
  }

  bool out_of_impacts() {
    return fail(fmt::format("the budget of {} impacts was spent", options_.max_impacts));
  }

  bool impact() {
    const State before{motion_.q(), walk_.qdot_before()};
    if (options_.impact) options_.impact(walk_.shares());
    int hits = 0;
    for (const ImpactShare<double>& share : walk_.shares()) {
      if (!share.hit) continue;
      ++hits;
      ++impacts_;
      segment_.impacts.push_back(
          {share.stop, motion_.instant(), share.speed, before,
           options_.along ? carried_.speed_rate(*options_.along, share.stop, before) : 0.0});
    }
    if (impacts_ > options_.max_impacts) return out_of_impacts();
    if (carried_.any() && hits > 1)
      return fail("two stops are hit at one instant: the map has no derivative there");
    carried_.jump(walk_.shares(), before.qdot);
    return true;
  }

  void open_sticking(int i, const Instant<double>& from, bool from_start) {
    holding_.push_back({i, from, from, from_start, false, motion_.force(i), {}});
  }

  void close_sticking(int i) {
    const auto held =
        std::find_if(holding_.begin(), holding_.end(),
                     [i](const SegmentSticking& sticking) { return sticking.stop == i; });
    if (held == holding_.end()) return;
    held->to = motion_.instant();
    segment_.sticking.push_back(*held);
    holding_.erase(held);
  }

  void open_contact(int i, double speed, bool from_start) {
    contacts_[static_cast<std::size_t>(i)] = {};
    contacts_[static_cast<std::size_t>(i)].held = motion_.spring_energy(i);
    SegmentContact contact;
    contact.stop = i;
    contact.from = motion_.instant();
    contact.from_start = from_start;
    contact.speed = speed;
    contact.before = state_now();
    in_contact_.push_back(std::move(contact));
  }

  std::vector<SegmentContact>::iterator contact_of(int i) {
    return std::find_if(in_contact_.begin(), in_contact_.end(),
                        [i](const SegmentContact& contact) { return contact.stop == i; });
  }

  // Ends a contact: the force is gone, at the surface or below it, or the segment is over.
  void part(int i, double speed, bool to_end) {
    const auto open = contact_of(i);
    if (open == in_contact_.end()) return;
    const SpringContact& contact = contacts_[static_cast<std::size_t>(i)];
    open->to = motion_.instant();
    open->to_end = to_end;
    open->parted = !to_end;
    open->speed_after = speed;
    open->peak_force = contact.peak_force;
    open->taken = 0.0 - contact.change(motion_.spring_energy(i));
  }

  void close_contact(int i) {
    const auto open = contact_of(i);
    if (open == in_contact_.end()) return;
    segment_.contacts.push_back(*open);
    in_contact_.erase(open);
  }

  const System& system_;
  Instant<double> start_;
  double fall_ = 0.0;  // of a speed of sliding at its end
  const Instant<double> end_;
  const SegmentOptions& options_;
  Motion<double>& motion_;
  MotionWalk<double> walk_;
  CarriedDeviations carried_;
  std::vector<SegmentSticking> holding_;
  std::vector<SegmentContact> in_contact_;
  SpringContacts contacts_;
  StopPoll poll_;
  long long work_ = 0;  // since it was asked last
  long long impacts_ = 0;
  TrajectorySegment segment_;
};

}  // namespace

TrajectorySegment pass(const System& system, const MotionState<double>& start,
                       const Instant<double>& end, const SegmentOptions& options,
                       Deviations* deviations, ParameterDeviation* parameter) {
  Motion<double> motion(system, start);
  return pass(system, motion, end, options, deviations, parameter);
}

TrajectorySegment pass(const System& system, Motion<double>& motion, const Instant<double>& end,
                       const SegmentOptions& options, Deviations* deviations,
                       ParameterDeviation* parameter) {
  return Follower(system, motion, end, options, deviations, parameter).follow();
}

}  // namespace graze
