// graze map: what the motion settles on over a plane of two parameters or two coordinates of its
// start.
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/base/errors.hpp"
#include "graze/report/csv.hpp"
#include "graze/report/json.hpp"
#include "graze/report/map_names.hpp"
#include "graze/report/page.hpp"
#include "graze/report/pictures.hpp"
#include "graze/report/text.hpp"
#include "graze/study/step_choice.hpp"
#include "journals.hpp"
#include "plane_options.hpp"
#include "search_options.hpp"
#include "session.hpp"
#include "settling_options.hpp"

namespace graze {
namespace {

AttractorMapOptions map_options(const Command& command) {
  AttractorMapOptions options;
  static_cast<Plane&>(options) = plane_of(command, command.first_points, command.second_points);
  set_settling(command, options);
  options.threads = command.threads;
  options.stop = stop_signal(command);
  return options;
}

MapQuantity shown(const Command& command) {
  for (const MapQuantity quantity : kMapQuantities)
    if (name_of(quantity) == command.show) return quantity;
  return MapQuantity::kAttractor;
}

// What makes a difference to the cells.
void note_cells(const AttractorMapOptions& options, RunInfo& info) {
  note_plane(options, info);
  note_settling(options, info);
}

}  // namespace

int run_map(const Command& command) {
  if (!command.plot.empty()) check_picture_or_page_name(command.plot);
  check_journal_options(command);
  if (command.show == "exponent" && command.exponents == 0)
    throw InputError(
        "--show exponent: give --exponents K, the periods that they are averaged over");
  const Scene scene = scene_of(command);
  require_exact_flow(scene, "maps are drawn");
  require_forcing_and_stop(scene);
  AttractorMapOptions options = map_options(command);
  if (is_page_name(command.plot)) check_map_page(command.plot, options);
  MapRecord record;
  record.info = run_info(command.name, command.scene, scene);
  record.x_unit = axis_unit_of(scene, options.x.name);
  record.y_unit = axis_unit_of(scene, options.y.name);
  record.shown = shown(command);
  note_cells(options, record.info);
  record.warnings = system_warnings(scene, assemble(scene));
  warn(command, record.warnings);
  prepare_output(command);
  note_call(command, record.info);
  const auto cells = static_cast<int>(options.cells());
  std::optional<Journal> journal =
      journal_of(command, {record.info, "cell", options.cells(), 1, {}, {}});
  options.memory = memory_in<SettledCell>(journal);
  options.share = command.share;
  options.progress = progress_line(command, cells, "cells");
  record.map = map_attractors(scene, options);
  options.progress = nullptr;
  if (!command.share.is_all()) return conclude_share(command, *journal, record.map.stopped);
  record.info.options.emplace_back("show", command.show);
  record.info.options.emplace_back("max_seconds", command.max_seconds);
  record.outcome = map_outcome(record.map);
  return conclude(command, record.info, record.outcome,
                  {to_json(record),
                   to_text(record),
                   {{"map.csv", map_csv(record)}},
                   [&] {
                     if (is_page_name(command.plot))
                       write_page(command.plot, record, scene);
                     else
                       draw_map(command.plot, record);
                   },
                   {}});
}

}  // namespace graze
