// How a flight ends and how the stops stand to the structure there: what the phases of a motion and
// those who decide between them tell each other.
#pragma once

#include <optional>
#include <vector>

#include "graze/flow/instant.hpp"
#include "graze/flow/turning_structure.hpp"

namespace graze {

enum class ArrivalKind {
  kTime,        // the end of the flight was reached
  kContact,     // at a stop, approaching: `impact` is due
  kTouch,       // at a stop within rounding, not approaching: no impact; fly on
  kStick,       // at rest on a stop and pushed: it is closed from now on
  kRelease,     // the contact force of a closed stop is gone: it is open from now on
  kEntry,       // a spring is compressed from now on
  kSeparation,  // the force of a compressed spring is gone
  kLeft,        // the surface of a stop whose force was gone before
  kJoint,       // a hub's joint with friction stands still, or is turned again
  kUndecided,   // the search for an event used up its evaluations
  kNotFinite,   // the state left the range of the scalar
  kRefused      // the motion on the stop cannot be followed; see refusal()
};

template <class Real>
struct Arrival {
  ArrivalKind kind = ArrivalKind::kTime;
  int stop = -1;              // -1: the event, or what is refused, is at none
  Real flight = 0;            // s, length of the arc
  Real speed = 0;             // m/s, approach speed at a contact
  long long evaluations = 0;  // of gaps and contact forces, in search of the event
  // Least of these at the ends of the steps of a motion that is integrated step by step.
  std::optional<Real> lowest{};
  // Separation: the force is gone below the surface of the stop, which is left later.
  bool below = false;
  bool forward = false;  // joint: what has held it is turned forward

  // Whether the motion does not go on.
  bool fails() const {
    return kind == ArrivalKind::kUndecided || kind == ArrivalKind::kNotFinite ||
           kind == ArrivalKind::kRefused;
  }
};

// How a stop stands to the structure at one instant.
enum class Contact {
  kClear,       // gap > 0
  kTouching,    // on the stop, and what follows is still to be decided
  kDeparting,   // on the stop, leaving
  kClosed,      // held on the stop by its contact force
  kLocked,      // on the stop because other, closed stops keep it there; on a compliant one
                // because nothing moves it
  kCompressed,  // beyond the surface of a compliant stop, against its force
  kParted       // beyond it, but its force is gone
};

// What a motion needs to go on from an instant as if it had never stopped there.
template <class Real>
struct MotionState {
  Instant<Real> instant;
  RealVector<Real> q, qdot;
  std::vector<Contact> contacts;  // one per stop
  // Of the zero at the instant, one per stop: of the gap, or beyond a surface of the force's grip.
  std::vector<int> multiplicities;
  // The speed left in a shared chatter that could not be summed, m/s; 0: there was none. It is
  // looked at again at half of it.
  Real unsummed = 0;
  Joint joint = Joint::kFree;  // of a hub with friction
};

}  // namespace graze
