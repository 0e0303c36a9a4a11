#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "graze/report/picture/detail/diagram_panels.hpp"
#include "graze/report/picture/detail/gnuplot_looks.hpp"
#include "graze/report/picture/detail/picture_branch_curves.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

// Heights as parts of 12 cm.
constexpr double kOnePanel = 0.75;  // of a picture with one, in all
constexpr double kPanel = 0.36,
                 kBetweenDiagramPanels = 0.05;  // of several: each, and what is between two
constexpr int kDiagramPixels = 2000;            // across a picture of 12 cm
constexpr double kDiagramWidth = 12.0;          // cm, of which the parts are
constexpr std::size_t kDiagramColumns = 2;      // of the legend: names of points are long
constexpr double kCut = 2.0;                    // of marks where an axis cuts, by dots
constexpr double kThin = 0.55;                  // of curves over dots, by those without

// One pair of axes with what is drawn in it, in the axes' units.
struct DrawnPanel {
  DrawnPanel(const DiagramPanel& of, const AxisRequest& asked, std::vector<double> heights)
      : panel(of), axis(asked, of.unit, heights, 0.05, of.from_zero), plane{1.0,   1.0,
                                                                            {},    axis.range(),
                                                                            false, axis.is_log()} {}

  const DiagramPanel& panel;
  ShownAxis axis;
  PicturePlane plane;
  std::map<std::string, PlotTable> tables;  // of dots, by look
  std::map<std::string, std::size_t> counts;
  std::vector<DiagramCurve> curves;  // of the axis
  std::optional<BranchCurves> branches;
};

std::vector<double> heights_of(const DiagramPanel& panel) {
  std::vector<double> heights;
  const auto add = [&](double height) {
    heights.push_back(std::clamp(height, panel.least, panel.most));
  };
  for (const DiagramPanel::Dot& dot : panel.dots) add(dot.height);
  for (const DiagramCurve& curve : panel.curves)
    for (const std::vector<double>& point : curve.points)
      for (const double height : point) add(height);
  return heights;
}

class DiagramPicture {
 public:
  DiagramPicture(const PictureRequest& request, const BranchRecord& record,
                 const DiagramRecord* diagram)
      : request_(request),
        record_(record),
        panels_(diagram_panels(record, diagram, request.multipliers)),
        has_dots_(diagram != nullptr),
        canvas_(canvas_of(request, record.info, kDiagramWidth * kOnePanel)),
        columns_(canvas_.columns(kDiagramColumns)),
        x_(request.x, record.unit, {record.from, record.to}, 0.0) {
    for (const DiagramPanel& panel : panels_) add(panel);
    // Pixels are evenly spaced, which a logarithmic axis is not.
    as_pixels_ = has_dots_ && !request.file.ends_with(".png") && !x_.is_log() &&
                 std::none_of(drawn_.begin(), drawn_.end(),
                              [](const DrawnPanel& panel) { return panel.axis.is_log(); });
    lay_out();
  }

  const Canvas& canvas() const { return canvas_; }
  bool as_pixels() const { return as_pixels_; }

  GnuplotScript script() {
    set_style(script_);
    for (const DrawnPanel& panel : drawn_) {
      panel.branches->write(script_);
      if (!as_pixels_) write_dots(panel, script_);
    }
    if (drawn_.size() > 1) script_.command("set multiplot");
    for (std::size_t i = 0; i < drawn_.size(); ++i) draw(i);
    if (drawn_.size() > 1) script_.command("unset multiplot");
    return script_;
  }

