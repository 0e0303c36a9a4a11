#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/record/records.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostPanels = 4;  // of one stop each
constexpr double kRow = 0.9;            // of the distance between rows, of the largest force

// The force of one stop over time: a step for each window, or the force itself, zero where the stop
// is open.
struct ForceCurve {
  bool is_mean = false;
  std::vector<double> time, force;  // s, N
  double largest = 0.0;             // N, of the sizes
};

void add(ForceCurve& curve, double time, double force) {
  curve.time.push_back(time);
  curve.force.push_back(force);
  curve.largest = std::max(curve.largest, std::abs(force));
}

ForceCurve means_of(const StopForces& forces, std::size_t stop) {
  ForceCurve curve{true, {}, {}};
  for (std::size_t k = 0; k < forces.means[stop].size(); ++k)
    for (const std::size_t end : {k, k + 1})
      add(curve, forces.from + static_cast<double>(end) * forces.length, forces.means[stop][k]);
  return curve;
}

ForceCurve force_of(const MotionSeen& seen, std::size_t stop) {
  ForceCurve curve;
  add(curve, seen.window.start, 0.0);
  for (const SeenForce& of : seen.forces) {
    if (static_cast<std::size_t>(of.stop) != stop) continue;
    curve = {};
    // It is zero between contacts, from the end of one to the beginning of the next.
    if (of.force.front().time > seen.window.start) add(curve, seen.window.start, 0.0);
    bool is_open = true;
    for (const DrawnPoint& point : of.force) {
      const bool opens = std::isnan(point.value);
      if (is_open && !opens && !curve.time.empty()) add(curve, point.time, 0.0);
      if (opens && !curve.time.empty()) add(curve, curve.time.back(), 0.0);
      if (!opens) add(curve, point.time, point.value);
      is_open = opens;
    }
    if (is_open) add(curve, curve.time.back(), 0.0);
  }
  if (curve.force.back() == 0.0) add(curve, seen.window.end, 0.0);
  return curve;
}

std::vector<ForceCurve> curves_of(const SimulationRecord& record) {
  const bool all_means = shows_force_means(record);
  const std::optional<Amplitudes>& measured = record.run.amplitudes;
  std::optional<MotionSeen> seen;
  std::vector<ForceCurve> curves;
  for (std::size_t i = 0; i < record.system.stops.size(); ++i) {
    if (all_means || !record.system.stops[i].is_compliant()) {
      curves.push_back(means_of(*measured->forces, i));
      continue;
    }
    if (!seen) seen = motion_seen(record);
    curves.push_back(force_of(*seen, i));
  }
  return curves;
}

// The curve times `scale`, above `base`.
ChartSeries series_of(const ForceCurve& curve, double base = 0.0, double scale = 1.0) {
  ChartSeries series{"", {.colour = kBlue, .width = 1.0}, true, false, curve.time, curve.force};
  for (double& y : series.y) y = base + scale * y;
  return series;
}

ChartPanel panel_of(const SimulationRecord& record, bool has_means) {
  const Units units = record.info.units;
  ChartPanel panel{{.name = "time", .unit = unit_in(units, "s")}, {}};
  if (has_means)
    panel.heading = fmt::format("means over {:.4g}{}", record.run.amplitudes->forces->length,
                                unit_behind(units, "s"));
  return panel;
}

// All stops above each other, the first at the bottom.
ChartPanel rows_panel(const SimulationRecord& record, const std::vector<ForceCurve>& curves) {
  double largest = 0.0;
  for (const ForceCurve& curve : curves) largest = std::max(largest, curve.largest);
  ChartPanel panel = panel_of(record, std::any_of(curves.begin(), curves.end(),
                                                  [](const auto& any) { return any.is_mean; }));
  if (largest > 0.0)
    panel.heading += fmt::format("{}largest {:.4g}{}", panel.heading.empty() ? "" : ", ", largest,
                                 unit_behind(record.info.units, "N"));
  panel.y.name = "stop, with its force";
  panel.y.range = {0.5, static_cast<double>(curves.size()) + 1.2};
  panel.height = std::clamp(0.55 * static_cast<double>(curves.size()), 4.0, 14.0);
  for (std::size_t i = 0; i < curves.size(); ++i)
    panel.series.push_back(
        series_of(curves[i], static_cast<double>(i + 1), largest > 0.0 ? kRow / largest : 0.0));
  return panel;
}

}  // namespace

bool shows_force_means(const SimulationRecord& record) {
  return record.run.amplitudes && record.run.amplitudes->forces &&
         std::any_of(record.info.options.begin(), record.info.options.end(),
                     [](const auto& option) { return option.first == "forces"; });
}

Chart forces_chart(const SimulationRecord& record) {
  Chart chart{"Forces of the stops", {}};
  const std::vector<ForceCurve> curves = curves_of(record);
  if (curves.size() > kMostPanels) {
    chart.rows.push_back({rows_panel(record, curves)});
    return chart;
  }
  bool is_told = false;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    ChartPanel panel = panel_of(record, curves[i].is_mean && !is_told);
    is_told = is_told || curves[i].is_mean;
    panel.y = {.name = curves.size() > 1 ? fmt::format("force of\nstop {}", i + 1) : "force",
               .unit = unit_in(record.info.units, "N"),
               .from_zero = true};
    panel.series.push_back(series_of(curves[i]));
    chart.rows.push_back({panel});
  }
  return chart;
}

}  // namespace graze
