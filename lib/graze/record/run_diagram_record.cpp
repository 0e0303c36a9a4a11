#include "graze/record/detail/run_diagram_record.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace graze {

Outcome run_diagram_outcome(const std::vector<ValueRun>& runs, std::size_t asked,
                            StopReason stopped) {
  if (runs.size() < asked) return stopped_outcome(stopped, runs.size(), asked, "values").value();
  const auto is_cut = [](const ValueRun& run) { return run.outcome != RunOutcome::kReachedEnd; };
  const auto first = std::find_if(runs.begin(), runs.end(), is_cut);
  if (first == runs.end()) return {"complete", ""};
  return {"budget", fmt::format("{} of {} runs did not reach their end; the first, at {:.9g}: {}",
                                std::count_if(runs.begin(), runs.end(), is_cut), asked,
                                first->value, first->message)};
}

}  // namespace graze