  // The dots alone, the insides of the axes one below the other over the whole of a canvas.
  PixelLayer dots() const {
    PixelLayer layer;
    const auto count = static_cast<double>(drawn_.size());
    layer.width = canvas_width();
    layer.height = panel_pixels() * static_cast<int>(drawn_.size());
    layer.script.command("unset border\nunset tics\nunset key");
    for (const DrawnPanel& panel : drawn_) write_dots(panel, layer.script);
    if (drawn_.size() > 1) layer.script.command("set multiplot");
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      const auto above = static_cast<double>(i);
      set_margins(layer.script, {0.0, 0.0, (count - above - 1.0) / count, above / count});
      layer.script.command("set xrange " + x_.range().text() + "\nset yrange " +
                           drawn_[i].plane.y.text());
      // Points of size 1 are some 5 pixels wide here, so a dot is 0.3 mm at most.
      layer.script.plot(dot_layers(drawn_[i], 1.0));
    }
    if (drawn_.size() > 1) layer.script.command("unset multiplot");
    return layer;
  }

 private:
  void add(const DiagramPanel& panel) {
    // What is asked of the vertical axis holds for what the picture is of.
    DrawnPanel& drawn =
        drawn_.emplace_back(panel, panel.scales ? request_.y : AxisRequest{}, heights_of(panel));
    drawn.plane.x = x_.range();
    drawn.plane.x_is_log = x_.is_log();
    drawn.plane.x_factor = x_.factor();
    for (const DiagramPanel::Dot& dot : panel.dots) {
      drawn.tables[dot.look->id].row({x_.of(dot.value), drawn.axis.of(dot.height)});
      ++drawn.counts[dot.look->id];
    }
    drawn.curves = panel.curves;
    for (DiagramCurve& curve : drawn.curves)
      for (auto* list : {&curve.points, &curve.special})
        for (std::vector<double>& point : *list)
          for (double& height : point) height = drawn.axis.of(height);
    drawn.branches.emplace(record_.traced.branches, drawn.curves, drawn.plane,
                           has_dots_ ? kThin : 1.0, data_prefix(drawn_.size()));
  }

  static std::string data_prefix(std::size_t panel) {
    return panel == 1 ? "" : fmt::format("panel{}_", panel);
  }

  void lay_out() {
    const double legend = kOnePanel * legend_height(legend_entries().size(), columns_);
    Margins margins;  // of a single panel, as parts of the width
    margins.bottom = kOnePanel * margins.bottom + legend;
    margins.top =
        kOnePanel * (has_hertz_axis(parameter(), record_.unit) ? kHertzMargin : margins.top);
    const auto count = static_cast<double>(drawn_.size());
    panel_height_ = drawn_.size() == 1 ? kOnePanel - margins.top - margins.bottom : kPanel;
    const double text = margins.top + (count - 1.0) * kBetweenDiagramPanels + margins.bottom;
    canvas_ = canvas_of(request_, record_.info, kDiagramWidth * (text + count * panel_height_));
    canvas_.laid_out = canvas_.height;
    panel_height_ =
        std::max(canvas_.height / kDiagramWidth - text, 0.3 * count * panel_height_) / count;
    height_ = text + count * panel_height_;
    margins_ = margins;
  }

  const std::string& parameter() const { return record_.traced.parameter; }
  int canvas_width() const {
    return static_cast<int>(kDiagramPixels * (1.0 - margins_.left - margins_.right));
  }
  int panel_pixels() const { return static_cast<int>(kDiagramPixels * panel_height_); }

  void draw(std::size_t i) {
    const DrawnPanel& panel = drawn_[i];
    const bool last = i + 1 == drawn_.size();
    const double top =
        margins_.top + static_cast<double>(i) * (panel_height_ + kBetweenDiagramPanels);
    Margins margins = margins_;
    margins.top = top / height_;
    margins.bottom = 1.0 - (top + panel_height_) / height_;
    script_.command("unset label\nunset arrow\nunset key");
    set_margins(script_, margins);
    if (last) set_legend(script_, margins, columns_);
    set_parameter_axis(script_, parameter(), x_.range(), x_.unit(),
                       {.below = last, .above = i == 0}, x_.is_log());
    panel.axis.set_vertical(script_,
                            tics_within(kDiagramWidth * panel_height_, drawn_.size() > 1 ? 5 : 8));
    name_axis(panel);
    if (panel.panel.level)
      script_.command(fmt::format(
          "set arrow from graph 0, first {0:.9g} to graph 1, first {0:.9g} nohead back lw 0.5 lc "
          "rgb '{1}'",
          panel.axis.of(*panel.panel.level), kGrey));
    if (panel.panel.dots.empty() && panel.curves.empty())
      script_.command(fmt::format("set label '{}' at graph 0.5, graph 0.5 center",
                                  has_dots_ ? "no impacts" : "no branch was found"));
    if (!panel.curves.empty()) label(panel);
    std::vector<std::string> layers = sweep_layers(i);
    for (const std::string& layer : panel.branches->layers()) layers.push_back(layer);
    if (last)
      for (const std::string& entry : legend_entries()) layers.push_back(entry);
    script_.plot(layers);
  }

  // In a low panel over two lines, which take the room beside them.
  void name_axis(const DrawnPanel& panel) {
    constexpr double kLetter = 0.18;  // cm
    const auto letters = static_cast<std::size_t>(kDiagramWidth * panel_height_ / kLetter);
    const std::string name =
        in_two_lines(panel.panel.name, std::min<std::size_t>(drawn_.size() > 1 ? 17 : 30, letters));
    const bool breaks = name.find('\n') != std::string::npos;
    name_vertical_axis(script_, name, panel.axis.unit(), breaks ? 0.015 : 0.03);
  }

  void label(const DrawnPanel& panel) {
    LabelRoom room(panel.plane, canvas_.width - kDiagramWidth * (margins_.left + margins_.right),
                   kDiagramWidth * panel_height_);
    for (const DiagramPanel::Dot& dot : panel.panel.dots)
      room.add_dot(x_.of(dot.value), panel.axis.of(dot.height));
    panel.branches->label(script_, room, panel.panel.scales ? request_.labels : LabelChoice::kNone);
  }

  std::vector<std::string> sweep_layers(std::size_t i) const {
    const DrawnPanel& panel = drawn_[i];
    if (!as_pixels_) return dot_layers(panel, 0.16);
    if (panel.panel.dots.empty()) return {};
    // The whole canvas, placed so that this panel's part lies over the axes, which cut off the
    // rest.
    const auto below = static_cast<double>(drawn_.size() - 1 - i);
    const double dx = panel.plane.x.span() / canvas_width(),
                 dy = panel.plane.y.span() / panel_pixels();
    return {
        fmt::format("pixels binary filetype=png origin=({:.12g},{:.12g}) "
                    "dx={:.12g} dy={:.12g} with rgbalpha",
                    panel.plane.x.low + dx / 2.0,
                    panel.plane.y.low + dy / 2.0 - below * panel.plane.y.span(), dx, dy)};
  }

  std::string data_name(const DrawnPanel& panel, const std::string& look) const {
    const auto at = std::find_if(drawn_.begin(), drawn_.end(),
                                 [&](const DrawnPanel& any) { return &any == &panel; });
    return fmt::format("panel{}_{}", at - drawn_.begin() + 1, look);
  }

  void write_dots(const DrawnPanel& panel, GnuplotScript& script) const {
    for (const auto& [look, table] : panel.tables) script.data(data_name(panel, look), table);
  }

  // In the order of the looks' drawing: periodic motions lie over others, the largest exponents
  // over lower ones. Motions that never repeat fill areas: their dots shrink as they crowd.
  std::vector<std::string> dot_layers(const DrawnPanel& panel, double size) const {
    std::vector<std::string> layers;
    for (const char* id : {"cut", "lower", "wild", "largest", "periodic"}) {
      if (!panel.tables.contains(id)) continue;
      const double crowd = static_cast<double>(panel.counts.at(id));
      const double part =
          id == std::string("wild") ? std::clamp(std::sqrt(4000.0 / crowd), 0.5, 1.0) : 1.0;
      const bool is_cut = id == std::string("cut");
      layers.push_back(fmt::format("${} with points pt {} ps {:.3g} lc rgb '{}'",
                                   data_name(panel, id), point_type(dot_look(id)),
                                   size * (is_cut ? kCut : part), dot_look(id).colour));
    }
    return layers;
  }

  // Every panel shows the same rows and the same branches; each thing stands once.
  std::vector<std::string> legend_entries() const {
    std::vector<std::string> entries;
    for (const Look& look : dot_looks())
      if (std::any_of(drawn_.begin(), drawn_.end(),
                      [&](const DrawnPanel& any) { return any.tables.contains(look.id); }))
        entries.push_back(fmt::format("NaN with points pt {} ps 0.35 lc rgb '{}' title '{}'",
                                      point_type(look), look.colour, look.title));
    if (!drawn_.empty())
      for (const std::string& entry : drawn_.front().branches->legend()) entries.push_back(entry);
    return entries;
  }

  const PictureRequest& request_;
  const BranchRecord& record_;
  std::vector<DiagramPanel> panels_;
  bool has_dots_, as_pixels_ = false;
  Canvas canvas_;
  std::size_t columns_;  // of the legend
  ShownAxis x_;
  std::deque<DrawnPanel> drawn_;  // their places do not change
  Margins margins_;               // of the picture, as parts of 12 cm
  double panel_height_ = 0.0, height_ = 0.0;
  GnuplotScript script_;
};

}  // namespace

void draw_branches(const PictureRequest& request, const BranchRecord& record) {
  DiagramPicture picture(request, record, nullptr);
  const GnuplotScript script = picture.script();
  draw_picture(request, record.info, script, picture.canvas());
}

void draw_diagram(const PictureRequest& request, const DiagramRecord& record) {
  DiagramPicture picture(request, record.branches, &record);
  const GnuplotScript script = picture.script();
  const RunInfo& info = record.branches.info;
  if (!picture.as_pixels()) return draw_picture(request, info, script, picture.canvas());
  draw_picture(request, info, script, picture.canvas(), picture.dots());
}

}  // namespace graze
