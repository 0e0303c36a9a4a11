#include "graze/report/picture/detail/chart_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

// The values that the axis has to show. A logarithmic one shows all values above zero.
AxisRequest request_of(const ChartAxis& axis, const std::vector<double>& values,
                       const AxisRequest& asked) {
  AxisRequest request = asked;
  if (axis.scale != AxisScale::kLinear) request.scale = axis.scale;
  // The given range of an axis is for its own scale.
  if (!axis.range.empty() && request.scale == axis.scale) {
    if (!request.low) request.low = axis.range.low;
    if (!request.high) request.high = axis.range.high;
  }
  if (axis.scale != AxisScale::kLog || (request.low && request.high)) return request;
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  for (const double value : values) {
    if (!(value > 0.0) || !std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!(low < high)) low = 0.5 * std::max(high, 1e-300), high = 4.0 * low;
  const double room = std::pow(high / low, 0.06);
  if (!request.low) request.low = low / room;
  if (!request.high) request.high = high * room;
  return request;
}

// Adds the values of a panel's series along an axis, within its range if that is given.
void add_values(const ChartPanel& panel, bool upright, std::vector<double>& values) {
  const AxisRange& range = (upright ? panel.y : panel.x).range;
  const auto add = [&](double value) {
    values.push_back(range.empty() ? value : std::clamp(value, range.low, range.high));
  };
  for (const ChartSeries& series : panel.series) {
    const std::vector<double>& list = upright ? series.y : series.x;
    for (std::size_t i = 0; i < list.size(); ++i) {
      add(list[i]);
      if (upright && i < series.error.size())
        for (const double end : {list[i] - series.error[i], list[i] + series.error[i]}) add(end);
    }
  }
  if (upright) values.insert(values.end(), panel.levels.begin(), panel.levels.end());
  if (!upright && !range.empty()) values.insert(values.end(), {range.low, range.high});
}

// Whether the range of the axis is known without data.
bool is_settled(const ChartAxis& axis, const AxisRequest& asked) {
  return !axis.range.empty() && (asked.scale == axis.scale || axis.scale != AxisScale::kLinear);
}

// The values along the axis of all panels that share it.
std::vector<double> across_of(const Chart& chart, const ChartPanel& own, const AxisRequest& asked) {
  if (is_settled(own.x, asked)) return {own.x.range.low, own.x.range.high};
  std::vector<double> values;
  for (const std::vector<ChartPanel>& panels : chart.rows)
    for (const ChartPanel& panel : panels)
      if (is_alike(panel.x, own.x)) add_values(panel, false, values);
  return values;
}

std::vector<double> up_of(const ChartPanel& own, const AxisRequest& asked) {
  if (is_settled(own.y, asked)) return {own.y.range.low, own.y.range.high};
  std::vector<double> values;
  add_values(own, true, values);
  return values;
}

}  // namespace

bool is_alike(const ChartAxis& a, const ChartAxis& b) {
  return a.name == b.name && a.path == b.path && a.scale == b.scale && a.unit == b.unit;
}

std::vector<PanelAxes> axes_of(const Chart& chart, const PictureRequest& request) {
  std::vector<PanelAxes> list;
  for (const std::vector<ChartPanel>& row : chart.rows)
    for (const ChartPanel& panel : row) {
      const AxisRequest asked = list.empty() || panel.y.is_asked ? request.y : AxisRequest{};
      const std::vector<double> along = across_of(chart, panel, request.x);
      const std::vector<double> up = up_of(panel, asked);
      const ShownAxis x(request_of(panel.x, along, request.x), panel.x.unit, along,
                        panel.x.path.empty() ? 0.02 : 0.0, panel.x.from_zero);
      const ShownAxis y(request_of(panel.y, up, asked), panel.y.unit, up,
                        panel.y.path.empty() ? 0.06 : 0.0, panel.y.from_zero);
      list.push_back({&panel, x, y, list.empty() ? "" : fmt::format("panel{}_", list.size() + 1)});
    }
  return list;
}

}  // namespace graze
