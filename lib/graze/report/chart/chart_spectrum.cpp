#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "graze/base/spectrum.hpp"
#include "graze/record/records.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"

namespace graze {

namespace {

constexpr std::size_t kMostPlaces = 3;

// Values over the frequency, down to a part of the largest, below which they are rounding and
// leakage of the window. `end`: half the sampling rate, 1/s.
ChartPanel lines_panel(const SimulationRecord& record, ChartAxis y, double smallest_part,
                       const std::vector<double>& frequency, const std::vector<double>& values,
                       double end) {
  const Units units = record.info.units;
  y.scale = AxisScale::kLog;
  ChartPanel panel{
      {.name = units == Units::kSi ? "frequency" : "frequency / 2π", .unit = unit_in(units, "Hz")},
      std::move(y)};
  panel.height = 4.0;
  if (frequency.empty()) {
    panel.remark = "too few samples for a spectrum";
    panel.y.scale = AxisScale::kLinear;
  }
  // Beyond twenty forcing frequencies a smooth motion has no amplitude, and impacts have little.
  const auto forcing = record.system.forcing();
  const double most = forcing ? 20.0 * forcing->frequency / (2.0 * std::numbers::pi) : 0.5 * end;
  if (!frequency.empty()) panel.x.range = {0.0, std::min(most, frequency.back())};
  panel.series.push_back({"", {.colour = kBlue, .width = 1.0}, true, false, frequency, values});
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, value);
  if (largest > 0.0) panel.y.range = {smallest_part * largest, 2.0 * largest};
  return panel;
}

}  // namespace

Chart spectrum_chart(const SimulationRecord& record) {
  Chart chart{"Amplitude spectrum", {}};
  const std::vector<Sample>& samples = record.samples;
  const double rate = samples.size() < 2 ? 0.0
                                         : static_cast<double>(samples.size() - 1) /
                                               (samples.back().time - samples.front().time);
  for (const SeenPlace& place : places_of(record.system)) {
    if (chart.rows.size() == kMostPlaces) break;
    std::vector<double> values;
    for (const Sample& sample : samples) values.push_back(place.row.dot(sample.state.q));
    const Spectrum spectrum = amplitude_spectrum(values, rate);
    chart.rows.push_back({lines_panel(
        record,
        {.name = place.is_modal() ? std::string("amplitude of q_1")
                 : record.system.stops.size() == 1 && !place.stops.empty()
                     ? "amplitude at the stop"
                     : "amplitude\nat " + place.name(record.system),
         .unit = unit_in(record.info.units, place.is_modal() ? "kg^1/2 m" : "m")},
        1e-6, spectrum.frequency, spectrum.amplitude, 0.5 * rate)});
  }
  return chart;
}

Chart psd_chart(const SimulationRecord& record) {
  Chart chart{"Power spectral density", {}};
  const RunStatistics& statistics = *record.statistics;
  for (std::size_t i = 0; i < std::min(record.places.size(), kMostPlaces); ++i) {
    const MeasuredPlace& place = record.places[i];
    chart.rows.push_back({lines_panel(
        record, {.name = "PSD at\n" + place.name(), .unit = density_unit(place, record.info.units)},
        1e-12, statistics.frequencies(), statistics.places[i].density,
        0.5 * statistics.sample_rate)});
  }
  return chart;
}

Chart returns_chart(const SimulationRecord& record) {
  Chart chart{"Return map of the impacts", {}};
  const Units units = record.info.units;
  const std::string of_speed = unit_in(units, "m/s"), of_phase = unit_in(units, "rad");
  ChartPanel speed{{.name = "impact speed", .unit = of_speed},
                   {.name = "speed of\nthe next", .unit = of_speed}};
  ChartPanel phase{{.name = "phase", .unit = of_phase},
                   {.name = "phase of\nthe next", .unit = of_phase}};
  // Only the last ones: a vector picture should not hold more dots.
  constexpr std::size_t kMost = 20'000;
  const std::vector<SectionPoint>& points = record.section->points();
  const std::size_t first = points.size() > kMost + 1 ? points.size() - kMost - 1 : 0;
  ChartSeries speeds{"", {.colour = kBlue, .mark = MarkShape::kDot, .size = 0.1}, false, true, {},
                     {}};
  ChartSeries phases = speeds;
  double fastest = 0.0;
  for (std::size_t i = first; i + 1 < points.size(); ++i) {
    speeds.x.push_back(points[i].up), speeds.y.push_back(points[i + 1].up);
    phases.x.push_back(points[i].across), phases.y.push_back(points[i + 1].across);
    fastest = std::max({fastest, points[i].up, points[i + 1].up});
  }
  const auto diagonal = [](double end) {
    return ChartSeries{"each like the one before",
                       {.colour = kGrey, .width = 1.0},
                       true,
                       false,
                       {0.0, end},
                       {0.0, end}};
  };
  speed.series = {diagonal(fastest), speeds};
  phase.series = {diagonal(2.0 * std::numbers::pi), phases};
  for (ChartPanel* panel : {&speed, &phase}) {
    panel->height = 4.0;
    panel->x.from_zero = panel->y.from_zero = true;
    if (speeds.x.empty()) panel->remark = "no impacts";
  }
  chart.rows = {{speed, phase}};
  if (first > 0) chart.rows[0][0].heading = fmt::format("the last {} impacts", kMost);
  return chart;
}

}  // namespace graze
