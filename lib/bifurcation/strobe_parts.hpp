// A traced branch of orbits on compliant stops, cut into parts of orbits with the same contacts.
#pragma once

#include <vector>

#include "graze/bifurcation/passage_equations.hpp"

namespace graze {

struct StrobePart {
  OrbitBranch branch;
  // Of each special point, in the trace: what to switch from. Only PD and BP have one.
  std::vector<std::optional<CriticalPoint>> critical;
  // Of each special point: the equations that it solves.
  std::vector<PassageEquations*> on;
};

// Those with contacts; the response that meets no stop is none.
std::vector<StrobePart> parts_of(PassageEquations& equations, const ContinuationOptions& options,
                                 const Branch& trace);
// Appends those of a trace that begins with the orbit which the last one ends with.
void append_parts(std::vector<StrobePart>& parts, std::vector<StrobePart> more);

// Whether a step along a branch shows what its contacts do: where one is born or lost within it,
// its grazing lies there too, and the branch has not turned too far up to that.
bool resolves_contacts(const PassageEquations& equations, const ContinuationOptions& options,
                       const BranchPoint& from, const BranchPoint& to);

}  // namespace graze
