// Probes of a run by their units, a panel each.
#pragma once

#include <string>
#include <vector>

#include "graze/report/chart/detail/motion_seen.hpp"

namespace graze {

struct ProbePanel {
  std::string si_unit;
  std::vector<SeenProbe> probes;

  std::string name() const;  // in two lines
};
std::vector<ProbePanel> probe_panels(const std::vector<SeenProbe>& probes);

}  // namespace graze
