#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/report/picture/detail/picture_branch_curves.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

constexpr std::size_t kColumns = 2;  // of the legend: the names of special points are long

GnuplotScript branches_script(const BranchRecord& record) {
  const OrbitBranches& traced = record.traced;
  const std::vector<DiagramCurve> curves =
      record.shown ? amplitude_curves(record) : impact_curves(traced);
  const std::string unit =
      record.shown ? shown_unit(*record.shown, record.amplitudes.places) : "m/s";
  AxisRange speeds;
  speeds.include(0.0);
  for (const DiagramCurve& curve : curves)
    for (const std::vector<double>& heights : curve.points)
      for (const double height : heights) speeds.include(height);
  const AxisUnit parameter =
      axis_unit(record.unit, std::max(std::abs(record.from), std::abs(record.to)));
  const AxisUnit speed = axis_unit(unit, std::max(speeds.high, -speeds.low));
  PicturePlane plane{parameter.factor, speed.factor, {}, {}};
  plane.x.include(parameter.factor * record.from);
  plane.x.include(parameter.factor * record.to);
  plane.x.settle(0.0);
  plane.y = {speed.factor * speeds.low, speed.factor * speeds.high};
  if (!(plane.y.span() > 0.0)) plane.y.high = 1.0;
  const BranchCurves branches(traced.branches, curves, plane, 1.0);
  GnuplotScript script;
  set_style(script);
  branches.write(script);
  AxisRange y = plane.y;
  const double room = 0.06 * y.span();
  y.high += room;
  if (y.low < 0.0 || branches.marks(SpecialKind::kGrazing) ||
      branches.marks(SpecialKind::kLiftOff)) {
    y.low -= room;
    script.command(
        fmt::format("set arrow from graph 0, first 0 to graph 1, first 0 nohead back "
                    "lw 0.5 lc rgb '{}'",
                    kGrey));
  }
  const std::vector<std::string> legend = branches.legend();
  Margins margins;
  margins.bottom += legend_height(legend.size(), kColumns);
  if (has_hertz_axis(traced.parameter)) margins.top = kHertzMargin;
  set_margins(script, margins);
  set_legend(script, margins, kColumns);
  set_parameter_axis(script, traced.parameter, plane.x, parameter.unit);
  script.command("set yrange " + y.text());
  script.command(fmt::format("set ytics {:.6g}", y.tic_step(8)));
  name_vertical_axis(
      script, record.shown ? shown_title(*record.shown, record.amplitudes.places) : "impact speed",
      speed.unit);
  if (traced.branches.empty())
    script.command("set label 'no branch was found' at graph 0.5, graph 0.5 center");
  std::vector<std::string> layers = branches.layers();
  layers.insert(layers.end(), legend.begin(), legend.end());
  script.plot(layers);
  return script;
}

}  // namespace

void draw_branches(const std::string& file, const BranchRecord& record) {
  draw_picture(file, branches_script(record));
}

}  // namespace graze
