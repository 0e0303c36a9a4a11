#include "graze/report/picture_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace graze {
namespace {

constexpr std::size_t kColumns = 3;  // of the legend
constexpr double kHeight = 0.75;     // of the picture over its width

// Colours of equal steps in lightness, dark to bright (after M. Kuhn's and N. Smith's viridis), and
// two hues away from zero.
constexpr std::array kScale = {"#440154", "#3B528B", "#21918C", "#5EC962", "#FDE725"};
constexpr std::array kAboutZero = {"#2166AC", "#92C5DE", "#F7F7F7", "#F4A582", "#B2182B"};

class CellPicture {
 public:
  CellPicture(const Plane& plane, const std::string& x_unit, const std::string& y_unit)
      : plane_(plane) {
    x_unit_ = axis_unit(x_unit, std::max(std::abs(plane.x.from), std::abs(plane.x.to)));
    y_unit_ = axis_unit(y_unit, std::max(std::abs(plane.y.from), std::abs(plane.y.to)));
    x_ = range_of(plane.x, x_unit_.factor);
    y_ = range_of(plane.y, y_unit_.factor);
  }

  GnuplotScript script(const CellColours& colours) {
    Margins margins;
    margins.bottom += legend_height(colours.legend.size(), kColumns);
    set_axes(margins);
    write_cells(colours.of);
    set_legend(script_, margins, kColumns);
    std::vector<std::string> layers = {kCells};
    for (const auto& [name, colour] : colours.legend)
      layers.push_back(
          fmt::format("NaN with points pt 5 ps 1.1 lc rgb '{}' title '{}'", colour, name));
    script_.plot(layers);
    return script_;
  }

  GnuplotScript script(const CellNumbers& numbers) {
    bar_ = cell_bar(plane_.cells(), numbers.of, numbers.scale);
    Margins margins;
    margins.right = 0.2;
    set_axes(margins);
    write_cells([&](std::size_t cell) {
      const double value = numbers.of(cell);
      if (std::isfinite(value)) return bar_.at(value);
      return numbers.is_known(cell) ? colour_of(kNoCell) : Colour{};
    });
    script_.plot({kCells, colour_bar(numbers.title)});
    return script_;
  }

 private:
  static constexpr const char* kCells = "$cells using 1:2:3:4:5 with rgbimage";

  static AxisRange range_of(const PlaneAxis& axis, double factor) {
    const AxisRange range = cell_range(axis);
    return {factor * range.low, factor * range.high};
  }

  void set_axes(Margins& margins) {
    set_style(script_);
    if (has_hertz_axis(plane_.x.name)) margins.top = kHertzMargin;
    set_margins(script_, margins);
    set_parameter_axis(script_, plane_.x.name, x_, x_unit_.unit);
    script_.command("set yrange " + y_.text());
    script_.command(fmt::format("set ytics {:.6g}", y_.tic_step(8)));
    name_vertical_axis(script_, parameter_title(plane_.y.name), y_unit_.unit);
  }

  void write_cells(const std::function<Colour(std::size_t)>& colour_of_cell) {
    PlotTable table;
    for (std::size_t i = 0; i < plane_.cells(); ++i) {
      const Colour colour = colour_of_cell(i);
      table.row({x_unit_.factor * plane_.x_at(i), y_unit_.factor * plane_.y_at(i),
                 std::round(colour.red), std::round(colour.green), std::round(colour.blue)});
    }
    script_.data("cells", table);
  }

  // The bar beside the axes comes with a layer that has a palette: two dots without a size.
  std::string colour_bar(const std::string& title) {
    std::string palette;
    for (std::size_t i = 0; i < bar_.colours.size(); ++i)
      palette += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, bar_.colours[i]);
    script_.command("set palette defined (" + palette + ")");
    script_.command("set cbrange " + bar_.range.text());
    script_.command(fmt::format("set cbtics {:.6g}", bar_.range.tic_step(6)));
    script_.command("set cblabel " + title + " offset 1.5");
    PlotTable ends;
    ends.row({x_.low, y_.low, bar_.range.low});
    ends.row({x_.high, y_.high, bar_.range.high});
    script_.data("ends", ends);
    return "$ends using 1:2:3 with points pt 7 ps 0 lc palette";
  }

  const Plane& plane_;
  GnuplotScript script_;
  AxisUnit x_unit_, y_unit_;
  AxisRange x_, y_;
  CellBar bar_;
};

}  // namespace

Colour colour_of(const std::string& hex) {
  const long code = std::strtol(hex.c_str() + 1, nullptr, 16);
  return {static_cast<double>(code >> 16 & 255), static_cast<double>(code >> 8 & 255),
          static_cast<double>(code & 255)};
}

Colour CellBar::at(double value) const {
  const double place = std::clamp((value - range.low) / range.span(), 0.0, 1.0) *
                       static_cast<double>(colours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  const double part = place - static_cast<double>(below);
  const Colour a = colour_of(colours[below]), b = colour_of(colours[below + 1]);
  return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green),
          a.blue + part * (b.blue - a.blue)};
}

CellBar cell_bar(std::size_t cells, const std::function<double(std::size_t cell)>& of,
                 CellScale scale) {
  AxisRange range;
  for (std::size_t i = 0; i < cells; ++i) range.include(of(i));
  bool has_two_hues = scale == CellScale::kSigned;
  if (scale == CellScale::kFromZero) range.include(0.0);
  if (scale == CellScale::kSigned)
    for (const double end : {range.low, range.high}) range.include(-end);
  if (scale == CellScale::kUnbounded && range.low < 0.0 && range.high > 0.0) {
    has_two_hues = true;
    range.low = -range.high;
  }
  range.settle(0.0);
  return {range, has_two_hues ? kAboutZero : kScale};
}

AxisRange cell_range(const PlaneAxis& axis) {
  const double half = 0.5 * std::abs(axis.to - axis.from) / (axis.points - 1);
  AxisRange range;
  range.include(std::min(axis.from, axis.to) - half);
  range.include(std::max(axis.from, axis.to) + half);
  return range;
}

void draw_cells(const std::string& file, const Plane& plane, const std::string& x_unit,
                const std::string& y_unit, const CellColours& colours) {
  draw_picture(file, CellPicture(plane, x_unit, y_unit).script(colours), kHeight);
}

void draw_cells(const std::string& file, const Plane& plane, const std::string& x_unit,
                const std::string& y_unit, const CellNumbers& numbers) {
  draw_picture(file, CellPicture(plane, x_unit, y_unit).script(numbers), kHeight);
}

}  // namespace graze
