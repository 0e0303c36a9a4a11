#include "graze/report/picture/detail/picture_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "graze/report/picture/detail/picture_locus_curves.hpp"

namespace graze {
namespace {

constexpr double kCellsWidth = 12.0;   // cm
constexpr double kCellsHeight = 0.75;  // of the picture over that width, without a legend
constexpr double kAround = 3.6;        // cm above and below the axes
// Cells without a number because their motions meet no stop.
constexpr std::array kClear = {"clear of the stops", "both clear"};
// Of an SVG, as rectangles: 1 MB. Browsers smooth an image, which mixes the colours of large cells
// to those of others; of more cells most are smaller than a hundredth of the plane.
constexpr std::size_t kMostRectangles = 10'000;
// Columns of the legend, of names that are short and of others.
constexpr std::size_t kColumns = 3, kColumnsOfLong = 2, kLongLegend = 14;

// Colours of equal steps in lightness, dark to bright (after M. Kuhn's and N. Smith's viridis), and
// two hues away from zero.
constexpr std::array kScale = {"#440154", "#3B528B", "#21918C", "#5EC962", "#FDE725"};
constexpr std::array kAboutZero = {"#2166AC", "#92C5DE", "#F7F7F7", "#F4A582", "#B2182B"};

class CellPicture {
 public:
  CellPicture(const PictureRequest& request, const DrawnPlane& drawn)
      : request_(request),
        info_(drawn.info),
        plane_(drawn.plane),
        loci_(drawn.loci),
        x_(request.x, drawn.x_unit, ends_of(plane_.x), 0.0),
        y_(request.y, drawn.y_unit, ends_of(plane_.y), 0.0) {}

  void draw(const CellColours& colours) {
    begin(legend_of(colours.legend), 0.04);
    write_cells(colours.of);
    plot({});
    draw_picture(request_, info_, script_, canvas_of(request_, info_, kCellsWidth * proportion_));
  }

  void draw(const CellNumbers& numbers) {
    bar_ = cell_bar(plane_.cells(), numbers.of, numbers.scale);
    std::map<std::string, std::string> grounds;  // of what has no number
    for (std::size_t i = 0; i < plane_.cells(); ++i)
      if (!std::isfinite(numbers.of(i))) grounds[numbers.without(i)];
    const std::span<const char* const> without = grounds_without_motion();
    std::size_t next = 0;
    std::vector<std::pair<std::string, std::string>> legend;
    // White is what is clear of the stops, in every picture that has such cells.
    for (const char* name : kClear)
      if (const auto clear = grounds.find(name); clear != grounds.end()) {
        clear->second = ground_look("blank").colour;
        legend.emplace_back(std::string(name) + " (blank)", clear->second);
      }
    for (auto& [name, colour] : grounds) {
      if (!colour.empty()) continue;
      colour = without[std::min(next++, without.size() - 1)];
      legend.emplace_back(name, colour);
    }
    begin(legend_of(legend), 0.23);
    write_cells([&](std::size_t cell) {
      const double value = numbers.of(cell);
      return std::isfinite(value) ? bar_.at(value) : colour_of(grounds.at(numbers.without(cell)));
    });
    plot({colour_bar(numbers.title)});
    draw_picture(request_, info_, script_, canvas_of(request_, info_, kCellsWidth * proportion_));
  }

 private:
  static std::vector<double> ends_of(const PlaneAxis& axis) {
    const AxisRange range = cell_range(axis);
    return {range.low, range.high};
  }

  // Without the room of the legend.
  Canvas usual_canvas() const { return canvas_of(request_, info_, kCellsWidth * kCellsHeight); }

