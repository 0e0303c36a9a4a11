// Numbers of orbits that mark points along branches and loci: UZ, where such a number takes a
// value, and EX, where it is largest or smallest.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/orbit/problem/orbit.hpp"
#include "graze/scene/scene.hpp"
#include "graze/system/system.hpp"

namespace graze {

// Of an orbit of this system of the scene; nullopt where it has none.
using OrbitNumber = std::function<std::optional<double>(const Scene& scene, const System& system,
                                                        const Orbit& orbit)>;

struct OrbitLevel {
  std::string name;  // "stop.1.peak-force=10", of an extreme "stop.1.peak-force"
  OrbitNumber number;
  std::optional<double> value{};  // none: the extremes
  double turn = 0.0;              // of numbers that count modulo it; 0: those of others
  bool ends = false;              // branches end there

  // What the number changes by, the short way round where it counts modulo a turn.
  double change(double from, double to) const;
  // Zero where the number takes the value; of an extreme the number itself.
  double excess(double at) const;
};

std::vector<std::string> names_of(const std::vector<OrbitLevel>& levels);

}  // namespace graze
