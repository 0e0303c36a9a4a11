// chart_page FILE: a page of a chart that has all that charts may have, of numbers that the test of
// it knows.
#include <cmath>
#include <limits>

#include "graze/report/page/detail/page_chart.hpp"

namespace {

using graze::Chart;
using graze::ChartPanel;
using graze::ChartSeries;

const graze::Look kMeasured{.id = "measured",
                            .title = "measured",
                            .colour = graze::kBlue,
                            .mark = graze::MarkShape::kDot,
                            .size = 0.6};
const graze::Look kFitted{.id = "fitted", .title = "fitted", .colour = graze::kVermillion};
const graze::Look kDashed{
    .id = "bound", .title = "bound", .colour = graze::kGreen, .dashes = {8, 5}};

// 1 mm at 0 s to 10 mm at 0.009 s, with bars of 0.5 mm.
ChartPanel values() {
  ChartPanel panel;
  panel.x = {.name = "time", .unit = "s", .range = {}};
  panel.y = {.name = "displacement u", .unit = "m", .range = {}, .from_zero = true};
  ChartSeries measured{"measured", kMeasured, false, true, {}, {}};
  ChartSeries fitted{"fitted", kFitted, true, false, {}, {}};
  for (int i = 0; i < 10; ++i) {
    measured.x.push_back(1e-3 * i);
    measured.y.push_back(1e-3 * (i + 1));
    measured.error.push_back(0.5e-3);
    fitted.x.push_back(1e-3 * i);
    fitted.y.push_back(i == 5 ? std::numeric_limits<double>::quiet_NaN() : 1e-3 * i);
  }
  panel.series = {measured, fitted};
  panel.fills = {{.is_upright = true,
                  .from = 9e-3,
                  .to = std::numeric_limits<double>::infinity(),
                  .title = "behind the stop"}};
  panel.height = 3.6;
  return panel;
}

// Over the same axis.
ChartPanel residuals() {
  ChartPanel panel = values();
  panel.y = {.name = "residual", .unit = "m", .range = {}};
  panel.series.pop_back();
  for (double& y : panel.series.front().y) y = 1e-6;
  panel.series.front().error.assign(10, 2e-6);
  panel.fills.clear();
  panel.levels = {0.0};
  return panel;
}

// y = x^-2 over six decades, and what never reaches the axis.
ChartPanel decades() {
  ChartPanel panel;
  panel.x = {.name = "steps", .unit = "", .range = {}, .scale = graze::AxisScale::kLog};
  panel.y = {.name = "error", .unit = "s", .range = {}, .scale = graze::AxisScale::kLog};
  ChartSeries line{"bound", kDashed, true, false, {}, {}};
  for (int i = 0; i <= 3; ++i) {
    line.x.push_back(std::pow(10.0, i));
    line.y.push_back(std::pow(10.0, -2 * i));
  }
  line.x.push_back(1e4);
  line.y.push_back(0.0);
  panel.series = {line};
  return panel;
}

ChartPanel nothing() {
  ChartPanel panel;
  panel.x = {.name = "frequency q_{1}", .unit = "rad/s", .range = {1.0, 3.0}};
  panel.y = {
      .name = "level", .unit = "m", .range = {1e-3, 1.0}, .scale = graze::AxisScale::kDecibel};
  panel.remark = "nothing was found";
  return panel;
}

}  // namespace

int main(int, char** arguments) {
  graze::RunInfo info;
  info.version = "0";
  info.command = "fit";
  info.scene_file = "scene.toml";
  info.scene_title = "By hand";
  Chart chart{"All of a chart", {{values()}, {residuals()}, {decades(), nothing()}}};
  graze::write_page(arguments[1], chart, info, {"fitted", ""}, {},
                    {{"Fitted parameters", {"name", "value (m)"}, {{"stop.gap", "0.001"}}}});
}
