// The results of the commands as values: what was computed and what made it. Reports format them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/bifurcation/orbit_branches.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/orbit/finder.hpp"
#include "graze/record/run_info.hpp"

namespace graze {

// How a command ended, in the words of the result document.
struct Outcome {
  std::string name;     // "reached_end", "found", "complete", ..
  std::string message;  // a sentence unless all went well
};

struct CheckRecord {
  RunInfo info;
  Scene scene;
  System system;
  double collocation_condition = 0.0;  // 0: nothing collocates
  std::vector<std::string> warnings;
  Outcome outcome;
};

struct SimulationRecord {
  RunInfo info;
  System system;
  Simulation run;
  std::vector<Event> events;    // empty unless recorded
  std::vector<Sample> samples;  // empty unless recorded
  std::vector<std::string> warnings;
  Outcome outcome;
};

struct OrbitRecord {
  RunInfo info;
  System system;
  FoundOrbits found;
  std::vector<std::string> warnings;
  Outcome outcome;
};

struct BranchRecord {
  RunInfo info;
  System system;  // at the scene's own value
  OrbitBranches traced;
  double from = 0.0, to = 0.0;
  std::string unit;  // of the parameter
  std::vector<std::string> warnings;
  Outcome outcome;
};

Outcome simulation_outcome(const Simulation& run);
Outcome orbit_outcome(const FoundOrbits& found, const FinderOptions& options, StopReason stopped);
Outcome branch_outcome(const OrbitBranches& traced, const BranchOptions& options);

}  // namespace graze
