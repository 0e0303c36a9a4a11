// graze continue: branches of orbits over a parameter.
#include <fmt/format.h>

#include "branch_options.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/bifurcation/problem/option_faults.hpp"
#include "graze/record/orbit_quantity.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "graze/study/sweep/sweep.hpp"
#include "option_notes.hpp"
#include "restart.hpp"
#include "session.hpp"
#include "work_options.hpp"

namespace graze {

BranchOptions branch_options(const BranchingOptions& command) {
  BranchOptions options;
  options.period = command.period;
  options.impacts = command.impacts.value_or(1);
  options.response = command.measures() || options.impacts == 0;
  options.follow_depth = command.follows ? command.depth : 0;
  set_range(command, options);
  if (const auto fault = fault_in(options)) throw InputError(fault->text_of_program());
  options.keep_virtual = command.keep_virtual;
  // A number of impacts that was asked for is none of an orbit that closes a chatter.
  options.sticking = !command.impacts.has_value();
  options.finder = finder_options(command);
  options.finder.closure_speed = command.closure_speed;
  options.stop = options.finder.stop;
  options.progress = progress_line(command);
  return options;
}

std::optional<Shown> shown_of(std::optional<ShownQuantity> quantity, const std::string& at,
                              const std::vector<MeasuredPlace>& places) {
  if (!quantity) return {};
  std::string known;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const MeasuredPlace& place = places[i];
    if (!exists_at(*quantity, place)) continue;
    const std::string name = place.name('.');
    if (at.empty() || at == name) return Shown{*quantity, i};
    known += (known.empty() ? "" : ", ") + name;
  }
  throw InputError(fmt::format("--at: '{}' is not allowed; give one of {}", at, known));
}

OrbitNumber number_shown(const std::optional<Shown>& shown) {
  return shown ? number_of(*shown) : OrbitNumber();
}

std::vector<OrbitLevel> levels_of(const LevelOptions& options, const std::string& at,
                                  const Scene& scene) {
  const std::vector<MeasuredPlace> places = measured_places(scene, assemble(scene));
  std::vector<OrbitLevel> levels;
  for (const std::string& text : options.levels)
    levels.push_back(level_named(text, false, at, places));
  for (OrbitLevel& level : levels) level.ends = options.level_ends;
  for (const std::string& text : options.extremes)
    levels.push_back(level_named(text, true, at, places));
  return levels;
}

namespace {

void check_impacts(const ContinueCommand& command) {
  if (command.any_impacts && command.period_given)
    throw InputError("--impacts any: what motions settle on has any period; leave out --period");
}

// Also from what motions from the scene's initial state settle on, at values spread over the range.
void start_from_motions(const ContinueCommand& command, const SystemFamily& family,
                        BranchOptions& options) {
  SweepOptions motions;
  motions.from = command.from;
  motions.to = command.to;
  motions.points = 101;  // two of them a fiftieth of the range, the longest step of a branch
  motions.direction = SweepDirection::kFresh;
  motions.max_impacts = command.max_impacts;
  motions.closure_speed = command.closure_speed;
  motions.threads = command.threads;
  motions.stop = options.stop;
  motions.progress = progress_line(command, motions.points, "values");
  options.settled = settled_starts(sweep(family, motions).rows);
}

// Whether a point of that kind has another branch to go onto.
bool has_other_branch(const SpecialOrbit& at) {
  if (at.kind == SpecialKind::kPeriodDoubling) return true;
  const bool found = at.kind == SpecialKind::kBranchPoint || at.kind == SpecialKind::kGrazing;
  return found && !at.sticks() && !at.by_push;
}

// From a special point of an earlier run alone.
void start_from(const Restart& restart, const ContinueCommand& command, BranchOptions& options) {
  value_in_range(restart, command.parameter, command.from, command.to);
  const bool same = restart.parameters == std::vector<std::string>{command.parameter};
  if (command.restart.switched && !has_other_branch(restart.at))
    throw InputError(fmt::format(
        "--switch: no other branch begins or crosses at {}; one does at PD, and at BP and GR of "
        "orbits that do not stick",
        restart.at.id));
  if (command.restart.switched && restart.at.by_speed && restart.at.impacts.size() == 1)
    throw InputError(fmt::format("--switch: beyond {} the motion meets no stop", restart.at.id));
  if (restart.at.kind == SpecialKind::kBranchPoint && !restart.at.sticks() && !same)
    throw InputError(
        fmt::format("--label: two branches cross at {}, which over another parameter than {} are "
                    "not told apart; restart over that one, or from another special point",
                    restart.at.id, restart.parameters.front()));
  options.start = BranchStart{restart.at, same, command.restart.switched};
  options.period = restart.at.followed ? restart.at.followed->period : restart.at.pattern.period;
  options.impacts = restart.at.pattern.impacts();
}

}  // namespace

int run(const ContinueCommand& command) {
  if (!command.locus.empty()) return run_loci(command);
  check_plot<BranchRecord>(command);
  check_impacts(command);
  const Scene given = timed(scene_of(command));
  require_exact_flow(given, "branches are traced");
  const std::optional<Restart> restart = read_restart(command, given);
  const Scene& scene = restart ? restart->scene : given;
  require_forcing_and_contact(scene);
  require_harmonics(scene);
  BranchOptions options = branch_options(command);
  if (scene.stops.empty()) options.impacts = 0;
  if (restart) start_from(*restart, command, options);
  if (std::optional<SettledStart> state = read_state(command, scene)) {
    options.settled = {std::move(*state)};
    options.impacts = 0;  // nothing is searched for
  }
  options.levels = levels_of(command, command.curve_at, scene);
  options.normal_forms = command.normal_forms;
  const SystemFamily family(scene, command.parameter);
  BranchRecord record{info_of_call(command, scene),
                      assemble(scene),
                      {},
                      command.from,
                      command.to,
                      parameter_unit(scene, command.parameter),
                      {},
                      {}};
  record.shown = shown_of(command.curve, command.curve_at, measured_places(scene, record.system));
  // A range that reaches beyond what the scene allows is the user's error, not a broken branch.
  for (const double value : {command.from, command.to})
    with_parameter(scene, command.parameter, value);
  if (restart) note_values(*restart, {command.parameter}, record.info);
  note_options(command, record.info);
  record.warnings = system_warnings(scene, record.system);
  warn(command, record.warnings);
  prepare_output(command);
  if (command.any_impacts) start_from_motions(command, family, options);
  record.traced = trace_orbits(family, options, number_shown(record.shown));
  options.progress = nullptr;
  if (command.measures())
    record.amplitudes = measure_branches(family, record.traced, command.threads, options.stop);
  record.outcome = branch_outcome(record.traced, options);
  return conclude(command, record, scene);
}

}  // namespace graze
