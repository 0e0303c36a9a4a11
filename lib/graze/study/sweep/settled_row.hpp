// One value of a sweep, or one cell of a map: what the motion from a start settles on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/defaults.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/exponents.hpp"
#include "graze/orbit/search/settled.hpp"
#include "graze/scene/scene.hpp"
#include "graze/system/scale.hpp"

namespace graze {

enum class SweepStart {
  kScene,     // the scene's initial state
  kHandedOn,  // the state that the value before settled to
  kAnew       // the scene's initial state, as what the value before left cannot be gone on from
};

enum class SweepStatus {
  kSettled,      // periodic, and as near to its orbit as asked for
  kApproaching,  // repeats, but is still further from its orbit than that
  kNotPeriodic,
  kImpactBudget,
  kRefused,  // the motion could not be followed
  kNoStart   // the scene does not allow the value, or a start there
};

struct SweepRow {
  double value = 0.0;  // of the parameter, SI
  SweepStatus status = SweepStatus::kNoStart;
  SweepStart start = SweepStart::kScene;
  // Without pattern and points, in a sweep without states; empty where there is no start.
  SettledMotion motion;
  // Gap and row of the stops do not fit a table of rows; what they make of a stroboscopic state
  // does: row.q (m) and row.q' (m/s) of every stop, for each state at the start of a period.
  struct StopState {
    int stop = 0;
    double displacement = 0.0, velocity = 0.0;
  };
  std::vector<StopState> stop_states;
  // Where they were asked for and the motion could be followed that far: of the multipliers where
  // it repeats, else of an average.
  std::optional<Exponents> exponents;
  std::optional<Amplitudes> amplitudes;  // over what is shown of it, where they were asked for
  std::string message;                   // a sentence where there is something to say
};

// What rows that belong together have in common, in the order in which they are listed.
struct AttractorClass {
  SweepStatus status = SweepStatus::kNoStart;
  SettledKind kind = SettledKind::kNotPeriodic;
  int period = 0;   // 0 where nothing repeats
  int impacts = 0;  // in a repetition; 0 where it sticks, as how many are counted is a matter of
                    // the speed at which chatter is summed
  Wandering wandering = Wandering::kOpen;  // where nothing repeats and exponents are known
  auto operator<=>(const AttractorClass&) const = default;
};
AttractorClass attractor_class(const SweepRow& row);

// How long a motion is followed until it has settled, and what is told of it.
struct RowOptions {
  long long periods = 1000;  // forcing periods run, at most
  long long samples = 100;   // periods shown where nothing repeats
  // How near a motion has to come to its orbit; see SettleOptions. 0: run all the periods.
  double nearness = 1e-8;
  long long max_impacts = kDefaultImpactBudget;
  std::optional<double> closure_speed;  // m/s
  // Forcing periods over which Lyapunov exponents are averaged where nothing repeats; 0: none are
  // wanted.
  long long exponent_periods = 0;
  bool measure = false;  // at the places of the scene (measured_places)
  StopSignal stop{};
};

// The speed at which chatters are summed, m/s: where it is not given, by the scene alone, whatever
// the start.
double closure_speed_of(const Scene& scene, const System& system, const RowOptions& options);

// Whether the motion was followed to the end of its periods, and left a state to go on from.
bool was_followed(SweepStatus status);

// How the motion of a row is settled; `row.start` says where its start comes from.
SettleOptions settle_options(const Scene& scene, const System& system, const RowOptions& options,
                             const SweepRow& row);

// Fills motion, status, message and, where they are wanted, exponents, by what the motion has
// settled on. False where it was stopped before that was done.
bool conclude_row(const Scene& scene, const System& system, const RowOptions& options,
                  SettledMotion motion, SweepRow& row);

// Both, with the settling between them: the row that it is beside others, to the last bit.
bool settle_row(const Scene& scene, const System& system, const State& start,
                const RowOptions& options, SweepRow& row);

// How many forcing periods of what the motion has settled on are shown: one repetition, or as many
// as asked for where nothing repeats; and a run over them, on from where they end.
long long shown_periods(const SweepRow& row, const RowOptions& options);
SimulationOptions on_from_settled(const Scene& scene, const System& system, const SweepRow& row,
                                  const RowOptions& options);

// Fills amplitudes: of what the motion has settled on, over the periods shown of it. False where it
// was stopped before that was done.
bool measure_row(const Scene& scene, const System& system, const RowOptions& options,
                 SweepRow& row);

// Whether two motions that repeat are the same orbit, seen in whichever of its periods: states at
// the starts of their periods no further apart than this part of the scale.
bool are_same_period_states(const MotionScale& scale, const std::vector<State>& left,
                            const std::vector<State>& right, double apart);

}  // namespace graze
