// What a picture over a parameter shows, one panel below the other: heights of a sweep's motions as
// dots, and of branches as curves.
#pragma once

#include <string>
#include <vector>

#include "graze/record/detail/diagram_record.hpp"
#include "graze/report/appearance/looks.hpp"
#include "graze/report/picture/picture_request.hpp"

namespace graze {

struct DiagramPanel {
  struct Dot {
    double value = 0.0, height = 0.0;  // SI
    const Look* look = nullptr;
  };
  std::string name, unit;  // of the vertical axis, SI
  std::vector<Dot> dots = {};
  std::vector<DiagramCurve> curves = {};  // one a branch, or none
  bool from_zero = false;                 // zero belongs to the axis
  bool scales = false;                    // as the picture's vertical axis is asked to
  std::optional<double> level = {};       // a line across
  double least = -1e300, most = 1e300;    // what the axis shows of the heights
};

// Of branches alone (`diagram` null), or of a diagram with its branches.
std::vector<DiagramPanel> diagram_panels(const BranchRecord& record, const DiagramRecord* diagram,
                                         bool multipliers);

}  // namespace graze
