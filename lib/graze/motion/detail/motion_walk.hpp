// A walk along a motion, used by simulations, trajectory segments, settling motions, fits and
// reference runs. It flies from event to event, applies the impacts, sums the tails of chatters,
// and reports one event at a time, in the order of time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/motion/detail/motion.hpp"
#include "graze/motion/spring_contact.hpp"

namespace graze {

// Whether the stops of a tail are reported as sticking when the tail is over, or at once, as the
// motion has it.
enum class Tails { kTold, kUntold };

enum class WalkStep {
  kDeparture,   // an arc is about to be flown, or an open decision of an instant to be made
  kFlight,      // that is done; the event at its end comes next
  kImpact,      // at stops that were hit; the motion has left them
  kChatter,     // the impact just reported was the last of a chatter whose tail is summed
  kStick,       // a stop holds the structure from now on; where a tail was summed, it is over
  kRelease,     // of a stop
  kEntry,       // into a compliant stop
  kSeparation,  // from it
  kLeft,        // the surface of a compliant stop, after a separation below it
  kTouch,       // of a stop without an impact
  kFriction,    // dry friction slips, sticks or reverses: see arrival()
  kFailure,     // the motion does not go on; see failure()
  kEnd
};

template <class Real>
class MotionWalk {
 public:
  // Refers to the motion, which must not be moved otherwise. `closure_speed`, m/s: see
  // Motion::close_chatter. `tail`: of a chatter that is summed already.
  MotionWalk(const System& system, Motion<Real>& motion, const Real& closure_speed,
             Tails tails = Tails::kTold, std::optional<ChatterTail> tail = {});

  // The next step, at most up to `end`. Flights are cut at the end of a forcing period, of a tail,
  // and after longest_flight() of scale.hpp, whichever is first. A flight that `end` cuts is
  // searched as if it went on: a motion that goes on from the cut gets the same result to the last
  // bit.
  WalkStep next(const Instant<Real>& end);

  // The stop or the friction of the event.
  int stop() const { return stop_; }
  // For departure and flight: whether only an instant is decided, without an arc; whether the arc
  // is cut by the end; where it begins, and where it ends unless an event happens before (s on the
  // local clock).
  bool is_at_once() const { return at_once_; }
  bool is_cut() const { return cut_; }
  const Instant<Real>& departure() const { return departure_; }
  const Real& until() const { return until_; }
  // For a flight and the event at its end.
  const Arrival<Real>& arrival() const { return arrival_; }
  // For impact and chatter: the shares of the impact, and the velocities before it.
  const std::vector<ImpactShare<Real>>& shares() const { return *shares_; }
  const RealVector<Real>& qdot_before() const { return qdot_before_; }
  // For a chatter.
  const ClosedChatter<Real>& closed() const { return *closed_; }
  // The reason of a failure, as a main clause.
  std::string failure() const;

  // The tail of the chatter that was summed, until it is over.
  const std::optional<ChatterTail>& tail() const { return tail_; }
  // Whether a stop holds the structure and this was reported.
  bool is_stuck(int stop) const { return motion_.is_closed(stop) && !is_in_tail(stop); }
  // Whether it does, but will only be reported when the tail is over.
  bool is_in_tail(int stop) const { return tail_ && tail_->holds(stop); }

 private:
  WalkStep depart(const Instant<Real>& end);
  WalkStep fly();
  std::optional<WalkStep> happen();
  void leave_tail();
  std::optional<WalkStep> sum_tail();

  Motion<Real>& motion_;
  int stops_;
  Real closure_speed_;
  double longest_flight_;  // s
  std::vector<const TimeCourse*> courses_;
  bool alone_;             // a single stop
  Tails tails_;
  std::optional<ChatterTail> tail_;
  std::vector<int> told_;  // stops of a tail that is over, still to be reported

  int stop_ = -1;
  enum class Due { kDeparture, kFlight, kWhatLiesAtItsEnd, kTail };
  Due due_ = Due::kDeparture;  // what is looked at next
  bool at_once_ = false, cut_ = false;
  Instant<Real> departure_;
  Real until_ = 0, horizon_ = 0;
  Arrival<Real> arrival_;
  const std::vector<ImpactShare<Real>>* shares_ = nullptr;
  RealVector<Real> qdot_before_;
  std::optional<ClosedChatter<Real>> closed_;
};

}  // namespace graze
