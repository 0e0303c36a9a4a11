#include "graze/record/detail/sensitivity_record.hpp"

#include <fmt/format.h>

namespace graze {

Outcome sensitivity_outcome(const std::vector<SensitivityCurve>& curves, std::size_t asked,
                            StopReason stopped) {
  if (stopped == StopReason::kInterrupted)
    return {"interrupted", "stopped before all values were run"};
  if (stopped == StopReason::kOutOfTime || curves.size() < asked)
    return {"budget", "the budget of computing time was spent before all values were run"};
  for (const SensitivityCurve& curve : curves)
    for (const ValueRun& run : curve.runs)
      if (run.outcome != RunOutcome::kReachedEnd)
        return {"incomplete",
                fmt::format("at {:.9g} the run did not reach its end: {}", run.value, run.message)};
  return {"compared", ""};
}

}  // namespace graze
