#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "graze/report/chart/chart.hpp"
#include "graze/report/picture/detail/gnuplot_looks.hpp"
#include "graze/report/picture/detail/picture_curve.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

// Centimetres of a Canvas.
constexpr double kSheet = 12.0;  // of which margins are parts
constexpr double kLowest = 0.3;  // of the height of axes, where there is too little room
constexpr double kUsual = 9.0;   // height of a picture
constexpr double kLeft = 2.56, kRight = 0.48;
constexpr double kHead = 0.36, kHertz = 1.55;    // above the axes, and with an axis in Hz
constexpr double kAxisText = 1.55;               // tics and name of a horizontal axis
constexpr double kBetween = 0.4, kBeside = 1.3;  // two panels
constexpr double kNamed = 2.6;                   // the same where both name their vertical axis
constexpr double kLetter = 0.18;                 // of the name of an axis
constexpr double kNameLine = 0.45;               // of the name of a horizontal axis
constexpr double kHeading = 0.42;                // a line above a panel
constexpr double kLegendLine = 0.37;             // of a legend at the foot
constexpr double kMarkSpacing = 1.25;            // of its lines, relative, where they have marks
constexpr std::size_t kLong = 27;  // of a legend's entry: longer ones have a line each

// The values that the axis has to show. A logarithmic one shows all that is above zero.
AxisRequest request_of(const ChartAxis& axis, const std::vector<double>& values,
                       const AxisRequest& asked) {
  AxisRequest request = asked;
  request.scale = axis.scale;
  if (!axis.range.empty()) {
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

std::vector<double> values_of(const ChartPanel& panel, std::vector<double> ChartSeries::*part,
                              bool upright) {
  std::vector<double> values;
  for (const ChartSeries& series : panel.series)
    for (std::size_t i = 0; i < (series.*part).size(); ++i) {
      const double value = (series.*part)[i];
      values.push_back(value);
      if (upright && i < series.error.size())
        for (const double end : {value - series.error[i], value + series.error[i]})
          values.push_back(end);
    }
  if (upright) values.insert(values.end(), panel.levels.begin(), panel.levels.end());
  return values;
}

bool is_alike(const ChartAxis& a, const ChartAxis& b) {
  return a.name == b.name && a.path == b.path && a.scale == b.scale && a.unit == b.unit;
}

class ChartPicture {
 public:
  ChartPicture(const PictureRequest& request, const RunInfo& info, const Chart& chart)
      : request_(request), chart_(chart), canvas_(canvas_of(request, info, kUsual)) {
    gather_legend();
    lay_out(info);
  }

  const Canvas& canvas() const { return canvas_; }

  GnuplotScript script() {
    set_style(script_);
    script_.command("set multiplot");
    double top = 0.0;
    for (std::size_t row = 0; row < chart_.rows.size(); ++row) {
      const std::vector<ChartPanel>& panels = chart_.rows[row];
      top += above(row);
      for (std::size_t i = 0; i < panels.size(); ++i) draw(row, i, top);
      top += stretch_ * panels.front().height;
    }
    draw_legend();
    script_.command("unset multiplot");
    return script_;
  }

 private:
  void gather_legend() {
    std::set<std::string> known;
    for (const std::vector<ChartPanel>& row : chart_.rows)
      for (const ChartPanel& panel : row) {
        for (const ChartSeries& series : panel.series)
          if (!series.title.empty() && known.insert(series.title).second) {
            add_entries(series, legend_);
            if (series.has_marks || !series.is_line) spacing_ = kMarkSpacing;
          }
        for (const ChartFill& fill : panel.fills)
          if (!fill.title.empty() && known.insert(fill.title).second)
            legend_.push_back(fmt::format("NaN with boxes fs solid noborder lc rgb '{}' title {}",
                                          fill.colour, gnuplot_string(fill.title)));
      }
    for (const std::string& title : known)
      if (title.size() > kLong) columns_ = 1;
    columns_ = std::min(canvas_.columns(columns_), std::max<std::size_t>(known.size(), 1));
  }

  static void add_entries(const ChartSeries& series, std::vector<std::string>& entries) {
    const std::string title = " title " + gnuplot_string(series.title);
    entries.push_back("NaN " + layer_of(series) + title);
  }

  static std::string layer_of(const ChartSeries& series) {
    const Look& look = series.look;
    if (series.is_line && series.has_marks)
      return fmt::format("with linespoints lw {:.3g}{} pt {} ps {:.2f}*mark lc rgb '{}'",
                         look.width, dashes_of(look), point_type(look), look.size, look.colour);
    if (series.is_line) return line_of(look);
    if (!series.error.empty())
      return fmt::format("using 1:2:3 with yerrorbars pt {} ps {:.2f}*mark lw 0.7 lc rgb '{}'",
                         point_type(look), look.size, look.colour);
    return mark_of(look);
  }

  // Whether the row below has the same horizontal axes, and names them.
  bool shares_below(std::size_t row) const {
    if (row + 1 >= chart_.rows.size() || chart_.rows[row].size() != chart_.rows[row + 1].size())
      return false;
    for (std::size_t i = 0; i < chart_.rows[row].size(); ++i)
      if (!is_alike(chart_.rows[row][i].x, chart_.rows[row + 1][i].x)) return false;
    return true;
  }

  bool has_heading(std::size_t row) const {
    const std::vector<ChartPanel>& panels = chart_.rows[row];
    return std::any_of(panels.begin(), panels.end(),
                       [](const ChartPanel& panel) { return !panel.heading.empty(); });
  }

  // Of one panel of a row, from the left.
  struct Across {
    double left, width, beside;
  };
  Across across(std::size_t row, std::size_t i) const {
    const std::vector<ChartPanel>& panels = chart_.rows[row];
    const auto count = static_cast<double>(panels.size());
    const double beside = count > 1.0 && is_alike(panels[i].y, panels[1 - i].y) ? kBeside : kNamed;
    const double width = (canvas_.width - kLeft - kRight - (count - 1.0) * beside) / count;
    return {kLeft + static_cast<double>(i) * (width + beside), width, beside};
  }

  // In two lines where it would run into the name beside it.
  std::string horizontal_name(std::size_t row, std::size_t i) const {
    const ChartAxis& axis = chart_.rows[row][i].x;
    if (chart_.rows[row].size() == 1) return axis.name;
    const Across place = across(row, i);
    return in_two_lines(axis.name,
                        letters_within(place.width + std::min(place.beside, kBeside), axis.unit));
  }

  // Tics and names below a row.
  double axis_text(std::size_t row) const {
    for (std::size_t i = 0; i < chart_.rows[row].size(); ++i)
      if (horizontal_name(row, i).find('\n') != std::string::npos) return kAxisText + kNameLine;
    return kAxisText;
  }

  // From the foot of the panels above to the head of these.
  double above(std::size_t row) const {
    const double heading = has_heading(row) ? kHeading : 0.0;
    if (row == 0)
      return heading +
             (has_hertz_axis(chart_.rows.front().front().x.path, chart_.rows.front().front().x.unit)
                  ? kHertz
                  : kHead);
    return heading + kBetween + (shares_below(row - 1) ? 0.0 : axis_text(row - 1));
  }

  void lay_out(const RunInfo& info) {
    double axes = 0.0, text = axis_text(chart_.rows.size() - 1);
    for (std::size_t row = 0; row < chart_.rows.size(); ++row) {
      text += above(row);
      axes += chart_.rows[row].front().height;
    }
    const std::size_t lines = legend_.empty() ? 0 : (legend_.size() + columns_ - 1) / columns_;
    text += spacing_ * kLegendLine * static_cast<double>(lines) + 0.1;
    canvas_ = canvas_of(request_, info, axes + text);
    canvas_.laid_out = canvas_.height;
    stretch_ = std::max(canvas_.height - text, kLowest * axes) / axes;
    total_ = text + stretch_ * axes;
  }

  // That a name may have beside its unit along so many centimetres.
  static std::size_t letters_within(double length, const std::string& unit) {
    const auto letters = static_cast<std::size_t>(length / kLetter);
    return letters - std::min(letters, unit.empty() ? 0 : unit.size() + 3);
  }

  // The values along the axis of all panels that share it.
  std::vector<double> across_of(std::size_t row, std::size_t i) const {
    std::vector<double> values;
    const ChartAxis& own = chart_.rows[row][i].x;
    for (const std::vector<ChartPanel>& panels : chart_.rows)
      for (const ChartPanel& panel : panels)
        if (is_alike(panel.x, own)) {
          const std::vector<double> more = values_of(panel, &ChartSeries::x, false);
          values.insert(values.end(), more.begin(), more.end());
        }
    return values;
  }

  void draw(std::size_t row, std::size_t i, double top) {
    const std::vector<ChartPanel>& panels = chart_.rows[row];
    const ChartPanel& panel = panels[i];
    const auto [left, width, beside] = across(row, i);
    const std::vector<double> along = across_of(row, i);
    const std::vector<double> up = values_of(panel, &ChartSeries::y, true);
    const bool is_first = row == 0 && i == 0;
    const ShownAxis x(request_of(panel.x, along, request_.x), panel.x.unit, along,
                      panel.x.path.empty() ? 0.02 : 0.0, panel.x.from_zero);
    const ShownAxis y(request_of(panel.y, up, is_first ? request_.y : AxisRequest{}), panel.y.unit,
                      up, 0.06, panel.y.from_zero);
    script_.command("unset label\nunset arrow\nunset object\nunset key");
    const double height = stretch_ * panel.height;
    set_margins(script_, {.left = left / kSheet,
                          .right = (canvas_.width - left - width) / kSheet,
                          .bottom = 1.0 - (top + height) / total_,
                          .top = top / total_});
    set_horizontal(x, row, i);
    y.set_vertical(script_, tics_within(1.6 * height, height < 2.0 ? 3 : 6));
    if (i == 0 || !is_alike(panel.y, panels[i - 1].y)) {
      const std::string name = in_two_lines(panel.y.name, letters_within(height, y.unit()));
      const double from_axis = name.find('\n') == std::string::npos ? 1.9 : 2.34;
      name_vertical_axis(script_, name, y.unit(), (left - from_axis) / kSheet);
    }
    draw_ground(panel, x, y);
    plot(row, i, x, y);
  }

  void set_horizontal(const ShownAxis& x, std::size_t row, std::size_t i) {
    const ChartPanel& panel = chart_.rows[row][i];
    const bool below = !shares_below(row);
    if (!panel.x.path.empty()) {
      set_parameter_axis(script_, panel.x.path, x.range(), x.unit(),
                         {.below = below, .above = row == 0}, x.is_log());
      return;
    }
    script_.command("set border 3\nunset x2tics\nunset x2label");
    x.set_horizontal(script_, chart_.rows[row].size() == 1 ? 7 : 4);
    if (!below) script_.command("set format x ''");
    script_.command(below ? "set xlabel " + axis_label(horizontal_name(row, i), x.unit())
                          : "unset xlabel");
  }

  void draw_ground(const ChartPanel& panel, const ShownAxis& x, const ShownAxis& y) {
    const auto at = [](const ShownAxis& axis, double value) {
      return std::isfinite(value) ? std::clamp(axis.of(value), axis.range().low, axis.range().high)
             : value > 0.0        ? axis.range().high
                                  : axis.range().low;
    };
    for (const ChartFill& fill : panel.fills) {
      const ShownAxis& axis = fill.is_upright ? y : x;
      const double from = at(axis, fill.from), to = at(axis, fill.to);
      script_.command(fmt::format(
          fmt::runtime(fill.is_upright
                           ? "set object rectangle from graph 0, first {:.9g} to graph "
                             "1, first {:.9g} behind fillcolor rgb '{}' fillstyle solid "
                             "noborder"
                           : "set object rectangle from first {:.9g}, graph 0 to first "
                             "{:.9g}, graph 1 behind fillcolor rgb '{}' fillstyle solid "
                             "noborder"),
          from, to, fill.colour));
    }
    for (const double level : panel.levels)
      script_.command(fmt::format(
          "set arrow from graph 0, first {0:.9g} to graph 1, first {0:.9g} nohead back lw 0.5 lc "
          "rgb '{1}'",
          y.of(level), kGrey));
    if (!panel.heading.empty())
      script_.command(fmt::format("set label {} at graph 0, graph {:.4g} left font medium",
                                  gnuplot_string(panel.heading),
                                  1.0 + 0.5 * kHeading / (stretch_ * panel.height)));
    if (!panel.remark.empty())
      script_.command(
          fmt::format("set label {} at graph 0.5, graph 0.5 center", gnuplot_string(panel.remark)));
  }

  void plot(std::size_t row, std::size_t i, const ShownAxis& x, const ShownAxis& y) {
    const ChartPanel& panel = chart_.rows[row][i];
    std::vector<std::string> layers;
    for (std::size_t k = 0; k < panel.series.size(); ++k) {
      const ChartSeries& series = panel.series[k];
      const std::string name = fmt::format("row{}_{}_series{}", row + 1, i + 1, k + 1);
      script_.data(name, table_of(series, x, y));
      layers.push_back("$" + name + " " + layer_of(series));
    }
    script_.plot(layers);
  }

  // In axes of its own, invisible and as wide as the picture: gnuplot makes no legend wider than
  // its axes.
  void draw_legend() {
    if (legend_.empty()) return;
    script_.command(
        "unset label\nunset arrow\nunset object\nunset border\nunset tics\nunset x2tics");
    script_.command(
        "unset xlabel\nunset x2label\nunset logscale\nset xrange [0:1]\nset yrange [0:1]");
    set_margins(script_, {.left = kLeft / kSheet, .right = kRight / kSheet, .bottom = 0, .top = 0});
    script_.command(fmt::format(
        "set key at screen {:.4g}, screen {:.4g}*body center bottom horizontal maxcols "
        "{} Left reverse samplen 2 spacing {:.4g}*legend_line font small",
        0.5 * (canvas_.width + kLeft - kRight) / canvas_.width, 0.08 / total_, columns_, spacing_));
    script_.plot(legend_);
  }

  static PlotTable table_of(const ChartSeries& series, const ShownAxis& x, const ShownAxis& y) {
    PlotTable table;
    // Long curves as the band between their extremes.
    if (series.is_line && series.x.size() > kMostPoints && series.error.empty()) {
      DrawnCurve curve;
      for (std::size_t i = 0; i < series.x.size(); ++i)
        curve.push_back({x.of(series.x[i]), y.of(series.y[i])});
      return graze::table_of(curve, 1.0, 1.0);
    }
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      const double across = x.of(series.x[i]), up = y.of(series.y[i]);
      if (series.error.empty())
        table.row({across, up});
      else
        table.row({across, up, y.factor() * series.error[i]});
    }
    return table;
  }

  const PictureRequest& request_;
  const Chart& chart_;
  Canvas canvas_;
  GnuplotScript script_;
  std::vector<std::string> legend_;
  std::size_t columns_ = 2;
  double total_ = 0.0, stretch_ = 1.0, spacing_ = 1.0;
};

}  // namespace

void draw_chart(const PictureRequest& request, const RunInfo& info, const Chart& chart) {
  ChartPicture picture(request, info, chart);
  const GnuplotScript script = picture.script();
  draw_picture(request, info, script, picture.canvas());
}

}  // namespace graze
