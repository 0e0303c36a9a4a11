// The result of a diagram of a motion that no forcing repeats: one run from the scene's start at
// each value of a parameter.
#pragma once

#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/study/sweep/detail/run_series.hpp"

namespace graze {

struct RunDiagramRecord {
  RunInfo info;
  std::string parameter, unit;
  double from = 0.0, to = 0.0;
  double duration = 0.0;  // s
  std::size_t stops = 0;
  std::vector<Probe> probes;
  std::vector<ValueRun> runs;  // those that were finished, in the order of the values
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "complete", or "budget" or "interrupted" with what is missing. `asked`: values in all.
Outcome run_diagram_outcome(const std::vector<ValueRun>& runs, std::size_t asked,
                            StopReason stopped);

}  // namespace graze
