#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "graze/report/chart/chart.hpp"
#include "graze/report/picture/detail/chart_layers.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

// Centimetres of a Canvas.
constexpr double kSheet = 12.0;  // of which margins are parts
constexpr double kLowest = 0.3;  // of the height of axes, where there is too little room
constexpr double kUsual = 9.0;   // height of a picture
constexpr double kHigh = 5.0;    // of a panel that has room for more tics
constexpr double kLeft = 2.56, kRight = 0.48, kRightOfBar = 2.76;
constexpr double kHead = 0.36, kHertz = 1.55;    // above the axes, and with an axis in Hz
constexpr double kAxisText = 1.55;               // tics and name of a horizontal axis
constexpr double kBetween = 0.4, kBeside = 1.3;  // two panels
constexpr double kNamed = 2.6;                   // the same where both name their vertical axis
constexpr double kLetter = 0.18;                 // of the name of an axis
constexpr double kNameLine = 0.45;               // of the name of a horizontal axis
constexpr double kHeading = 0.42;                // a line above a panel
constexpr double kLegendLine = 0.37;             // of a legend at the foot
constexpr double kEdge = 0.02;                   // beside it, part of the sheet
constexpr double kMarkSpacing = 1.25;            // of its lines, relative, where they have marks
// Letters of a legend's entry: of longer entries gnuplot puts no two in a line; many short ones are
// three in a line.
constexpr std::size_t kLong = 24, kShort = 14, kMany = 4;
constexpr double kDot = 0.16;  // of gnuplot's points, of one that is seen among a million
constexpr int kPixels = 2000;  // of dots, across a picture of 12 cm

class ChartPicture {
 public:
  ChartPicture(const PictureRequest& request, const RunInfo& info, const Chart& chart)
      : request_(request),
        chart_(chart),
        axes_(axes_of(chart, request)),
        canvas_(canvas_of(request, info, kUsual)) {
    for (const std::vector<ChartPanel>& row : chart.rows)
      for (const ChartPanel& panel : row)
        if (panel.cells && !panel.cells->numbers.empty()) right_ = kRightOfBar;
    gather_legend();
    lay_out(info);
    lay_out_dots();
  }

  const Canvas& canvas() const { return canvas_; }
  bool has_pixels() const { return !bands_.empty(); }

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

  // The dots alone: the insides of the axes above each other over a whole canvas.
  PixelLayer dots() const {
    PixelLayer layer;
    layer.width = band_width_;
    layer.height = band_height_;
    layer.script.command("unset border\nunset tics\nunset key\nset multiplot");
    const auto part = [](int pixels, int of) {
      return static_cast<double>(pixels) / static_cast<double>(of);
    };
    for (const Band& band : bands_) {
      set_margins(layer.script, {.left = 0.0,
                                 .right = 1.0 - part(band.width, layer.width),
                                 .bottom = part(band.below, layer.height),
                                 .top = 1.0 - part(band.below + band.height, layer.height)});
      layer.script.command("set xrange " + band.axes->x.range().text() + "\nset yrange " +
                           band.axes->y.range().text());
      // Points of size 1 are some 5 pixels wide here, so a dot is 0.3 mm at most.
      layer.script.plot(dot_layers(*band.axes, 1.0, layer.script));
    }
    layer.script.command("unset multiplot");
    return layer;
  }

 private:
  // A panel's part of the canvas of dots, pixels from the bottom.
  struct Band {
    const PanelAxes* axes;
    int width, height, below;
  };

