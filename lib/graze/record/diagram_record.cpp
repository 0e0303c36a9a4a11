#include "graze/record/detail/diagram_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "graze/study/sweep/detail/stroboscopic_states.hpp"

namespace graze {
namespace {

// By speed: the j-th of them is continuous along a branch whatever impacts come and go.
std::vector<double> chatter_heights(const Orbit& orbit) {
  const double fastest = leading_impact(orbit).speed;
  std::vector<double> heights;
  for (const OrbitImpact& impact : orbit.impacts)
    if (impact.speed >= kSlowestShown * fastest) heights.push_back(impact.speed);
  std::sort(heights.begin(), heights.end(), std::greater<>());
  return heights;
}

std::vector<double> impact_heights(const Orbit& orbit) {
  if (orbit.sticks() && !orbit.impacts.empty()) return chatter_heights(orbit);
  std::vector<double> heights;
  for (const OrbitImpact& impact : orbit.impacts) heights.push_back(impact.speed);
  // At rest on a stop: where impacts slow down until they are none.
  if (orbit.sticks()) heights.push_back(0.0);
  return heights;
}

}  // namespace

std::vector<DiagramCurve> impact_curves(const OrbitBranches& traced) {
  std::vector<DiagramCurve> curves;
  for (const OrbitBranch& branch : traced.branches) {
    DiagramCurve curve;
    for (const OrbitBranchPoint& point : branch.points)
      curve.points.push_back(impact_heights(point.orbit));
    for (const SpecialPoint& special : branch.special)
      curve.special.push_back(impact_heights(special.at.orbit));
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<DiagramCurve> amplitude_curves(const BranchRecord& record) {
  return amplitude_curves(record.amplitudes, *record.shown);
}

std::vector<DiagramCurve> amplitude_curves(const BranchAmplitudes& amplitudes, const Shown& shown) {
  std::vector<DiagramCurve> curves;
  for (const BranchAmplitudes::Measured& measured : amplitudes.branches) {
    const auto heights = [&](const std::vector<Amplitudes>& of) {
      std::vector<std::vector<double>> list;
      for (const Amplitudes& one : of) {
        const std::optional<double> value = shown_value(shown, amplitudes.places, one);
        list.push_back(value ? std::vector<double>{*value} : std::vector<double>());
      }
      return list;
    };
    curves.push_back({heights(measured.points), heights(measured.special)});
  }
  return curves;
}

std::optional<double> shown_height(const BranchRecord& record, const SweepRow& row) {
  if (!row.amplitudes) return {};
  return shown_value(*record.shown, record.amplitudes.places, *row.amplitudes);
}

std::vector<std::vector<DiagramCurve>> stroboscopic_curves(const SystemFamily& family,
                                                           const OrbitBranches& traced) {
  std::vector<std::vector<DiagramCurve>> by_stop(family.scene().stops.size());
  for (const OrbitBranch& branch : traced.branches) {
    for (std::vector<DiagramCurve>& curves : by_stop) curves.emplace_back();
    const auto add = [&](const OrbitBranchPoint& point, auto part) {
      std::vector<State> states;
      const std::optional<System> system = family.at(point.value);
      if (system && (point.orbit.sticks() || !point.orbit.impacts.empty()))
        states = stroboscopic_states(*system, point.orbit);
      for (std::size_t stop = 0; stop < by_stop.size(); ++stop) {
        std::vector<double>& heights = (by_stop[stop].back().*part).emplace_back();
        for (const State& state : states) heights.push_back(system->stops[stop].row.dot(state.q));
      }
    };
    for (const OrbitBranchPoint& point : branch.points) add(point, &DiagramCurve::points);
    for (const SpecialPoint& special : branch.special) add(special.at, &DiagramCurve::special);
  }
  return by_stop;
}

Outcome diagram_outcome(const Sweep& swept, const std::optional<Outcome>& branches) {
  const std::size_t values = static_cast<std::size_t>(swept.options.points);
  if (const auto stopped = stopped_outcome(swept.stopped, swept.rows.size(), values, "values"))
    return *stopped;
  // That there are no such orbits is a note; the sweep says what there is.
  if (branches && branches->name != "complete" && branches->name != "no_orbit") return *branches;
  const auto is_failed = [](const SweepRow& row) {
    return row.status == SweepStatus::kImpactBudget || row.status == SweepStatus::kRefused ||
           row.status == SweepStatus::kNoStart;
  };
  const auto failed = std::find_if(swept.rows.begin(), swept.rows.end(), is_failed);
  if (failed == swept.rows.end()) return {"complete", ""};
  return {"budget",
          fmt::format("{} of {} values could not be followed to their end; the first, {:.9g}: {}",
                      std::count_if(swept.rows.begin(), swept.rows.end(), is_failed), values,
                      failed->value, failed->message)};
}

}  // namespace graze
