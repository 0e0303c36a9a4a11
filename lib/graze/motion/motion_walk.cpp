#include "graze/motion/detail/motion_walk.hpp"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>
#include <utility>

#include "graze/base/stop_scope.hpp"
#include "graze/flow/exact/extended.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Courses of loads, whose flights are cut where their lines meet.
std::vector<const TimeCourse*> courses_of(const System& system) {
  std::vector<const TimeCourse*> list;
  if (system.harmonics())
    for (const Harmonic& one : *system.harmonics())
      if (one.timed) list.push_back(one.timed->course.get());
  return list;
}

}  // namespace

template <class Real>
MotionWalk<Real>::MotionWalk(const System& system, Motion<Real>& motion, const Real& closure_speed,
                             Tails tails, std::optional<ChatterTail> tail)
    : motion_(motion),
      stops_(static_cast<int>(system.stops.size())),
      closure_speed_(closure_speed),
      longest_flight_(longest_flight(system)),
      courses_(courses_of(system)),
      alone_(system.stops.size() == 1),
      tails_(tails),
      tail_(std::move(tail)) {}

template <class Real>
WalkStep MotionWalk<Real>::next(const Instant<Real>& end) {
  std::optional<WalkStep> step;
  switch (std::exchange(due_, Due::kDeparture)) {
    case Due::kDeparture:
      break;
    case Due::kFlight:
      return fly();
    case Due::kWhatLiesAtItsEnd:
      step = happen();
      break;
    case Due::kTail:
      step = sum_tail();
      break;
  }
  return step ? *step : depart(end);
}

// Takes the next step from the present instant on.
template <class Real>
WalkStep MotionWalk<Real>::depart(const Instant<Real>& end) {
  const Instant<Real>& now = motion_.instant();
  // The event at the end of a cut arc is decided when the arc is flown again as a whole.
  if (std::exchange(cut_, false) && not_before(now, end)) return WalkStep::kEnd;
  at_once_ = motion_.has_pending_events();
  if (!at_once_) {
    if (tail_ && not_before(now, tail_->over)) {
      told_.assign(tail_->stops.rbegin(), tail_->stops.rend());
      tail_.reset();
    }
    while (!told_.empty()) {
      stop_ = told_.back();
      told_.pop_back();
      if (motion_.is_closed(stop_)) return WalkStep::kStick;
    }
    if (not_before(now, end)) return WalkStep::kEnd;
  }
  due_ = Due::kFlight;
  departure_ = now;
  horizon_ = until_ = now.local;
  if (at_once_) return WalkStep::kDeparture;
  horizon_ = motion_.flow().period();
  if (tail_ && tail_->over.period == now.period)
    horizon_ = std::min<Real>(horizon_, tail_->over.local);
  for (const TimeCourse* course : courses_)
    horizon_ = std::min<Real>(horizon_, Real(course->next(static_cast<double>(now.local))));
  if (horizon_ - now.local > longest_flight_) horizon_ = now.local + longest_flight_;
  cut_ = now.period == end.period && end.local <= horizon_;
  until_ = cut_ ? end.local : horizon_;
  using std::isfinite;
  if (!isfinite(horizon_)) horizon_ = until_;
  return WalkStep::kDeparture;
}

template <class Real>
WalkStep MotionWalk<Real>::fly() {
  // Callers without a signal of their own are covered by the scope's.
  const StopSignal& stop = StopScope::current();
  if (stop.interrupted || stop.deadline) motion_.stop_on(stop);
  if (StopScope::is_over()) {
    arrival_ = {ArrivalKind::kUndecided};
    return WalkStep::kFailure;
  }
  arrival_ = motion_.fly(until_, horizon_);
  if (arrival_.kind != ArrivalKind::kTime) cut_ = false;
  due_ = Due::kWhatLiesAtItsEnd;
  return WalkStep::kFlight;
}

// The event at the end of the flight, if any.
template <class Real>
std::optional<WalkStep> MotionWalk<Real>::happen() {
  stop_ = arrival_.stop;
  switch (arrival_.kind) {
    case ArrivalKind::kTime:
    case ArrivalKind::kJoint:
    case ArrivalKind::kStandstill:
      return {};
    case ArrivalKind::kSlip:
    case ArrivalKind::kReversal:
      return WalkStep::kFriction;
    case ArrivalKind::kContact:
      qdot_before_ = motion_.qdot();
      shares_ = &motion_.impact();
      due_ = Due::kTail;
      return WalkStep::kImpact;
    case ArrivalKind::kStick:
      if (stop_ >= stops_) return WalkStep::kFriction;
      if (is_in_tail(stop_)) return {};
      return WalkStep::kStick;
    case ArrivalKind::kRelease:
      leave_tail();
      return WalkStep::kRelease;
    case ArrivalKind::kEntry:
      return WalkStep::kEntry;
    case ArrivalKind::kSeparation:
      return WalkStep::kSeparation;
    case ArrivalKind::kLeft:
      return WalkStep::kLeft;
    case ArrivalKind::kTouch:
      return WalkStep::kTouch;
    case ArrivalKind::kUndecided:
    case ArrivalKind::kNotFinite:
    case ArrivalKind::kRefused:
      break;
  }
  return WalkStep::kFailure;
}

// The stop is released before the tail is over.
template <class Real>
void MotionWalk<Real>::leave_tail() {
  if (!tail_) return;
  std::erase(tail_->stops, stop_);
  if (tail_->stops.empty()) tail_.reset();
}

// Sums the chatter that the impact belongs to; returns nullopt when that is not yet possible.
template <class Real>
std::optional<WalkStep> MotionWalk<Real>::sum_tail() {
  // At a single stop only impacts up to the closure speed are summed.
  if (alone_ && shares_->size() == 1 && shares_->front().speed > closure_speed_) return {};
  closed_ = motion_.close_chatter(*shares_, closure_speed_);
  if (!closed_) return {};
  if (tails_ == Tails::kTold) {
    const Instant<Real> over = later(motion_.instant(), closed_->duration, motion_.flow().period());
    tail_ = {closed_->stops, {over.period, static_cast<double>(over.local)}};
  }
  stop_ = closed_->stops.front();
  return WalkStep::kChatter;
}

template <class Real>
std::string MotionWalk<Real>::failure() const {
  const bool at_stop = arrival_.stop >= 0;
  const std::string place = arrival_.stop < stops_
                                ? fmt::format("stop {}", arrival_.stop + 1)
                                : fmt::format("friction {}", arrival_.stop - stops_ + 1);
  switch (arrival_.kind) {
    case ArrivalKind::kUndecided:
      return fmt::format("the search for the next event{} used up its evaluations",
                         at_stop ? " at " + place : "");
    case ArrivalKind::kNotFinite:
      return std::is_same_v<Real, double> ? "the motion left the range of double precision"
                                          : "the motion left the range of the numbers";
    default:
      return fmt::format("the motion{} cannot be followed: {}", at_stop ? " on " + place : "",
                         motion_.refusal());
  }
}

template class MotionWalk<double>;
// Compiled in motion_extended.cpp: its definitions may stand in the same unit here.
extern template class Motion<Extended>;
template class MotionWalk<Extended>;

}  // namespace graze
