// graze map: what the motion settles on over a plane of two parameters or two coordinates of its
// start.
#include <fmt/format.h>

#include <optional>

#include "branch_options.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/page/page.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/start_coordinate.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "journals.hpp"
#include "loci_options.hpp"
#include "option_notes.hpp"
#include "session.hpp"
#include "work_options.hpp"

namespace graze {
namespace {

AttractorMapOptions map_options(const MapCommand& command) {
  AttractorMapOptions options;
  static_cast<Plane&>(options) =
      plane_of(command, command, command.first_points, command.second_points);
  set_settling(command, command.settling, options);
  options.measure = command.measures();
  options.stop = stop_signal(command);
  return options;
}

// Loci of the orbits over the map, and how the whole ended.
void trace_over(const MapCommand& command, const Scene& scene, const LociOptions& options,
                MapRecord& record) {
  record.loci = trace_loci(scene, command.parameter, command.second, options);
  const Outcome outcome = loci_outcome(*record.loci, options);
  // That there are none is no failure: the map says what there is.
  if (record.outcome.name == "complete" && outcome.name != "no_orbit") record.outcome = outcome;
}

void check_options(const MapCommand& command) {
  check_plot<MapRecord>(command);
  check_journal_options(command, command.journal);
  if (command.show == MapQuantity::kExponent && command.settling.exponents == 0)
    throw InputError(
        "--show exponent: give --exponents K, the periods that they are averaged over");
  if (command.locus.empty()) return;
  for (const std::string& axis : {command.parameter, command.second})
    if (names_start_coordinate(axis))
      throw InputError(fmt::format(
          "--locus: {} is no parameter; orbits, and so their loci, do not depend on the start",
          axis));
}

}  // namespace

int run(const MapCommand& command) {
  check_options(command);
  const Scene scene = scene_of(command);
  require_exact_flow(scene, "maps are drawn");
  require_forcing_and_stop(scene);
  // What loci need is refused before the map is made, and the time for loci counts from here.
  std::optional<LociOptions> loci;
  if (!command.locus.empty()) loci = loci_options(command, scene);
  AttractorMapOptions options = map_options(command);
  if (is_page_name(command.plot.file)) check_map_page(command.plot.file, options);
  MapRecord record;
  record.info = info_of_call(command, scene);
  record.x_unit = number_unit(scene, options.x.name);
  record.y_unit = number_unit(scene, options.y.name);
  const System system = assemble(scene);
  const std::vector<MeasuredPlace> places = measured_places(scene, system);
  record.measured = shown_of(command.curve, command.curve_at, places);
  record.shown = record.measured ? MapQuantity::kMeasured : command.show;
  if (command.measures()) record.places = places;
  note_options(command, Recorded::In::kPieces, record.info);
  record.warnings = system_warnings(scene, system);
  warn(command, record.warnings);
  prepare_output(command);
  const auto cells = static_cast<int>(options.cells());
  JournalledWork work(command, command.journal, {record.info, "cell", options.cells(), 1, {}, {}});
  work.set(options);
  options.progress = progress_line(command, cells, "cells");
  record.map = map_attractors(scene, options);
  options.progress = nullptr;
  if (!work.is_whole_here()) return work.conclude_part(record.map.stopped);
  note_options(command, Recorded::In::kResult, record.info);
  record.outcome = map_outcome(record.map);
  if (loci) trace_over(command, scene, *loci, record);
  const bool stops_in_loci = record.loci && record.map.stopped == StopReason::kNone;
  return work.conclude(record, stops_in_loci ? record.loci->stopped : record.map.stopped, scene);
}

}  // namespace graze
