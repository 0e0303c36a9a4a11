#include "graze/study/sweep/settled_row.hpp"

#include <utility>

#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/orbit/search/detail/random_start.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

SweepStatus status_of(const SettledMotion& motion) {
  switch (motion.kind) {
    case SettledKind::kImpacts:
    case SettledKind::kSticks:
    case SettledKind::kClear:
    case SettledKind::kAtRest:
      return motion.near ? SweepStatus::kSettled : SweepStatus::kApproaching;
    case SettledKind::kNotPeriodic:
      return SweepStatus::kNotPeriodic;
    case SettledKind::kImpactBudget:
      return SweepStatus::kImpactBudget;
    default:
      return SweepStatus::kRefused;
  }
}

bool is_finished(const SettledMotion& motion) {
  return motion.kind != SettledKind::kInterrupted && motion.kind != SettledKind::kTimeBudget;
}

}  // namespace

bool was_followed(SweepStatus status) {
  return status == SweepStatus::kSettled || status == SweepStatus::kApproaching ||
         status == SweepStatus::kNotPeriodic;
}

double closure_speed_of(const Scene& scene, const System& system, const RowOptions& options) {
  const State rest{Vector::Zero(system.modes()), Vector::Zero(system.modes())};
  return options.closure_speed.value_or(default_closure_speed(
      system, clear_start(scene, system).value_or(rest), scene.solver.tolerance));
}

State handed_on(const System& from, const System& to, const State& at_end) {
  if (*to.coordinates() == *from.coordinates()) return at_end;
  const LuFactors modal(*to.coordinates());
  return {modal.solve(*from.coordinates() * at_end.q),
          modal.solve(*from.coordinates() * at_end.qdot)};
}

SettleOptions settle_options(const Scene& scene, const System& system, const RowOptions& options,
                             const SweepRow& row) {
  SettleOptions settling;
  settling.periods = options.periods;
  settling.max_impacts = options.max_impacts;
  settling.closure_speed = closure_speed_of(scene, system, options);
  settling.nearness = options.nearness;
  settling.tail = options.samples;
  settling.stop = options.stop;
  if (row.start == SweepStart::kHandedOn) settling.from = "the final state of the value before";
  return settling;
}

bool conclude_row(const Scene& scene, const System& system, const RowOptions& options,
                  SettledMotion motion, SweepRow& row) {
  row.motion = std::move(motion);
  if (!is_finished(row.motion)) return false;
  row.status = status_of(row.motion);
  row.message = row.status == SweepStatus::kSettled ? "" : row.motion.classification;
  if (options.exponent_periods == 0 || !was_followed(row.status)) return true;
  ExponentOptions exponents;
  exponents.periods = options.exponent_periods;
  exponents.repeats = row.motion.period;
  exponents.closure_speed = closure_speed_of(scene, system, options);
  exponents.max_impacts = options.max_impacts;
  exponents.stop = options.stop;
  row.exponents = lyapunov_exponents(system, row.motion.at_end, exponents);
  return row.exponents->failure.empty() || !options.stop.requested();
}

bool settle_row(const Scene& scene, const System& system, const State& start,
                const RowOptions& options, SweepRow& row) {
  return conclude_row(scene, system, options,
                      settle_in_lane(system, start, settle_options(scene, system, options, row)),
                      row);
}

AttractorClass attractor_class(const SweepRow& row) {
  const SettledMotion& motion = row.motion;
  AttractorClass attractor{row.status, motion.kind, motion.period, 0, Wandering::kOpen};
  // How near the motion has come does not distinguish attractors.
  if (row.status == SweepStatus::kApproaching) attractor.status = SweepStatus::kSettled;
  if (motion.kind == SettledKind::kImpacts)
    attractor.impacts = static_cast<int>(motion.impacts.size());
  if (row.status == SweepStatus::kNotPeriodic && row.exponents)
    attractor.wandering = row.exponents->wandering;
  return attractor;
}

long long shown_periods(const SweepRow& row, const RowOptions& options) {
  return row.motion.period > 0 ? row.motion.period : options.samples;
}

SimulationOptions on_from_settled(const Scene& scene, const System& system, const SweepRow& row,
                                  const RowOptions& options) {
  SimulationOptions run;
  run.periods = shown_periods(row, options);
  run.max_impacts = options.max_impacts;
  run.closure_speed = closure_speed_of(scene, system, options);
  return run;
}

// Orbits are the same in whichever of their periods they are seen first.
bool measure_row(const Scene& scene, const System& system, const RowOptions& options,
                 SweepRow& row) {
  if (!was_followed(row.status)) return true;
  SimulationOptions run = on_from_settled(scene, system, row, options);
  run.stop = options.stop;
  run.measure = MeasureOptions{rows_of(measured_places(scene, system))};
  const Simulation again = simulate(system, row.motion.at_end, run);
  if (again.outcome == RunOutcome::kReachedEnd) row.amplitudes = again.amplitudes;
  return again.outcome != RunOutcome::kInterrupted && again.outcome != RunOutcome::kTimeBudget;
}

bool are_same_period_states(const MotionScale& scale, const std::vector<State>& left,
                            const std::vector<State>& right, double apart) {
  if (left.size() != right.size()) return false;
  if (left.empty()) return true;  // at rest
  for (std::size_t turn = 0; turn < right.size(); ++turn) {
    bool same = true;
    for (std::size_t i = 0; i < left.size() && same; ++i) {
      const State &x = left[i], &y = right[(i + turn) % right.size()];
      same = ((x.q - y.q).cwiseAbs().array() <= apart * scale.displacement).all() &&
             ((x.qdot - y.qdot).cwiseAbs().array() <= apart * scale.velocity.array()).all();
    }
    if (same) return true;
  }
  return false;
}

}  // namespace graze
