// The result of a bifurcation diagram: a sweep, and the branches over it.
#pragma once

#include <optional>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/study/sweep/sweep.hpp"

namespace graze {

// What a picture shows of a branch over the parameter: impact speeds (m/s) or displacements at a
// stop (m), one for every impact or forcing period of an orbit.
struct DiagramCurve {
  std::vector<std::vector<double>> points, special;  // of each point of the branch
};

struct DiagramRecord {
  // With what made the diagram and the outcome of the whole; without branches where none were asked
  // for.
  BranchRecord branches;
  Sweep swept;
  DiagramSection section = DiagramSection::kImpact;
  // One a branch; of a stroboscopic section such a list for each stop, of impacts one for all of
  // them together.
  std::vector<std::vector<DiagramCurve>> curves;
};

// Impacts slower than this part of the fastest are not shown where a chatter completes: there is no
// end to them.
inline constexpr double kSlowestShown = 1e-3;

// The speeds of all impacts along the branches; where a chatter completes of those that are not
// many times slower than the fastest.
std::vector<DiagramCurve> impact_curves(const OrbitBranches& traced);

// What is shown of the amplitudes along the branches, one height a point; requires both.
std::vector<DiagramCurve> amplitude_curves(const BranchRecord& record);
// The same of another number of them.
std::vector<DiagramCurve> amplitude_curves(const BranchAmplitudes& amplitudes, const Shown& shown);

// The same of a row of the sweep over them.
std::optional<double> shown_height(const BranchRecord& record, const SweepRow& row);

// The displacements at each stop at t = 0, T, 2T, .. along the branches.
std::vector<std::vector<DiagramCurve>> stroboscopic_curves(const SystemFamily& family,
                                                           const OrbitBranches& traced);

// How the diagram ended: `branches` is the outcome of tracing them, as far as they were asked for.
Outcome diagram_outcome(const Sweep& swept, const std::optional<Outcome>& branches);

}  // namespace graze
