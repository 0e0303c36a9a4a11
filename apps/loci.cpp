// graze continue --locus: loci of special points in two parameters.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "branch_options.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/bifurcation/loci/restart.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "loci_options.hpp"
#include "option_notes.hpp"
#include "restart.hpp"
#include "session.hpp"
#include "work_options.hpp"

namespace graze {
namespace {

// The one among the levels of this run that the point is of.
std::size_t level_of(const SpecialOrbit& at, const LociOptions& options) {
  const std::vector<OrbitLevel>& levels = options.branches.levels;
  const auto found = std::find_if(levels.begin(), levels.end(),
                                  [&](const OrbitLevel& level) { return level.name == at.level; });
  if (found == levels.end())
    throw InputError(
        fmt::format("--label: {} is of the level {}; give it once more, --{} {}", at.id, at.level,
                    at.level.find('=') == std::string::npos ? "extreme" : "level", at.level));
  return static_cast<std::size_t>(found - levels.begin());
}

// From a special point of an earlier run alone.
void start_from(const Restart& restart, const ContinueCommand& command, LociOptions& options) {
  const double first = value_in_range(restart, command.parameter, command.from, command.to);
  const double second =
      value_in_range(restart, command.second, options.second_from, options.second_to);
  options.start = locus_start(assemble(restart.scene), restart.at, first, second);
  if (!options.start)
    throw InputError(
        fmt::format("--label: {} has no locus to go on along; LP, PD and NS have, and GR of orbits "
                    "that do not stick",
                    restart.at.id));
  if (is_of_level(options.start->kind)) options.start->level = level_of(restart.at, options);
  // Which orbits these are, for what else is asked of the plane; a locus of grazing counts its
  // touch.
  if (restart.at.followed) {
    options.branches.period = restart.at.followed->period;
  } else {
    const ImpactPattern& pattern = restart.at.pattern;
    options.branches.period = pattern.period;
    options.branches.impacts =
        std::max(1, pattern.impacts() - (restart.at.locus == OrbitLocusKind::kGrazing ? 1 : 0));
  }
  const OrbitLocusKind kind = options.start->kind;
  if (std::find(options.kinds.begin(), options.kinds.end(), kind) == options.kinds.end())
    throw InputError(fmt::format("--locus: {} lies on a locus of {}; give --locus {}{}",
                                 restart.at.id, label_of(kind), label_of(kind),
                                 is_of_level(kind) ? "" : " or all"));
}

// Loci of levels need some, and branches are not cut at them.
void check_levels(const ContinueCommand& command, const LociOptions& options) {
  const auto wants = [&](OrbitLocusKind kind) {
    return std::find(options.kinds.begin(), options.kinds.end(), kind) != options.kinds.end();
  };
  if (wants(OrbitLocusKind::kLevel) && command.levels.empty())
    throw InputError("--locus UZ: give the level, --level QUANTITY=VALUE");
  if (wants(OrbitLocusKind::kExtreme) && command.extremes.empty())
    throw InputError("--locus EX: give what is extreme, --extreme QUANTITY");
  if (command.level_ends)
    throw InputError("--level-ends: branches end at levels, loci do not; leave it out");
}

// What is stable between the loci, as far as the time goes that tracing them has left.
StableRegions regions_of(const ContinueCommand& command, const Scene& scene,
                         const LociOptions& loci) {
  StableRegionsOptions options;
  options.from = command.from;
  options.to = command.to;
  options.second_from = loci.second_from;
  options.second_to = loci.second_to;
  options.columns = options.rows = command.regions;
  options.search.period = loci.branches.period;
  options.search.impacts = loci.branches.impacts;
  options.search.from_closed_form = loci.branches.finder.from_closed_form;
  options.search.from_simulation = loci.branches.finder.from_simulation;
  options.search.random_starts = loci.branches.finder.from_random ? 1 : 0;
  options.search.random_seed = command.random_seed;
  options.search.max_impacts = command.max_impacts;
  options.search.stop = loci.branches.stop;
  options.closure_speed = command.closure_speed;
  options.threads = command.threads;
  options.progress = progress_line(command);
  return find_stable_regions(scene, command.parameter, command.second, options);
}

}  // namespace

int run_loci(const ContinueCommand& command) {
  check_plot<LociRecord>(command);
  const Scene given = scene_of(command);
  require_exact_flow(given, "loci are traced");
  const std::optional<Restart> restart = read_restart(command, given);
  const Scene& scene = restart ? restart->scene : given;
  require_forcing_and_stop(scene);
  require_harmonics(scene);
  LociOptions options = loci_options(command, scene);
  options.branches.levels = levels_of(command, "", scene);
  options.branches.normal_forms = command.normal_forms;
  check_levels(command, options);
  if (restart) start_from(*restart, command, options);
  LociRecord record;
  record.info = info_of_call(command, scene);
  if (restart) note_values(*restart, {command.parameter, command.second}, record.info);
  record.from = command.from;
  record.to = command.to;
  record.second_from = options.second_from;
  record.second_to = options.second_to;
  record.unit = parameter_unit(scene, command.parameter);
  record.second_unit = parameter_unit(scene, command.second);
  note_options(command, record.info);
  record.warnings = system_warnings(scene, assemble(scene));
  warn(command, record.warnings);
  prepare_output(command);
  record.traced = trace_loci(scene, command.parameter, command.second, options);
  options.branches.progress = nullptr;
  record.outcome = loci_outcome(record.traced, options);
  if (command.regions > 0) {
    record.regions = regions_of(command, scene, options);
    if (std::includes(options.kinds.begin(), options.kinds.end(), kOrbitLocusKinds.begin(),
                      kOrbitLocusKinds.end()))
      record.boundaries = region_boundaries(*record.regions, record.traced);
    record.outcome = regions_outcome(*record.regions, record.outcome);
  }
  return conclude(command, record, scene);
}

}  // namespace graze
