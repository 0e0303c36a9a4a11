#include "graze/study/cost/run_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze {
namespace {

// Whether the event is an instant at which a stop is met or left; an impact of a rigid stop is
// both.
bool is_instant(const Event& event, double slowest) {
  if (event.kind == EventKind::kImpact) return event.speed > slowest;
  return event.kind == EventKind::kContact || event.kind == EventKind::kSeparation;
}

bool stands_for(const ReferenceImpact& a, const ReferenceImpact& b) {
  return a.stop == b.stop && a.leaves == b.leaves;
}

}  // namespace

RunComparison::RunComparison(ReferenceRun reference, std::size_t impacts, double slowest,
                             double speed)
    : reference_(std::move(reference)), slowest_(slowest), speed_(speed) {
  for (const ReferenceImpact& impact : reference_.impacts) {
    if (!impact.leaves && impacts_ == impacts) break;
    impacts_ += impact.leaves ? 0 : 1;
    ++instants_;
  }
}

RunError RunComparison::of(const System& system, const State& start,
                           const SimulationOptions& options) const {
  std::vector<ReferenceImpact> impacts;
  std::vector<State> samples;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (is_instant(event, slowest_))
      impacts.push_back(
          {event.time, event.stop, event.speed, event.kind == EventKind::kSeparation});
  };
  if (impacts_ == 0) {
    listeners.sample = [&](const Sample& sample) { samples.push_back(sample.state); };
    listeners.sample_rate = 1.0 / reference_.sample_interval;
  }
  SimulationOptions whole = options;
  whole.duration = reference_.end_time;
  const Simulation run = simulate(system, start, whole, listeners);
  RunError error;
  if (run.outcome != RunOutcome::kReachedEnd) {
    error.message = run.message;
    return error;
  }
  error.impacts_agree = agrees(impacts);
  if (!error.impacts_agree) return error;
  error.error = impacts_ > 0 ? std::optional(time_error(impacts)) : displacement_error(samples);
  if (reference_.message.empty()) error.state_error = state_error(system, run.final);
  return error;
}

// A surplus impact is as wrong as a missing one. Each has to be nearer to its counterpart than to
// any other impact on that stop, and to the start; the beginning of a contact to its counterpart
// than to that of another, and likewise its end.
bool RunComparison::agrees(const std::vector<ReferenceImpact>& impacts) const {
  const std::vector<ReferenceImpact>& meant = reference_.impacts;
  // Where the reference ended early a further impact may be there or not.
  const bool cut = !reference_.message.empty();
  if (cut ? impacts.size() < meant.size() : impacts.size() != meant.size()) return false;
  for (std::size_t i = 0; i < meant.size(); ++i) {
    if (!stands_for(impacts[i], meant[i])) return false;
    const double off = std::abs(impacts[i].time - meant[i].time);
    if (impacts[i].time < off) return false;
    for (std::size_t k = 0; k < meant.size(); ++k)
      if (k != i && stands_for(meant[k], meant[i]) &&
          std::abs(impacts[i].time - meant[k].time) < off)
        return false;
  }
  return true;
}

double RunComparison::time_error(const std::vector<ReferenceImpact>& impacts) const {
  double error = 0.0;
  for (std::size_t i = 0; i < instants_; ++i)
    error = std::max(error, std::abs(impacts[i].time - reference_.impacts[i].time));
  return error;
}

// Returns nullopt when the reference has no samples.
std::optional<double> RunComparison::displacement_error(const std::vector<State>& samples) const {
  if (reference_.samples.empty()) return {};
  double error = 0.0, size = 0.0;
  // The first sample of the run is its start.
  for (std::size_t i = 0; i < reference_.samples.size() && i + 1 < samples.size(); ++i) {
    size = std::max(size, reference_.samples[i].q.norm());
    error = std::max(error, (samples[i + 1].q - reference_.samples[i].q).norm());
  }
  return size > 0.0 ? error / size : error;
}

double RunComparison::state_error(const System& system, const State& end) const {
  const Vector displacement = system.omega.cwiseProduct(end.q - reference_.end.q);
  return std::hypot(displacement.norm(), (end.qdot - reference_.end.qdot).norm()) / speed_;
}

}  // namespace graze
