#include "graze/report/picture/detail/picture_locus_curves.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

#include "graze/report/picture/detail/special_marks.hpp"
#include "graze/report/picture/picture_style.hpp"

namespace graze {
namespace {

struct KindStyle {
  OrbitLocusKind kind;
  const char *title, *colour, *dashes;
};
constexpr std::array<KindStyle, 5> kStyles = {
    {{OrbitLocusKind::kFold, "fold (LP)", kBlue, "solid"},
     {OrbitLocusKind::kPeriodDoubling, "period doubling (PD)", kVermillion, "(10,4)"},
     {OrbitLocusKind::kTorus, "torus (NS)", kPurple, "(10,3,2,3)"},
     {OrbitLocusKind::kGrazing, "grazing (GR)", kGreen, "(2,3)"},
     {OrbitLocusKind::kChatterCompletes, "completion (CH)", kOrange, "(14,3,2,3,2,3)"}}};

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
  const bool on_colours = ground == LociGround::kColours;
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
       fmt::format("lines lw 1.0 dt solid lc rgb '{}'", on_colours ? "white" : kGrey));
  for (const KindStyle& style : kStyles) {
    const PlotTable& table = layers.real[style.kind];
    const std::string name = label_of(style.kind);
    draw(name, table, style.title,
         fmt::format("lines lw {:.3g} dt {} lc rgb '{}'", 2.4 * weight, style.dashes,
                     on_colours ? kBlack : style.colour));
    if (on_colours && !table.empty())
      drawn.curves.insert(drawn.curves.end() - 1,
                          fmt::format("${} using 1:2 with lines lw {:.3g} dt solid lc rgb 'white' "
                                      "notitle",
                                      name, 3.6 * weight));
  }
  draw("special", layers.special, "codimension two",
       fmt::format("points pt 7 ps {:.3g}*mark lc rgb '{}'",
                   0.6 * crowded_mark_size(special_count(traced) / 4), kBlack));
}

}  // namespace graze
