#include <fmt/format.h>

#include <algorithm>

#include "graze/assembly/beam_shape.hpp"
#include "graze/base/angle.hpp"
#include "graze/record/records.hpp"
#include "graze/report/chart/charts.hpp"

namespace graze {
namespace {

constexpr int kPlaces = 201;  // along the beam
constexpr std::size_t kMostModes = 6;

ChartPanel beam_panel(const char* name, const char* unit, Units units) {
  ChartPanel panel{{.name = "place along the beam x", .unit = unit_in(units, "m")},
                   {.name = name, .unit = unit_in(units, unit)}};
  panel.height = 5.0;
  panel.levels = {0.0};
  return panel;
}

// Where the stops stand, as short bars: "stop 1" at its place and gap.
void add_stops(const std::vector<BeamStop>& all, ChartPanel& panel) {
  ChartSeries stops{
      "stop", {.colour = kBlack, .mark = MarkShape::kSquare, .size = 0.7}, false, true, {}, {}};
  for (const BeamStop& stop : all) {
    stops.x.push_back(stop.x);
    stops.y.push_back(stop.u);
  }
  if (!stops.x.empty()) panel.series.push_back(stops);
}

}  // namespace

Chart mode_shapes_chart(const CheckRecord& record) {
  ChartPanel panel = beam_panel("mode shape / its largest value", "", record.info.units);
  const std::optional<BeamPlaces> places = beam_places(record.scene, kPlaces);
  if (!places) {
    panel.remark = "only a beam, string or bar, not on a hub, has shapes to draw";
    return {"Mode shapes", {{panel}}};
  }
  const auto modes = std::min(static_cast<std::size_t>(places->rows.cols()), kMostModes);
  for (std::size_t j = 0; j < modes; ++j) {
    const Vector shape = places->rows.col(static_cast<Eigen::Index>(j));
    const double largest = shape.cwiseAbs().maxCoeff();
    const double frequency = record.system.omega[static_cast<Eigen::Index>(j)];
    ChartSeries series{
        record.info.units == Units::kSi
            ? fmt::format("mode {}: {:.4g} rad/s ({:.4g} Hz)", j + 1, frequency, frequency / kTurn)
            : fmt::format("mode {}: {:.4g}", j + 1, frequency),
        curve_look(j),
        true,
        false,
        places->x,
        {}};
    for (const double value : shape) series.y.push_back(value / largest);
    panel.series.push_back(series);
  }
  return {"Mode shapes", {{panel}}};
}

Chart shapes_chart(const SimulationRecord& record) {
  ChartPanel panel = beam_panel("displacement u", "m", record.info.units);
  for (std::size_t i = 0; i < record.shapes.size(); ++i) {
    const BeamShape& shape = record.shapes[i];
    panel.series.push_back(
        {fmt::format("t = {:.6g}{}", shape.time, unit_behind(record.info.units, "s")),
         curve_look(i), true, false, shape.x, shape.deflection});
  }
  if (record.beam) add_stops(record.beam->stops, panel);
  return {"Shapes of the beam", {{panel}}};
}

}  // namespace graze
