// A special point with its full orbit, apart from the branch or the locus it was found on: all that
// is needed to continue from there, in the same parameter or in another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/bifurcation/problem/orbit_branch.hpp"
#include "graze/bifurcation/problem/orbit_locus.hpp"

namespace graze {

struct FollowedAnswer;
struct SegmentOptions;

struct SpecialOrbit {
  std::string id, label;                  // "PD1", "PD"; on a locus "CP-1", "CP"
  std::optional<SpecialKind> kind{};      // on a branch
  std::optional<OrbitLocusKind> locus{};  // of the locus it was found on; nullopt: on a branch
  std::vector<double> values;             // of the parameter, on a locus of both
  // Empty for an orbit that sticks or is on compliant stops; on a locus of grazing the grazing
  // contact is among the impacts.
  ImpactPattern pattern;
  std::vector<ImpactPoint> impacts;  // in the pattern's order
  // The branch's direction there, of any length, in the units of its unknowns.
  struct Direction {
    std::vector<ImpactPoint> impacts;
    double value = 0.0;
  };
  std::optional<Direction> along;          // of a branch whose orbits do not stick
  std::optional<Complex> multiplier;       // the critical one
  bool by_speed = false, by_push = false;  // as of SpecialPoint
  std::string level{};                     // of UZ and EX, and on their loci: its name
  // An orbit that is followed, as the states from which the motion repeats it: one within a stuck
  // phase, or those at the starts of its forcing periods. At the ends of a branch that sticks,
  // where the motion no longer sticks, those of the neighbouring point.
  struct Followed {
    int period = 1;      // p
    double value = 0.0;  // of the parameter; on a locus of the first one
    std::vector<MotionState<double>> states;
    double closure_speed = 0.0;  // m/s
  };
  std::optional<Followed> followed{};
  bool sticks() const;
};

// For a special point that is followed: its orbit, with all that its equations need for a start.
// `system`: at its values.
FollowedAnswer orbit_again(const System& system, const SpecialOrbit& special,
                           SegmentOptions segment);

// Start of a branch without any search: a special point, at the value of the parameter in the
// family's own scene.
struct BranchStart {
  SpecialOrbit at;
  bool same_parameter = false;  // of the branch it was found on, whose direction is then known
  bool switched = false;        // onto the branch that begins or crosses there
};

}  // namespace graze
