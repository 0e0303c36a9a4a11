// A branch of orbits on compliant stops, traced in pieces: where a contact that begins or ends with
// a jump of the derivative comes near the stroboscopic section, at which the equations would have a
// corner though nothing happens to the orbits, the section moves away from all of them and the
// branch goes on from there.
#pragma once

#include <functional>
#include <vector>

#include "graze/bifurcation/passage_equations.hpp"

namespace graze {

struct StrobePiece {
  PassageEquations* equations;
  Branch branch;
};

// The equations of the same orbits at a section.
using AtSection = std::function<PassageEquations&(double section)>;

// In order along the branch; each piece but the first begins with the orbit that the one before it
// ends with. Its orbits meet stops, and its period is not halved, but at the ends.
std::vector<StrobePiece> trace_pieces(const AtSection& at_section, PassageEquations& equations,
                                      const ContinuationOptions& options, const BranchPoint& start,
                                      Directions directions);

}  // namespace graze
