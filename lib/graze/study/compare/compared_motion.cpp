#include "graze/study/compare/compared_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/detail/energy_changes.hpp"
#include "graze/motion/energy_balance.hpp"

namespace graze {
namespace {

// Samples per forcing period of a settled motion; no power of two and no multiple of small orders,
// so that means are not synchronous with repetitions within the period.
constexpr std::size_t kMeasuredSamplesPerPeriod = 509;

bool was_stopped(const Simulation& run) {
  return run.outcome == RunOutcome::kInterrupted || run.outcome == RunOutcome::kTimeBudget;
}

// False where it was stopped.
bool add_first_impacts(const Scene& scene, const System& system, const State& start,
                       const CompareOptions& options, ComparedMotion& motion) {
  SimulationOptions run;
  run.periods = options.periods;
  run.max_impacts = options.first;
  run.closure_speed = closure_speed_of(scene, system, options);
  run.stop = options.stop;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (meets_stop(event)) motion.first.push_back({event.time, event.stop, event.speed});
  };
  return !was_stopped(simulate(system, start, run, listeners));
}

// Runs over the periods shown of the settled motion once more. False where it was stopped.
bool add_settled(const Scene& scene, const System& system, const SweepRow& row,
                 const CompareOptions& options, ComparedMotion& motion) {
  const long long turns = shown_periods(row, options);
  SimulationOptions run = on_from_settled(scene, system, row, options);
  run.energy = true;
  run.stop = options.stop;
  const std::size_t count = static_cast<std::size_t>(turns) * kMeasuredSamplesPerPeriod;
  const bool repeats = row.motion.period > 0;
  const Vector& to_stop = system.stops.front().row;
  double energy = 0.0;
  std::size_t seen = 0;
  RunListeners listeners;
  listeners.sample_rate = static_cast<double>(kMeasuredSamplesPerPeriod) / system.period();
  listeners.sample = [&](const Sample& sample) {
    // The end is the beginning of the next one.
    if (seen == count) return;
    ++seen;
    energy += mechanical_energy(system, sample.state.q, sample.state.qdot);
    if (!repeats) return;
    motion.displacement.push_back(to_stop.dot(sample.state.q));
    motion.velocity.push_back(to_stop.dot(sample.state.qdot));
  };
  const Simulation again = simulate(system, row.motion.at_end, run, listeners);
  if (was_stopped(again)) return false;
  if (again.outcome != RunOutcome::kReachedEnd) {
    motion.message = again.message;
    motion.displacement.clear();
    motion.velocity.clear();
    return true;
  }
  motion.energy = energy / static_cast<double>(seen);
  const EnergyBalance& balance = *again.energy;
  const double given = balance.impacts + balance.work.constraint + balance.work.contact;
  motion.taken = (0.0 - given) / static_cast<double>(turns);
  return true;
}

double root_mean_square(const std::vector<double>& values) {
  double mean = 0.0, squares = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

double apart(const std::vector<double>& one, const std::vector<double>& other, std::size_t turn) {
  double squares = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double by = other[(i + turn) % other.size()] - one[i];
    squares += by * by;
  }
  return std::sqrt(squares / static_cast<double>(one.size()));
}

// The difference as a part of the larger size; nullopt when both are zero.
double part_of(double difference, double one, double other) {
  const double size = std::fmax(std::abs(one), std::abs(other));
  return size > 0.0 ? difference / size : 0.0;
}

std::optional<double> change(const std::optional<double>& one, const std::optional<double>& other) {
  if (!one || !other) return {};
  return part_of(*other - *one, *one, *other);
}

void compare_first(const ComparedMotion& one, const ComparedMotion& other,
                   const CompareOptions& options, MotionDifference& difference) {
  const std::size_t common = std::min(one.first.size(), other.first.size());
  difference.first = static_cast<int>(std::max(one.first.size(), other.first.size()));
  double fastest = 0.0;
  for (const ComparedMotion* motion : {&one, &other})
    for (const RunImpact& impact : motion->first) fastest = std::fmax(fastest, impact.speed);
  const auto agree = [&](const RunImpact& a, const RunImpact& b) {
    return a.stop == b.stop && std::abs(a.time - b.time) <= options.within * one.forcing_period &&
           std::abs(a.speed - b.speed) <= options.within * fastest;
  };
  std::size_t agreeing = 0;
  while (agreeing < common && agree(one.first[agreeing], other.first[agreeing])) ++agreeing;
  difference.agreeing = static_cast<int>(agreeing);
  if (common == 0) return;
  const RunImpact &a = one.first.front(), &b = other.first.front();
  difference.first_time = (b.time - a.time) / one.forcing_period;
  difference.first_speed = part_of(b.speed - a.speed, a.speed, b.speed);
}

void compare_orbits(const ComparedMotion& one, const ComparedMotion& other,
                    MotionDifference& difference) {
  if (one.displacement.empty() || one.displacement.size() != other.displacement.size()) return;
  double least = std::numeric_limits<double>::infinity();
  std::size_t turn = 0;
  for (std::size_t k = 0; k < one.displacement.size(); k += kMeasuredSamplesPerPeriod) {
    const double difference_then = apart(one.displacement, other.displacement, k);
    if (difference_then >= least) continue;
    least = difference_then;
    turn = k;
  }
  difference.displacement =
      part_of(least, root_mean_square(one.displacement), root_mean_square(other.displacement));
  difference.velocity = part_of(apart(one.velocity, other.velocity, turn),
                                root_mean_square(one.velocity), root_mean_square(other.velocity));
}

}  // namespace

std::optional<ComparedMotion> compared_motion(const Scene& scene, const CompareOptions& options) {
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  ComparedMotion motion;
  motion.forcing_period = system.period();
  if (!add_first_impacts(scene, system, start, options, motion)) return {};
  SweepRow row;
  if (!settle_row(scene, system, start, options, row)) return {};
  motion.attractor = attractor_class(row);
  motion.message = row.message;
  if (was_followed(row.status) && !add_settled(scene, system, row, options, motion)) return {};
  return motion;
}

MotionDifference difference(const ComparedMotion& one, const ComparedMotion& other,
                            const CompareOptions& options) {
  MotionDifference difference;
  compare_first(one, other, options, difference);
  difference.is_same_attractor = one.attractor == other.attractor;
  compare_orbits(one, other, difference);
  difference.energy = change(one.energy, other.energy);
  difference.taken = change(one.taken, other.taken);
  return difference;
}

}  // namespace graze
