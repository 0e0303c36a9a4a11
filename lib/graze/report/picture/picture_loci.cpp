#include "graze/record/detail/loci_record.hpp"
#include "graze/report/picture/detail/picture_locus_curves.hpp"
#include "graze/report/picture/detail/picture_regions.hpp"
#include "graze/report/picture/picture_style.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

constexpr double kProportion = 0.75;  // height by width, without the tints' legend
constexpr double kLociWidth = 12.0;   // cm, of which it is a part
constexpr double kAroundLoci = 3.6;   // cm above and below the axes
constexpr std::size_t kLociColumns = 2;

void draw_regions(const StableRegions& regions, const PicturePlane& plane, LabelRoom& room,
                  GnuplotScript& script, LociDrawn& drawn) {
  const RegionTints tints(regions, plane);
  tints.write(script);
  tints.label(script, room);
  drawn.curves = tints.layers();
  drawn.legend = tints.legend();
}

struct LociPicture {
  GnuplotScript script;
  double proportion = kProportion;
};

LociPicture loci_picture(const PictureRequest& request, const LociRecord& record) {
  const OrbitLoci& traced = record.traced;
  const ShownAxis first(request.x, record.unit, {record.from, record.to}, 0.0);
  const ShownAxis second(request.y, record.second_unit, {record.second_from, record.second_to},
                         0.0);
  const PicturePlane plane{first.factor(), second.factor(), first.range(),
                           second.range(), first.is_log(),  second.is_log()};
  LociPicture picture;
  GnuplotScript& script = picture.script;
  set_style(script);
  LociDrawn drawn;
  const Canvas canvas = canvas_of(request, record.info, kLociWidth * kProportion);
  const std::size_t columns = canvas.columns(kLociColumns);
  LabelRoom room = loci_room(plane, canvas);
  PicturePlane whole = plane;  // what the regions are of, whatever part of it is shown
  whole.x = {}, whole.y = {};
  for (const double end : {record.from, record.to}) whole.x.include(first.of(end));
  for (const double end : {record.second_from, record.second_to}) whole.y.include(second.of(end));
  if (record.regions) draw_regions(*record.regions, whole, room, script, drawn);
  draw_locus_curves(traced, plane, record.regions ? LociGround::kColours : LociGround::kPaper,
                    script, drawn);
  label_loci(traced, plane, request.labels, room, script);
  // The legend takes its room below, not from the axes.
  const double legend = kProportion * legend_height(drawn.legend.size(), columns);
  picture.proportion = kProportion + legend;
  Margins margins;
  margins.bottom = (kProportion * margins.bottom + legend) / picture.proportion;
  margins.top = kProportion *
                (has_hertz_axis(traced.first, record.unit) ? kHertzMargin : margins.top) /
                picture.proportion;
  set_margins(script, margins);
  set_legend(script, margins, columns);
  set_parameter_axis(script, traced.first, first.range(), first.unit(), {}, first.is_log());
  second.set_vertical(script, tics_within(canvas.height - kAroundLoci, 8));
  name_vertical_axis(script, parameter_title(traced.second), second.unit());
  if (traced.loci.empty() && !record.regions)
    script.command("set label 'no locus was found' at graph 0.5, graph 0.5 center");
  drawn.curves.insert(drawn.curves.end(), drawn.legend.begin(), drawn.legend.end());
  script.plot(drawn.curves);
  return picture;
}

}  // namespace

void draw_loci(const PictureRequest& request, const LociRecord& record) {
  const LociPicture picture = loci_picture(request, record);
  draw_picture(request, record.info, picture.script,
               canvas_of(request, record.info, kLociWidth * picture.proportion));
}

}  // namespace graze
