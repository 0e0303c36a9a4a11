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
  kAnew       // the scene's initial state, as the end of the previous value cannot be used
};

enum class SweepStatus {
  kSettled,      // periodic, and within the nearness of its orbit
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
  // The motion at the stops for each state at the start of a period: row.q (m) and row.q' (m/s) of
  // every stop, as a table of rows does not hold gaps and rows.
  struct StopState {
    int stop = 0;
    double displacement = 0.0, velocity = 0.0;
  };
  std::vector<StopState> stop_states;
  // If requested and the motion could be followed that far: from the multipliers where it repeats,
  // else from an average.
  std::optional<Exponents> exponents;
  std::optional<Amplitudes> amplitudes;  // over the periods shown, if requested
  std::string message;                   // a sentence, or empty
};

// What rows of one class have in common, in the order in which classes are listed.
struct AttractorClass {
  SweepStatus status = SweepStatus::kNoStart;
  SettledKind kind = SettledKind::kNotPeriodic;
  int period = 0;   // 0 where nothing repeats
  int impacts = 0;  // in a repetition; 0 where it sticks, since the number depends on the speed at
                    // which chatter is summed
  Wandering wandering = Wandering::kOpen;  // where the motion does not repeat and exponents are
                                           // known
  auto operator<=>(const AttractorClass&) const = default;
};
AttractorClass attractor_class(const SweepRow& row);

// How long a motion is followed until it has settled, and what is recorded of it.
struct RowOptions {
  long long periods = 1000;  // forcing periods run, at most
  long long samples = 100;   // periods shown where the motion does not repeat
  // How near a motion has to come to its orbit; see SettleOptions. 0: run all the periods.
  double nearness = 1e-8;
  long long max_impacts = kDefaultImpactBudget;
  std::optional<double> closure_speed;  // m/s
  // Forcing periods over which Lyapunov exponents are averaged where the motion does not repeat; 0:
  // none are wanted.
  long long exponent_periods = 0;
  bool measure = false;  // at the places of the scene (measured_places)
  StopSignal stop{};
};

// The speed at which chatters are summed, m/s: where it is not given it depends on the scene alone,
// not on the start.
double closure_speed_of(const Scene& scene, const System& system, const RowOptions& options);

// Whether the motion was followed to the end of its periods, and its last state can be used.
bool was_followed(SweepStatus status);

// The state in which the motion of one system begins as that of another ended: with the same
// displacements and velocities of the masses. Both have coordinates().
State handed_on(const System& from, const System& to, const State& at_end);

// How the motion of a row is settled; `row.start` says where its start comes from.
SettleOptions settle_options(const Scene& scene, const System& system, const RowOptions& options,
                             const SweepRow& row);

// Fills motion, status, message and, if wanted, exponents, from the settled motion. False when it
// was stopped before that was done.
bool conclude_row(const Scene& scene, const System& system, const RowOptions& options,
                  SettledMotion motion, SweepRow& row);

// Both, with the settling between them: the same row as beside others, to the last bit.
bool settle_row(const Scene& scene, const System& system, const State& start,
                const RowOptions& options, SweepRow& row);

// How many forcing periods of the settled motion are shown: one repetition, or the requested number
// where it does not repeat; and options of a run over them, starting at their end.
long long shown_periods(const SweepRow& row, const RowOptions& options);
SimulationOptions on_from_settled(const Scene& scene, const System& system, const SweepRow& row,
                                  const RowOptions& options);

// Fills amplitudes of the settled motion over the periods shown. False when it was stopped before
// that was done.
bool measure_row(const Scene& scene, const System& system, const RowOptions& options,
                 SweepRow& row);

// Whether two motions that repeat are the same orbit, seen in whichever of its periods: states at
// the starts of their periods no further apart than this part of the scale.
bool are_same_period_states(const MotionScale& scale, const std::vector<State>& left,
                            const std::vector<State>& right, double apart);

}  // namespace graze
