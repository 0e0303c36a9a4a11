#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/assembly/beam_shape.hpp"
#include "graze/base/angle.hpp"
#include "graze/record/records.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/scene/matrix_structure.hpp"

namespace graze {
namespace {

constexpr int kPlaces = 201;  // along the beam
constexpr std::size_t kMostDrawnModes = 6;
constexpr std::size_t kMostLarge = 8;  // stops with marks of full size

ChartPanel beam_panel(const std::string& structure, const char* name, const char* unit,
                      Units units) {
  ChartPanel panel{
      {.name = fmt::format("place along the {} x", structure), .unit = unit_in(units, "m")},
      {.name = name, .unit = unit_in(units, unit)}};
  panel.height = 5.0;
  panel.levels = {0.0};
  return panel;
}

// Draws the stops as short bars: "stop 1" at its place and gap.
void add_stops(const std::vector<BeamStop>& all, ChartPanel& panel) {
  ChartSeries stops{
      "stop",
      {.colour = kBlack, .mark = MarkShape::kSquare, .size = all.size() > kMostLarge ? 0.35 : 0.7},
      false,
      true,
      {},
      {}};
  for (const BeamStop& stop : all) {
    stops.x.push_back(stop.x);
    stops.y.push_back(stop.u);
  }
  if (!stops.x.empty()) panel.series.push_back(stops);
}

}  // namespace

namespace {

std::string mode_title(std::size_t j, double frequency, Units units) {
  return units == Units::kSi
             ? fmt::format("mode {}: {:.4g} rad/s ({:.4g} Hz)", j + 1, frequency, frequency / kTurn)
             : fmt::format("mode {}: {:.4g}", j + 1, frequency);
}

// Draws the shapes over places, or over degrees of freedom in their order.
void add_shapes(const std::vector<double>& x, const Matrix& rows, const Vector& omega, Units units,
                bool is_line, ChartPanel& panel) {
  const auto modes = std::min(static_cast<std::size_t>(rows.cols()), kMostDrawnModes);
  for (std::size_t j = 0; j < modes; ++j) {
    const auto mode = static_cast<Eigen::Index>(j);
    const Vector shape = rows.col(mode);
    const double largest = shape.cwiseAbs().maxCoeff();
    ChartSeries series{mode_title(j, omega[mode], units), curve_look(j), is_line, !is_line, x, {}};
    for (const double value : shape) series.y.push_back(value / largest);
    panel.series.push_back(series);
  }
}

// The nodes in the plane of their two largest extents.
struct NodePlane {
  std::size_t across = 0, up = 1;  // axes, 0 for x
  double size = 0.0;               // the larger extent, m
};

NodePlane plane_of(const MatrixModes& found) {
  std::array<double, 3> low{}, high{};
  bool is_first = true;
  for (const auto& [node, place] : found.coordinates) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = is_first ? place[d] : std::min(low[d], place[d]);
      high[d] = is_first ? place[d] : std::max(high[d], place[d]);
    }
    is_first = false;
  }
  const auto extent = [&](std::size_t d) { return high[d] - low[d]; };
  std::size_t least = 2;
  for (const std::size_t d : {1u, 0u})
    if (extent(d) < extent(least)) least = d;
  NodePlane plane{least == 0 ? 1u : 0u, least == 2 ? 1u : 2u, 0.0};
  plane.size = std::max(extent(plane.across), extent(plane.up));
  return plane;
}

