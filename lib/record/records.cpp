#include "graze/record/records.hpp"

#include <fmt/format.h>

namespace graze {

Outcome simulation_outcome(const Simulation& run) {
  switch (run.outcome) {
    case RunOutcome::kReachedEnd:
      return {"reached_end", run.message};
    case RunOutcome::kEventBudget:
      return {"event_budget", run.message};
    case RunOutcome::kTimeBudget:
      return {"time_budget", run.message};
    case RunOutcome::kNotFinite:
      return {"not_finite", run.message};
    case RunOutcome::kInterrupted:
      return {"interrupted", run.message};
  }
  return {};
}

Outcome orbit_outcome(const FoundOrbits& found, const FinderOptions& options, StopReason stopped) {
  if (stopped == StopReason::kInterrupted)
    return {"interrupted", "stopped before all starts were tried"};
  if (stopped == StopReason::kOutOfTime)
    return {"budget", "the budget of computing time was spent before all starts were tried"};
  if (!found.orbits.empty()) return {"found", ""};
  if (found.closed_form.tried + found.random.tried == 0 && !found.simulated && found.notes.empty())
    return {"none",
            "none of the chosen starts applies: the closed form and the random starts are "
            "for one impact, the simulation needs a start clear of the stop"};
  std::string message =
      options.impacts
          ? fmt::format("no orbit with {} impact{} in {} forcing period{} was found",
                        *options.impacts, *options.impacts == 1 ? "" : "s", options.period,
                        options.period == 1 ? "" : "s")
          : fmt::format("no orbit with one impact in {} forcing period{} was found{}",
                        options.period, options.period == 1 ? "" : "s",
                        found.simulated ? ", nor does the simulation settle on one" : "");
  if (found.inadmissible > 0)
    message += fmt::format(
        "; {} solution{} of the equations {} no orbit of the system (penetrating "
        "or impacting at negative speed; --virtual lists such)",
        found.inadmissible, found.inadmissible == 1 ? "" : "s",
        found.inadmissible == 1 ? "is" : "are");
  return {"none", message};
}

Outcome branch_outcome(const OrbitBranches& traced, const BranchOptions& options) {
  if (traced.stopped == StopReason::kInterrupted)
    return {"interrupted", "stopped; the branches traced so far are kept"};
  if (traced.stopped == StopReason::kOutOfTime)
    return {"budget",
            "the budget of computing time was spent; the branches traced so far are kept"};
  if (traced.branches.empty() && traced.cut_short == 0)
    return {"no_orbit", fmt::format("no ({}, 1) orbit was found for {} between {:g} and {:g}{}",
                                    options.period, traced.parameter, options.from, options.to,
                                    traced.starts > 0
                                        ? "; every solution of the equations penetrates a stop or "
                                          "impacts at negative speed (--virtual traces such)"
                                        : "")};
  if (traced.cut_short > 0)
    return {"budget",
            fmt::format("{} of {} traces could not be followed to an end, so branches may be "
                        "missing or cut short",
                        traced.cut_short, traced.traced)};
  return {"complete", ""};
}

}  // namespace graze
