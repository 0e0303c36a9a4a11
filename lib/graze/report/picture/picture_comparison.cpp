#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "graze/report/names/detail/comparison_names.hpp"
#include "graze/report/names/detail/sweep_names.hpp"
#include "graze/report/picture/detail/picture_cells.hpp"
#include "graze/report/picture/detail/picture_column.hpp"
#include "graze/report/picture/detail/picture_motion.hpp"
#include "graze/report/picture/detail/picture_stops.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

// Names of settings are no markup.
std::string plain(const std::string& name) {
  std::string result;
  for (const char letter : name)
    result += letter == '_' || letter == '^' ? std::string("\\") + letter : std::string(1, letter);
  return result;
}

// The motions at the first stop, over one time axis.
class MotionsPicture {
 public:
  explicit MotionsPicture(const ComparisonRecord& record) : record_(record), column_(script_) {
    AxisRange displacement, velocity;
    for (const SimulationRecord& run : record.runs) {
      seen_.push_back(motion_seen(run));
      time_.include(seen_.back().window.start);
      time_.include(seen_.back().window.end);
      for (const MotionPoint& point : seen_.back().places.front().motion) {
        displacement.include(point.displacement);
        velocity.include(point.velocity);
      }
    }
    length_ = axis_unit("m", largest(displacement));
    speed_ = axis_unit("m/s", largest(velocity));
  }

  GnuplotScript script() {
    set_style(script_);
    column_.lay_out({1.4 * PanelColumn::kPanel, 1.4 * PanelColumn::kPanel}, false, true, false);
    script_.command("set multiplot");
    const AxisUnit time = axis_unit("s", time_.high);
    column_.set_time_axis({time.factor * time_.low, time.factor * time_.high}, time.unit);
    draw("displacement\ntowards the stop", length_, &MotionPoint::displacement, time, true);
    draw("velocity\ntowards the stop", speed_, &MotionPoint::velocity, time, false);
    script_.command("unset multiplot");
    return script_;
  }
  double proportion() const { return column_.proportion(); }

 private:
  void draw(const std::string& name, const AxisUnit& unit, double MotionPoint::*part,
            const AxisUnit& time, bool has_stop) {
    AxisRange range;
    std::vector<DrawnCurve> curves;
    for (const MotionSeen& seen : seen_) {
      DrawnCurve& curve = curves.emplace_back();
      for (const MotionPoint& point : seen.places.front().motion)
        curve.push_back({point.time, point.*part});
      const AxisRange own = range_of(curve);
      range.include({unit.factor * own.low, unit.factor * own.high});
    }
    const StopMarks stops(seen_.front().places.front().stops, range, unit, false);
    if (has_stop) {
      stops.include(range);
      for (const SeenStop& stop : seen_.back().places.front().stops)
        if (std::abs(unit.factor * stop.place) <= 1.5 * largest(range))
          range.include(unit.factor * stop.place);
    }
    range.settle(0.08);
    column_.begin_panel(range, name, unit.unit);
    column_.draw_zero_line();
    std::vector<std::string> layers;
    if (has_stop) {
      name_motions();
      stops.draw(script_, range, column_.label_line(), layers);
      draw_stops_of_other(unit);
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const std::string data = fmt::format("{}{}", has_stop ? "displacement" : "velocity", i + 1);
      script_.data(data, table_of(curves[i], time.factor, unit.factor));
      layers.push_back(fmt::format("${} with lines lw 1.4 {} lc rgb '{}' notitle", data,
                                   i == 0 ? "" : "dt (8,4)", i == 0 ? kBlue : kVermillion));
    }
    column_.end_panel(layers);
  }

  // Above the panel at its ends, in the colours of their lines: gnuplot's own legend misjudges how
  // wide such names are.
  void name_motions() {
    const double above = 1.0 + 0.8 * column_.label_line();
    const auto name = [&](int end, const char* side, const std::string& text, const char* colour) {
      script_.command(fmt::format("set label {} at graph {}, graph {:.4g} {} textcolor rgb '{}'",
                                  gnuplot_string(text), end, above, side, colour));
    };
    name(0, "left", "━━━ " + plain(record_.names[0]), kBlue);
    name(1, "right", "╍╍╍ " + plain(record_.names[1]), kVermillion);
  }

  // Where they are not those of the first motion: lines, dashed as it is.
  void draw_stops_of_other(const AxisUnit& unit) {
    const std::vector<SeenStop>& own = seen_.front().places.front().stops;
    for (const SeenStop& stop : seen_.back().places.front().stops)
      if (std::none_of(own.begin(), own.end(),
                       [&](const SeenStop& one) { return one.place == stop.place; }))
        script_.command(
            fmt::format("set arrow from graph 0, first {0:.9g} to graph 1, first "
                        "{0:.9g} nohead lw 1.6 dt (8,4) lc rgb '{1}'",
                        unit.factor * stop.place, kVermillion));
  }

  const ComparisonRecord& record_;
  std::vector<MotionSeen> seen_;
  GnuplotScript script_;
  PanelColumn column_;
  AxisRange time_;  // s
  AxisUnit length_, speed_;
};

