// All that a motion needs to go on from an instant: its state and how every stop stands to it.
#pragma once

#include <vector>

#include "graze/base/vector.hpp"
#include "graze/flow/exact/instant.hpp"

namespace graze {

// How the joint of a hub with Coulomb friction stands; without friction it is free.
enum class Joint { kFree, kForward, kBackward, kHeld };

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

// In place of the multiplicity of a zero that no derivative tells, because springs press as powers
// of time that are not whole, or high: the motion tells it (WalkingFlow::tells). Of a contact force
// that holds the structure since this instant, of one that did before, and of a gap.
inline constexpr int kHeldUntold = 1;
inline constexpr int kHeldBeforeUntold = 2;
inline constexpr int kLeftUntold = 5;
// The contact force of what nothing moves stays zero.
inline constexpr int kHeldIdle = 3;

// What a motion needs to go on from an instant as if it had never stopped there.
template <class Real>
struct MotionState {
  Instant<Real> instant;
  RealVector<Real> q, qdot;
  std::vector<Contact> contacts;  // one per stop
  // Of the zero at the instant, one per stop: of the gap, or beyond a surface of the force's grip;
  // of the contact force of a closed stop 0 but where the motion has to tell it.
  std::vector<int> multiplicities;
  // The speed left in a shared chatter that could not be summed, m/s; 0: there was none. It is
  // looked at again at half of it.
  Real unsummed = 0;
  Joint joint = Joint::kFree;  // of a hub with friction
};

}  // namespace graze
