#include "graze/report/chart/detail/motion_observables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostObservedPlaces = 4;  // with axes of their own
// Next to grazing multipliers have no bound; the axis ends at the largest informative one.
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

// In the order of the speeds of `impact_curves`: where a chatter completes, the fastest first.
std::vector<double> phases_of(const Orbit& orbit) {
  std::vector<OrbitImpact> impacts = orbit.impacts;
  if (orbit.sticks() && !impacts.empty()) {
    const double least = kSlowestShown * leading_impact(orbit).speed;
    std::erase_if(impacts, [&](const OrbitImpact& impact) { return impact.speed < least; });
    std::stable_sort(impacts.begin(), impacts.end(),
                     [](const OrbitImpact& a, const OrbitImpact& b) { return a.speed > b.speed; });
  }
  std::vector<double> phases;
  for (const OrbitImpact& impact : impacts) phases.push_back(impact.phase);
  return phases;
}

std::vector<double> largest_multiplier(const Orbit& orbit) {
  double largest = -1.0;
  for (const Eigenvalue& multiplier : orbit.multipliers)
    largest = std::max(largest, std::abs(multiplier.value));
  if (largest < 0.0) return {};
  return {largest};
}

using Observables = std::vector<MotionObservable>;

void add_impacts(const OrbitBranches& traced, Units units, Observables& list) {
  list.push_back({"speed", "impact speed", unit_in(units, "m/s"), false, true,
                  impact_curves(traced), [](const SweepRow& row) {
                    std::vector<double> speeds;
                    for (const MetImpact& impact : row.motion.impacts)
                      speeds.push_back(impact.speed);
                    return speeds;
                  }});
  list.push_back({"phase", "forcing phase of the impact", unit_in(units, "rad"), false, true,
                  curves_of(traced, phases_of), [](const SweepRow& row) {
                    std::vector<double> phases;
                    for (const MetImpact& impact : row.motion.impacts)
                      phases.push_back(impact_phase(impact));
                    return phases;
                  }});
  list.back().most = kTurn;
  list.back().turn = kTurn;
}

void add_stroboscopic(const DiagramRecord& record, Observables& list) {
  const std::size_t stops = record.branches.system.stops.size();
  // If a picture shows an amplitude, the curves are those of the amplitude.
  const bool has_curves = !record.branches.shown && !record.curves.empty();
  std::size_t shown = 0;
  for (const SeenPlace& place : places_of(record.branches.system)) {
    if (place.stops.empty() || shown++ == kMostObservedPlaces) break;
    const int stop = place.stops.front().index;
    const auto index = static_cast<std::size_t>(stop);
    const std::string which = stops > 1 ? fmt::format("stop {}", stop + 1) : "the stop";
    const auto heights = [stop](double SweepRow::StopState::*part) {
      return [stop, part](const SweepRow& row) {
        std::vector<double> values;
        for (const SweepRow::StopState& state : row.stop_states)
          if (state.stop == stop) values.push_back(state.*part);
        return values;
      };
    };
    list.push_back({fmt::format("displacement_{}", stop + 1), "displacement towards " + which,
                    unit_in(record.branches.info.units, "m"), false, false,
                    has_curves ? record.curves[index] : std::vector<DiagramCurve>(),
                    heights(&SweepRow::StopState::displacement)});
    list.push_back({fmt::format("velocity_{}", stop + 1),
                    "velocity towards " + which,
                    unit_in(record.branches.info.units, "m/s"),
                    false,
                    false,
                    {},
                    heights(&SweepRow::StopState::velocity)});
  }
}

bool has_any(const std::vector<DiagramCurve>& curves) {
  const auto is_there = [](const std::vector<double>& heights) { return !heights.empty(); };
  return std::any_of(curves.begin(), curves.end(), [&](const DiagramCurve& curve) {
    return std::any_of(curve.points.begin(), curve.points.end(), is_there);
  });
}

// The picture's amplitude is the first of them, also in a picture without branches and dots.
void add_amplitudes(const BranchRecord& record, const Sweep* swept, Observables& list) {
  const std::vector<MeasuredPlace>& places = record.amplitudes.places;
  const auto is_shown = [&](const Shown& shown) {
    return record.shown && record.shown->quantity == shown.quantity &&
           record.shown->place == shown.place;
  };
  for (std::size_t place = 0; place < places.size(); ++place)
    for (const ShownQuantity quantity : kShownQuantities) {
      const Shown shown{quantity, place};
      if (is_of_stop(quantity) && !places[place].stop) continue;
      const auto heights = [shown, &places](const SweepRow& row) {
        const std::optional<double> value =
            row.amplitudes ? shown_value(shown, places, *row.amplitudes) : std::nullopt;
        return value ? std::vector<double>{*value} : std::vector<double>();
      };
      MotionObservable made{std::string(name_of(quantity)) + "." + places[place].name('.'),
                            shown_title(shown, places),
                            unit_in(record.info.units, shown_unit(shown, places)),
                            true,
                            true,
                            amplitude_curves(record.amplitudes, shown),
                            heights};
      const bool in_sweep =
          swept && std::any_of(swept->rows.begin(), swept->rows.end(),
                               [&](const SweepRow& row) { return !heights(row).empty(); });
      if (is_shown(shown))
        list.insert(list.begin(), std::move(made));
      else if (in_sweep || has_any(made.curves))
        list.push_back(std::move(made));
    }
}

void add_multiplier(const OrbitBranches& traced, Observables& list) {
  if (traced.branches.empty()) return;
  MotionObservable made{"multiplier", "largest multiplier, modulus",        "", true,
                        true,         curves_of(traced, largest_multiplier)};
  made.reference = 1.0;
  made.most = kLargestMultiplier;
  list.push_back(std::move(made));
}

void add_exponent(const Sweep* swept, Units units, Observables& list) {
  if (!swept || swept->options.exponent_periods == 0) return;
  MotionObservable made{"exponent", "largest exponent", unit_in(units, "1/s"), true};
  made.heights = [](const SweepRow& row) {
    return row.exponents && row.exponents->values.size() > 0
               ? std::vector<double>{row.exponents->values[0]}
               : std::vector<double>();
  };
  made.reference = 0.0;
  list.push_back(std::move(made));
}

}  // namespace

std::vector<MotionObservable> motion_observables(const BranchRecord& record, const Sweep* swept) {
  Observables list;
  add_impacts(record.traced, record.info.units, list);
  add_amplitudes(record, swept, list);
  add_multiplier(record.traced, list);
  add_exponent(swept, record.info.units, list);
  return list;
}

std::vector<MotionObservable> motion_observables(const DiagramRecord& record) {
  if (record.section == DiagramSection::kImpact)
    return motion_observables(record.branches, &record.swept);
  Observables list;
  add_stroboscopic(record, list);
  add_amplitudes(record.branches, &record.swept, list);
  add_multiplier(record.branches.traced, list);
  add_exponent(&record.swept, record.branches.info.units, list);
  return list;
}

AxisRange exponent_range(const Sweep& swept) {
  constexpr double kDeepest = 2.0;  // exponents shown below zero, relative to those above
  AxisRange range;
  range.include(0.0);
  for (const SweepRow& row : swept.rows)
    if (row.exponents && row.exponents->values.size() > 0) range.include(row.exponents->values[0]);
  if (range.high > 0.0) range.low = std::max(range.low, -kDeepest * range.high);
  return range;
}

bool has_dots(const SweepRow& row) {
  return row.status == SweepStatus::kNotPeriodic || row.motion.period > 0;
}

}  // namespace graze
