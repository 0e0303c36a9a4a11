#include "graze/record/diagram_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "graze/study/strobes.hpp"

namespace graze {
namespace {

// Impacts slower than this part of the fastest are not shown where a chatter completes: there is no
// end to them.
constexpr double kSlowest = 1e-3;

// By speed: the j-th of them is continuous along a branch whatever impacts come and go.
std::vector<double> chatter_heights(const Orbit& orbit) {
  const double fastest = leading_impact(orbit).speed;
  std::vector<double> heights;
  for (const OrbitImpact& impact : orbit.impacts)
    if (impact.speed >= kSlowest * fastest) heights.push_back(impact.speed);
  std::sort(heights.begin(), heights.end(), std::greater<>());
  return heights;
}

std::vector<double> heights_of(const SystemFamily& family, const OrbitBranchPoint& point,
                               DiagramSection section) {
  std::vector<double> heights;
  if (section == DiagramSection::kImpact && point.orbit.sticking)
    return chatter_heights(point.orbit);
  if (section == DiagramSection::kImpact) {
    for (const OrbitImpact& impact : point.orbit.impacts) heights.push_back(impact.speed);
    return heights;
  }
  const std::optional<System> system = family.at(point.value);
  if (!system || point.orbit.impacts.empty()) return heights;
  for (const State& state : stroboscopic_states(*system, point.orbit))
    heights.push_back(system->stops.front().row.dot(state.q));
  return heights;
}

}  // namespace

std::vector<DiagramCurve> diagram_curves(const SystemFamily& family, const OrbitBranches& traced,
                                         DiagramSection section) {
  std::vector<DiagramCurve> curves;
  for (const OrbitBranch& branch : traced.branches) {
    DiagramCurve curve;
    for (const OrbitBranchPoint& point : branch.points)
      curve.points.push_back(heights_of(family, point, section));
    for (const SpecialPoint& special : branch.special) {
      curve.special.push_back(heights_of(family, special.at, section));
      // One mark is enough for all the impacts of a chatter.
      if (branch.sticks() && curve.special.back().size() > 1) curve.special.back().resize(1);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

Outcome diagram_outcome(const Sweep& swept, const std::optional<Outcome>& branches) {
  const std::size_t values = static_cast<std::size_t>(swept.options.points);
  if (swept.stopped == StopReason::kInterrupted)
    return {"interrupted",
            fmt::format("stopped; {} of {} values are kept", swept.rows.size(), values)};
  if (swept.stopped == StopReason::kOutOfTime)
    return {"budget",
            fmt::format("the budget of computing time was spent; {} of {} values are kept",
                        swept.rows.size(), values)};
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
