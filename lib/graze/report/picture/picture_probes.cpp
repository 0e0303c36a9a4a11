#include "graze/report/picture/detail/picture_probes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/assembly/probes.hpp"

namespace graze {
namespace {

// As an axis names it. What has a direction counts along +u, as scenes do, whatever side the stops
// are on; angles count along it too.
std::string axis_name(ProbeQuantity quantity) {
  const std::string name = probe_quantity_name(quantity);
  if (quantity == ProbeQuantity::kDisplacement) return name + " u";
  if (quantity == ProbeQuantity::kVelocity) return name + " u’";
  if (quantity == ProbeQuantity::kDeflection) return name + " along u";
  return name;
}

}  // namespace

std::string ProbePanels::Panel::name() const {
  const std::string first = axis_name(probes.front().quantity);
  if (is_of_hub(probes.front().quantity)) return "hub’s\n" + first;
  if (probes.size() == 1) return fmt::format("{}\nprobe {}", first, probes.front().number);
  for (const SeenProbe& probe : probes)
    if (probe.quantity != probes.front().quantity) return first + ",\n" + axis_name(probe.quantity);
  return first + "\nprobes";
}

ProbePanels::ProbePanels(const std::vector<SeenProbe>& probes, Units units) : units_(units) {
  for (const SeenProbe& probe : probes) {
    const std::string unit = probe_unit(probe.quantity);
    auto panel = std::find_if(panels_.begin(), panels_.end(),
                              [&](const Panel& known) { return known.si_unit == unit; });
    if (panel == panels_.end()) panel = panels_.insert(panel, Panel{unit, {}});
    panel->probes.push_back(probe);
  }
}

bool ProbePanels::labelled() const {
  return std::any_of(panels_.begin(), panels_.end(),
                     [](const Panel& panel) { return panel.probes.size() > 1; });
}

void ProbePanels::draw(std::size_t i, GnuplotScript& script, PanelColumn& column,
                       double time_factor) const {
  const Panel& panel = panels_[i];
  const std::size_t shown = std::min(panel.probes.size(), curve_colours().size());
  AxisRange values;
  for (std::size_t k = 0; k < shown; ++k) values.include(range_of(panel.probes[k].curve));
  const AxisUnit axis = axis_unit(unit_in(units_, panel.si_unit), largest(values));
  AxisRange range;
  range.include(axis.factor * values.low);
  range.include(axis.factor * values.high);
  range.settle(0.08);
  column.begin_panel(range, panel.name(), axis.unit);
  column.draw_zero_line();
  std::vector<std::string> layers;
  std::vector<CurveLabel> labels;
  for (std::size_t k = 0; k < shown; ++k) {
    const SeenProbe& probe = panel.probes[k];
    const std::string data = fmt::format("probe{}", probe.number);
    script.data(data, table_of(probe.curve, time_factor, axis.factor));
    layers.push_back(fmt::format("${} with lines lw 1.2 lc rgb '{}'", data, curve_colours()[k]));
    labels.push_back({axis.factor * probe.curve.back().value, fmt::format("probe {}", probe.number),
                      curve_colours()[k]});
  }
  if (panel.probes.size() > 1) label_curves(script, labels, range, column.label_line());
  if (shown < panel.probes.size())
    column.note(fmt::format("the first {} of {} probes", shown, panel.probes.size()));
  column.end_panel(layers);
}

}  // namespace graze
