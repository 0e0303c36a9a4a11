// graze diagram of a motion that no forcing repeats: one run at each value of a parameter.
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/start_coordinate.hpp"
#include "journals.hpp"
#include "option_notes.hpp"
#include "work_options.hpp"

namespace graze {
namespace {

void require_what_is_shown(const DiagramCommand& command, const Scene& scene) {
  if (!command.duration)
    throw InputError(
        "--duration: it is missing; no forcing repeats this scene's motion, so a diagram of it "
        "shows one run at each value: give its time in s");
  if (scene.stops.empty() && scene.probes.empty())
    throw scene_error(scene, "stop",
                      "there is neither a [[stop]] nor a [[probe]]; a diagram shows impacts and "
                      "the values of probes");
}

}  // namespace

int run_diagram_of_runs(const DiagramCommand& command, const Scene& scene) {
  check_plot<RunDiagramRecord>(command);
  require_what_is_shown(command, scene);
  RunSeriesOptions options = series_options(command, command, *command.duration, command.points);
  RunDiagramRecord record;
  record.info = info_of_call(command, scene);
  record.parameter = command.parameter;
  record.unit = number_unit(scene, command.parameter);
  record.from = command.from;
  record.to = command.to;
  record.duration = options.duration;
  record.stops = scene.stops.size();
  record.probes = scene.probes;
  note_options(command, Recorded::In::kPieces, record.info);
  record.warnings = system_warnings(scene, assemble(scene));
  warn(command, record.warnings);
  prepare_output(command);
  JournalledWork work(command, command.journal,
                      {record.info, "row", options.values.size(), 1, {}, {}});
  work.set(options);
  options.progress = progress_line(command, command.points, "values");
  record.runs = run_series(scene, options);
  options.progress = nullptr;
  const bool is_done = record.runs.size() == options.values.size();
  const StopReason stopped = is_done ? StopReason::kNone : options.stop.reason();
  if (!work.is_whole_here()) return work.conclude_part(stopped);
  note_options(command, Recorded::In::kResult, record.info);
  record.outcome = run_diagram_outcome(record.runs, options.values.size(), stopped);
  return work.conclude(record, stopped, scene);
}

}  // namespace graze
