// How the options of a search for orbits reach the finder.
#pragma once

#include <algorithm>

#include "command.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/record/file/run_info.hpp"
#include "session.hpp"

namespace graze {

inline FinderOptions finder_options(const OrbitSearchOptions& command) {
  const auto wanted = [&](const char* name) {
    return command.starts.empty() ||
           std::find(command.starts.begin(), command.starts.end(), name) != command.starts.end();
  };
  FinderOptions options;
  options.period = command.period;
  options.impacts = command.impacts;
  options.only_this_period = command.period_given;
  options.from_closed_form = wanted("closed-form");
  options.from_simulation = wanted("simulation");
  options.from_random = wanted("random");
  options.keep_virtual = command.keep_virtual;
  options.random_seed = command.random_seed;
  options.max_impacts = command.max_impacts;
  options.threads = command.threads;
  options.stop = stop_signal(command);
  return options;
}

// Periodic orbits repeat with the forcing and are made of impacts: both must be there.
inline void require_forcing_and_stop(const Scene& scene) {
  if (!scene.forcing)
    throw scene_error(scene, "forcing",
                      "the table is missing; periodic orbits are counted in forcing periods");
  if (scene.stops.empty())
    throw scene_error(scene, "stop", "there is no [[stop]]; periodic orbits here have impacts");
}

inline void record_search(const OrbitSearchOptions& command, RunInfo& info) {
  const bool any = command.any_impacts || (command.name == "orbit" && !command.impacts);
  info.options.emplace_back("period", static_cast<long long>(command.period));
  info.options.emplace_back("impacts", any ? "any" : std::to_string(command.impacts.value_or(1)));
  info.options.emplace_back("virtual", command.keep_virtual);
  std::string starts;
  for (const std::string& start : command.starts) starts += (starts.empty() ? "" : ",") + start;
  info.options.emplace_back("start", starts.empty() ? std::string("all") : starts);
  info.options.emplace_back("max_impacts", command.max_impacts);
  info.options.emplace_back("max_seconds", command.max_seconds);
  info.options.emplace_back("random_seed", static_cast<long long>(command.random_seed));
}

}  // namespace graze