  // A white ground has an outline.
  std::vector<std::string> legend_of(
      const std::vector<std::pair<std::string, std::string>>& entries) {
    columns_ = usual_canvas().columns(kColumns);
    std::vector<std::string> legend;
    for (const auto& [name, colour] : entries) {
      if (name.size() > kLongLegend) columns_ = usual_canvas().columns(kColumnsOfLong);
      legend.push_back(
          fmt::format("NaN with boxes lc rgb '{}' lw 0.5 fs solid border lc rgb '{}' "
                      "title {}",
                      colour, kGrey, gnuplot_string(name)));
    }
    return legend;
  }

  // Axes with room at the foot for the legend; that of cells and loci takes its own below.
  void begin(std::vector<std::string> legend, double right) {
    set_style(script_);
    legend_ = std::move(legend);
    const PicturePlane plane{x_.factor(), y_.factor(), x_.range(), y_.range()};
    if (loci_) {
      columns_ = usual_canvas().columns(kColumnsOfLong);
      draw_locus_curves(*loci_, plane, LociGround::kColours, script_, loci_drawn_);
      LabelRoom room = loci_room(plane, usual_canvas());
      room.stand_on_white();
      label_loci(*loci_, plane, request_.labels, room, script_);
    }
    legend_.insert(legend_.end(), loci_drawn_.legend.begin(), loci_drawn_.legend.end());
    const double more = kCellsHeight * legend_height(legend_.size(), columns_);
    proportion_ = kCellsHeight + more;
    Margins margins;
    margins.right = right;
    margins.bottom = (kCellsHeight * margins.bottom + more) / proportion_;
    margins.top = kCellsHeight *
                  (has_hertz_axis(plane_.x.name, x_.unit()) ? kHertzMargin : margins.top) /
                  proportion_;
    set_margins(script_, margins);
    if (!legend_.empty()) set_legend(script_, margins, columns_);
    set_parameter_axis(script_, plane_.x.name, x_.range(), x_.unit());
    y_.set_vertical(script_, tics_within(usual_canvas().height - kAround, 8));
    name_vertical_axis(script_, parameter_title(plane_.y.name), y_.unit());
  }

  // Cells, loci over them, and what else there is.
  void plot(std::vector<std::string> others) {
    const bool rectangles = request_.file.ends_with(".svg") && plane_.cells() <= kMostRectangles;
    std::vector<std::string> layers = {
        fmt::format("$cells using 1:2:3:4:5 with rgbimage {}notitle", rectangles ? "pixels " : "")};
    for (const auto* more : {&loci_drawn_.curves, &others, &legend_})
      layers.insert(layers.end(), more->begin(), more->end());
    script_.plot(layers);
  }

  void write_cells(const std::function<Colour(std::size_t)>& colour_of_cell) {
    PlotTable table;
    for (std::size_t i = 0; i < plane_.cells(); ++i) {
      const Colour colour = colour_of_cell(i);
      table.row({x_.of(plane_.x_at(i)), y_.of(plane_.y_at(i)), std::round(colour.red),
                 std::round(colour.green), std::round(colour.blue)});
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
    script_.command("set label " + title + " at screen 1-0.018*across, graph 0.5 center rotate");
    PlotTable ends;
    ends.row({x_.range().low, y_.range().low, bar_.range.low});
    ends.row({x_.range().high, y_.range().high, bar_.range.high});
    script_.data("ends", ends);
    return "$ends using 1:2:3 with points pt 7 ps 0 lc palette notitle";
  }

  const PictureRequest& request_;
  const RunInfo& info_;
  const Plane& plane_;
  const OrbitLoci* loci_;
  ShownAxis x_, y_;
  LociDrawn loci_drawn_;
  GnuplotScript script_;
  std::vector<std::string> legend_;
  std::size_t columns_ = kColumns;
  CellBar bar_;
  double proportion_ = kCellsHeight;
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

void draw_cells(const PictureRequest& request, const DrawnPlane& plane,
                const CellColours& colours) {
  CellPicture(request, plane).draw(colours);
}

void draw_cells(const PictureRequest& request, const DrawnPlane& plane,
                const CellNumbers& numbers) {
  CellPicture(request, plane).draw(numbers);
}

}  // namespace graze
