// A special point with its full orbit, apart from the branch or the locus it was found on: what it
// takes to go on from there, in the same parameter or in another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/bifurcation/orbit_branch.hpp"
#include "graze/bifurcation/orbit_locus.hpp"
#include "graze/hybrid/motion.hpp"

namespace graze {

struct SpecialOrbit {
  std::string id, label;                  // "PD1", "PD"; on a locus "CP-1", "CP"
  std::optional<SpecialKind> kind{};      // on a branch
  std::optional<OrbitLocusKind> locus{};  // that it was found on; nothing: on a branch
  std::vector<double> values;             // of the parameter, on a locus of both
  // Nothing of an orbit that sticks or is on compliant stops; on a locus of grazing with the touch
  // among the impacts.
  ImpactPattern pattern;
  std::vector<ImpactPoint> impacts;  // in the pattern's order
  // The branch's direction there, however long, in the units of what it moves.
  struct Direction {
    std::vector<ImpactPoint> impacts;
    double value = 0.0;
  };
  std::optional<Direction> along;          // of a branch whose orbits do not stick
  std::optional<Complex> multiplier;       // the critical one
  bool by_speed = false, by_push = false;  // as of SpecialPoint
  // An orbit that sticks, as a state within a stuck phase from which the motion repeats it. At the
  // ends of a branch, where it no longer does, that of the point beside.
  struct Sticking {
    int period = 1;      // p
    double value = 0.0;  // of the parameter
    MotionState<double> at_section;
    double closure_speed = 0.0;  // m/s
  };
  std::optional<Sticking> sticking;
  // An orbit on compliant stops, as its states at the starts of its forcing periods.
  struct Strobe {
    double value = 0.0;  // of the parameter
    std::vector<State> turns;
    double closure_speed = 0.0;  // m/s
  };
  std::optional<Strobe> strobe{};
};

// Where a branch is to be traced from, without any search: from a special point, at the value that
// the family's own scene has.
struct BranchStart {
  SpecialOrbit at;
  bool same_parameter = false;  // as of the branch it was found on, whose direction is then known
  bool switched = false;        // onto the branch that begins or crosses there
};

}  // namespace graze
