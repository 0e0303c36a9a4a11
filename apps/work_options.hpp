// How the options of several commands reach what does the work.
#pragma once

#include <algorithm>

#include "command.hpp"
#include "graze/base/even_values.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/structure/modal_model.hpp"
#include "graze/study/plane/plane.hpp"
#include "graze/study/sweep/run_series.hpp"
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

// A scene that belts alone drive, with a guess of the period of its orbits in place of a forcing's.
inline Scene timed(Scene scene) {
  const auto drags = [](const DryFriction& friction) { return friction.speed != 0.0; };
  if (scene.forcing || std::none_of(scene.frictions.begin(), scene.frictions.end(), drags))
    return scene;
  const Vector omega = modal_model(scene).omega;
  Forcing guess;
  guess.kind = ForcingKind::kNone;
  guess.frequency = omega.minCoeff() > 0.0 ? omega.minCoeff() : 1.0;
  scene.forcing = guess;
  return scene;
}

// Periodic orbits repeat with the forcing and are made of impacts: both must be there.
inline void require_forcing(const Scene& scene) {
  if (!scene.forcing)
    throw scene_error(scene, "forcing",
                      "the table is missing; periodic orbits are counted in forcing periods");
  if (!scene.repeats())
    throw scene_error(scene, "forcing",
                      "the loads have no common period, after which a motion could repeat; such a "
                      "motion is simulated, and a diagram of it shows runs (--duration)");
}

inline void require_forcing_and_stop(const Scene& scene) {
  require_forcing(scene);
  if (scene.stops.empty())
    throw scene_error(scene, "stop",
                      "there is no [[stop]]; only orbits and their branches are known of a "
                      "structure that rubs alone");
}

// Of orbits, which have impacts or rub.
inline void require_forcing_and_contact(const Scene& scene) {
  require_forcing(scene);
  if (scene.stops.empty() && scene.frictions.empty())
    throw scene_error(
        scene, "stop",
        "there is no [[stop]] and no [[friction]]; periodic orbits here have impacts, "
        "or rub");
}

inline bool has_signal(const Scene& scene) {
  const std::vector<const HarmonicLoad*> loads = scene.harmonic_loads();
  return std::any_of(loads.begin(), loads.end(),
                     [](const HarmonicLoad* load) { return load->signal.has_value(); });
}

// Branches rest on derivatives by the phase, which a signal has between its instants alone.
inline void require_harmonics(const Scene& scene) {
  if (!has_signal(scene)) return;
  throw scene_error(scene, "forcing",
                    "a load is a signal; its orbits are found (orbit), and its motions followed over "
                    "a parameter (diagram), but branches are traced under harmonics alone");
}

// Of motions that are followed until they settle.
inline void set_settling(const MotionOptions& command, const SettlingOptions& settling,
                         RowOptions& options) {
  options.periods = settling.periods;
  options.samples = settling.samples;
  options.exponent_periods = settling.exponents;
  options.max_impacts = command.max_impacts;
  options.closure_speed = command.closure_speed;
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

}  // namespace graze
