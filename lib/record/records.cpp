#include "graze/record/records.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace graze {

Outcome simulation_outcome(const Simulation& run) {
  switch (run.outcome) {
    case RunOutcome::kReachedEnd: return {"reached_end", run.message};
    case RunOutcome::kEventBudget: return {"event_budget", run.message};
    case RunOutcome::kTimeBudget: return {"time_budget", run.message};
    case RunOutcome::kNotFinite: return {"not_finite", run.message};
    case RunOutcome::kInterrupted: return {"interrupted", run.message};
  }
  return {};
}

Outcome orbit_outcome(const FoundOrbits& found, const FinderOptions& options, bool interrupted) {
  if (interrupted) return {"interrupted", "interrupted before all starts were tried"};
  if (!found.orbits.empty()) return {"found", ""};
  std::string message =
      options.impacts
          ? fmt::format("no orbit with {} impact{} in {} forcing period{} was found",
                        *options.impacts, *options.impacts == 1 ? "" : "s", options.period,
                        options.period == 1 ? "" : "s")
          : fmt::format("no orbit with one impact in {} forcing period{} was found, nor does the "
                        "simulation settle on one",
                        options.period, options.period == 1 ? "" : "s");
  if (found.inadmissible > 0)
    message += fmt::format("; {} solution{} of the equations {} no orbit of the system (penetrating "
                           "or impacting at negative speed; --virtual lists such)",
                           found.inadmissible, found.inadmissible == 1 ? "" : "s",
                           found.inadmissible == 1 ? "is" : "are");
  return {"none", message};
}

Outcome branch_outcome(const OrbitBranches& traced, const BranchOptions& options) {
  if (traced.interrupted) return {"interrupted", "interrupted; the branches traced so far are kept"};
  if (traced.branches.empty())
    return {"no_orbit",
            fmt::format("no ({}, 1) orbit was found for {} between {:g} and {:g}{}", options.period,
                        traced.parameter, options.from, options.to,
                        traced.starts > 0 ? "; every solution of the equations penetrates a stop or "
                                            "impacts at negative speed (--virtual traces such)"
                                          : "")};
  const auto cut_short = [](const OrbitBranch& branch) {
    return std::any_of(branch.ends.begin(), branch.ends.end(), [](OrbitBranchEnd end) {
      return end == OrbitBranchEnd::kStepLimit || end == OrbitBranchEnd::kNotConverged;
    });
  };
  const auto short_ones =
      std::count_if(traced.branches.begin(), traced.branches.end(), cut_short);
  if (short_ones > 0)
    return {"budget", fmt::format("{} branch{} could not be traced to an end", short_ones,
                                  short_ones == 1 ? "" : "es")};
  return {"complete", ""};
}

}  // namespace graze
