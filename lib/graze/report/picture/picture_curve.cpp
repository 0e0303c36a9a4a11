#include "graze/report/picture/detail/picture_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace graze {
namespace {

constexpr std::size_t kBands = 3'000;

// The nearest rising sequence in the sense of least squares: neighbours that fall are pooled.
std::vector<double> nearest_rising(const std::vector<double>& values) {
  struct Pool {
    double sum;
    std::size_t count;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (const double value : values) {
    pools.push_back({value, 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back() = {pools.back().sum + last.sum, pools.back().count + last.count};
    }
  }
  std::vector<double> rising;
  for (const Pool& pool : pools) rising.insert(rising.end(), pool.count, pool.mean());
  return rising;
}

}  // namespace

PlotTable table_of(const DrawnCurve& curve, double time_factor, double factor) {
  PlotTable table;
  const auto add = [&](const DrawnPoint& p) {
    table.row({time_factor * p.time, factor * p.value});
  };
  if (curve.size() <= kMostPoints) {
    for (const DrawnPoint& point : curve) add(point);
    return table;
  }
  for (std::size_t band = 0; band < kBands; ++band) {
    const auto first = curve.begin() + static_cast<std::ptrdiff_t>(band * curve.size() / kBands);
    const auto last =
        curve.begin() + static_cast<std::ptrdiff_t>((band + 1) * curve.size() / kBands);
    std::optional<DrawnPoint> lowest, highest;
    for (auto point = first; point != last; ++point) {
      if (!std::isfinite(point->value)) continue;
      if (!lowest || point->value < lowest->value) lowest = *point;
      if (!highest || point->value > highest->value) highest = *point;
    }
    if (!lowest) {
      table.gap();
      continue;
    }
    add(lowest->time <= highest->time ? *lowest : *highest);
    add(lowest->time <= highest->time ? *highest : *lowest);
  }
  return table;
}

void label_curves(GnuplotScript& script, std::vector<CurveLabel> labels, const AxisRange& axis,
                  double spacing) {
  if (labels.empty()) return;
  for (CurveLabel& label : labels)
    if (!std::isfinite(label.at)) label.at = 0.5 * (axis.low + axis.high);
  std::stable_sort(labels.begin(), labels.end(),
                   [](const CurveLabel& a, const CurveLabel& b) { return a.at < b.at; });
  // Less their spacing, places that are far enough apart rise.
  std::vector<double> places;
  for (std::size_t i = 0; i < labels.size(); ++i)
    places.push_back((labels[i].at - axis.low) / axis.span() - spacing * static_cast<double>(i));
  places = nearest_rising(places);
  const double room = std::max(1.0 - spacing * static_cast<double>(labels.size() - 1), 0.0);
  for (std::size_t i = 0; i < labels.size(); ++i)
    script.command(fmt::format(
        "set label {} at graph 1.015, graph {:.5g} left font medium textcolor rgb '{}'",
        gnuplot_string(labels[i].text),
        std::clamp(places[i], 0.0, room) + spacing * static_cast<double>(i), labels[i].colour));
}

}  // namespace graze
