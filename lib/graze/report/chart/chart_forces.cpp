#include <fmt/format.h>

#include <algorithm>

#include "graze/record/records.hpp"
#include "graze/report/chart/charts.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostPanels = 4;  // of one stop each
constexpr double kRow = 0.9;            // of the distance between rows, of the largest force

// A step a window, times `scale` on `base`.
ChartSeries force_steps(const StopForces& forces, const std::vector<double>& means, double base,
                        double scale) {
  ChartSeries series{"", {.colour = kBlue, .width = 1.0}, true, false, {}, {}};
  for (std::size_t k = 0; k < means.size(); ++k)
    for (const std::size_t end : {k, k + 1}) {
      series.x.push_back(forces.from + static_cast<double>(end) * forces.length);
      series.y.push_back(base + scale * means[k]);
    }
  return series;
}

ChartPanel panel_of(const StopForces& forces, Units units) {
  ChartPanel panel{{.name = "time", .unit = unit_in(units, "s")}, {}};
  panel.heading = fmt::format("means over {:.4g}{}", forces.length, unit_behind(units, "s"));
  return panel;
}

// All stops one above the other, from the first at the foot.
ChartPanel rows_panel(const StopForces& forces, Units units) {
  double largest = 0.0;
  for (const std::vector<double>& means : forces.means)
    for (const double mean : means) largest = std::max(largest, std::abs(mean));
  ChartPanel panel = panel_of(forces, units);
  if (largest > 0.0)
    panel.heading += fmt::format(", largest {:.4g}{}", largest, unit_behind(units, "N"));
  panel.y.name = "stop, with its force";
  panel.y.range = {0.5, static_cast<double>(forces.means.size()) + 1.2};
  panel.height = std::clamp(0.55 * static_cast<double>(forces.means.size()), 4.0, 14.0);
  for (std::size_t i = 0; i < forces.means.size(); ++i)
    panel.series.push_back(force_steps(forces, forces.means[i], static_cast<double>(i + 1),
                                       largest > 0.0 ? kRow / largest : 0.0));
  return panel;
}

}  // namespace

Chart forces_chart(const SimulationRecord& record) {
  Chart chart{"Forces of the stops", {}};
  const Units units = record.info.units;
  const StopForces& forces = *record.run.amplitudes->forces;
  if (forces.means.size() > kMostPanels) {
    chart.rows.push_back({rows_panel(forces, units)});
    return chart;
  }
  for (std::size_t i = 0; i < forces.means.size(); ++i) {
    ChartPanel panel = panel_of(forces, units);
    if (i > 0) panel.heading = "";
    panel.y = {.name = forces.means.size() > 1 ? fmt::format("force of\nstop {}", i + 1) : "force",
               .unit = unit_in(units, "N"),
               .from_zero = true};
    panel.series.push_back(force_steps(forces, forces.means[i], 0.0, 1.0));
    chart.rows.push_back({panel});
  }
  return chart;
}

}  // namespace graze
