// How continue --restart finds the special point to go on from.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "graze/bifurcation/problem/branch_options.hpp"
#include "graze/bifurcation/problem/special_orbit.hpp"
#include "graze/record/file/run_info.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

struct Restart {
  SpecialOrbit at;
  std::vector<std::string> parameters;  // that the run was over
  Scene scene;                          // the one given, with the values of the special point
};

// What --restart and --label, or --from-orbit and --orbit name; nullopt when they are not given.
// Throws InputError where there is no such point, where `scene` differs from that of the run in
// what its orbits depend on, and where --out is the run's own folder.
std::optional<Restart> read_restart(const ContinueCommand& command, const Scene& scene);

// The start that --from-state names, at the scene's own value of the parameter; nullopt when it is
// not given. Throws InputError likewise, and where the table does not fit the scene.
std::optional<SettledStart> read_state(const ContinueCommand& command, const Scene& scene);

// The point's own value of a parameter. Throws InputError where the scene has no such parameter, or
// the value lies outside the range asked for.
double value_in_range(const Restart& restart, const std::string& parameter, double from, double to);

// The values of the special point that the scene is at beside those that `varied` names, among the
// settings.
void note_values(const Restart& restart, const std::vector<std::string>& varied, RunInfo& info);

}  // namespace graze
