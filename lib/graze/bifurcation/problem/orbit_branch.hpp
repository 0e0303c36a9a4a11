// A branch of periodic orbits as a value: its points, its special points, how it ends; and the
// conversion of solutions of a zero problem (branch_values.hpp) into such values.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/angle.hpp"
#include "graze/continuation/branch.hpp"
#include "graze/continuation/normal_form.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

enum class SpecialKind {
  kFold,              // LP: the branch turns back
  kPeriodDoubling,    // PD: a multiplier passes -1
  kTorus,             // NS: a complex pair of multipliers passes the unit circle
  kBranchPoint,       // BP: another branch of the same impact pattern crosses
  kGrazing,           // GR: an approach touches a stop, an impact speed vanishes, or one with r = 0
                      // begins to stick
  kChatterCompletes,  // CH: a chatter completes at the instant of its release
  kLiftOff,           // LO: the contact force of a structure at rest on a stop touches zero
  // Of dry friction:
  kGrazingSliding,    // GS: the speed of sliding touches zero, and a rest begins
  kCrossingSliding,   // CS: a reversal becomes a rest
  kSwitchingSliding,  // SS: a rest ends towards the other side
  kAddingSliding,     // AS: a slip begins within a rest
  kLevel,             // UZ: a number of the orbit takes a value (OrbitLevel)
  kExtreme            // EX: it is largest or smallest along the branch
};

// UZ and EX.
inline bool is_of_level(SpecialKind kind) {
  return kind == SpecialKind::kLevel || kind == SpecialKind::kExtreme;
}

struct OrbitBranchPoint {
  double value = 0.0;  // of the parameter
  Orbit orbit;
  int unstable_multipliers = 0;
  double smallest_speed = 0.0;  // m/s
};

struct SpecialPoint {
  SpecialKind kind = SpecialKind::kFold;
  std::string id;  // "LP1"
  OrbitBranchPoint at;
  std::optional<Complex> multiplier;  // the critical one
  // For a grazing: whether an impact speed vanishes there (else an interior approach touches).
  bool by_speed = false;
  SolutionPoint solution;  // of the shooting equations, to continue from
  // For CH: whether a contact force touches zero within a stuck phase and cuts it in two (else one
  // shrinks to nothing).
  bool interrupted = false;
  // For a grazing: whether an impact that leaves its stop at rest (r = 0) begins to stick there.
  bool by_push = false;
  std::size_t level = 0;               // for UZ and EX: which of the levels that were asked for
  std::optional<NormalForm> normal{};  // of LP, PD and NS, where it was asked for

  // Phase, rad, and approach speed, m/s, of the orbit's first impact; for a lift-off those of the
  // flight that shrinks to nothing. Returns nullopt when there is neither.
  struct Impact {
    double phase = 0.0, speed = 0.0;
  };
  std::optional<Impact> impact() const;
};

enum class OrbitBranchEnd {
  kParameterLimit,
  kClosed,
  kGrazing,
  kChatterCompletes,
  kLevel,           // of a number of its orbits
  kAtRest,          // beyond the lift-off there, the structure stays at rest on the stop
  kPeriodDoubling,  // where it joins orbits of half the period
  kSliding,         // friction would slide or stick in another order, with a jump
  kImpactsMeet,     // a flight from impact to impact shrinks to nothing: their order would change
  kStepLimit,
  kOutOfTime,  // the budget of computing time is spent
  kStopped,    // from outside
  kNotConverged
};

struct OrbitBranch {
  int id = 0;             // from 1
  int component = 0;      // connected set of solutions it is part of, from 1
  ImpactPattern pattern;  // its stops are empty for orbits that stick, whose number of impacts
                          // varies
  // For orbits that stick: the stops that are closed by a chatter, in time order.
  std::vector<int> sticking;
  std::string origin;                    // id of the special point it was switched onto from, or ""
  std::vector<OrbitBranchPoint> points;  // in order along the branch, special points among them
  std::vector<SpecialPoint> special;     // in order along the branch
  std::array<OrbitBranchEnd, 2> ends{OrbitBranchEnd::kNotConverged, OrbitBranchEnd::kNotConverged};

  bool sticks() const { return !sticking.empty(); }
};

// An orbit as a point of a branch.
OrbitBranchPoint point_of_branch(double value, Orbit orbit);

// Whether a special point of the equations is a special point of orbits, too: where branches of
// orbits cross, a multiplier is 1. Beside a grazing of orbits that stick the map's derivative
// jumps, and the orientation with it; and where an amplitude passes zero, orbits shrink to a point
// of rest that is a solution at every phase.
bool is_of_orbits(const CriticalPoint& critical);
// The orbit there: its critical multipliers are on the unit circle, on whichever side rounding has
// put them.
OrbitBranchPoint with_critical(OrbitBranchPoint at, const CriticalPoint& critical);
// That special point, without a name; `at`: that orbit.
SpecialPoint as_special(const CriticalPoint& critical, OrbitBranchPoint at);

// The end of a branch of orbits that corresponds to the end of a traced branch.
OrbitBranchEnd as_orbit_end(BranchEnd end);

}  // namespace graze
