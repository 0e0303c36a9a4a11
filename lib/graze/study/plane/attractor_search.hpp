// Stable motions at one place of a plane of two parameters: the attractors of one system, from the
// closed form, from simulation, and from those of neighbouring places.
//
// Every orbit that is stable by its multipliers is checked by simulation: a motion that starts
// beside it has to settle on that very orbit. Conversely, a motion that settles on a (p, 1) orbit
// has to be on one from the closed form, where that applies. With compliant stops the closed form
// of rigid ones only gives starts.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/defaults.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// In the order of a label.
enum class AttractorKind {
  kOrbit,   // impacts without sticking, both numbers at most twice those requested
  kClear,   // meets no stop
  kSticks,  // with a stop closed for part of the time
  kAtRest,  // stays on a stop for ever
  kOther    // orbits of longer periods or with more impacts; motions that do not repeat
};

// Motions with equal names are listed once in a label.
struct MotionName {
  AttractorKind kind = AttractorKind::kOther;
  int period = 0, impacts = 0;                          // p and k of an orbit
  auto operator<=>(const MotionName&) const = default;  // NOLINT(modernize-use-nullptr)
};
// "(1,1)", "no impact", "sticks", "at rest", "other".
std::string name_of(const MotionName& name);

struct Attractor {
  MotionName name;
  std::optional<Orbit> orbit;
  State start;  // a state of the motion at the start of a forcing period
};

struct AttractorSearchOptions {
  int period = 1, impacts = 1;   // p, k asked for
  bool from_closed_form = true;  // with k = 1
  bool from_simulation = true;   // of the scene's initial state
  int random_starts = 1;         // motions besides
  std::uint64_t random_seed = 1;
  std::uint64_t first_draw = 0;  // of the random starts
  // Forcing periods for which a motion is followed at first; up to four times as many where the
  // structure decays slowly.
  long long periods = 1000;
  long long most_periods = 16000;                // while it comes nearer to a repetition
  double nearness = 1e-8;                        // of a motion to its orbit; see SettleOptions
  long long max_impacts = kDefaultImpactBudget;  // of one motion
  double closure_speed = 0.0;                    // m/s
  StopSignal stop;
};

struct PlaceAttractors {
  std::vector<Attractor> list;  // each once; of motions that are no orbits one of each kind
  // Orbits that are stable by their multipliers, although the motion that started beside them went
  // elsewhere; they are not listed.
  std::vector<Orbit> refuted;
  // Orbits that a simulation settled on, or a neighbour led to, and that the closed form missed;
  // they are listed.
  std::vector<Orbit> missed;
  int confirmed = 0;        // orbits that a motion started beside them settled on
  int undecided = 0;        // motions that returned to them, but not to the nearness within the
                            // periods
  int searched = 0;         // stops whose (p, 1) orbits are from the closed form
  long long simulated = 0;  // motions
  std::string message;      // of a motion that could not be followed
  bool finished = true;     // false: stopped before
};

// Searches from the closed form, the steady response, the motion from `initial`, if there is one,
// and random starts. Requires forcing and a stop.
PlaceAttractors find_attractors(const System& system, const std::optional<State>& initial,
                                const AttractorSearchOptions& options);

// Searches from the attractors of a neighbour: its orbits are solved for again here; where that
// fails, or an attractor is no orbit, the motion from its state is followed. Extends counters and
// lists of `known`; new attractors are appended.
PlaceAttractors hand_on(const System& system, PlaceAttractors known,
                        const std::vector<const Attractor*>& from,
                        const AttractorSearchOptions& options);

}  // namespace graze
