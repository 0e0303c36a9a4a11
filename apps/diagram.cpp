// graze diagram: a brute-force sweep over a parameter, and the branches of orbits over it.
#include <fmt/format.h>

#include "branch_options.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/base/errors.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/page/page.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "journals.hpp"
#include "option_notes.hpp"
#include "session.hpp"
#include "work_options.hpp"

namespace graze {
namespace {

SweepOptions sweep_options(const DiagramCommand& command, const StopSignal& stop) {
  SweepOptions options;
  options.from = command.from;
  options.to = command.to;
  options.points = command.points;
  options.direction = command.direction;
  set_settling(command, command.settling, options);
  options.measure = command.measures();
  options.stop = stop;
  options.progress = progress_line(command, options.points, "values");
  return options;
}

// Who names period or impacts means all such orbits.
DiagramBranches wanted_branches(const DiagramCommand& command, const Scene& scene) {
  if (has_signal(scene)) {
    if (command.branches && *command.branches != DiagramBranches::kNone) require_harmonics(scene);
    return DiagramBranches::kNone;
  }
  const bool names_them = command.period_given || command.impacts;
  const DiagramBranches other = names_them ? DiagramBranches::kAll : DiagramBranches::kFound;
  const DiagramBranches wanted = command.branches.value_or(other);
  if (wanted == DiagramBranches::kFound && names_them)
    throw InputError(
        "--branches found: these are (1, 1) orbits and whatever the sweep settles on; leave out "
        "--period and --impacts, or give --branches all");
  if (wanted == DiagramBranches::kAll && command.any_impacts)
    throw InputError("--impacts any: that is --branches found; of all give a number");
  return wanted;
}

// Adds the branches; returns the outcome, or nullopt if they are not wanted.
std::optional<Outcome> add_branches(const DiagramCommand& command, DiagramBranches wanted,
                                    const SystemFamily& family, BranchOptions options,
                                    DiagramRecord& record) {
  OrbitBranches& traced = record.branches.traced;
  traced.parameter = command.parameter;
  if (wanted == DiagramBranches::kNone) return {};
  if (wanted == DiagramBranches::kFound) options.settled = settled_starts(record.swept.rows);
  traced = trace_orbits(family, options, number_shown(record.branches.shown));
  if (command.measures())
    record.branches.amplitudes = measure_branches(family, traced, command.threads, options.stop);
  if (wanted == DiagramBranches::kFound && traced.cut_settled > 0) {
    // The sweep says where else its orbits go.
    traced.notes.push_back(fmt::format(
        "{} of the branches through what the sweep settles on could not be followed to {}",
        traced.cut_settled, traced.cut_settled == 1 ? "an end" : "their ends"));
    traced.cut_short -= traced.cut_settled;
  }
  const Outcome outcome = branch_outcome(traced, options);
  if (outcome.name == "no_orbit") traced.notes.push_back(outcome.message);
  if (record.branches.shown)
    record.curves = {amplitude_curves(record.branches)};
  else if (record.section == DiagramSection::kImpact)
    record.curves = {impact_curves(traced)};
  else
    record.curves = stroboscopic_curves(family, traced);
  return outcome;
}

}  // namespace

int run(const DiagramCommand& command) {
  check_plot<DiagramRecord>(command);
  check_journal_options(command, command.journal);
  const Scene scene = scene_of(command);
  const DiagramBranches wanted = wanted_branches(command, scene);
  if (!scene.repeats()) return run_diagram_of_runs(command, scene);
  if (command.duration)
    throw InputError(
        "--duration: it is not allowed here; this scene's motion repeats with its forcing and is "
        "followed until it has settled (--periods)");
  require_exact_flow(scene, "diagrams are drawn");
  require_forcing_and_stop(scene);
  BranchOptions tracing = branch_options(command);
  SweepOptions options = sweep_options(command, tracing.stop);
  const SystemFamily family(scene, command.parameter);
  // A range that reaches beyond what the scene allows is the user's error, not a row.
  for (const double value : {command.from, command.to})
    with_parameter(scene, command.parameter, value);
  DiagramRecord record;
  record.section = command.section;
  record.branches = {info_of_call(command, scene),
                     assemble(scene),
                     {},
                     command.from,
                     command.to,
                     parameter_unit(scene, command.parameter),
                     {},
                     {}};
  const std::vector<MeasuredPlace> places = measured_places(scene, record.branches.system);
  record.branches.shown = shown_of(command.curve, command.curve_at, places);
  if (command.measures()) record.branches.amplitudes.places = places;
  DiagramCommand in_force = command;
  in_force.branches = wanted;
  note_options(in_force, Recorded::In::kPieces, record.branches.info);
  record.branches.warnings = system_warnings(scene, record.branches.system);
  warn(command, record.branches.warnings);
  prepare_output(command);
  JournalledWork work(command, command.journal,
                      {record.branches.info,
                       "row",
                       static_cast<std::size_t>(command.points),
                       sweep_block(options.direction),
                       {},
                       {}});
  work.set(options);
  record.swept = sweep(family, options);
  options.progress = nullptr;
  if (!work.is_whole_here()) return work.conclude_part(record.swept.stopped);
  note_options(in_force, Recorded::In::kResult, record.branches.info);
  const std::optional<Outcome> traced = add_branches(command, wanted, family, tracing, record);
  record.branches.outcome = diagram_outcome(record.swept, traced);
  const bool swept = record.swept.stopped == StopReason::kNone;
  const StopReason stopped = swept ? record.branches.traced.stopped : record.swept.stopped;
  return work.conclude(record, stopped, scene);
}

}  // namespace graze
