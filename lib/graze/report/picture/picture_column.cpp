#include "graze/report/picture/detail/picture_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace graze {
namespace {

constexpr double kColumnSheet = 12.0;  // of which margins are parts
constexpr double kLowestColumn = 0.3;  // of the height of axes, where there is too little room
constexpr double kColumnLeft = 2.5, kColumnRight = 0.5, kRightWithLabels = 1.85;
constexpr double kColumnLegend = 0.65, kNoLegend = 0.3;  // at the head
constexpr double kBetweenColumnPanels = 0.35;            // two panels over the same time axis
constexpr double kColumnAxisText = 1.5;                  // tics and name of a horizontal axis
constexpr double kNextInRow = 1.7;   // left of the second panel in the row, its tics
constexpr double kNamePlace = 0.02;  // of a vertical axis, as a part of the width

}  // namespace

void PanelColumn::lay_out(const PictureRequest& request, const RunInfo& info,
                          std::vector<double> panels, bool row, bool legend, bool labels) {
  panels_ = std::move(panels);
  right_ = labels ? kRightWithLabels : kColumnRight;
  top_ = legend ? kColumnLegend : kNoLegend;
  const double axes = std::accumulate(panels_.begin(), panels_.end(), row ? kRow : 0.0);
  const double text = top_ + static_cast<double>(panels_.size() - 1) * kBetweenColumnPanels +
                      kColumnAxisText + (row ? kBetweenColumnPanels + kColumnAxisText : 0.0);
  canvas_ = canvas_of(request, info, axes + text);
  canvas_.laid_out = canvas_.height;
  const double stretch = std::max(canvas_.height - text, kLowestColumn * axes) / axes;
  for (double& height : panels_) height *= stretch;
  row_ = stretch * kRow;
  total_ = text + stretch * axes;
}

void PanelColumn::set_time_axis(const AxisRange& range, const std::string& unit,
                                const std::string& name) {
  time_unit_ = unit;
  time_name_ = name;
  script_.command("set xrange " + range.text());
  script_.command(fmt::format("set xtics {:.6g}", range.tic_step(6)));
  script_.command("set format x ''");
}

double PanelColumn::set_parameter_axis(const std::string& path, const std::string& si_unit,
                                       AxisRange values, double margin) {
  const AxisUnit unit = axis_unit(si_unit, std::max(std::abs(values.low), std::abs(values.high)));
  AxisRange axis{unit.factor * values.low, unit.factor * values.high};
  axis.settle(margin);
  set_time_axis(axis, unit.unit, parameter_title(path));
  return unit.factor;
}

void PanelColumn::begin_panel(const AxisRange& range, const std::string& name,
                              const std::string& unit) {
  height_ = panels_[begun_++];
  vertical_ = range;
  set_box(kColumnLeft, canvas_.width - right_);
  script_.command("set yrange " + range.text());
  script_.command(fmt::format(
      "set ytics {:.6g}", range.tic_step(tics_within(1.6 * height_, height_ < kPanel ? 3 : 6))));
  name_vertical(name, unit);
  if (begun_ < panels_.size()) return;
  script_.command("set format x '%h'");
  script_.command("set xlabel " + axis_label(time_name_, time_unit_));
}

void PanelColumn::end_panel(const std::vector<std::string>& layers) {
  script_.plot(layers);
  clear_marks();
  top_ += height_ + kBetweenColumnPanels;
  if (begun_ == panels_.size()) top_ += kColumnAxisText;
}

void PanelColumn::begin_in_row(std::size_t i, std::size_t count, const AxisRange& x,
                               const AxisRange& y) {
  height_ = row_;
  vertical_ = y;
  const double width = 0.5 * (canvas_.width - kColumnLeft - kNextInRow - kColumnRight);
  if (count == 1)
    set_box(kColumnLeft, canvas_.width - right_);
  else if (i == 0)
    set_box(kColumnLeft, kColumnLeft + width);
  else
    set_box(canvas_.width - kColumnRight - width, canvas_.width - kColumnRight);
  script_.command("set xrange " + x.text());
  script_.command("set yrange " + y.text());
  script_.command(fmt::format("set xtics {:.6g}", x.tic_step(count == 1 ? 7 : 4)));
  script_.command(fmt::format("set ytics {:.6g}", y.tic_step(6)));
}

void PanelColumn::end_in_row(const std::vector<std::string>& layers) {
  script_.plot(layers);
  clear_marks();
}

void PanelColumn::name_vertical(const std::string& name, const std::string& unit) {
  name_vertical_axis(script_, name, unit, kNamePlace);
}

void PanelColumn::set_legend() {
  script_.command(fmt::format(
      "set key at screen {:.4g}, screen {:.4g}*body right center horizontal Left reverse "
      "samplen 1.5 font small",
      1.0 - right_ / canvas_.width, 1.0 - 0.5 * kColumnLegend / total_));
}

void PanelColumn::remark(const std::string& text) {
  script_.command(fmt::format("set label {} at screen {:.4g}, screen {:.4g}*body left font medium",
                              gnuplot_string(text), kNamePlace,
                              1.0 - 0.5 * kColumnLegend / total_));
}

void PanelColumn::note(const std::string& text) {
  script_.command(fmt::format("set label {} at graph 0.01, graph {:.4g} left font medium",
                              gnuplot_string(text), 1.0 + 0.4 * kBetweenColumnPanels / height_));
}

void PanelColumn::draw_zero_line() {
  if (vertical_.low < 0.0 && vertical_.high > 0.0)
    script_.command(
        fmt::format("set arrow from graph 0, first 0 to graph 1, first 0 nohead back "
                    "lw 0.5 lc rgb '{}'",
                    kGrey));
}

void PanelColumn::set_box(double left, double right) {
  set_margins(script_, {.left = left / kColumnSheet,
                        .right = (canvas_.width - right) / kColumnSheet,
                        .bottom = 1.0 - (top_ + height_) / total_,
                        .top = top_ / total_});
}

void PanelColumn::clear_marks() {
  script_.command("unset object\nunset arrow\nunset label\nunset key");
}

}  // namespace graze
