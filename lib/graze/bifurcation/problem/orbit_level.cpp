#include "graze/bifurcation/problem/orbit_level.hpp"

#include <cmath>

namespace graze {

double OrbitLevel::change(double from, double to) const {
  return turn > 0.0 ? std::remainder(to - from, turn) : to - from;
}

double OrbitLevel::excess(double at) const {
  if (!value) return at;
  return turn > 0.0 ? std::remainder(at - *value, turn) : at - *value;
}

std::vector<std::string> names_of(const std::vector<OrbitLevel>& levels) {
  std::vector<std::string> names;
  for (const OrbitLevel& level : levels) names.push_back(level.name);
  return names;
}

}  // namespace graze
