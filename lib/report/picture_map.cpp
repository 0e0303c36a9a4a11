#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

#include "graze/report/map_names.hpp"
#include "graze/report/picture_style.hpp"
#include "graze/report/pictures.hpp"

namespace graze {
namespace {

struct Colour {
  double red = 255.0, green = 255.0, blue = 255.0;  // 0..255
};

Colour colour_of(const std::string& hex) {
  const long code = std::strtol(hex.c_str() + 1, nullptr, 16);
  return {static_cast<double>(code >> 16 & 255), static_cast<double>(code >> 8 & 255),
          static_cast<double>(code & 255)};
}

// Attractors that repeat, by their cells; what never does is dark, what has no motion pale.
constexpr std::array kOrbits = {kSky, kOrange, kGreen, kPurple, kBlue, "#F0E442", kVermillion};
constexpr const char* kWild = "#444444";
constexpr const char* kOther = "#BBBBBB";
constexpr const char* kNoStart = "#EEEEEE";
constexpr std::size_t kColumns = 3;  // of the legend
constexpr double kOnePanel = 0.75;   // height of the picture without its legend, over its width

// Colours of equal steps in lightness, dark to bright (after M. Kuhn's and N. Smith's viridis), and
// two hues away from zero.
constexpr std::array kScale = {"#440154", "#3B528B", "#21918C", "#5EC962", "#FDE725"};
constexpr std::array kAboutZero = {"#2166AC", "#92C5DE", "#F7F7F7", "#F4A582", "#B2182B"};

class MapPicture {
 public:
  explicit MapPicture(const MapRecord& record) : record_(record) {
    const MapAxis &x = record.map.options.x, &y = record.map.options.y;
    x_unit_ = axis_unit(record.x_unit, std::max(std::abs(x.from), std::abs(x.to)));
    y_unit_ = axis_unit(record.y_unit, std::max(std::abs(y.from), std::abs(y.to)));
    x_ = range_of(x, x_unit_.factor);
    y_ = range_of(y, y_unit_.factor);
    is_of_attractors_ = record.shown == MapQuantity::kAttractor;
    if (is_of_attractors_) choose_colours();
    if (!is_of_attractors_) find_range();
  }

  double proportion() const { return height_; }

  GnuplotScript script() {
    set_style(script_);
    Margins margins;
    const std::string& parameter = record_.map.options.x.name;
    if (has_hertz_axis(parameter)) margins.top = kHertzMargin;
    if (is_of_attractors_) margins.bottom += legend_height(legend_.size(), kColumns);
    if (!is_of_attractors_) margins.right = 0.2;
    height_ = kOnePanel;
    set_margins(script_, margins);
    set_parameter_axis(script_, parameter, x_, x_unit_.unit);
    script_.command("set yrange " + y_.text());
    script_.command(fmt::format("set ytics {:.6g}", y_.tic_step(8)));
    name_vertical_axis(script_, parameter_title(record_.map.options.y.name), y_unit_.unit);
    write_cells();
    std::vector<std::string> layers = {"$cells using 1:2:3:4:5 with rgbimage"};
    if (is_of_attractors_) {
      set_legend(script_, margins, kColumns);
      for (const auto& [name, colour] : legend_)
        layers.push_back(
            fmt::format("NaN with points pt 5 ps 1.1 lc rgb '{}' title '{}'", colour, name));
    } else {
      layers.push_back(colour_bar());
    }
    script_.plot(layers);
    return script_;
  }

 private:
  // Cells reach half their width beyond the values at their middles.
  static AxisRange range_of(const MapAxis& axis, double factor) {
    const double half = 0.5 * std::abs(axis.to - axis.from) / (axis.points - 1);
    AxisRange range;
    range.include(factor * (std::min(axis.from, axis.to) - half));
    range.include(factor * (std::max(axis.from, axis.to) + half));
    return range;
  }

  void choose_colours() {
    const AttractorMap& map = record_.map;
    std::size_t orbits = 0;
    bool others = false;
    for (std::size_t i = 0; i < map.attractors.size(); ++i) {
      const bool wild = map.attractors[i].attractor.status == SweepStatus::kNotPeriodic;
      const bool named = wild || orbits < kOrbits.size();
      colours_.emplace_back(wild ? kWild : named ? kOrbits[orbits++] : kOther);
      if (named) legend_.emplace_back(attractor_name(map, i), colours_.back());
      others = others || !named;
    }
    if (others) legend_.emplace_back("other orbits", kOther);
    std::set<std::string> rest;
    for (const MapCell& cell : map.cells)
      if (cell.place < 0 && cell.is_known) rest.insert(cell_name(map, cell));
    for (const std::string& name : rest)
      legend_.emplace_back(name, name == "no start" ? kNoStart : kOther);
  }

