#include "graze/report/picture/detail/picture_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "graze/report/picture/detail/picture_locus_curves.hpp"

namespace graze {
namespace {

constexpr double kHeight = 0.75;  // of the picture over its width, without a legend of loci
// Columns of the legend, of names that are short and of others.
constexpr std::size_t kColumns = 3, kColumnsOfLong = 2, kLong = 14;

// Colours of equal steps in lightness, dark to bright (after M. Kuhn's and N. Smith's viridis), and
// two hues away from zero.
constexpr std::array kScale = {"#440154", "#3B528B", "#21918C", "#5EC962", "#FDE725"};
constexpr std::array kAboutZero = {"#2166AC", "#92C5DE", "#F7F7F7", "#F4A582", "#B2182B"};

class CellPicture {
 public:
  explicit CellPicture(const DrawnPlane& drawn) : plane_(drawn.plane), loci_(drawn.loci) {
    x_unit_ = axis_unit(drawn.x_unit, std::max(std::abs(plane_.x.from), std::abs(plane_.x.to)));
    y_unit_ = axis_unit(drawn.y_unit, std::max(std::abs(plane_.y.from), std::abs(plane_.y.to)));
    x_ = range_of(plane_.x, x_unit_.factor);
    y_ = range_of(plane_.y, y_unit_.factor);
  }

  void draw(const std::string& file, const CellColours& colours) {
    const bool has_long = std::any_of(colours.legend.begin(), colours.legend.end(),
                                      [](const auto& entry) { return entry.first.size() > kLong; });
    std::vector<std::string> legend;
    for (const auto& [name, colour] : colours.legend)
      legend.push_back(
          fmt::format("NaN with points pt 5 ps 1.1 lc rgb '{}' title '{}'", colour, name));
    begin(legend.size(), has_long ? kColumnsOfLong : kColumns, 0.04);
    write_cells(colours.of);
    plot(std::move(legend));
    draw_picture(file, script_, proportion_);
  }

  void draw(const std::string& file, const CellNumbers& numbers) {
    bar_ = cell_bar(plane_.cells(), numbers.of, numbers.scale);
    begin(0, kColumns, 0.2);
    write_cells([&](std::size_t cell) {
      const double value = numbers.of(cell);
      if (std::isfinite(value)) return bar_.at(value);
      return numbers.is_known(cell) ? colour_of(kNoCell) : Colour{};
    });
    plot({colour_bar(numbers.title)});
    draw_picture(file, script_, proportion_);
  }

 private:
  static AxisRange range_of(const PlaneAxis& axis, double factor) {
    const AxisRange range = cell_range(axis);
    return {factor * range.low, factor * range.high};
  }

  // Axes with room at the foot for `entries` of the legend; that of loci takes its own below.
  void begin(std::size_t entries, std::size_t columns, double right) {
    set_style(script_);
    if (loci_)
      draw_locus_curves(*loci_, {x_unit_.factor, y_unit_.factor, x_, y_}, LociGround::kColours,
                        script_, loci_drawn_);
    if (loci_) columns = kColumnsOfLong;
    const std::size_t all = entries + loci_drawn_.legend.size();
    const double more = legend_height(all, columns) - legend_height(entries, columns);
    proportion_ *= 1.0 + more;
    Margins margins;
    margins.right = right;
    margins.bottom = (margins.bottom + legend_height(all, columns)) / (1.0 + more);
    margins.top = (has_hertz_axis(plane_.x.name) ? kHertzMargin : margins.top) / (1.0 + more);
    set_margins(script_, margins);
    if (all > 0) set_legend(script_, margins, columns);
    set_parameter_axis(script_, plane_.x.name, x_, x_unit_.unit);
    script_.command("set yrange " + y_.text());
    script_.command(fmt::format("set ytics {:.6g}", y_.tic_step(8)));
    name_vertical_axis(script_, parameter_title(plane_.y.name), y_unit_.unit);
  }

  // Cells, loci over them, and what else there is.
  void plot(std::vector<std::string> others) {
    std::vector<std::string> layers = {"$cells using 1:2:3:4:5 with rgbimage notitle"};
    for (const auto* more : {&loci_drawn_.curves, &others, &loci_drawn_.legend})
      layers.insert(layers.end(), more->begin(), more->end());
    script_.plot(layers);
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
    return "$ends using 1:2:3 with points pt 7 ps 0 lc palette notitle";
  }

  const Plane& plane_;
  const OrbitLoci* loci_;
  LociDrawn loci_drawn_;
  GnuplotScript script_;
  AxisUnit x_unit_, y_unit_;
  AxisRange x_, y_;
  CellBar bar_;
  double proportion_ = kHeight;
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

void draw_cells(const std::string& file, const DrawnPlane& plane, const CellColours& colours) {
  CellPicture(plane).draw(file, colours);
}

void draw_cells(const std::string& file, const DrawnPlane& plane, const CellNumbers& numbers) {
  CellPicture(plane).draw(file, numbers);
}

}  // namespace graze
