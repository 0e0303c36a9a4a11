#include <algorithm>
#include <cmath>
#include <map>

#include "graze/record/study_records.hpp"
#include "graze/report/chart/charts.hpp"

namespace graze {
namespace {

// More dots than this overlap: they are drawn smaller, and the line over them thinner.
constexpr Eigen::Index kManyDots = 80;

// The name of "force2" on an axis.
std::string series_title(const std::string& name) {
  static const std::map<std::string, std::string> kTitles = {
      {"restitution", "restitution r"},
      {"time", "time of impact"},
      {"force", "contact force"},
      {"gap", "gap"},
      {"displacement", "displacement u"},
      {"velocity", "velocity u’"},
      {"penetration", "penetration"},
      {"q", "coordinate q"},
      {"qdot", "rate q’"},
  };
  const std::size_t letters = std::min(name.find_first_of("0123456789"), name.size());
  const std::string word = name.substr(0, letters), number = name.substr(letters);
  const auto known = kTitles.find(word);
  if (known == kTitles.end()) return name;
  if (word == "q" || word == "qdot") return known->second + "_{" + number + "}";
  return known->second + (number.empty() || number == "1" ? "" : ", stop " + number);
}

std::vector<double> numbers(const Vector& values) { return {values.begin(), values.end()}; }

ChartAxis abscissa_axis(const FitResult& result, Units units) {
  const Abscissa abscissa = abscissa_of(result.kind);
  ChartAxis axis;
  axis.name = result.kind == MeasurementKind::kRestitution   ? "approach speed v"
              : result.kind == MeasurementKind::kImpactTimes ? "impact"
                                                             : "time";
  axis.unit = unit_in(units, abscissa.unit);
  return axis;
}

ChartPanel values_panel(const FitResult& result, std::size_t k, bool many, Units units) {
  const FittedSeries& series = result.series[k];
  ChartPanel panel{abscissa_axis(result, units),
                   {.name = series_title(series.name), .unit = unit_in(units, series.unit)}};
  panel.height = 3.6;
  panel.series.push_back(
      {"measured",
       {.colour = many ? kSky : kBlue, .mark = MarkShape::kDot, .size = many ? 0.4 : 0.6},
       false,
       true,
       numbers(result.at),
       numbers(series.measured)});
  const auto c = static_cast<Eigen::Index>(k);
  const bool curved = result.curve.cols() > c;
  panel.series.push_back({"fitted",
                          {.colour = kVermillion, .width = many ? 1.2 : 1.8},
                          true,
                          false,
                          numbers(curved ? result.curve_at : result.at),
                          numbers(curved ? Vector(result.curve.col(c)) : series.predicted)});
  return panel;
}

ChartPanel residual_panel(const FitResult& result, std::size_t k, bool many, Units units) {
  const FittedSeries& series = result.series[k];
  ChartPanel panel{abscissa_axis(result, units),
                   {.name = "residual", .unit = unit_in(units, series.unit)}};
  const Vector missed = series.measured - series.predicted;
  panel.series.push_back({"",
                          {.colour = kBlue, .mark = MarkShape::kDot, .size = many ? 0.4 : 0.6},
                          false,
                          true,
                          numbers(result.at),
                          numbers(missed),
                          numbers(series.uncertainty)});
  panel.levels = {0.0};
  return panel;
}

}  // namespace

Chart chart_of(const FitRecord& record) {
  constexpr std::size_t kMostSeries = 4;
  Chart chart{"Fit", {}};
  const FitResult& result = record.result;
  const bool many = result.at.size() > kManyDots;
  for (std::size_t k = 0; k < std::min(result.series.size(), kMostSeries); ++k) {
    chart.rows.push_back({values_panel(result, k, many, record.info.units)});
    chart.rows.push_back({residual_panel(result, k, many, record.info.units)});
  }
  return chart;
}

}  // namespace graze
