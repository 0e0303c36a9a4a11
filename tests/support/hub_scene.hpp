// A strip of aluminium on a hub, in code.
#pragma once

#include "graze/assembly/assembly.hpp"
#include "graze/scene/scene.hpp"
#include "graze/system/system.hpp"

namespace graze::support {

// 0.6 m x 25 mm x 3 mm on a hub of 20 mm and 1e-3 kg m^2; nothing acts on it.
inline Scene strip_on_hub(int modes = 3) {
  Scene scene;
  Beam beam;
  beam.length = 0.6;
  beam.youngs_modulus = 6.895e10;
  beam.second_moment = 0.025 * 0.003 * 0.003 * 0.003 / 12.0;
  beam.density = 2700.0;
  beam.area = 0.025 * 0.003;
  beam.modes = modes;
  scene.structure = beam;
  Hub hub;
  hub.radius = 0.02;
  hub.inertia = 1e-3;
  scene.hub = hub;
  return scene;
}

inline SceneStop stop_at(double position, double gap, double restitution) {
  SceneStop stop;
  stop.position = position;
  stop.gap = gap;
  stop.restitution = {restitution};
  return stop;
}

// The beam's inertia about the hub's centre, kg m^2.
inline double beam_inertia(const Scene& scene) {
  const Beam& beam = *scene.beam();
  const double l = beam.length, a = scene.hub->radius;
  return beam.density * *beam.area * ((l + a) * (l + a) * (l + a) - a * a * a) / 3.0;
}

}  // namespace graze::support
