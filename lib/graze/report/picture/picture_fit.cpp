#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "graze/record/detail/fit_record.hpp"
#include "graze/report/picture/detail/picture_column.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostSeries = 4;
// More dots than this overlap: they are drawn smaller.
constexpr Eigen::Index kManyDots = 80;

// "force2" as an axis names it; two lines at most.
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

class FitPicture {
 public:
  explicit FitPicture(const FitResult& result) : result_(result), column_(script_) {
    count_ = std::min(result.series.size(), kMostSeries);
    many_ = result.at.size() > kManyDots;
    dot_ = many_ ? 0.4 : 0.6;
  }

  GnuplotScript script() {
    set_style(script_);
    std::vector<double> panels;
    for (std::size_t k = 0; k < count_; ++k) {
      panels.push_back(1.4 * PanelColumn::kPanel);
      panels.push_back(PanelColumn::kPanel);
    }
    column_.lay_out(panels, false, true, false);
    script_.command("set multiplot");
    set_axis();
    for (std::size_t k = 0; k < count_; ++k) {
      draw_values(k);
      draw_residuals(k);
    }
    script_.command("unset multiplot");
    return script_;
  }
  double proportion() const { return column_.proportion(); }

 private:
  void set_axis() {
    const Abscissa abscissa = abscissa_of(result_.kind);
    AxisRange range;
    for (const double at : result_.at) range.include(at);
    for (const double at : result_.curve_at) range.include(at);
    const AxisUnit unit = axis_unit(abscissa.unit, std::max(std::abs(range.low), range.high));
    along_ = unit.factor;
    AxisRange shown;
    shown.include(along_ * range.low);
    shown.include(along_ * range.high);
    shown.settle(0.02);
    const bool pairs = result_.kind == MeasurementKind::kRestitution;
    const bool counted = result_.kind == MeasurementKind::kImpactTimes;
    column_.set_time_axis(shown, unit.unit,
                          pairs     ? "approach speed v"
                          : counted ? "impact"
                                    : "time");
  }

  void draw_values(std::size_t k) {
    const FittedSeries& series = result_.series[k];
    const auto c = static_cast<Eigen::Index>(k);
    AxisRange range;
    for (const double value : series.measured) range.include(value);
    for (const double value : series.predicted) range.include(value);
    if (result_.curve.cols() > c)
      for (const double value : result_.curve.col(c)) range.include(value);
    const AxisUnit unit = unit_of(series, range);
    AxisRange shown;
    shown.include(unit.factor * range.low);
    shown.include(unit.factor * range.high);
    shown.settle(0.06);
    PlotTable dots, line;
    const bool bars = series.uncertainty.size() > 0;
    for (Eigen::Index i = 0; i < series.measured.size(); ++i)
      dots.row({along_ * result_.at[i], unit.factor * series.measured[i],
                bars ? unit.factor * series.uncertainty[i] : 0.0});
    if (result_.curve.cols() > c)
      for (Eigen::Index i = 0; i < result_.curve_at.size(); ++i)
        line.row({along_ * result_.curve_at[i], unit.factor * result_.curve(i, c)});
    else
      for (Eigen::Index i = 0; i < series.predicted.size(); ++i)
        line.row({along_ * result_.at[i], unit.factor * series.predicted[i]});
    const std::string name = fmt::format("{}", k + 1);
    script_.data("measured" + name, dots);
    script_.data("fitted" + name, line);
    column_.begin_panel(shown, series_title(series.name), unit.unit);
    if (k == 0) column_.set_legend();
    // The line lies over its dots, so that it is seen where they are many.
    column_.end_panel(
        {fmt::format("$measured{} using 1:2 with points pt 7 ps {}*mark lc rgb '{}' title '{}'",
                     name, dot_, many_ ? kSky : kBlue, k == 0 ? "measured" : ""),
         fmt::format("$fitted{} using 1:2 with lines lw {} lc rgb '{}' title '{}'", name,
                     many_ ? 1.2 : 1.8, kVermillion, k == 0 ? "fitted" : "")});
  }

  void draw_residuals(std::size_t k) {
    const FittedSeries& series = result_.series[k];
    const Vector missed = series.measured - series.predicted;
    const bool bars = series.uncertainty.size() > 0;
    AxisRange range;
    for (Eigen::Index i = 0; i < missed.size(); ++i) {
      const double size = std::abs(missed[i]) + (bars ? series.uncertainty[i] : 0.0);
      range.include(-size);
      range.include(size);
    }
    const AxisUnit unit = unit_of(series, range);
    AxisRange shown;
    shown.include(unit.factor * range.low);
    shown.include(unit.factor * range.high);
    shown.settle(0.08);
    PlotTable dots;
    for (Eigen::Index i = 0; i < missed.size(); ++i)
      dots.row({along_ * result_.at[i], unit.factor * missed[i],
                bars ? unit.factor * series.uncertainty[i] : 0.0});
    const std::string name = fmt::format("missed{}", k + 1);
    script_.data(name, dots);
    column_.begin_panel(shown, "residual", unit.unit);
    column_.draw_zero_line();
    const std::string style = bars ? "using 1:2:3 with yerrorbars" : "using 1:2 with points";
    column_.end_panel(
        {fmt::format("${} {} pt 7 ps {}*mark lw 0.7 lc rgb '{}'", name, style, dot_, kBlue)});
  }

  static AxisUnit unit_of(const FittedSeries& series, const AxisRange& range) {
    return axis_unit(series.unit, std::max(std::abs(range.low), std::abs(range.high)));
  }

  const FitResult& result_;
  GnuplotScript script_;
  PanelColumn column_;
  std::size_t count_ = 0;
  double along_ = 1.0;  // factor of the horizontal axis
  bool many_ = false;
  double dot_ = 0.6;  // size
};

}  // namespace

void draw_fit(const std::string& file, const FitRecord& record) {
  FitPicture picture(record.result);
  const GnuplotScript script = picture.script();
  draw_picture(file, script, picture.proportion());
}

}  // namespace graze
