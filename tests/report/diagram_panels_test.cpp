#include "graze/report/picture/detail/diagram_panels.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace graze {
namespace {

// The axis ends below zero at twice the largest exponent, .5 here.
TEST(DiagramPanels, MarkExponentsThatTheAxisCuts) {
  DiagramRecord record;
  record.swept.options.exponent_periods = 1;
  for (const double lower : {-0.5, -40.0, -std::numeric_limits<double>::infinity()}) {
    SweepRow row;
    row.value = static_cast<double>(record.swept.rows.size());
    row.exponents.emplace();
    row.exponents->values = (Vector(2) << 0.5 - row.value, lower).finished();
    record.swept.rows.push_back(row);
  }
  const std::vector<DiagramPanel> panels = diagram_panels(record.branches, &record, false);
  const DiagramPanel& panel = panels.back();
  ASSERT_EQ(panel.name, "Lyapunov exponents");
  EXPECT_EQ(panel.least, -1.0);
  std::map<std::string, std::vector<double>> heights;
  for (const DiagramPanel::Dot& dot : panel.dots) heights[dot.look->id].push_back(dot.height);
  EXPECT_EQ(heights["largest"], (std::vector<double>{0.5, -0.5}));
  EXPECT_EQ(heights["lower"], std::vector<double>{-0.5});
  // The largest of the last row, -1.5, is below the axis too.
  EXPECT_EQ(heights["cut"], (std::vector<double>{-1.0, -1.0, -1.0}));
}

}  // namespace
}  // namespace graze
