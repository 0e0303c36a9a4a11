#include <gtest/gtest.h>

#include "graze/record/study_records.hpp"
#include "graze/report/chart/charts.hpp"

namespace graze {
namespace {

// What is open covers what was drawn before it at its place.
TEST(ChartOfCosts, DrawsTheMarksThatARingSurroundsAboveIt) {
  CostRecord record;
  record.costs.forced = true;
  record.costs.rows = {{"exact", "", {true, 1e-14, 1e-14, ""}, 1e-6, 10.0},
                       {"rk4", "step=0.01", {true, 1e-9, 1e-9, ""}, 1e-4, 1e3}};
  const ChartPanel panel = chart_of(record).rows.at(0).at(0);
  for (const ChartSeries& ring : panel.series) {
    if (!ring.look.open) continue;
    for (const ChartSeries* below = panel.series.data(); below != &ring; ++below)
      for (std::size_t i = 0; i < below->x.size(); ++i)
        for (std::size_t k = 0; k < ring.x.size(); ++k)
          EXPECT_FALSE(below->x[i] == ring.x[k] && below->y[i] == ring.y[k]) << below->title;
  }
}

}  // namespace
}  // namespace graze
