#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "graze/report/picture_branch_curves.hpp"
#include "graze/report/picture_regions.hpp"
#include "graze/report/picture_style.hpp"
#include "graze/report/pictures.hpp"
#include "graze/report/special_marks.hpp"

namespace graze {
namespace {

constexpr double kProportion = 0.75;  // height by width, without the tints' legend
constexpr std::size_t kColumns = 2;
// More labels than this cover one another, and the curves.
constexpr std::size_t kMostLabels = 24;

struct KindStyle {
  OrbitLocusKind kind;
  const char *title, *colour, *dashes;
};
constexpr std::array<KindStyle, 4> kStyles = {
    {{OrbitLocusKind::kFold, "fold (LP)", kBlue, "solid"},
     {OrbitLocusKind::kPeriodDoubling, "period doubling (PD)", kVermillion, "(10,4)"},
     {OrbitLocusKind::kTorus, "torus (NS)", kPurple, "(10,3,2,3)"},
     {OrbitLocusKind::kGrazing, "grazing (GR)", kGreen, "(2,3)"}}};

// Of each kind its parts that are orbits of the system, and of all kinds those that are not.
struct LocusLayers {
  std::map<OrbitLocusKind, PlotTable> real;
  PlotTable not_real, special;
};

void add(const OrbitLocus& locus, double x, double y, LocusLayers& layers) {
  PlotTable& real = layers.real[locus.kind];
  // Where the verdict changes both parts have the point.
  for (std::size_t i = 0; i + 1 < locus.points.size(); ++i) {
    const OrbitLocusPoint &a = locus.points[i], &b = locus.points[i + 1];
    PlotTable& table = a.admissible && b.admissible ? real : layers.not_real;
    table.row({x * a.value, y * a.second});
    table.row({x * b.value, y * b.second});
    const bool last = i + 2 == locus.points.size();
    if (last || (locus.points[i + 2].admissible && b.admissible) != (a.admissible && b.admissible))
      table.gap();
  }
  for (const OrbitLocusSpecial& special : locus.special)
    layers.special.row({x * special.at.value, y * special.at.second});
}

std::size_t special_count(const OrbitLoci& traced) {
  std::size_t count = 0;
  for (const OrbitLocus& locus : traced.loci) count += locus.special.size();
  return count;
}

// What stands at one place in the plane is named in one label.
void label_special_points(GnuplotScript& script, const OrbitLoci& traced,
                          const PicturePlane& plane) {
  constexpr double kOnePlace = 1e-3;  // of the axes
  struct Label {
    double x = 0.0, y = 0.0;
    std::set<std::string> names;
  };
  std::vector<Label> labels;
  for (const OrbitLocus& locus : traced.loci)
    for (const OrbitLocusSpecial& special : locus.special) {
      const double x = plane.x_factor * special.at.value, y = plane.y_factor * special.at.second;
      auto same = std::find_if(labels.begin(), labels.end(), [&](const Label& label) {
        return std::hypot((label.x - x) / plane.x.span(), (label.y - y) / plane.y.span()) <=
               kOnePlace;
      });
      if (same == labels.end()) same = labels.insert(labels.end(), {x, y, {}});
      same->names.insert(special.label);
    }
  if (labels.size() > kMostLabels) return;
  for (const Label& label : labels)
    script.command(fmt::format("set label {} at {:.9g}, {:.9g} left offset 0.6, 0.5 front",
                               gnuplot_string(fmt::format("{}", fmt::join(label.names, ", "))),
                               label.x, label.y));
}

// What is drawn, in its order, and what the legend says of it.
struct Drawn {
  std::vector<std::string> curves, legend;
};

void draw_regions(const StableRegions& regions, const PicturePlane& plane, GnuplotScript& script,
                  Drawn& drawn) {
  const RegionTints tints(regions, plane);
  tints.write(script);
  tints.label(script);
  drawn.curves = tints.layers();
  drawn.legend = tints.legend();
}

void draw_curves(const OrbitLoci& traced, LocusLayers& layers, GnuplotScript& script,
                 Drawn& drawn) {
  // Thinner as they crowd.
  const double weight = crowded_mark_size(traced.loci.size());
  const auto draw = [&](const std::string& name, const PlotTable& table, const char* title,
                        const std::string& how) {
    if (table.empty()) return;
    script.data(name, table);
    drawn.curves.push_back(fmt::format("${} using 1:2 with {} notitle", name, how));
    drawn.legend.push_back(fmt::format("NaN with {} title '{}'", how, title));
  };
  draw("virtual", layers.not_real, "virtual",
       fmt::format("lines lw 1.0 dt solid lc rgb '{}'", kGrey));
  for (const KindStyle& style : kStyles)
    draw(
        label_of(style.kind), layers.real[style.kind], style.title,
        fmt::format("lines lw {:.3g} dt {} lc rgb '{}'", 2.4 * weight, style.dashes, style.colour));
  draw("special", layers.special, "codimension two",
       fmt::format("points pt 7 ps {:.3g}*mark lc rgb '{}'",
                   0.6 * crowded_mark_size(special_count(traced) / 4), kBlack));
}

struct LociPicture {
  GnuplotScript script;
  double proportion = kProportion;
};

LociPicture loci_picture(const LociRecord& record) {
  const OrbitLoci& traced = record.traced;
  const AxisUnit first =
      axis_unit(record.unit, std::max(std::abs(record.from), std::abs(record.to)));
  const AxisUnit second = axis_unit(
      record.second_unit, std::max(std::abs(record.second_from), std::abs(record.second_to)));
  AxisRange x, y;
  x.include(first.factor * record.from);
  x.include(first.factor * record.to);
  x.settle(0.0);
  y.include(second.factor * record.second_from);
  y.include(second.factor * record.second_to);
  y.settle(0.0);
  LocusLayers layers;
  for (const OrbitLocus& locus : traced.loci) add(locus, first.factor, second.factor, layers);
  const PicturePlane plane{first.factor, second.factor, x, y};
  LociPicture picture;
  GnuplotScript& script = picture.script;
  set_style(script);
  Drawn drawn;
  if (record.regions) draw_regions(*record.regions, plane, script, drawn);
  const std::size_t tints = drawn.legend.size();
  draw_curves(traced, layers, script, drawn);
  label_special_points(script, traced, plane);
  Margins margins;
  margins.bottom += legend_height(drawn.legend.size(), kColumns);
  if (has_hertz_axis(traced.first)) margins.top = kHertzMargin;
  // The legend of the tints takes its room below, not from the axes.
  const double more = legend_height(drawn.legend.size(), kColumns) -
                      legend_height(drawn.legend.size() - tints, kColumns);
  picture.proportion *= 1.0 + more;
  margins.bottom /= 1.0 + more;
  margins.top /= 1.0 + more;
  set_margins(script, margins);
  set_legend(script, margins, kColumns);
  set_parameter_axis(script, traced.first, x, first.unit);
  script.command("set yrange " + y.text());
  script.command(fmt::format("set ytics {:.6g}", y.tic_step(8)));
  name_vertical_axis(script, parameter_title(traced.second), second.unit);
  if (traced.loci.empty() && !record.regions)
    script.command("set label 'no locus was found' at graph 0.5, graph 0.5 center");
  drawn.curves.insert(drawn.curves.end(), drawn.legend.begin(), drawn.legend.end());
  script.plot(drawn.curves);
  return picture;
}

}  // namespace

void draw_loci(const std::string& file, const LociRecord& record) {
  const LociPicture picture = loci_picture(record);
  draw_picture(file, picture.script, picture.proportion);
}

}  // namespace graze
