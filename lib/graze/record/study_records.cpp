#include "graze/record/study_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "graze/scene/reader.hpp"
#include "graze/study/cost/detail/extended_contact.hpp"
#include "graze/study/sweep/detail/stroboscopic_states.hpp"

namespace graze {

namespace {

// Sorted by speed: the j-th is continuous along a branch even where impacts come and go.
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
  // At rest on a stop, the limit of impacts that slow down, the height is zero.
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
  // The absence of orbits is a note; the sweep shows what there is.
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

Outcome run_diagram_outcome(const std::vector<ValueRun>& runs, std::size_t asked,
                            StopReason stopped) {
  if (runs.size() < asked) return stopped_outcome(stopped, runs.size(), asked, "values").value();
  const auto is_cut = [](const ValueRun& run) { return run.outcome != RunOutcome::kReachedEnd; };
  const auto first = std::find_if(runs.begin(), runs.end(), is_cut);
  if (first == runs.end()) return {"complete", ""};
  return {"budget", fmt::format("{} of {} runs did not reach their end; the first, at {:.9g}: {}",
                                std::count_if(runs.begin(), runs.end(), is_cut), asked,
                                first->value, first->message)};
}

Outcome map_outcome(const AttractorMap& map) {
  const std::vector<MapCell>& cells = map.cells;
  const auto known =
      std::count_if(cells.begin(), cells.end(), [](const MapCell& cell) { return cell.is_known; });
  if (const auto stopped =
          stopped_outcome(map.stopped, static_cast<std::size_t>(known), cells.size(), "cells"))
    return *stopped;
  const auto is_failed = [](const MapCell& cell) {
    return cell.attractor.status == SweepStatus::kImpactBudget ||
           cell.attractor.status == SweepStatus::kRefused;
  };
  const auto failed = std::find_if(cells.begin(), cells.end(), is_failed);
  if (failed == cells.end()) return {"complete", ""};
  return {"budget", fmt::format("{} of {} cells could not be followed to their end; the first: {}",
                                std::count_if(cells.begin(), cells.end(), is_failed), cells.size(),
                                failed->message)};
}

namespace {

// "LP and PD"
std::string names_of(const std::vector<OrbitLocusKind>& kinds) {
  std::string names;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (i > 0) names += i + 1 == kinds.size() ? " or " : ", ";
    names += label_of(kinds[i]);
  }
  return names;
}

}  // namespace

Outcome loci_outcome(const OrbitLoci& traced, const LociOptions& options) {
  if (traced.stopped == StopReason::kInterrupted)
    return {"interrupted", "stopped; the loci traced so far are kept"};
  if (traced.stopped == StopReason::kOutOfTime)
    return {"budget", "the budget of computing time was spent; the loci traced so far are kept"};
  std::string missing;
  const auto add = [&](int count, const char* one, const char* several, const std::string& what) {
    if (count > 0)
      missing += fmt::format("{}{} {} {}", missing.empty() ? "" : ", ", count,
                             count == 1 ? one : several, what);
  };
  add(traced.cut_short, "locus", "loci", "could not be followed to an end");
  add(traced.lost_starts, "special point", "special points",
      "led to no locus that could be solved for");
  add(traced.traces_cut_short, "branch", "branches",
      "on the slices could not be followed to an end");
  if (!missing.empty()) return {"budget", missing + ": loci may be missing or cut short"};
  if (traced.loci.empty() && options.start)
    return {"no_orbit", "no locus goes on from the special point"};
  if (traced.loci.empty())
    return {"no_orbit", fmt::format("no {} of ({}, {}) orbits was met on {} slices of the plane",
                                    names_of(options.kinds), options.branches.period,
                                    options.branches.impacts, traced.slices)};
  return {"complete", ""};
}

Outcome regions_outcome(const StableRegions& regions, const Outcome& loci) {
  const std::size_t all = regions.places.size();
  const std::string kept = fmt::format("{} of {} places are kept", regions.finished, all);
  if (loci.name == "interrupted" || regions.stopped == StopReason::kInterrupted)
    return {"interrupted", "stopped; the loci traced so far and " + kept};
  if (regions.stopped == StopReason::kOutOfTime)
    return {"budget", "the budget of computing time was spent; the loci traced so far and " + kept};
  if (loci.name != "complete" && loci.name != "no_orbit") return loci;
  const auto says = [](const RegionPlace& place) { return !place.message.empty(); };
  const auto first = std::find_if(regions.places.begin(), regions.places.end(), says);
  if (first != regions.places.end())
    return {"budget", fmt::format("at {} of {} places the list of stable motions is incomplete; "
                                  "the first, ({:.9g}, {:.9g}): {}",
                                  std::count_if(first, regions.places.end(), says), all,
                                  first->value, first->second, first->message)};
  if (!regions.settled)
    return {"budget", fmt::format("the exchange of orbits between neighbouring places still found "
                                  "new ones after {} rounds",
                                  regions.rounds)};
  return {"complete", ""};
}

namespace {

bool is_failed(const AttractorClass& attractor) {
  return attractor.status == SweepStatus::kImpactBudget ||
         attractor.status == SweepStatus::kRefused;
}

}  // namespace

void conclude_comparison(ComparisonRecord& record, std::size_t asked, StopReason stopped) {
  const std::vector<ComparedMotion>& motions = record.motions;
  for (std::size_t i = 1; i < motions.size(); ++i)
    record.differences.push_back(difference(motions[i - 1], motions[i], record.options));
  record.outcome = {"compared", ""};
  if (motions.size() < asked)
    if (const auto outcome = stopped_outcome(stopped, motions.size(), asked, "motions")) {
      record.outcome = *outcome;
      return;
    }
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (is_failed(motions[i].attractor)) {
      record.outcome = {"budget", record.names[i] + ": " + motions[i].message};
      return;
    }
}

Outcome comparison_map_outcome(const ComparisonMap& map) {
  const std::vector<ComparedCell>& cells = map.cells;
  const auto known = std::count_if(cells.begin(), cells.end(),
                                   [](const ComparedCell& cell) { return cell.is_known; });
  if (const auto stopped =
          stopped_outcome(map.stopped, static_cast<std::size_t>(known), cells.size(), "cells"))
    return *stopped;
  const auto failed = [](const ComparedCell& cell) {
    return is_failed(cell.one) || is_failed(cell.other);
  };
  const auto first = std::find_if(cells.begin(), cells.end(), failed);
  if (first == cells.end()) return {"complete", ""};
  return {"budget", fmt::format("{} of {} cells could not be followed to their end; the first: {}",
                                std::count_if(cells.begin(), cells.end(), failed), cells.size(),
                                first->message)};
}

Outcome sensitivity_outcome(const std::vector<SensitivityCurve>& curves, std::size_t asked,
                            StopReason stopped) {
  if (stopped == StopReason::kInterrupted)
    return {"interrupted", "stopped before all values were run"};
  if (stopped == StopReason::kOutOfTime || curves.size() < asked)
    return {"budget", "the budget of computing time was spent before all values were run"};
  for (const SensitivityCurve& curve : curves)
    for (const ValueRun& run : curve.runs)
      if (run.outcome != RunOutcome::kReachedEnd)
        return {"incomplete",
                fmt::format("at {:.9g} the run did not reach its end: {}", run.value, run.message)};
  return {"compared", ""};
}

Outcome cost_outcome(const FlowCosts& costs, StopReason stopped) {
  if (stopped == StopReason::kInterrupted)
    return {"interrupted", fmt::format("stopped after {} settings", costs.rows.size())};
  if (stopped == StopReason::kOutOfTime)
    return {"budget", fmt::format("the budget of computing time was spent after {} settings",
                                  costs.rows.size())};
  if (costs.rows.empty())
    return {"none", "there is no motion to compare: " + costs.reference_message};
  // The exact flow is first; without its motion there is nothing to compare.
  const std::string& failure = costs.rows.front().compared.message;
  if (!failure.empty()) return {"budget", "the exact flow did not get to the end: " + failure};
  return {"measured", ""};
}

std::string reference_name(const FlowCosts& costs) {
  if (costs.turns) return "fehlberg78, as far as bulirsch-stoer agrees with it";
  if (!costs.compliant) return "exact, 50 digits";
  return fmt::format("exact, 50 digits; contacts with compliant stops integrated to {:g} a step",
                     kReferenceTolerance);
}

std::string compared_span(const FlowCosts& costs, Units units) {
  const std::string second = unit_behind(units, "s");
  if (costs.impacts == 0) return fmt::format("no impacts, {:.6g}{}", costs.end_time, second);
  return fmt::format("first {} {}{}, {:.6g}{}", costs.impacts,
                     costs.compliant ? "contact" : "impact", costs.impacts == 1 ? "" : "s",
                     costs.end_time, second);
}

Outcome fit_outcome(const FitResult& result) {
  switch (result.end) {
    case FitEnd::kFitted:
      return {"fitted", ""};
    case FitEnd::kNotDetermined:
      return {"not_determined", result.message};
    case FitEnd::kNotConverged:
      return {"not_converged", result.message};
    case FitEnd::kBudget:
      return {"budget", result.message};
    case FitEnd::kInterrupted:
      break;
  }
  return {"interrupted", result.message};
}

std::string name_of(MeasurementKind kind) {
  switch (kind) {
    case MeasurementKind::kRestitution:
      return "restitution";
    case MeasurementKind::kImpactTimes:
      return "impact times";
    case MeasurementKind::kResponse:
      break;
  }
  return "response";
}

Abscissa abscissa_of(MeasurementKind kind) {
  switch (kind) {
    case MeasurementKind::kRestitution:
      return {"speed", "m/s"};
    case MeasurementKind::kImpactTimes:
      return {"impact", ""};
    case MeasurementKind::kResponse:
      break;
  }
  return {"time", "s"};
}

std::string fitted_scene_text(const FitResult& result) {
  return result.fitted ? write_scene(*result.fitted) : "";
}

}  // namespace graze
