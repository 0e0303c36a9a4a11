#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "graze/report/chart/detail/motion_seen.hpp"
#include "graze/report/picture/detail/picture_curve.hpp"
#include "graze/report/picture/picture_style.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

constexpr double kSectionHeight = 0.75;  // over the width
constexpr int kSectionPixels = 2000;     // across a picture of 12 cm
constexpr std::size_t kSectionColumns = 3;

class SectionPicture {
 public:
  explicit SectionPicture(const SimulationRecord& record)
      : section_(*record.section), stops_(record.system.stops.size()) {
    is_of_impacts_ = section_.kind() == DiagramSection::kImpact;
    // Stops at one place see the same points.
    std::vector<int> stops;
    if (is_of_impacts_)
      for (std::size_t i = 0; i < record.system.stops.size(); ++i)
        stops.push_back(static_cast<int>(i));
    else
      for (const SeenPlace& place : places_of(record.system)) stops.push_back(place.stops[0].index);
    AxisRange across, up;
    for (const SectionPoint& point : section_.points()) {
      across.include(point.across);
      up.include(point.up);
    }
    if (is_of_impacts_) up.include(0.0);
    const Units units = record.info.units;
    x_unit_ = is_of_impacts_ ? AxisUnit{1.0, unit_in(units, "rad")}
                             : axis_unit(unit_in(units, "m"), largest(across));
    y_unit_ = axis_unit(unit_in(units, "m/s"), largest(up));
    x_ = {x_unit_.factor * across.low, x_unit_.factor * across.high};
    y_ = {y_unit_.factor * up.low, y_unit_.factor * up.high};
    x_.settle(0.05);
    y_.settle(0.05);
    for (const int stop : stops) tables_[stop];
    for (const SectionPoint& point : section_.points())
      if (const auto table = tables_.find(point.stop); table != tables_.end())
        table->second.row({x_unit_.factor * point.across, y_unit_.factor * point.up});
    std::erase_if(tables_, [](const auto& entry) { return entry.second.empty(); });
    if (tables_.size() > 1) margins_.bottom += legend_height(tables_.size(), kSectionColumns);
  }

  GnuplotScript script(bool as_pixels) const {
    GnuplotScript script;
    set_style(script);
    set_margins(script, margins_);
    script.command("set xrange " + x_.text() + "\nset yrange " + y_.text());
    script.command(
        fmt::format("set xtics {:.6g}\nset ytics {:.6g}", x_.tic_step(8), y_.tic_step(8)));
    // What one of several stops sees is said to be its own.
    const std::string towards =
        stops_ > 1 && tables_.size() == 1 ? " towards stop 1" : " towards the stop";
    script.command("set xlabel " + axis_label(is_of_impacts_ ? "forcing phase at the impact"
                                                             : "displacement" + towards,
                                              x_unit_.unit));
    name_vertical_axis(script, is_of_impacts_ ? "impact speed" : "velocity" + towards,
                       y_unit_.unit);
    if (tables_.empty())
      script.command("set label 'no point of the section' at graph 0.5, graph 0.5 center");
    std::vector<std::string> layers;
    if (as_pixels && !tables_.empty()) {
      const double dx = x_.span() / canvas_width(), dy = y_.span() / canvas_height();
      layers.push_back(
          fmt::format("pixels binary filetype=png origin=({:.12g},{:.12g}) "
                      "dx={:.12g} dy={:.12g} with rgbalpha notitle",
                      x_.low + dx / 2.0, y_.low + dy / 2.0, dx, dy));
    }
    if (!as_pixels) layers = write_dots(script, 0.16);
    if (tables_.size() > 1) {
      set_legend(script, margins_, kSectionColumns);
      for (const auto& [stop, table] : tables_)
        layers.push_back(fmt::format("NaN with points pt 7 ps 0.5 lc rgb '{}' title 'stop {}'",
                                     colour_of(stop), stop + 1));
    }
    script.plot(layers);
    return script;
  }

  // The inside of the axes.
  PixelLayer dots() const {
    PixelLayer layer;
    layer.width = canvas_width();
    layer.height = canvas_height();
    layer.script.command("unset border\nunset tics\nunset key");
    set_margins(layer.script, {0.0, 0.0, 0.0, 0.0});
    layer.script.command("set xrange " + x_.text() + "\nset yrange " + y_.text());
    // Points of size 1 are some 5 pixels wide here.
    layer.script.plot(write_dots(layer.script, 1.0));
    return layer;
  }

 private:
  // Pixels.
  int canvas_width() const {
    return static_cast<int>(kSectionPixels * (1.0 - margins_.left - margins_.right));
  }
  int canvas_height() const {
    return static_cast<int>(kSectionPixels * kSectionHeight *
                            (1.0 - margins_.top - margins_.bottom));
  }
  static const char* colour_of(int stop) {
    return curve_colours()[static_cast<std::size_t>(stop) % curve_colours().size()];
  }

  // Dots shrink as they crowd.
  std::vector<std::string> write_dots(GnuplotScript& script, double size) const {
    const double crowd = static_cast<double>(section_.points().size());
    const double part = std::clamp(std::sqrt(4000.0 / crowd), 0.35, 1.0);
    std::vector<std::string> layers;
    for (const auto& [stop, table] : tables_) {
      const std::string name = fmt::format("section{}", stop + 1);
      script.data(name, table);
      layers.push_back(fmt::format("${} with points pt 7 ps {:.3g} lc rgb '{}' notitle", name,
                                   size * part, colour_of(stop)));
    }
    return layers;
  }

  const RunSection& section_;
  std::size_t stops_;  // of the system
  bool is_of_impacts_ = true;
  AxisUnit x_unit_, y_unit_;
  AxisRange x_, y_;
  std::map<int, PlotTable> tables_;  // of the stops
  Margins margins_;
};

}  // namespace

void draw_section(const PictureRequest& request, const SimulationRecord& record) {
  const SectionPicture picture(record);
  constexpr double kWidth = 12.0;  // cm
  const Canvas canvas = canvas_of(request, record.info, kWidth * kSectionHeight);
  if (request.file.ends_with(".png"))
    return draw_picture(request, record.info, picture.script(false), canvas);
  draw_picture(request, record.info, picture.script(true), canvas, picture.dots());
}

}  // namespace graze
