// What a motion settles on: it is followed forcing period by forcing period, through chatter and
// sticking, until it repeats.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/default_budget.hpp"
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
  // Where it was to get near: whether it did, and how far it still is. Where it impacts without
  // sticking that is its distance from the orbit by the shooting equations, which has to be stable;
  // elsewhere it is the estimate of repetition.hpp, 0 within rounding, infinite where nothing
  // shrinks.
  bool near = false;
  double remaining = std::numeric_limits<double>::infinity();
  bool sticks = false;     // a stop was closed during what `impacts` covers
  State at_start, at_end;  // at the start of the last repetition, and after it
  long long periods = 0;   // run in all
  long long impacts_met = 0;
  // Of the last repetition, or of the last `tail` periods where it does not repeat.
  std::vector<MetImpact> impacts;
  std::vector<State> period_states;  // the states at the starts of these periods
  // The repeating pattern, with the points of its last repetition; nothing when none was found,
  // when it sticks, or where a stop is compliant. Where no nearness was asked for it need
  // not be minimal: where deviations alternate in sign, two periods agree before one does.
  std::optional<ImpactPattern> pattern;
  std::vector<ImpactPoint> points;
  std::string classification;  // a sentence: what the motion does
};

struct SettleOptions {
  long long periods = 3000;  // simulated at most
  int longest_period = 32;   // longest orbit looked for, in forcing periods
  long long max_impacts = kDefaultImpactBudget;
  // Speed below which a chatter is summed, m/s; nothing: the default of a simulation.
  std::optional<double> closure_speed;
  // Go on until what is left to the orbit (phases in rad, relative speeds, states in units of the
  // system's scale) is less than this. Nothing: stop where the motion repeats; 0: run all the
  // periods.
  std::optional<double> nearness;
  long long tail = 100;                            // periods kept where nothing repeats
  std::string from = "the scene's initial state";  // for the classification: where it starts
  StopSignal stop;
};

// Follows the motion from `start`, at the start of a forcing period, until it repeats. It counts as
// repeating when phases (rad) and relative speeds of the last three repetitions agree to 1e-6: near
// enough for Newton, which then decides. Requires forcing.
SettledMotion settle(const System& system, const State& start, const SettleOptions& options = {});

// Many motions to be settled, in so many places at a time: those that free flights and impacts make
// up are flown side by side in the lanes of the processor's vector unit, as far as they do. Each
// settles as `settle` has it, with the rounding of its lane, which depends on nothing but itself.
struct SettleTask {
  const System* system = nullptr;  // until it has settled
  State start;
  SettleOptions options;
};
class SettleTasks {
 public:
  virtual ~SettleTasks() = default;
  // The next one for a place; nothing where there are no more.
  virtual std::optional<SettleTask> next(std::size_t place) = 0;
  // What the last one there has settled on.
  virtual void take(std::size_t place, SettledMotion motion) = 0;
};
void settle_side_by_side(SettleTasks& tasks);
// One of them by itself: as it settles beside others, to the last bit.
SettledMotion settle_in_lane(const System& system, const State& start,
                             const SettleOptions& options);

}  // namespace graze
