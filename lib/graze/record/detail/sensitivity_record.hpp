// The result of compare --sensitivity with what made it.
#pragma once

#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/study/compare/detail/sensitivity.hpp"

namespace graze {

struct SensitivityRecord {
  RunInfo info;
  std::string parameter, unit;
  std::string second, second_unit;  // empty: there is none
  double reference = 0.0;           // value of the parameter that s2 compares with
  std::vector<Probe> probes;
  std::vector<SensitivityCurve> curves;
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "compared", "incomplete" where a run did not reach its end, or why not all values were run.
Outcome sensitivity_outcome(const std::vector<SensitivityCurve>& curves, std::size_t asked,
                            StopReason stopped);

}  // namespace graze
