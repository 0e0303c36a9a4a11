// One walk along a motion: what simulations, segments, settling motions, fits and reference runs
// share. It flies from event to event, applies the impacts, sums the tails of chatters, and hands
// out what happens one thing at a time, in the order of time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/motion/chatter_tail.hpp"
#include "graze/motion/detail/motion.hpp"

namespace graze {

// Whether the stops of a tail are handed out as sticking when it is over, or at once, as the motion
// has it.
enum class Tails { kTold, kUntold };

enum class WalkStep {
  kDeparture,   // an arc is about to be flown, or what an instant leaves open to be decided
  kFlight,      // that is done; what lies at its end comes next
  kImpact,      // at stops that were hit; the motion has left them
  kChatter,     // of which that was the last impact told: its tail is summed
  kStick,       // a stop holds the structure from now on; where a tail was summed, it is over
  kRelease,     // of a stop
  kEntry,       // into a compliant stop
  kSeparation,  // from it
  kLeft,        // the surface of a compliant stop, after a separation below it
  kTouch,       // of a stop without an impact
  kFailure,     // the motion does not go on; see failure()
  kEnd
};

template <class Real>
class MotionWalk {
 public:
  // Refers to the motion, which nobody else moves. `closure_speed`, m/s: see
  // Motion::close_chatter. `tail`: of a chatter that is summed already.
  MotionWalk(const System& system, Motion<Real>& motion, const Real& closure_speed,
             Tails tails = Tails::kTold, std::optional<ChatterTail> tail = {});

  // The next thing that happens, at most up to `end`. Flights are cut at the end of a forcing
  // period, of a tail, and after longest_flight() of scale.hpp, whichever is first. One that `end`
  // cuts is searched as if it went on: a motion that goes on from the cut finds the same to the
  // last bit.
  WalkStep next(const Instant<Real>& end);

  // The stop at which it happens.
  int stop() const { return stop_; }
  // Departure and flight: whether an instant is decided, and no arc flown; whether the arc is cut
  // by the end; where it begins, and where it ends unless something happens before (s on the local
  // clock).
  bool is_at_once() const { return at_once_; }
  bool is_cut() const { return cut_; }
  const Instant<Real>& departure() const { return departure_; }
  const Real& until() const { return until_; }
  // Flight, and what lies at its end.
  const Arrival<Real>& arrival() const { return arrival_; }
  // Impact and chatter: the shares of the impact, and the velocities before it.
  const std::vector<ImpactShare<Real>>& shares() const { return *shares_; }
  const RealVector<Real>& qdot_before() const { return qdot_before_; }
  // Chatter.
  const ClosedChatter<Real>& closed() const { return *closed_; }
  // A main clause.
  std::string failure() const;

  // Of the chatter that was summed, until it is over.
  const std::optional<ChatterTail>& tail() const { return tail_; }
  // Whether a stop holds the structure, and that was handed out.
  bool is_stuck(int stop) const { return motion_.is_closed(stop) && !is_in_tail(stop); }
  // Whether it does, but that will be handed out when the tail is over.
  bool is_in_tail(int stop) const { return tail_ && tail_->holds(stop); }

 private:
  WalkStep depart(const Instant<Real>& end);
  WalkStep fly();
  std::optional<WalkStep> happen();
  void leave_tail();
  std::optional<WalkStep> sum_tail();

  Motion<Real>& motion_;
  Real closure_speed_;
  double longest_flight_;  // s
  bool alone_;             // a single stop
  Tails tails_;
  std::optional<ChatterTail> tail_;
  std::vector<int> told_;  // stops of a tail that is over, still to be handed out

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