  void gather_legend() {
    // Sorted by their place in the chart's own order, then in order of appearance.
    std::map<std::pair<std::size_t, std::size_t>, std::string> entries;
    std::set<std::string> known;
    std::size_t longest = 0;
    const auto add = [&](const std::string& title, const std::string& entry) {
      if (title.empty() || !known.insert(title).second) return;
      const auto at = std::find(chart_.legend.begin(), chart_.legend.end(), title);
      const auto place = at == chart_.legend.end() ? 0 : 1 + (at - chart_.legend.begin());
      entries[{static_cast<std::size_t>(place), entries.size()}] = entry;
      longest = std::max(longest, title.size());
    };
    for (const std::vector<ChartPanel>& row : chart_.rows)
      for (const ChartPanel& panel : row) {
        if (panel.cells)
          for (std::size_t i = 0; i < panel.cells->grounds.size(); ++i)
            if (std::find(panel.cells->ground.begin(), panel.cells->ground.end(),
                          static_cast<int>(i)) != panel.cells->ground.end())
              add(panel.cells->grounds[i].title, legend_entry(panel.cells->grounds[i]));
        for (const ChartSeries& series : panel.series) {
          if (!series.title.empty() && !series.are_dots && (series.has_marks || !series.is_line))
            spacing_ = kMarkSpacing;
          add(series.title, legend_entry(series));
        }
        for (const ChartFill& fill : panel.fills)
          add(fill.title, fmt::format("NaN with boxes fs solid noborder lc rgb '{}' title {}",
                                      fill.colour, gnuplot_string(fill.title)));
      }
    for (const auto& [place, entry] : entries) legend_.push_back(entry);
    if (longest > kLong) columns_ = 1;
    if (longest <= kShort && entries.size() > kMany) columns_ = 3;
    columns_ = std::min(canvas_.columns(columns_), std::max<std::size_t>(entries.size(), 1));
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

  // Horizontal position of a panel in its row.
  struct Across {
    double left, width, beside;
  };
  Across across(std::size_t row, std::size_t i) const {
    const std::vector<ChartPanel>& panels = chart_.rows[row];
    const auto count = static_cast<double>(panels.size());
    const double beside = count > 1.0 && is_alike(panels[i].y, panels[1 - i].y) ? kBeside : kNamed;
    const double width = (canvas_.width - kLeft - right_ - (count - 1.0) * beside) / count;
    return {kLeft + static_cast<double>(i) * (width + beside), width, beside};
  }

  // In two lines where it would overlap the name beside it.
  std::string horizontal_name(std::size_t row, std::size_t i) const {
    const ChartAxis& axis = chart_.rows[row][i].x;
    if (chart_.rows[row].size() == 1) return axis.name;
    const Across place = across(row, i);
    return in_two_lines(axis.name,
                        letters_within(place.width + std::min(place.beside, kBeside), axis.unit));
  }

  // Height of tics and names below a row.
  double axis_text(std::size_t row) const {
    for (std::size_t i = 0; i < chart_.rows[row].size(); ++i)
      if (horizontal_name(row, i).find('\n') != std::string::npos) return kAxisText + kNameLine;
    return kAxisText;
  }

  // Distance from the bottom of the panels above to the top of these.
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

  // Number of letters that a name may have beside its unit along this length, cm.
  static std::size_t letters_within(double length, const std::string& unit) {
    const auto letters = static_cast<std::size_t>(length / kLetter);
    return letters - std::min(letters, unit.empty() ? 0 : unit.size() + 3);
  }

  // Finds the dots of every panel, if they are drawn as pixels. A picture with a shape for each
  // would be megabytes large; but pixels are evenly spaced, which does not suit a logarithmic axis.
  void lay_out_dots() {
    const bool fit = std::none_of(axes_.begin(), axes_.end(), [](const PanelAxes& axes) {
      return axes.has_dots() && (axes.x.is_log() || axes.y.is_log());
    });
    if (request_.file.ends_with(".png") || !fit) return;
    std::size_t k = axes_.size();
    for (std::size_t row = chart_.rows.size(); row-- > 0;)
      for (std::size_t i = chart_.rows[row].size(); i-- > 0;) {
        const PanelAxes& axes = axes_[--k];
        if (!axes.has_dots()) continue;
        const auto pixels = [](double length) {
          return std::max(1, static_cast<int>(kPixels * length / kSheet));
        };
        bands_.push_back({&axes, pixels(across(row, i).width),
                          pixels(stretch_ * axes.panel->height), band_height_});
        band_height_ += bands_.back().height;
        band_width_ = std::max(band_width_, bands_.back().width);
      }
  }

  void draw(std::size_t row, std::size_t i, double top) {
    const std::vector<ChartPanel>& panels = chart_.rows[row];
    const ChartPanel& panel = panels[i];
    const PanelAxes& axes = axes_[drawn_++];
    const ShownAxis &x = axes.x, &y = axes.y;
    const auto [left, width, beside] = across(row, i);
    script_.command("unset label\nunset arrow\nunset object\nunset key");
    const double height = stretch_ * panel.height;
    set_margins(script_, {.left = left / kSheet,
                          .right = (canvas_.width - left - width) / kSheet,
                          .bottom = 1.0 - (top + height) / total_,
                          .top = top / total_});
    set_horizontal(x, row, i);
    y.set_vertical(script_,
                   tics_within(height < kHigh ? 1.6 * height : height, height < 2.0     ? 3
                                                                       : height < kHigh ? 6
                                                                                        : 8));
    if (i == 0 || !is_alike(panel.y, panels[i - 1].y)) {
      const std::string name = in_two_lines(panel.y.name, letters_within(height, y.unit()));
      const double from_axis = name.find('\n') == std::string::npos ? 1.9 : 2.34;
      name_vertical_axis(script_, name, y.unit(), (left - from_axis) / kSheet);
    }
    draw_ground(panel, x, y);
    const bool is_svg = request_.file.ends_with(".svg");
    std::vector<std::string> layers = cell_layers(axes, is_svg, script_);
    const auto add = [&](const std::vector<std::string>& more) {
      layers.insert(layers.end(), more.begin(), more.end());
    };
    write_names(axes, width, height, request_.labels, script_);
    add(has_pixels() ? pixel_layers(axes) : dot_layers(axes, kDot, script_));
    add(curve_layers(axes, script_));
    script_.plot(layers);
  }

  // The whole canvas, placed so that this panel's part lies over the axes, which cut off the rest.
  std::vector<std::string> pixel_layers(const PanelAxes& axes) const {
    for (const Band& band : bands_) {
      if (band.axes != &axes) continue;
      const double dx = axes.x.range().span() / band.width,
                   dy = axes.y.range().span() / band.height;
      return {fmt::format(
          "pixels binary filetype=png origin=({:.12g},{:.12g}) dx={:.12g} "
          "dy={:.12g} with rgbalpha",
          axes.x.range().low + 0.5 * dx, axes.y.range().low + (0.5 - band.below) * dy, dx, dy)};
    }
    return {};
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

  // In invisible axes of its own as wide as the picture: gnuplot makes no legend wider than its
  // axes. It underestimates the width of letters, so every title gets three more.
  void draw_legend() {
    if (legend_.empty()) return;
    script_.command(
        "unset label\nunset arrow\nunset object\nunset border\nunset tics\nunset x2tics\nunset "
        "colorbox");
    script_.command(
        "unset xlabel\nunset x2label\nunset logscale\nset xrange [0:1]\nset yrange [0:1]");
    set_margins(script_, {.left = kEdge, .right = kEdge, .bottom = 0, .top = 0});
    script_.command(fmt::format(
        "set key at screen {:.4g}, screen {:.4g}*body center bottom horizontal maxcols "
        "{} width 3 Left reverse samplen 2 spacing {:.4g}*legend_line font small",
        0.5 * (canvas_.width + kLeft - right_) / canvas_.width, 0.08 / total_, columns_, spacing_));
    script_.plot(legend_);
  }

  const PictureRequest& request_;
  const Chart& chart_;
  std::vector<PanelAxes> axes_;  // of all panels
  Canvas canvas_;
  GnuplotScript script_;
  std::vector<std::string> legend_;
  std::size_t columns_ = 2;
  double right_ = kRight;
  std::size_t drawn_ = 0;
  std::vector<Band> bands_;
  int band_width_ = 0, band_height_ = 0;
  double total_ = 0.0, stretch_ = 1.0, spacing_ = 1.0;
};

}  // namespace

void draw_chart(const PictureRequest& request, const RunInfo& info, const Chart& chart) {
  ChartPicture picture(request, info, chart);
  const GnuplotScript script = picture.script();
  if (!picture.has_pixels()) return draw_picture(request, info, script, picture.canvas());
  draw_picture(request, info, script, picture.canvas(), picture.dots());
}

}  // namespace graze
