#include "graze/report/chart/detail/probe_panels.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/assembly/probes.hpp"

namespace graze {
namespace {

// The name on an axis. Quantities with a direction count along +u, as in scenes, whatever side the
// stops are on; angles likewise.
std::string axis_name(ProbeQuantity quantity) {
  const std::string name = probe_quantity_name(quantity);
  if (quantity == ProbeQuantity::kDisplacement) return name + " u";
  if (quantity == ProbeQuantity::kVelocity) return name + " u’";
  if (quantity == ProbeQuantity::kDeflection) return name + " along u";
  return name;
}

}  // namespace

std::string ProbePanel::name() const {
  const std::string first = axis_name(probes.front().quantity);
  if (is_of_hub(probes.front().quantity)) return "hub’s\n" + first;
  if (probes.size() == 1) return fmt::format("{}\nprobe {}", first, probes.front().number);
  for (const SeenProbe& probe : probes)
    if (probe.quantity != probes.front().quantity) return first + ",\n" + axis_name(probe.quantity);
  return first + "\nprobes";
}

std::vector<ProbePanel> probe_panels(const std::vector<SeenProbe>& probes) {
  std::vector<ProbePanel> panels;
  for (const SeenProbe& probe : probes) {
    const std::string unit = probe_unit(probe.quantity);
    auto panel = std::find_if(panels.begin(), panels.end(),
                              [&](const ProbePanel& known) { return known.si_unit == unit; });
    if (panel == panels.end()) panel = panels.insert(panel, ProbePanel{unit, {}});
    panel->probes.push_back(probe);
  }
  return panels;
}

}  // namespace graze
