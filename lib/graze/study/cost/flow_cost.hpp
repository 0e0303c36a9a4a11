// The cost of accuracy in time: every flow over its ladder of settings, compared with a reference
// in 50 digits.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/study/cost/run_comparison.hpp"
#include "graze/study/cost/timed_run.hpp"

namespace graze {

struct FlowCost {
  std::string flow, setting;  // "rk4", "step=1e-05"; the exact flow has no setting
  RunError compared;
  double seconds_per_period = 0.0;  // of computing time, per forcing period (per second without)
  double evaluations_per_period = 0.0;
};

struct FlowCosts {
  std::size_t impacts = 0;  // compared
  double end_time = 0.0;    // s, of the compared motion
  double period = 0.0;      // s, to which costs refer: a forcing period, or one second
  bool forced = false;
  bool compliant = false;  // some stop is: impacts are contacts there, with two instants each
  bool turns = false;      // on a hub: the reference is that of stepped_reference.hpp
  double tolerance = 0.0;  // of the scene
  double allowed = 0.0;    // the error that this tolerance allows, in the unit of the errors
  std::vector<FlowCost> rows;
  std::string reference_message;  // why the reference ended early
};

struct FlowCostOptions {
  std::size_t impacts = 20;
  double longest = 0.0;    // s of motion, at most
  double tolerance = 0.0;  // of the scene
  // s; a ladder goes on while a run takes no longer than this
  double row_seconds = kRowSeconds;
  double speed = 1.0;  // of the modal motion, kg^1/2 m/s (StepSetting)
  // m/s, below which the tail of a chatter is summed; only the reference has slower impacts.
  double closure_speed = 0.0;
  long long max_impacts = kDefaultImpactBudget;  // of every run
  StopSignal stop;
  std::function<void(double)> progress;  // part of the ladder
};

// Runs one after the other, in this thread alone.
FlowCosts flow_costs(const System& system, const State& start, const FlowCostOptions& options);

// The cheapest row with at most the allowed error; null where there is none.
const FlowCost* cheapest(const FlowCosts& costs, double allowed);

}  // namespace graze
