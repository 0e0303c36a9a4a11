#include "graze/report/picture/detail/diagram_panels.hpp"

#include <algorithm>
#include <cmath>

#include "graze/report/chart/detail/motion_observables.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostPanelPlaces = 4;

const Look& look_of(const SweepRow& row) {
  return dot_look(row.status == SweepStatus::kNotPeriodic ? "wild" : "periodic");
}

DiagramPanel panel_of(const MotionObservable& observable, const Sweep* swept) {
  DiagramPanel panel{observable.name, observable.unit};
  panel.curves = observable.curves;
  panel.from_zero = observable.from_zero;
  panel.level = observable.reference;
  panel.most = observable.most;
  if (!swept || !observable.heights) return panel;
  for (const SweepRow& row : swept->rows)
    if (has_dots(row))
      for (const double height : observable.heights(row))
        panel.dots.push_back({row.value, height, &look_of(row)});
  return panel;
}

DiagramPanel exponent_panel(const Sweep& swept, Units units) {
  DiagramPanel panel{"Lyapunov exponents", unit_in(units, "1/s")};
  const Look &largest = dot_look("largest"), &lower = dot_look("lower"), &cut = dot_look("cut");
  panel.from_zero = true;
  panel.level = 0.0;
  panel.least = exponent_range(swept).low;
  for (const SweepRow& row : swept.rows)
    for (Eigen::Index j = 0; row.exponents && j < row.exponents->values.size(); ++j) {
      const double height = row.exponents->values[j];
      if (height < panel.least)  // minus infinity too
        panel.dots.push_back({row.value, panel.least, &cut});
      else if (std::isfinite(height))
        panel.dots.push_back({row.value, height, j > 0 ? &lower : &largest});
    }
  return panel;
}

}  // namespace

std::vector<DiagramPanel> diagram_panels(const BranchRecord& record, const DiagramRecord* diagram,
                                         bool multipliers) {
  const Sweep* swept = diagram ? &diagram->swept : nullptr;
  const std::vector<MotionObservable> observables =
      diagram ? motion_observables(*diagram) : motion_observables(record, nullptr);
  std::vector<DiagramPanel> panels;
  for (const MotionObservable& observable : observables) {
    const bool of_multipliers = observable.key == "multiplier";
    // Of several observables of a motion the picture shows the first, and displacements everywhere.
    const bool is_main = &observable == observables.data() ||
                         (!record.shown && observable.key.starts_with("displacement_") &&
                          panels.size() < kMostPanelPlaces);
    if (!is_main && !(of_multipliers && multipliers)) continue;
    panels.push_back(panel_of(observable, swept));
    panels.back().scales = is_main;
  }
  if (swept && swept->options.exponent_periods > 0)
    panels.push_back(exponent_panel(*swept, record.info.units));
  return panels;
}

}  // namespace graze