// The bars of the structure, displaced by a mode, its largest displacement a tenth of its size.
ChartSeries bars(const MatrixModes& found, const NodePlane& plane,
                 std::optional<Eigen::Index> mode) {
  double largest = 0.0;
  if (mode)
    for (const auto& [node, place] : found.coordinates)
      for (const double u : found.displacement(node, *mode))
        largest = std::max(largest, std::abs(u));
  const double scale = largest > 0.0 ? 0.1 * plane.size / largest : 0.0;
  ChartSeries series{mode ? "mode shape" : "at rest",
                     mode ? curve_look(0) : Look{.colour = kGrey},
                     !found.couplings.empty(),
                     found.couplings.empty(),
                     {},
                     {}};
  const auto add = [&](long node) {
    const auto place = found.coordinates.find(node);
    if (place == found.coordinates.end()) return;
    const auto moved = mode ? found.displacement(node, *mode) : std::array<double, 3>{};
    series.x.push_back(place->second[plane.across] + scale * moved[plane.across]);
    series.y.push_back(place->second[plane.up] + scale * moved[plane.up]);
  };
  for (const auto& [first, second] : found.couplings) {
    add(first), add(second);
    series.x.push_back(std::nan("")), series.y.push_back(std::nan(""));
  }
  if (found.couplings.empty())
    for (const auto& [node, place] : found.coordinates) add(node);
  return series;
}

Chart bars_chart(const MatrixModes& found, const Vector& omega, Units units) {
  static constexpr const char* kNames[] = {"x", "y", "z"};
  const NodePlane plane = plane_of(found);
  Chart chart{"Mode shapes", {}};
  const auto modes = std::min(static_cast<std::size_t>(omega.size()), kMostDrawnModes);
  for (std::size_t j = 0; j < modes; ++j) {
    const auto mode = static_cast<Eigen::Index>(j);
    ChartPanel panel{{.name = kNames[plane.across], .unit = unit_in(units, "m")},
                     {.name = kNames[plane.up], .unit = unit_in(units, "m")}};
    panel.height = 5.0;
    panel.heading = units == Units::kSi
                        ? fmt::format("mode {}: {:.4g} Hz", j + 1, omega[mode] / kTurn)
                        : fmt::format("mode {}: {:.4g}", j + 1, omega[mode]);
    panel.series = {bars(found, plane, {}), bars(found, plane, mode)};
    if (j % 2 == 0) chart.rows.emplace_back();
    chart.rows.back().push_back(panel);
  }
  return chart;
}

}  // namespace

Chart mode_shapes_chart(const Scene& scene, const Vector& omega) {
  if (const DiscreteStructure* matrices = scene.discrete()) {
    const MatrixModes& found = *matrices->solved;
    if (!found.coordinates.empty()) return bars_chart(found, omega, scene.units);
    ChartPanel panel{{.name = "degree of freedom"}, {.name = "mode shape / its largest value"}};
    panel.height = 5.0;
    panel.levels = {0.0};
    std::vector<double> numbers;
    for (int i = 1; i <= found.free_count(); ++i) numbers.push_back(i);
    add_shapes(numbers, found.modes.shapes, omega, scene.units, false, panel);
    return {"Mode shapes", {{panel}}};
  }
  ChartPanel panel =
      beam_panel(scene.structure_name(), "mode shape / its largest value", "", scene.units);
  if (const std::optional<BeamPlaces> places = beam_places(scene, kPlaces))
    add_shapes(places->x, places->rows, omega, scene.units, true, panel);
  else
    panel.remark = "modes that are given have no shapes to draw, nor has what turns with a hub";
  return {"Mode shapes", {{panel}}};
}

Chart shapes_chart(const SimulationRecord& record) {
  const std::string structure = record.beam ? record.beam->structure : "beam";
  ChartPanel panel = beam_panel(structure, "displacement u", "m", record.info.units);
  for (std::size_t i = 0; i < record.shapes.size(); ++i) {
    const BeamShape& shape = record.shapes[i];
    panel.series.push_back(
        {fmt::format("t = {:.6g}{}", shape.time, unit_behind(record.info.units, "s")),
         curve_look(i), true, false, shape.x, shape.deflection});
  }
  if (record.beam) add_stops(record.beam->stops, panel);
  return {fmt::format("Shapes of the {}", structure), {{panel}}};
}

}  // namespace graze
