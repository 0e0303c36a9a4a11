#include "restart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/start_table.hpp"
#include "graze/base/errors.hpp"
#include "graze/bifurcation/loci/restart.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/record/stored/record_file.hpp"
#include "graze/scene/difference.hpp"
#include "graze/scene/parameter.hpp"
#include "run_folder.hpp"

namespace graze {
namespace {

// A message names no more.
constexpr std::size_t kMostNames = 24;

std::string names_of(const std::vector<SpecialOrbit>& points) {
  if (points.empty()) return "there is none in it";
  std::vector<std::string> names;
  for (const SpecialOrbit& point : points) {
    if (names.size() == kMostNames) break;
    names.push_back(point.id);
  }
  const std::size_t left = points.size() - names.size();
  return fmt::format("there are {}{}", fmt::join(names, ", "),
                     left > 0 ? fmt::format(" and {} more", left) : "");
}

const SpecialOrbit& special_called(const std::string& label, const std::string& folder,
                                   const std::vector<SpecialOrbit>& points) {
  const auto found = std::find_if(points.begin(), points.end(),
                                  [&](const SpecialOrbit& point) { return point.id == label; });
  if (found != points.end()) return *found;
  if (label.empty())
    throw InputError(fmt::format("--restart: give --label ID, a special point of {}; {}", folder,
                                 names_of(points)));
  throw InputError(
      fmt::format("--label: {} has no special point {}; {}", folder, label, names_of(points)));
}

struct SpecialPoints {
  std::vector<std::string> parameters;  // one of a branch, two of a locus
  std::vector<SpecialOrbit> points;
};

SpecialPoints special_points(const StoredResult& run) {
  const auto of_branches = [](const BranchRecord& record) {
    return SpecialPoints{{record.traced.parameter}, special_orbits(record.traced, record.system)};
  };
  if (const auto* record = std::get_if<BranchRecord>(&run.record)) return of_branches(*record);
  if (const auto* record = std::get_if<DiagramRecord>(&run.record))
    return of_branches(record->branches);
  if (const auto* record = std::get_if<LociRecord>(&run.record))
    return {{record->traced.first, record->traced.second}, special_orbits(record->traced)};
  throw InputError(
      fmt::format("--restart: {} holds no branches and no loci; give a folder of "
                  "graze continue or graze diagram",
                  run.folder.string()));
}

// That `scene` is the run's but for these parameters; `folder`: the run's as it was given.
void require_scene_of(const StoredResult& run, const std::string& folder, const char* option,
                      const Scene& scene, const std::vector<std::string>& parameters) {
  const std::string difference = scene_difference(run.scene, scene, parameters);
  if (!difference.empty())
    throw InputError(fmt::format("{}: the run in {} is of another scene: {}; give {} as the scene",
                                 option, folder, difference, (run.folder / kSceneFile).string()));
}

// The n-th point of branches, row by row of their table.
Restart point_of_branches(const BranchRecord& record, int n, const Scene& scene) {
  std::size_t left = static_cast<std::size_t>(n) - 1;
  for (const OrbitBranch& branch : record.traced.branches) {
    if (left < branch.points.size()) {
      const OrbitBranchPoint& point = branch.points[left];
      return {orbit_to_start_from(point.orbit, fmt::format("row {}", n), point.value),
              {record.traced.parameter},
              scene};
    }
    left -= branch.points.size();
  }
  throw InputError(fmt::format("--orbit: there is no row {}, branches.csv has {}", n,
                               static_cast<std::size_t>(n) - 1 - left));
}

Restart orbit_of_run(const AnyRecord& any, int n, const std::string& folder, const Scene& scene) {
  if (const auto* record = std::get_if<BranchRecord>(&any))
    return point_of_branches(*record, n, scene);
  if (const auto* record = std::get_if<DiagramRecord>(&any))
    return point_of_branches(record->branches, n, scene);
  const auto* record = std::get_if<OrbitRecord>(&any);
  if (!record)
    throw InputError(
        fmt::format("--from-orbit: {} holds no orbits and no branches; give a folder of "
                    "graze orbit, continue or diagram",
                    folder));
  const std::vector<Orbit>& orbits = record->found.orbits;
  if (static_cast<std::size_t>(n) > orbits.size())
    throw InputError(
        fmt::format("--orbit: there is no orbit {}, the run found {}", n, orbits.size()));
  return {
      orbit_to_start_from(orbits[static_cast<std::size_t>(n) - 1], fmt::format("orbit {}", n), {}),
      {},
      scene};
}

}  // namespace

std::optional<Restart> read_restart(const ContinueCommand& command, const Scene& scene) {
  const RestartOptions& options = command.restart;
  const bool of_orbit = !options.orbit_folder.empty();
  if (options.folder.empty() && !of_orbit) return {};
  const char* option = of_orbit ? "--from-orbit" : "--restart";
  const std::string& folder = of_orbit ? options.orbit_folder : options.folder;
  const StoredResult run = read_result(folder);
  refuse_own_folder(command, run.folder, option);
  Restart restart{{}, {}, scene};
  if (of_orbit) {
    restart = orbit_of_run(run.record, options.orbit, folder, scene);
  } else {
    const SpecialPoints special = special_points(run);
    restart = {special_called(options.label, folder, special.points), special.parameters, scene};
  }
  require_scene_of(run, folder, option, scene, restart.parameters);
  for (std::size_t i = 0; i < restart.parameters.size(); ++i)
    restart.scene = with_parameter(
        restart.scene, restart.parameters[i],
        i == 0 && restart.at.sticks() ? restart.at.followed->value : restart.at.values[i]);
  return restart;
}

namespace {

// The end of a run, or the next start of a forcing period.
State end_of_run(const StoredResult& run, const std::string& folder, const System& system) {
  const auto* record = std::get_if<SimulationRecord>(&run.record);
  if (!record)
    throw InputError(fmt::format("--from-state: {} holds no run of graze simulate", folder));
  const MotionState<double>& end = record->run.state.motion;
  if (end.instant.local == 0.0) return record->run.final;
  SimulationOptions options;
  options.periods = end.instant.period + 1;
  const Simulation on = resume(system, record->run.state, options, {});
  if (on.outcome != RunOutcome::kReachedEnd)
    throw InputError(
        fmt::format("--from-state: the run in {} cannot go on to the next forcing period: "
                    "{}",
                    folder, on.message));
  return on.final;
}

}  // namespace

std::optional<SettledStart> read_state(const ContinueCommand& command, const Scene& scene) {
  const std::string& name = command.restart.state;
  if (name.empty()) return {};
  const System system = assemble(scene);
  Restart here;
  here.at.id = "the scene";
  here.scene = scene;
  SettledStart start{
      value_in_range(here, command.parameter, command.from, command.to), {}, command.period};
  if (!std::filesystem::is_directory(name)) {
    start.state = state_in_table(name, scene, system);
    return start;
  }
  const StoredResult run = read_result(name);
  refuse_own_folder(command, run.folder, "--from-state");
  require_scene_of(run, name, "--from-state", scene, {});
  start.state = end_of_run(run, name, system);
  return start;
}

double value_in_range(const Restart& restart, const std::string& parameter, double from,
                      double to) {
  with_parameter(restart.scene, parameter, from);  // throws where there is none
  const double value = *parameter_value(restart.scene, parameter);
  if (value < std::min(from, to) || value > std::max(from, to))
    throw InputError(fmt::format(
        "--from, --to: {} has {} = {:.9g}, which the range from {:g} to {:g} does not hold",
        restart.at.id, parameter, value, from, to));
  return value;
}

void note_values(const Restart& restart, const std::vector<std::string>& varied, RunInfo& info) {
  for (const std::string& name : restart.parameters)
    if (std::find(varied.begin(), varied.end(), name) == varied.end())
      info.settings.push_back(fmt::format("{}={}", name, *parameter_value(restart.scene, name)));
}

}  // namespace graze
