#include "loci_options.hpp"

#include <algorithm>

#include "branch_options.hpp"
#include "graze/base/errors.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

std::vector<OrbitLocusKind> kinds_of(const std::vector<std::string>& labels) {
  std::vector<OrbitLocusKind> kinds;
  for (const OrbitLocusKind kind : kOrbitLocusKinds)
    for (const std::string& label : labels)
      if (label == label_of(kind) || label == "all") {
        kinds.push_back(kind);
        break;
      }
  for (const OrbitLocusKind kind : {OrbitLocusKind::kLevel, OrbitLocusKind::kExtreme})
    if (std::find(labels.begin(), labels.end(), label_of(kind)) != labels.end())
      kinds.push_back(kind);
  return kinds;
}

}  // namespace

LociOptions loci_options(const LocusTracingOptions& command, const Scene& scene) {
  if (command.second.empty() || !command.second_from || !command.second_to)
    throw InputError(
        "--locus: give the second parameter, --second NAME --second-from C "
        "--second-to D");
  if (*command.second_from == *command.second_to)
    throw InputError("--second-from, --second-to: the range must not be empty");
  if (command.any_impacts)
    throw InputError("--impacts any: loci are traced of orbits with a number of impacts; give it");
  const std::vector<OrbitLocusKind> kinds = kinds_of(command.locus);
  const bool of_levels = std::all_of(kinds.begin(), kinds.end(),
                                     [](OrbitLocusKind kind) { return is_of_level(kind); });
  if (command.impacts == 0 && !of_levels)
    throw InputError(
        "--impacts: loci but UZ and EX are traced of orbits with impacts; give at least 1");
  LociOptions options;
  options.branches = branch_options(command);
  options.branches.start_values = 8;
  options.second_from = *command.second_from;
  options.second_to = *command.second_to;
  options.kinds = kinds;
  options.slices = command.slices;
  for (const double value : {command.from, command.to})
    for (const double second : {options.second_from, options.second_to})
      with_parameter(with_parameter(scene, command.parameter, value), command.second, second);
  return options;
}

}  // namespace graze
