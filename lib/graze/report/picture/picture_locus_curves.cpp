#include "graze/report/picture/detail/picture_locus_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "graze/report/picture/detail/gnuplot_looks.hpp"
#include "graze/report/picture/detail/label_room.hpp"
#include "graze/report/picture/picture_style.hpp"

namespace graze {
namespace {

// Of each kind its parts that are orbits of the system, and of all kinds those that are not.
struct LocusLayers {
  std::map<OrbitLocusKind, PlotTable> real;
  PlotTable not_real, special;
};

void add(const OrbitLocus& locus, double x, double y, LocusLayers& layers) {
  for (const LocusPart& part : locus_parts(locus)) {
    PlotTable& table = part.is_real ? layers.real[locus.kind] : layers.not_real;
    for (std::size_t i = part.first; i <= part.last; ++i)
      table.row({x * locus.points[i].value, y * locus.points[i].second});
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

}  // namespace

std::vector<LocusPart> locus_parts(const OrbitLocus& locus) {
  std::vector<LocusPart> parts;
  for (std::size_t i = 0; i + 1 < locus.points.size(); ++i) {
    const bool is_real = locus.points[i].admissible && locus.points[i + 1].admissible;
    if (parts.empty() || parts.back().is_real != is_real) parts.push_back({is_real, i, i});
    parts.back().last = i + 1;
  }
  return parts;
}

void draw_locus_curves(const OrbitLoci& traced, const PicturePlane& plane, LociGround ground,
                       GnuplotScript& script, LociDrawn& drawn) {
  LocusLayers layers;
  for (const OrbitLocus& locus : traced.loci) add(locus, plane.x_factor, plane.y_factor, layers);
  // Thinner as they crowd.
  const double weight = 1.3 * crowded_mark_size(traced.loci.size());
  const auto draw = [&](const std::string& name, const PlotTable& table, const Look& look) {
    if (table.empty()) return;
    script.data(name, table);
    const std::string line = line_of(look, weight);
    if (ground == LociGround::kColours)
      drawn.curves.push_back(
          fmt::format("${} using 1:2 with lines lw {:.3g} dt solid lc rgb "
                      "'#FFFFFF' notitle",
                      name, weight * look.width + 1.4));
    drawn.curves.push_back(fmt::format("${} using 1:2 {} notitle", name, line));
    drawn.legend.push_back(fmt::format("NaN {} title '{}'", line, look.title));
  };
  const std::span<const Look> looks = locus_looks();
  draw("virtual", layers.not_real, looks.back());
  for (const OrbitLocusKind kind : kOrbitLocusKinds)
    for (const Look& look : looks)
      if (look.id == label_of(kind)) draw(look.id, layers.real[kind], look);
  const std::string dots =
      mark_of(codimension_two_look(), crowded_mark_size(special_count(traced) / 4));
  if (layers.special.empty()) return;
  script.data("special", layers.special);
  drawn.curves.push_back("$special using 1:2 " + dots + " notitle");
  drawn.legend.push_back(fmt::format("NaN {} title '{}'", dots, codimension_two_look().title));
}

LabelRoom loci_room(const PicturePlane& plane, const Canvas& canvas) {
  // Beside the axes, and above and below them, cm.
  constexpr double kBeside = 2.64, kAbove = 3.6;
  return {plane, canvas.width - kBeside, std::max(canvas.height - kAbove, 1.0)};
}

void label_loci(const OrbitLoci& traced, const PicturePlane& plane, LabelChoice choice,
                LabelRoom& room, GnuplotScript& script) {
  if (choice == LabelChoice::kNone) return;
  std::vector<LabelRoom::NamedPoint> points;
  for (const OrbitLocus& locus : traced.loci) {
    for (std::size_t i = 0; i + 1 < locus.points.size(); ++i)
      room.add_line(plane.x_factor * locus.points[i].value, plane.y_factor * locus.points[i].second,
                    plane.x_factor * locus.points[i + 1].value,
                    plane.y_factor * locus.points[i + 1].second);
    for (const OrbitLocusSpecial& special : locus.special) {
      points.push_back(
          {plane.x_factor * special.at.value, plane.y_factor * special.at.second, special.id});
      room.add_mark(points.back().x, points.back().y);
    }
  }
  std::sort(points.begin(), points.end(),
            [](const auto& one, const auto& other) { return one.id < other.id; });
  room.name(script, points);
}

}  // namespace graze