struct QuantityStyle {
  ComparedQuantity quantity;
  const char* colour;
  int mark;  // of gnuplot
};
constexpr QuantityStyle kStyles[] = {
    {ComparedQuantity::kFirstTime, kBlue, 7},     {ComparedQuantity::kFirstSpeed, kSky, 6},
    {ComparedQuantity::kDisplacement, kGreen, 9}, {ComparedQuantity::kVelocity, kOrange, 13},
    {ComparedQuantity::kEnergy, kVermillion, 5},  {ComparedQuantity::kTaken, kPurple, 11}};

// Sizes of the differences from N modes to the next number of them.
GnuplotScript modes_script(const ComparisonRecord& record) {
  GnuplotScript script;
  set_style(script);
  AxisRange across, up;
  std::vector<std::string> layers;
  for (const QuantityStyle& style : kStyles) {
    PlotTable table;
    for (std::size_t i = 0; i < record.differences.size(); ++i) {
      const double size = std::abs(compared_value(record.differences[i], style.quantity));
      across.include(record.modes[i]);
      // What is exactly alike has no place on the axis.
      if (!(size > 0.0)) continue;
      up.include(std::log10(size));
      table.row({static_cast<double>(record.modes[i]), size});
    }
    const std::string data = name_of(style.quantity);
    if (table.empty()) continue;
    script.data(data, table);
    layers.push_back(fmt::format("${} with linespoints lw 1.2 pt {} ps mark lc rgb '{}' title {}",
                                 data, style.mark, style.colour,
                                 gnuplot_string(title_of(style.quantity))));
  }
  Margins margins;
  margins.bottom += legend_height(layers.size(), 1);
  set_margins(script, margins);
  set_legend(script, margins, 1);
  across.settle(0.05);
  up.settle(0.0);
  script.command("set logscale y\nset format y '10^{%L}'");
  script.command("set xrange " + across.text());
  script.command(fmt::format("set yrange [{:g}:{:g}]", std::pow(10.0, std::floor(up.low)),
                             std::pow(10.0, std::ceil(up.high))));
  script.command(fmt::format("set xtics {:g}", std::max(1.0, across.tic_step(10))));
  script.command("set xlabel 'number of modes N, compared with the next'");
  name_vertical_axis(script, "size of the difference", "");
  script.plot(layers);
  return script;
}

// What both settle on; where they differ it shows.
CellColours agreement_colours(const ComparisonMap& map) {
  std::map<std::string, std::size_t> counts;
  std::map<std::string, std::string> colours;
  for (const ComparedCell& cell : map.cells) {
    if (!cell.is_known) continue;
    const std::string name = cell_name(cell);
    ++counts[name];
    if (!is_comparable(cell))
      colours[name] = kNoCell;
    else if (!cell.difference.is_same_attractor)
      colours[name] = kVermillion;
    else if (cell.one.status == SweepStatus::kNotPeriodic)
      colours[name] = kWildCell;
  }
  std::vector<std::pair<std::string, std::size_t>> order(counts.begin(), counts.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  // The last one is that of a difference.
  constexpr std::size_t kOrbits = std::size(kOrbitCells) - 1;
  CellColours result;
  std::size_t orbits = 0;
  bool others = false;
  for (const auto& [name, count] : order) {
    const bool named = colours.contains(name) || orbits < kOrbits;
    if (!colours.contains(name)) colours[name] = named ? kOrbitCells[orbits++] : kOtherCell;
    if (named) result.legend.emplace_back(name, colours[name]);
    others = others || !named;
  }
  if (others) result.legend.emplace_back("both another orbit", kOtherCell);
  result.of = [&map, colours](std::size_t i) {
    const ComparedCell& cell = map.cells[i];
    return cell.is_known ? colour_of(colours.at(cell_name(cell))) : Colour{};
  };
  return result;
}

}  // namespace

void draw_comparison(const std::string& file, const ComparisonRecord& record) {
  if (!record.modes.empty()) {
    draw_picture(file, modes_script(record), 0.95);
    return;
  }
  MotionsPicture picture(record);
  const GnuplotScript script = picture.script();
  draw_picture(file, script, picture.proportion());
}

void draw_comparison(const std::string& file, const ComparisonMapRecord& record) {
  const ComparisonMap& map = record.map;
  if (record.shown == ComparedQuantity::kAttractor) {
    draw_cells(file, {map.options, record.x_unit, record.y_unit}, agreement_colours(map));
    return;
  }
  CellNumbers numbers;
  numbers.of = [&](std::size_t i) {
    const ComparedCell& cell = map.cells[i];
    return is_comparable(cell) ? compared_value(cell.difference, record.shown) : std::nan("");
  };
  numbers.is_known = [&](std::size_t i) { return map.cells[i].is_known; };
  numbers.title = gnuplot_string(title_of(record.shown));
  if (is_signed(record.shown)) numbers.scale = CellScale::kSigned;
  draw_cells(file, {map.options, record.x_unit, record.y_unit}, numbers);
}

}  // namespace graze
