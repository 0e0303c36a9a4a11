// The panels of a picture of a run that show its probes over time, one for every unit.
#pragma once

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "graze/report/chart/detail/motion_seen.hpp"
#include "graze/report/picture/detail/picture_column.hpp"
#include "graze/report/picture/detail/picture_curve.hpp"

namespace graze {

class ProbePanels {
 public:
  ProbePanels(const std::vector<SeenProbe>& probes, Units units);

  std::size_t count() const { return panels_.size(); }
  // Whether curves have labels at the right: where a panel has several.
  bool labelled() const;
  // Draws panel `i` as the next one of the column; times are drawn `time_factor` times as large.
  void draw(std::size_t i, GnuplotScript& script, PanelColumn& column, double time_factor) const;

  struct Panel {
    std::string si_unit;
    std::vector<SeenProbe> probes;

    std::string name() const;  // in two lines
  };
  const std::vector<Panel>& panels() const { return panels_; }

 private:
  Units units_;
  std::vector<Panel> panels_;
};

}  // namespace graze
