// All that a motion needs to go on from an instant: its state and the contact at every stop.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/flow/exact/instant.hpp"

namespace graze {

// State of the joint of a hub with Coulomb friction; without friction it is free.
enum class Joint { kFree, kForward, kBackward, kHeld };

// The contact between a stop and the structure at one instant.
enum class Contact {
  kClear,       // gap > 0
  kTouching,    // on the stop; whether it separates or presses is not yet decided
  kDeparting,   // on the stop, leaving
  kClosed,      // held on the stop by its contact force
  kLocked,      // on the stop because other, closed stops keep it there; on a compliant one
                // because nothing moves it
  kCompressed,  // beyond the surface of a compliant stop, against its force
  kParted,      // beyond it, but its force is gone
  // Of dry friction, which sticks where it is closed or, kept at rest by others, locked; touching:
  // at rest and undecided.
  kForward,  // slides at v > 0
  kBackward  // at v < 0
};

// These stand for the multiplicity of a zero that no derivative shows, because springs press as
// powers of time that are not whole, or high: the motion itself decides (WalkingFlow::tells). For a
// contact force that holds the structure since this instant, for one that held it before, and for a
// gap.
inline constexpr int kHeldUntold = 1;
inline constexpr int kHeldBeforeUntold = 2;
inline constexpr int kLeftUntold = 5;
// The contact force of a structure that nothing moves: it stays zero.
inline constexpr int kHeldIdle = 3;

// What dry friction does from an event on.
enum class Rubs { kSticks, kForward, kBackward };

// Of dry friction that is touching: how it slid before; that is locked: how it leans.
inline constexpr int kCameForward = 1;
inline constexpr int kCameBackward = 2;

// What a motion needs to go on from an instant as if it had never stopped there.
template <class Real>
struct MotionState {
  Instant<Real> instant;
  RealVector<Real> q, qdot;
  std::vector<Contact> contacts;  // one per stop and friction
  // Multiplicity of the zero at the instant, one per stop: of the gap, or beyond a surface of the
  // force's grip; for the contact force of a closed stop 0, or one of the constants above. Of dry
  // friction that slides, of the zero of its speed.
  std::vector<int> multiplicities;
  // The remaining speed of a shared chatter that could not be summed, m/s; 0: there was none. The
  // sum is tried again at half of it.
  Real unsummed = 0;
  Joint joint = Joint::kFree;  // of a hub with friction
  // row.q of each dry friction where it began to stick, m; absent without.
  std::optional<std::vector<double>> places{};
};

}  // namespace graze
