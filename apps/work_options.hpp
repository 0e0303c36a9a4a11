// How the options of several commands reach what does the work, and what a result tells of them.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "command.hpp"
#include "graze/base/detail/even_values.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/record/file/run_info.hpp"
#include "graze/study/plane/detail/plane.hpp"
#include "graze/study/sweep/detail/run_series.hpp"
#include "graze/study/sweep/settled_row.hpp"
#include "session.hpp"

namespace graze {

// Of a search for orbits.
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

// Of motions that are followed until they settle.
inline void set_settling(const MotionOptions& command, const SettlingOptions& settling,
                         RowOptions& options) {
  options.periods = settling.periods.value_or(options.periods);
  options.samples = settling.samples;
  options.exponent_periods = settling.exponents;
  options.max_impacts = command.max_impacts;
  options.closure_speed = command.closure_speed;
}

// What makes a difference to what they settle on.
inline void note_settling(const RowOptions& options, RunInfo& info) {
  info.options.emplace_back("periods", options.periods);
  info.options.emplace_back("samples", options.samples);
  if (options.exponent_periods > 0)
    info.options.emplace_back("exponents", options.exponent_periods);
  if (options.closure_speed) info.options.emplace_back("closure_speed", *options.closure_speed);
  info.options.emplace_back("max_impacts", options.max_impacts);
}

// Of single runs over a parameter, `duration` s each, at so many values over its range.
inline RunSeriesOptions series_options(const MotionOptions& command, const RangeOptions& range,
                                       double duration, int points) {
  RunSeriesOptions options;
  options.parameter = range.parameter;
  options.values = even_values(range.from, range.to, points);
  options.duration = duration;
  options.closure_speed = command.closure_speed;
  options.max_impacts = command.max_impacts;
  options.threads = command.threads;
  options.stop = stop_signal(command);
  return options;
}

// Of a plane of so many cells across and up. Requires both ends of the second range.
inline Plane plane_of(const RangeOptions& first, const SecondRangeOptions& second, int across,
                      int up) {
  return {{first.parameter, first.from, first.to, across},
          {second.second, *second.second_from, *second.second_to, up}};
}

inline void note_plane(const Plane& plane, RunInfo& info) {
  for (const auto& [prefix, axis] : {std::pair("", plane.x), std::pair("second_", plane.y)}) {
    const std::string before = prefix;
    info.options.emplace_back(before.empty() ? "parameter" : "second", axis.name);
    info.options.emplace_back(before + "from", axis.from);
    info.options.emplace_back(before + "to", axis.to);
    info.options.emplace_back(before + "points", static_cast<long long>(axis.points));
  }
}

}  // namespace graze
