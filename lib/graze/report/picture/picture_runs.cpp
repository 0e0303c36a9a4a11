#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/assembly/probes.hpp"
#include "graze/record/detail/run_diagram_record.hpp"
#include "graze/report/picture/detail/picture_column.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostStops = 3, kMostProbes = 3;

class RunDiagramPicture {
 public:
  explicit RunDiagramPicture(const RunDiagramRecord& record) : record_(record), column_(script_) {
    stops_ = std::min(record.stops, kMostStops);
    probes_ = std::min(record.probes.size(), kMostProbes);
  }

  GnuplotScript script() {
    set_style(script_);
    std::vector<double> heights(stops_, 2.0 * PanelColumn::kPanel);
    heights.resize(stops_ + probes_, 1.2 * PanelColumn::kPanel);
    column_.lay_out(heights, false, stops_ > 0, false);
    script_.command("set multiplot");
    AxisRange range;
    range.include(record_.from);
    range.include(record_.to);
    along_ = column_.set_parameter_axis(record_.parameter, record_.unit, range, 0.0);
    for (std::size_t i = 0; i < stops_; ++i) draw_impacts(static_cast<int>(i));
    for (std::size_t i = 0; i < probes_; ++i) draw_peaks(i);
    script_.command("unset multiplot");
    return script_;
  }
  double proportion() const { return column_.proportion(); }

 private:
  void draw_impacts(int stop) {
    AxisRange range;
    range.include(0.0);
    for (const ValueRun& run : record_.runs)
      for (const RunImpact& impact : run.impacts)
        if (impact.stop == stop) range.include(impact.speed);
    const AxisUnit unit = axis_unit("m/s", range.high);
    PlotTable first, later;
    for (const ValueRun& run : record_.runs)
      for (const RunImpact& impact : run.impacts)
        if (impact.stop == stop)
          (&impact == run.impacts.data() ? first : later)
              .row({along_ * run.value, unit.factor * impact.speed});
    range = {unit.factor * range.low, unit.factor * range.high};
    range.settle(0.05);
    const bool legend = stop == 0;
    std::vector<std::string> layers;
    const auto add = [&](const PlotTable& table, const char* name, const char* colour) {
      const std::string data = fmt::format("{}_{}", name, stop + 1);
      if (!table.empty()) {
        script_.data(data, table);
        layers.push_back(
            fmt::format("${} with points pt 7 ps 0.22 lc rgb '{}' notitle", data, colour));
      }
      if (legend)
        layers.push_back(fmt::format("NaN with points pt 7 ps 0.5 lc rgb '{}' title '{} impact{}'",
                                     colour, name, name == std::string("first") ? "" : "s"));
    };
    column_.begin_panel(
        range, stops_ == 1 ? "impact speed" : fmt::format("impact speed\nat stop {}", stop + 1),
        unit.unit);
    add(later, "later", kOrange);
    add(first, "first", kBlue);
    if (first.empty() && later.empty())
      script_.command("set label 'no impacts' at graph 0.5, graph 0.5 center");
    if (legend) column_.set_legend();
    column_.end_panel(layers);
  }

  void draw_peaks(std::size_t probe) {
    AxisRange range;
    range.include(0.0);
    for (const ValueRun& run : record_.runs) range.include(run.peaks[probe]);
    const ProbeQuantity quantity = record_.probes[probe].quantity;
    const AxisUnit unit = axis_unit(probe_unit(quantity), range.high);
    PlotTable table;
    for (const ValueRun& run : record_.runs)
      table.row({along_ * run.value, unit.factor * run.peaks[probe]});
    range = {unit.factor * range.low, unit.factor * range.high};
    range.settle(0.05);
    const std::string data = fmt::format("peak_{}", probe + 1);
    script_.data(data, table);
    column_.begin_panel(range, fmt::format("largest\n|{}|", probe_quantity_name(quantity)),
                        unit.unit);
    column_.end_panel({fmt::format("${} with lines lw 1.5 lc rgb '{}' notitle", data, kBlack)});
  }

  const RunDiagramRecord& record_;
  GnuplotScript script_;
  PanelColumn column_;
  std::size_t stops_ = 0, probes_ = 0;
  double along_ = 1.0;  // factor of the horizontal axis
};

}  // namespace

void draw_run_diagram(const std::string& file, const RunDiagramRecord& record) {
  RunDiagramPicture picture(record);
  const GnuplotScript script = picture.script();
  draw_picture(file, script, picture.proportion());
}

}  // namespace graze
