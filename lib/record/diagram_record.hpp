// The result of a bifurcation diagram: a sweep, and the branches over it.
#pragma once

#include <vector>

#include "graze/record/records.hpp"
#include "graze/study/sweep.hpp"

namespace graze {

// What is seen of a motion.
enum class DiagramSection {
  kImpact,  // phase and speed of every impact
  kStrobe   // displacement and velocity at the stops at the start of every forcing period
};

// What a diagram shows of a branch over the parameter: impact speeds (m/s) or displacements at the
// first stop (m), one for every impact or forcing period of an orbit.
struct DiagramCurve {
  std::vector<std::vector<double>> points, special;  // of each point of the branch
};

struct DiagramRecord {
  // With what made the diagram and the outcome of the whole; without branches where none were asked
  // for.
  BranchRecord branches;
  Sweep swept;
  DiagramSection section = DiagramSection::kImpact;
  std::vector<DiagramCurve> curves;  // one a branch
};

// The curves of the branches in this section.
std::vector<DiagramCurve> diagram_curves(const SystemFamily& family, const OrbitBranches& traced,
                                         DiagramSection section);

// How the diagram ended: `branches` is the outcome of tracing them, as far as they were asked for.
Outcome diagram_outcome(const Sweep& swept, const std::optional<Outcome>& branches);

}  // namespace graze
