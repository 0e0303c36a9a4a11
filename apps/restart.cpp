#include "restart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "graze/base/errors.hpp"
#include "graze/bifurcation/loci/restart.hpp"
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

}  // namespace

std::optional<Restart> read_restart(const ContinueCommand& command, const Scene& scene) {
  if (command.restart.folder.empty()) return {};
  const StoredResult run = read_result(command.restart.folder);
  refuse_own_folder(command, run.folder, "--restart");
  const SpecialPoints special = special_points(run);
  const std::string difference = scene_difference(run.scene, scene, special.parameters);
  if (!difference.empty())
    throw InputError(
        fmt::format("--restart: the run in {} is of another scene: {}; give {} as the scene",
                    command.restart.folder, difference, (run.folder / kSceneFile).string()));
  Restart restart{special_called(command.restart.label, command.restart.folder, special.points),
                  special.parameters, scene};
  for (std::size_t i = 0; i < restart.parameters.size(); ++i)
    restart.scene = with_parameter(
        restart.scene, restart.parameters[i],
        i == 0 && restart.at.sticks() ? restart.at.followed->value : restart.at.values[i]);
  return restart;
}

double value_in_range(const Restart& restart, const std::string& parameter, double from,
                      double to) {
  with_parameter(restart.scene, parameter, from);  // throws where there is none
  const double value = *parameter_value(restart.scene, parameter);
  if (value < std::min(from, to) || value > std::max(from, to))
    throw InputError(
        fmt::format("--label: {} has {} = {:.9g}, which the range from {:g} to {:g} does not hold",
                    restart.at.id, parameter, value, from, to));
  return value;
}

void note_values(const Restart& restart, const std::vector<std::string>& varied, RunInfo& info) {
  for (const std::string& name : restart.parameters)
    if (std::find(varied.begin(), varied.end(), name) == varied.end())
      info.settings.push_back(fmt::format("{}={}", name, *parameter_value(restart.scene, name)));
}

}  // namespace graze
