#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "graze/report/picture/detail/picture_branch_curves.hpp"
#include "graze/report/picture/detail/picture_motion.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

// Heights as parts of the picture's width.
constexpr double kOnePanel = 0.75;                // of a picture with one, in all
constexpr double kPanel = 0.36, kBetween = 0.05;  // of several: each, and what is between two
constexpr int kPixels = 2000;                     // across a picture of 12 cm
constexpr std::size_t kColumns = 2;
constexpr std::size_t kMostPanels = 4;
constexpr double kDeepest = 2.0;      // exponents shown below zero, by those above
constexpr double kLineWeight = 0.55;  // thinner than without the dots under the curves

// In the order in which they are drawn.
enum Dot : std::size_t { kLower, kWild, kPeriodic, kDots };
struct DotStyle {
  const char *name, *title, *colour;
};
constexpr std::array<DotStyle, kDots> kDotStyles = {{{"lower", "other exponents", kOrange},
                                                     {"wild", "sweep: not periodic", kGrey},
                                                     {"periodic", "sweep: periodic", kBlack}}};

struct DotAt {
  double x, y;
  Dot kind;
};

Dot kind_of(const SweepRow& row) {
  return row.status == SweepStatus::kNotPeriodic ? kWild : kPeriodic;
}

// One pair of axes: all impacts, or the displacement at one place.
struct Panel {
  std::string name;  // of the vertical axis
  std::vector<DotAt> dots;
  AxisUnit unit;
  AxisRange y;
  std::array<PlotTable, kDots> tables;
  std::optional<BranchCurves> branches;
  bool of_exponents = false;
};

bool is_shown(const SweepRow& row) {
  return row.status == SweepStatus::kNotPeriodic || row.motion.period > 0;
}

// The motion's dots: speeds of impacts, or displacements where `stop` is.
std::vector<DotAt> dots_of(const DiagramRecord& record, int stop) {
  std::vector<DotAt> dots;
  for (const SweepRow& row : record.swept.rows) {
    if (!is_shown(row)) continue;
    const Dot kind = kind_of(row);
    if (record.branches.shown) {
      if (const std::optional<double> height = shown_height(record.branches, row))
        dots.push_back({row.value, *height, kind});
      continue;
    }
    if (record.section == DiagramSection::kImpact)
      for (const MetImpact& impact : row.motion.impacts)
        dots.push_back({row.value, impact.speed, kind});
    else
      for (const SweepRow::StopState& state : row.stop_states)
        if (state.stop == stop) dots.push_back({row.value, state.displacement, kind});
  }
  return dots;
}

// None for minus infinity.
std::vector<DotAt> exponent_dots(const DiagramRecord& record) {
  std::vector<DotAt> dots;
  for (const SweepRow& row : record.swept.rows)
    for (Eigen::Index j = 0; row.exponents && j < row.exponents->values.size(); ++j)
      if (std::isfinite(row.exponents->values[j]))
        dots.push_back({row.value, row.exponents->values[j], j > 0 ? kLower : kind_of(row)});
  return dots;
}

class DiagramPicture {
 public:
  DiagramPicture(const DiagramRecord& record, bool as_pixels)
      : record_(record), as_pixels_(as_pixels) {
    const BranchRecord& branches = record.branches;
    x_unit_ = axis_unit(branches.unit, std::max(std::abs(branches.from), std::abs(branches.to)));
    x_.include(x_unit_.factor * branches.from);
    x_.include(x_unit_.factor * branches.to);
    x_.settle(0.0);
    if (branches.shown) {
      add_panel(shown_title(*branches.shown, branches.amplitudes.places),
                shown_unit(*branches.shown, branches.amplitudes.places), 0);
    } else if (record.section == DiagramSection::kImpact) {
      add_panel("impact speed", "m/s", 0);
    } else {
      const std::vector<SeenPlace> places = places_of(branches.system);
      for (const SeenPlace& place : places)
        if (panels_.size() < kMostPanels)
          add_panel(branches.system.stops.size() == 1 ? "displacement\ntowards the stop"
                                                      : fmt::format("displacement\ntowards stop {}",
                                                                    place.stops.front().index + 1),
                    "m", place.stops.front().index);
    }
    if (record.swept.options.exponent_periods > 0) add_exponents();
    lay_out();
  }

  double proportion() const { return height_; }

  GnuplotScript script() {
    set_style(script_);
    for (const Panel& panel : panels_) {
      panel.branches->write(script_);
      if (!as_pixels_) write_dots(panel, script_);
    }
    if (panels_.size() > 1) script_.command("set multiplot");
    for (std::size_t i = 0; i < panels_.size(); ++i) draw(i);
    if (panels_.size() > 1) script_.command("unset multiplot");
    return script_;
  }