  void find_range() {
    for (const MapCell& cell : record_.map.cells) shown_.include(cell_value(cell, record_.shown));
    const bool zero =
        record_.shown == MapQuantity::kExponent && shown_.low < 0.0 && shown_.high > 0.0;
    if (record_.shown != MapQuantity::kExponent) shown_.include(0.0);
    // Orbits may attract without bound; what tells order from chaos lies about zero.
    if (zero) shown_.low = -shown_.high;
    shown_.settle(0.0);
    scale_ = zero ? kAboutZero : kScale;
  }

  Colour colour_at(const MapCell& cell) const {
    if (is_of_attractors_) {
      if (cell.place >= 0) return colour_of(colours_[static_cast<std::size_t>(cell.place)]);
      if (!cell.is_known) return {};
      return colour_of(cell.attractor.status == SweepStatus::kNoStart ? kNoStart : kOther);
    }
    const double value = cell_value(cell, record_.shown);
    if (std::isnan(value)) return cell.is_known ? colour_of(kNoStart) : Colour{};
    const double place = std::clamp((value - shown_.low) / shown_.span(), 0.0, 1.0) *
                         static_cast<double>(scale_.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), scale_.size() - 2);
    const double part = place - static_cast<double>(below);
    const Colour a = colour_of(scale_[below]), b = colour_of(scale_[below + 1]);
    return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green),
            a.blue + part * (b.blue - a.blue)};
  }

  void write_cells() {
    const AttractorMap& map = record_.map;
    PlotTable table;
    for (int row = 0; row < map.options.y.points; ++row)
      for (int column = 0; column < map.options.x.points; ++column) {
        const Colour colour = colour_at(map.at(column, row));
        table.row({x_unit_.factor * map.options.x.value(column),
                   y_unit_.factor * map.options.y.value(row), std::round(colour.red),
                   std::round(colour.green), std::round(colour.blue)});
      }
    script_.data("cells", table);
  }

  // The bar beside the axes comes with a layer that has a palette: two dots without a size.
  std::string colour_bar() {
    std::string palette;
    for (std::size_t i = 0; i < scale_.size(); ++i)
      palette += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, scale_[i]);
    script_.command("set palette defined (" + palette + ")");
    script_.command("set cbrange " + shown_.text());
    script_.command(fmt::format("set cbtics {:.6g}", shown_.tic_step(6)));
    script_.command("set cblabel " + bar_title() + " offset 1.5");
    PlotTable ends;
    ends.row({x_.low, y_.low, shown_.low});
    ends.row({x_.high, y_.high, shown_.high});
    script_.data("ends", ends);
    return "$ends using 1:2:3 with points pt 7 ps 0 lc palette";
  }

  std::string bar_title() const {
    switch (record_.shown) {
      case MapQuantity::kAttractor:
        break;
      case MapQuantity::kImpacts:
        return gnuplot_string("impacts a forcing period");
      case MapQuantity::kExponent:
        return axis_label("largest exponent", "1/s");
      case MapQuantity::kSpeed:
        return axis_label("speed of the fastest impact", "m/s");
      case MapQuantity::kStuck:
        return gnuplot_string("part of the time at rest on a stop");
    }
    return gnuplot_string("");
  }

  const MapRecord& record_;
  GnuplotScript script_;
  AxisUnit x_unit_, y_unit_;
  AxisRange x_, y_, shown_;
  bool is_of_attractors_ = true;
  std::vector<std::string> colours_;                         // of the attractors
  std::vector<std::pair<std::string, std::string>> legend_;  // name, colour
  std::array<const char*, 5> scale_ = kScale;
  double height_ = kOnePanel;
};

}  // namespace

void draw_map(const std::string& file, const MapRecord& record) {
  MapPicture picture(record);
  const GnuplotScript script = picture.script();
  draw_picture(file, script, picture.proportion());
}

}  // namespace graze
