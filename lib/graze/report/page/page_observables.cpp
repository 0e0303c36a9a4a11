#include "graze/report/page/detail/page_observables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/report/names/detail/sweep_names.hpp"
#include "graze/report/picture/detail/picture_motion.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostPlaces = 4;  // with axes of their own
// Next to grazing multipliers have no bound; the axis shows those that tell something.
constexpr double kLargestMultiplier = 4.0;

// One height for each impact as `impact_curves` orders them, or for each point of a branch.
template <class Height>
std::vector<DiagramCurve> curves_of(const OrbitBranches& traced, const Height& height) {
  std::vector<DiagramCurve> curves;
  for (const OrbitBranch& branch : traced.branches) {
    DiagramCurve curve;
    for (const OrbitBranchPoint& point : branch.points) curve.points.push_back(height(point.orbit));
    for (const SpecialPoint& special : branch.special)
      curve.special.push_back(height(special.at.orbit));
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<double> phases_of(const Orbit& orbit) {
  std::vector<double> phases;
  const double least = orbit.sticks() && !orbit.impacts.empty()
                           ? kSlowestShown * leading_impact(orbit).speed
                           : -1e300;
  for (const OrbitImpact& impact : orbit.impacts)
    if (impact.speed >= least) phases.push_back(impact.phase);
  return phases;
}

std::vector<double> largest_multiplier(const Orbit& orbit) {
  double largest = -1.0;
  for (const Eigenvalue& multiplier : orbit.multipliers)
    largest = std::max(largest, std::abs(multiplier.value));
  if (largest < 0.0) return {};
  return {largest};
}

PageObservable multiplier_of(const OrbitBranches& traced) {
  PageObservable made{"multiplier", "largest multiplier, modulus",         "", true,
                      false,        curves_of(traced, largest_multiplier), {}};
  made.reference = 1.0;
  made.most = kLargestMultiplier;
  return made;
}

}  // namespace

std::vector<PageObservable> impact_observables(const OrbitBranches& traced) {
  std::vector<PageObservable> list;
  list.push_back(
      {"speed", "impact speed", "m/s", true, true, impact_curves(traced), [](const SweepRow& row) {
         std::vector<double> speeds;
         for (const MetImpact& impact : row.motion.impacts) speeds.push_back(impact.speed);
         return speeds;
       }});
  list.push_back({"phase", "forcing phase of the impact", "rad", true, true,
                  curves_of(traced, phases_of), [](const SweepRow& row) {
                    std::vector<double> phases;
                    for (const MetImpact& impact : row.motion.impacts)
                      phases.push_back(impact_phase(impact));
                    return phases;
                  }});
  list.back().most = kTurn;
  if (!traced.branches.empty()) list.push_back(multiplier_of(traced));
  return list;
}

std::vector<PageObservable> amplitude_observables(const BranchRecord& record) {
  const Shown shown = *record.shown;
  const std::vector<MeasuredPlace>& places = record.amplitudes.places;
  std::vector<PageObservable> list;
  list.push_back({name_of(shown.quantity), shown_title(shown, places), shown_unit(shown, places),
                  true, true, amplitude_curves(record), [&record](const SweepRow& row) {
                    const std::optional<double> height = shown_height(record, row);
                    return height ? std::vector<double>{*height} : std::vector<double>();
                  }});
  if (!record.traced.branches.empty()) list.push_back(multiplier_of(record.traced));
  return list;
}

std::vector<PageObservable> stroboscopic_observables(const DiagramRecord& record) {
  std::vector<PageObservable> list;
  const std::vector<SeenPlace> places = places_of(record.branches.system);
  for (const SeenPlace& place : places) {
    if (list.size() == 2 * kMostPlaces) break;
    const int stop = place.stops.front().index;
    const auto index = static_cast<std::size_t>(stop);
    const std::string which =
        record.branches.system.stops.size() > 1 ? fmt::format("stop {}", stop + 1) : "the stop";
    const auto heights = [stop](double SweepRow::StopState::*part) {
      return [stop, part](const SweepRow& row) {
        std::vector<double> values;
        for (const SweepRow::StopState& state : row.stop_states)
          if (state.stop == stop) values.push_back(state.*part);
        return values;
      };
    };
    list.push_back({fmt::format("displacement_{}", stop + 1), "displacement towards " + which, "m",
                    false, true,
                    record.curves.empty() ? std::vector<DiagramCurve>() : record.curves[index],
                    heights(&SweepRow::StopState::displacement)});
    list.push_back({fmt::format("velocity_{}", stop + 1),
                    "velocity towards " + which,
                    "m/s",
                    false,
                    true,
                    {},
                    heights(&SweepRow::StopState::velocity)});
  }
  if (!record.branches.traced.branches.empty())
    list.push_back(multiplier_of(record.branches.traced));
  return list;
}

bool has_dots(const SweepRow& row) {
  return row.status == SweepStatus::kNotPeriodic || row.motion.period > 0;
}

}  // namespace graze