  // The dots alone, the insides of the axes one below the other over the whole of a canvas.
  PixelLayer dots() const {
    PixelLayer layer;
    const auto count = static_cast<double>(panels_.size());
    layer.width = static_cast<int>(kPixels * (1.0 - margins_.left - margins_.right));
    layer.height = panel_pixels() * static_cast<int>(panels_.size());
    layer.script.command("unset border\nunset tics\nunset key");
    for (const Panel& panel : panels_) write_dots(panel, layer.script);
    if (panels_.size() > 1) layer.script.command("set multiplot");
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      const auto above = static_cast<double>(i);
      set_margins(layer.script, {0.0, 0.0, (count - above - 1.0) / count, above / count});
      layer.script.command("set xrange " + x_.text() + "\nset yrange " + panels_[i].y.text());
      // Points of size 1 are some 5 pixels wide here, so a dot is 0.3 mm at most.
      layer.script.plot(dot_layers(panels_[i], 1.0));
    }
    if (panels_.size() > 1) layer.script.command("unset multiplot");
    return layer;
  }

 private:
  // The axes span what the sweep and the branches reach.
  void add_panel(const std::string& name, const std::string& unit, int stop) {
    static const std::vector<DiagramCurve> kNone;
    const std::vector<DiagramCurve>& curves =
        record_.curves.empty() ? kNone : record_.curves[static_cast<std::size_t>(stop)];
    Panel panel{name, dots_of(record_, stop), {}, {}, {}, {}};
    AxisRange y;
    for (const DotAt& dot : panel.dots) y.include(dot.y);
    for (const DiagramCurve& curve : curves)
      for (const std::vector<double>& heights : curve.points)
        for (const double height : heights) y.include(height);
    if (record_.section == DiagramSection::kImpact || y.empty()) y.include(0.0);
    panel.unit = axis_unit(unit, std::max(std::abs(y.low), std::abs(y.high)));
    panel.y = {panel.unit.factor * y.low, panel.unit.factor * y.high};
    panel.y.settle(0.05);
    for (const DotAt& dot : panel.dots)
      panel.tables[dot.kind].row({x_unit_.factor * dot.x, panel.unit.factor * dot.y});
    panel.branches.emplace(
        curves.empty() ? std::vector<OrbitBranch>() : record_.branches.traced.branches, curves,
        PicturePlane{x_unit_.factor, panel.unit.factor, x_, panel.y}, kLineWeight,
        fmt::format("panel{}_", panels_.size() + 1));
    panels_.push_back(std::move(panel));
  }

  void add_exponents() {
    Panel panel{"Lyapunov\nexponents", exponent_dots(record_), {}, {}, {}, {}, true};
    AxisRange y;
    y.include(0.0);
    // Superstable orbits reach down without bound, and so do all other exponents; what
    // tells order from chaos lies about zero.
    for (const DotAt& dot : panel.dots)
      if (dot.kind != kLower) y.include(dot.y);
    if (y.high > 0.0) y.low = std::max(y.low, -kDeepest * y.high);
    panel.unit = {1.0, "1/s"};
    panel.y = y;
    panel.y.settle(0.05);
    for (const DotAt& dot : panel.dots) panel.tables[dot.kind].row({x_unit_.factor * dot.x, dot.y});
    panel.branches.emplace(std::vector<OrbitBranch>(), std::vector<DiagramCurve>(),
                           PicturePlane{x_unit_.factor, 1.0, x_, panel.y}, kLineWeight,
                           fmt::format("panel{}_", panels_.size() + 1));
    panels_.push_back(std::move(panel));
  }

  void lay_out() {
    margins_.bottom += legend_height(legend().size(), kColumns);
    if (has_hertz_axis(parameter())) margins_.top = kHertzMargin;
    if (panels_.size() > 1) margins_.left += 0.01;  // their names take two lines
    const double around = kOnePanel * (margins_.top + margins_.bottom);
    const auto count = static_cast<double>(panels_.size());
    panel_height_ = panels_.size() == 1 ? kOnePanel - around : kPanel;
    height_ = around + count * panel_height_ + (count - 1.0) * kBetween;
  }

  const std::string& parameter() const { return record_.branches.traced.parameter; }
  int panel_pixels() const { return static_cast<int>(kPixels * panel_height_); }

  void draw(std::size_t i) {
    const Panel& panel = panels_[i];
    const bool last = i + 1 == panels_.size();
    const double top =
        kOnePanel * margins_.top + static_cast<double>(i) * (panel_height_ + kBetween);
    Margins margins = margins_;
    margins.top = top / height_;
    margins.bottom = 1.0 - (top + panel_height_) / height_;
    script_.command("unset label\nunset key");
    set_margins(script_, margins);
    if (last) set_legend(script_, margins, kColumns);
    set_parameter_axis(script_, parameter(), x_, x_unit_.unit, {.below = last, .above = i == 0});
    script_.command("set yrange " + panel.y.text());
    script_.command(fmt::format("set ytics {:.6g}", panel.y.tic_step(panels_.size() > 1 ? 5 : 8)));
    // Two lines take the room beside them.
    name_vertical_axis(script_, panel.name, panel.unit.unit,
                       panel.name.find('\n') != std::string::npos ? 0.015 : 0.03);
    if (panel.of_exponents)
      script_.command(fmt::format(
          "set arrow 1 from graph 0, first 0 to graph 1, first 0 nohead back lw 0.5 lc rgb '{}'",
          kGrey));
    if (panel.dots.empty() && record_.curves.empty() && !panel.of_exponents)
      script_.command("set label 'no impacts' at graph 0.5, graph 0.5 center");
    std::vector<std::string> layers = sweep_layers(i);
    for (const std::string& layer : panel.branches->layers()) layers.push_back(layer);
    if (last)
      for (const std::string& entry : legend()) layers.push_back(entry);
    script_.plot(layers);
  }

  std::vector<std::string> sweep_layers(std::size_t i) const {
    const Panel& panel = panels_[i];
    if (!as_pixels_) return dot_layers(panel, 0.16);
    if (panel.dots.empty()) return {};
    // The whole canvas, placed so that this panel's part lies over the axes, which cut off the
    // rest.
    const PixelLayer layer = dots();
    const double dx = x_.span() / layer.width, dy = panel.y.span() / panel_pixels();
    const auto below = static_cast<double>(panels_.size() - 1 - i);
    return {
        fmt::format("pixels binary filetype=png origin=({:.12g},{:.12g}) "
                    "dx={:.12g} dy={:.12g} with rgbalpha",
                    x_.low + dx / 2.0, panel.y.low + dy / 2.0 - below * panel.y.span(), dx, dy)};
  }

  std::string data_name(const Panel& panel, std::size_t kind) const {
    return fmt::format("panel{}_{}", &panel - panels_.data() + 1, kDotStyles[kind].name);
  }

  void write_dots(const Panel& panel, GnuplotScript& script) const {
    for (std::size_t k = 0; k < kDots; ++k)
      if (!panel.tables[k].empty()) script.data(data_name(panel, k), panel.tables[k]);
  }

  // Motions that never repeat fill areas: their dots shrink as they crowd.
  static double dot_size(const Panel& panel, std::size_t kind) {
    if (kind != kWild) return 1.0;
    const auto crowd = std::count_if(panel.dots.begin(), panel.dots.end(),
                                     [](auto& dot) { return dot.kind == kWild; });
    return std::clamp(std::sqrt(4000.0 / static_cast<double>(crowd)), 0.5, 1.0);
  }

  std::vector<std::string> dot_layers(const Panel& panel, double size) const {
    std::vector<std::string> layers;
    for (std::size_t k = 0; k < kDots; ++k)
      if (!panel.tables[k].empty())
        layers.push_back(fmt::format("${} with points pt 7 ps {:.3g} lc rgb '{}'",
                                     data_name(panel, k), size * dot_size(panel, k),
                                     kDotStyles[k].colour));
    return layers;
  }

  // Every panel shows the same rows, and all but that of the exponents the same branches.
  std::vector<std::string> legend() const {
    const Panel& panel = panels_.front();
    std::vector<std::string> entries;
    for (std::size_t k = kDots; k-- > 0;)
      if (std::any_of(panels_.begin(), panels_.end(),
                      [&](const Panel& any) { return !any.tables[k].empty(); }))
        entries.push_back(fmt::format("NaN with points pt 7 ps 0.35 lc rgb '{}' title '{}'",
                                      kDotStyles[k].colour, kDotStyles[k].title));
    for (const std::string& entry : panel.branches->legend()) entries.push_back(entry);
    return entries;
  }

  const DiagramRecord& record_;
  bool as_pixels_;
  AxisUnit x_unit_;
  AxisRange x_;
  std::vector<Panel> panels_;
  Margins margins_;
  double panel_height_ = 0.0, height_ = 0.0;
  GnuplotScript script_;
};

}  // namespace

void draw_diagram(const std::string& file, const DiagramRecord& record) {
  const bool as_pixels = !file.ends_with(".png");
  DiagramPicture picture(record, as_pixels);
  const GnuplotScript script = picture.script();
  if (!as_pixels) return draw_picture(file, script, picture.proportion());
  draw_picture(file, script, picture.proportion(), picture.dots());
}

}  // namespace graze
