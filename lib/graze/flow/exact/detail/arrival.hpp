// How a flight ends: the event that a phase reports to the code that decides on the next phase.
#pragma once

#include <optional>

#include "graze/flow/exact/motion_state.hpp"

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
  // Smallest gap or contact force at the ends of the steps of a motion that is integrated.
  std::optional<Real> lowest{};
  // Separation: the force is gone below the surface of the stop, which is left later.
  bool below = false;
  bool forward = false;  // joint: the torque that its friction held turns it forward
  // For a spring whose surface the structure was touching at rest: it is entered, or left, from the
  // start of the arc on, and certain for at least this long, s.
  Real sure = 0;
  // The sign of a contact force that was zero at the start is certain `sure` seconds after it.
  bool told = false;

  // Whether the motion does not go on.
  bool fails() const {
    return kind == ArrivalKind::kUndecided || kind == ArrivalKind::kNotFinite ||
           kind == ArrivalKind::kRefused;
  }
};

}  // namespace graze
