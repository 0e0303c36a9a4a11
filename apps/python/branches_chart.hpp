// Branches and sweeps over a parameter as a chart, the panels of their picture.
#pragma once

#include "graze/record/detail/diagram_record.hpp"
#include "graze/report/chart/chart.hpp"

namespace graze {

// Of branches alone (`diagram` null), or of a diagram with its branches.
Chart branches_chart(const BranchRecord& record, const DiagramRecord* diagram);

}  // namespace graze
