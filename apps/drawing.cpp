#include "drawing.hpp"

#include <fmt/format.h>

#include "graze/assembly/beam_shape.hpp"
#include "graze/assembly/system_family.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/detail/comparison_record.hpp"
#include "graze/record/detail/cost_record.hpp"
#include "graze/record/detail/diagram_record.hpp"
#include "graze/record/detail/fit_record.hpp"
#include "graze/record/detail/loci_record.hpp"
#include "graze/record/detail/map_record.hpp"
#include "graze/record/detail/modes_record.hpp"
#include "graze/record/detail/run_diagram_record.hpp"
#include "graze/record/detail/sensitivity_record.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/page/detail/page.hpp"
#include "graze/report/page/detail/page_chart.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

constexpr int kShapePlaces = 201, kMovingPlaces = 41;  // along a beam

template <class Record>
void draw_charts_of(const PictureRequest& plot, const Record& record) {
  if (is_page_name(plot.file))
    write_page(plot.file, record);
  else
    draw_chart(plot, record.info, chart_of(record));
}

// One of several charts of a record.
template <class Record>
void draw_one_chart(const PictureRequest& plot, const Record& record, const Chart& chart) {
  if (is_page_name(plot.file))
    write_page(plot.file, chart, record.info, record.outcome, record.warnings);
  else
    draw_chart(plot, record.info, chart);
}

}  // namespace

void draw(const CommonOptions& command, const CheckRecord& record, const Scene&) {
  draw_one_chart(command.plot, record, mode_shapes_chart(record.scene, record.system.omega));
}

void draw(const CommonOptions& command, const ModesRecord& record, const Scene& scene) {
  draw_one_chart(command.plot, record, mode_shapes_chart(scene, record.table.omega));
}

void draw(const CommonOptions& command, const SimulationRecord& record, const Scene&) {
  const PictureRequest& plot = command.plot;
  if (record.shown == RunPicture::kReturns)
    draw_one_chart(plot, record, returns_chart(record));
  else if (record.shown == RunPicture::kSpectrum)
    draw_one_chart(plot, record, spectrum_chart(record));
  else if (record.shown == RunPicture::kShapes)
    draw_one_chart(plot, record, shapes_chart(record));
  else if (record.shown == RunPicture::kForces)
    draw_one_chart(plot, record, forces_chart(record));
  else if (record.section)
    draw_section(plot, record);
  else if (is_page_name(plot.file))
    write_page(plot.file, record);
  else
    draw_simulation(plot, record);
}

void place_beam(const CommonOptions& command, const Scene& scene, SimulationRecord& record) {
  const bool bent = record.shown == RunPicture::kShapes;
  if (bent || is_page_name(command.plot.file))
    record.beam = beam_places(scene, bent ? kShapePlaces : kMovingPlaces);
}

void draw(const CommonOptions& command, const OrbitRecord& record, const Scene&) {
  draw_charts_of(command.plot, record);
}

void draw(const CommonOptions& command, const BranchRecord& record, const Scene& scene) {
  if (is_page_name(command.plot.file))
    write_page(command.plot.file, record, SystemFamily(scene, record.traced.parameter));
  else
    draw_branches(command.plot, record);
}

void draw(const CommonOptions& command, const LociRecord& record, const Scene& scene) {
  if (is_page_name(command.plot.file))
    write_page(command.plot.file, record, scene);
  else
    draw_loci(command.plot, record);
}

void draw(const CommonOptions& command, const DiagramRecord& record, const Scene& scene) {
  if (is_page_name(command.plot.file))
    write_page(command.plot.file, record, SystemFamily(scene, record.swept.parameter));
  else
    draw_diagram(command.plot, record);
}

void draw(const CommonOptions& command, const RunDiagramRecord& record, const Scene&) {
  draw_charts_of(command.plot, record);
}

void draw(const CommonOptions& command, const MapRecord& record, const Scene& scene) {
  if (is_page_name(command.plot.file))
    write_page(command.plot.file, record, scene);
  else
    draw_map(command.plot, record);
}

void draw(const CommonOptions& command, const ComparisonRecord& record, const Scene&) {
  draw_charts_of(command.plot, record);
}

void draw(const CommonOptions& command, const ComparisonMapRecord& record, const Scene& scene) {
  if (is_page_name(command.plot.file))
    write_page(command.plot.file, record, scene);
  else
    draw_comparison(command.plot, record);
}

void draw(const CommonOptions& command, const SensitivityRecord& record, const Scene&) {
  draw_charts_of(command.plot, record);
}

void draw(const CommonOptions& command, const CostRecord& record, const Scene&) {
  draw_charts_of(command.plot, record);
}

void draw(const CommonOptions& command, const FitRecord& record, const Scene&) {
  draw_charts_of(command.plot, record);
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
    throw InputError(
        plot.file +
        ": --title, --style, --size, --font, --labels, ranges, scales and --multipliers are of "
        "pictures; a page has tools for what it shows");
}

void check_plot_of_run(const CommonOptions& command, bool has_section, RunPicture shown) {
  if (has_section && shown != RunPicture::kReturns && !command.plot.empty())
    check_picture_name(command.plot.file, ".svg, .png or .pdf with --section");
  check_plot<SimulationRecord>(command);
}

}  // namespace graze
