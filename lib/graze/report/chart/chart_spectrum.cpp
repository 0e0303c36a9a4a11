#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "graze/record/records.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"
#include "graze/report/chart/spectrum.hpp"

namespace graze {

Spectrum amplitude_spectrum(const std::vector<double>& values, double rate) {
  Spectrum spectrum;
  const std::size_t count = values.size();
  if (count < 4) return spectrum;
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(count);
  // Hann's window, periodic: a line between two frequencies spreads over four of them.
  std::vector<double> windowed;
  for (std::size_t i = 0; i < count; ++i)
    windowed.push_back((values[i] - mean) * 0.5 *
                       (1.0 - std::cos(2.0 * std::numbers::pi * static_cast<double>(i) /
                                       static_cast<double>(count))));
  std::vector<std::complex<double>> transformed;
  Eigen::FFT<double> fft;
  fft.fwd(transformed, windowed);
  // Twice for the negative frequencies, twice for the window's mean of a half.
  for (std::size_t k = 1; k < count / 2; ++k) {
    spectrum.frequency.push_back(rate * static_cast<double>(k) / static_cast<double>(count));
    spectrum.amplitude.push_back(4.0 * std::abs(transformed[k]) / static_cast<double>(count));
  }
  return spectrum;
}

Chart spectrum_chart(const SimulationRecord& record) {
  Chart chart{"Amplitude spectrum", {}};
  const Units units = record.info.units;
  const std::vector<Sample>& samples = record.samples;
  const std::vector<SeenPlace> places = places_of(record.system);
  const double rate = samples.size() < 2 ? 0.0
                                         : static_cast<double>(samples.size() - 1) /
                                               (samples.back().time - samples.front().time);
  constexpr std::size_t kMostPlaces = 3;
  for (const SeenPlace& place : places) {
    if (chart.rows.size() == kMostPlaces) break;
    const bool has_stop = !place.stops.empty();
    ChartPanel panel{
        {.name = units == Units::kSi ? "frequency" : "frequency / 2π",
         .unit = unit_in(units, "Hz")},
        {.name = !has_stop ? std::string("amplitude of q_1")
                 : record.system.stops.size() > 1
                     ? fmt::format("amplitude\nat stop {}", place.stops.front().index + 1)
                     : "amplitude at the stop",
         .unit = unit_in(units, has_stop ? "m" : "kg^1/2 m"),
         .scale = AxisScale::kLog}};
    panel.height = 4.0;
    std::vector<double> values;
    for (const Sample& sample : samples) values.push_back(place.row.dot(sample.state.q));
    const Spectrum spectrum = amplitude_spectrum(values, rate);
    if (spectrum.frequency.empty()) {
      panel.remark = "too few samples for a spectrum";
      panel.y.scale = AxisScale::kLinear;
    }
    // Beyond twenty forcing frequencies a smooth motion has no amplitude, and impacts have little.
    const auto forcing = record.system.forcing();
    const double most =
        forcing ? 20.0 * forcing->frequency / (2.0 * std::numbers::pi) : 0.25 * rate;
    if (!spectrum.frequency.empty())
      panel.x.range = {0.0, std::min(most, spectrum.frequency.back())};
    panel.series.push_back(
        {"", {.colour = kBlue, .width = 1.0}, true, false, spectrum.frequency, spectrum.amplitude});
    double largest = 0.0;
    for (const double amplitude : spectrum.amplitude) largest = std::max(largest, amplitude);
    // Below this the spectrum is rounding and leakage of the window.
    if (largest > 0.0) panel.y.range = {1e-6 * largest, 2.0 * largest};
    chart.rows.push_back({panel});
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
