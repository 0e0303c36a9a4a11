#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "graze/record/detail/loci_record.hpp"
#include "graze/report/picture/detail/picture_branch_curves.hpp"
#include "graze/report/picture/detail/picture_locus_curves.hpp"
#include "graze/report/picture/detail/picture_regions.hpp"
#include "graze/report/picture/detail/special_marks.hpp"
#include "graze/report/picture/picture_style.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

constexpr double kProportion = 0.75;  // height by width, without the tints' legend
constexpr std::size_t kColumns = 2;
// More labels than this cover one another, and the curves.
constexpr std::size_t kMostLabels = 24;

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

void draw_regions(const StableRegions& regions, const PicturePlane& plane, GnuplotScript& script,
                  LociDrawn& drawn) {
  const RegionTints tints(regions, plane);
  tints.write(script);
  tints.label(script);
  drawn.curves = tints.layers();
  drawn.legend = tints.legend();
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
  const PicturePlane plane{first.factor, second.factor, x, y};
  LociPicture picture;
  GnuplotScript& script = picture.script;
  set_style(script);
  LociDrawn drawn;
  if (record.regions) draw_regions(*record.regions, plane, script, drawn);
  const std::size_t tints = drawn.legend.size();
  draw_locus_curves(traced, plane, LociGround::kPaper, script, drawn);
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
