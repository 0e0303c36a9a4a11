// What a motion has settled on, and options for following it until then.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/defaults.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/orbit/search/repetition.hpp"

namespace graze {

enum class SettledKind {
  kImpacts,      // repeats, with impacts, without sticking
  kSticks,       // repeats, with a stop closed for part of the time
  kClear,        // repeats without meeting a stop
  kAtRest,       // stays on a stop for ever
  kNotPeriodic,  // none of these within the periods given
  kImpactBudget,
  kInterrupted,
  kTimeBudget,
  kRefused  // could not be followed further
};

struct SettledMotion {
  SettledKind kind = SettledKind::kNotPeriodic;
  int period = 0;  // p of the repetition, in forcing periods; 0: none
  // With `nearness`: whether it was reached, and the remaining distance. For a motion with impacts
  // and without sticking this is the distance from the orbit by the shooting equations, which has
  // to be stable; else it is the estimate of repetition.hpp, 0 within rounding, infinite when
  // differences do not shrink.
  bool near = false;
  double remaining = std::numeric_limits<double>::infinity();
  bool sticks = false;     // a stop was closed during the time of `impacts`
  State at_start, at_end;  // at the start of the last repetition, and after it
  long long periods = 0;   // run in all
  long long impacts_met = 0;
  // Impacts of the last repetition, or of the last `tail` periods where it does not repeat.
  std::vector<MetImpact> impacts;
  std::vector<State> period_states;  // the states at the starts of these periods
  // The repeating pattern, with the points of its last repetition; nullopt when none was found,
  // when it sticks, or when a stop is compliant. Without `nearness` it need not be minimal: where
  // deviations alternate in sign, two periods agree before one does.
  std::optional<ImpactPattern> pattern;
  std::vector<ImpactPoint> points;
  std::string classification;  // a sentence: what the motion does
};

struct SettleOptions {
  long long periods = 3000;  // simulated at most
  int longest_period = 32;   // longest orbit looked for, in forcing periods
  long long max_impacts = kDefaultImpactBudget;
  // Speed below which a chatter is summed, m/s; nullopt: the default of a simulation.
  std::optional<double> closure_speed;
  // Go on until the distance from the orbit (phases in rad, relative speeds, states in units of the
  // system's scale) is less than this. nullopt: stop when the motion repeats; 0: run all the
  // periods.
  std::optional<double> nearness;
  // Taken to repeat after so many periods, whatever the differences: a motion that starts on an
  // orbit, stable or not. 0: found out.
  int repeats_after = 0;
  long long tail = 100;                            // periods kept where nothing repeats
  std::string from = "the scene's initial state";  // for the classification: where it starts
  StopSignal stop;
};

}  // namespace graze
