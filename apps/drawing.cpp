#include "drawing.hpp"

#include <fmt/format.h>

#include "graze/assembly/beam_shape.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/study_records.hpp"

namespace graze {
namespace {

constexpr int kShapePlaces = 201, kMovingPlaces = 41;  // along a beam

}  // namespace

Chart chart_shown(const CheckRecord& record, const Scene&, bool) {
  return mode_shapes_chart(record.scene, record.system.omega);
}

Chart chart_shown(const ModesRecord& record, const Scene& scene, bool) {
  return mode_shapes_chart(scene, record.table.omega);
}

Chart chart_shown(const SimulationRecord& record, const Scene&, bool) {
  switch (record.shown) {
    case RunPicture::kReturns:
      return returns_chart(record);
    case RunPicture::kSpectrum:
      return spectrum_chart(record);
    case RunPicture::kPsd:
      return psd_chart(record);
    case RunPicture::kShapes:
      return shapes_chart(record);
    case RunPicture::kForces:
      return forces_chart(record);
    case RunPicture::kMotion:
      break;
  }
  return record.section ? section_chart(record) : motion_chart(record);
}

void draw_page(const std::string& file, const SimulationRecord& record, const Scene& scene) {
  if (record.shown == RunPicture::kMotion && !record.section)
    write_page(file, record);
  else
    write_page(file, chart_shown(record, scene), record.info, record.outcome, record.warnings);
}

void place_beam(const CommonOptions& command, const Scene& scene, SimulationRecord& record) {
  const bool bent = record.shown == RunPicture::kShapes;
  if (bent || is_page_name(command.plot.file))
    record.beam = beam_places(scene, bent ? kShapePlaces : kMovingPlaces);
}

std::string nothing_to_draw(const ComparisonRecord& record) {
  return record.differences.empty() ? "no two motions were compared" : "";
}

std::string nothing_to_draw(const SensitivityRecord& record) {
  return record.curves.empty() ? "no value was run to its end" : "";
}

std::string nothing_to_draw(const FitRecord& record) {
  return record.result.series.empty() ? "nothing was fitted" : "";
}

void check_plot(const CommonOptions& command, const PictureFeatures& features) {
  const PictureRequest &plot = command.plot, plain;
  if (plot.empty()) return;
  check_picture_or_page_name(plot.file);
  const auto refuse = [](const char* options, const char* what) {
    throw InputError(fmt::format("{}: pictures of this result have no {}", options, what));
  };
  for (const auto& [axis, name] : {std::pair(&plot.x, "--x-range"), {&plot.y, "--y-range"}})
    if (axis->scale != AxisScale::kLinear &&
        ((axis->low && *axis->low <= 0.0) || (axis->high && *axis->high <= 0.0)))
      throw InputError(fmt::format(
          "{}: a logarithmic axis shows what is above zero; give ends above zero", name));
  const bool ranges = plot.x.low || plot.x.high || plot.y.low || plot.y.high;
  const bool scales = plot.x.scale != plain.x.scale || plot.y.scale != plain.y.scale;
  if (ranges && !features.ranges) refuse("--x-range, --y-range", "ranges to choose");
  if (scales && !features.scales) refuse("--x-scale, --y-scale", "scales to choose");
  if (plot.labels != plain.labels && !features.labels) refuse("--labels", "labels to choose");
  if (plot.multipliers && !features.multipliers) refuse("--multipliers", "branches");
  const bool asks = ranges || scales || plot.labels != plain.labels || plot.multipliers ||
                    plot.title || plot.style != plain.style || plot.size || plot.font.points ||
                    plot.font.family != plain.font.family;
  if (asks && is_page_name(plot.file))
    throw InputError(plot.file +
                     ": --title, --style, --size, --font, --labels, ranges, scales and "
                     "--multipliers are options of pictures; the web page has controls of its own");
}

}  // namespace graze
