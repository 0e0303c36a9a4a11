#include "graze/scene/keys.hpp"

#include <algorithm>
#include <cassert>

namespace graze {
namespace {

const std::vector<TableKeys>& all_keys() {
  static const std::vector<TableKeys> keys = {
      {"",
       {"title", "beam", "modal", "damping", "forcing", "gravity", "stop", "initial", "solver"},
       {"hub", "probe"}},
      {"beam",
       {"length", "youngs_modulus", "second_moment", "density", "area", "modes", "discretisation",
        "points"},
       {"thickness"}},
      {"modal", {"frequencies", "damping_ratios", "participation", "inertia"}, {}},
      {"damping", {"viscous", "ratios", "rayleigh"}, {}},
      {"damping.rayleigh", {"mass", "stiffness"}, {}},
      {"forcing", {"kind", "amplitude", "frequency", "phase"}, {}},
      {"gravity", {"acceleration"}, {}},
      {"stop", {"position", "shape", "gap", "side", "restitution", "impulse"}, {"spring"}},
      {"initial", {"q", "qdot"}, {"angle", "rate"}},
      {"solver", {"flow", "tolerance", "step"}, {}},
  };
  return keys;
}

}  // namespace

const TableKeys& keys_of(const std::string& path) {
  const std::string table = path.compare(0, 5, "stop.") == 0 ? "stop" : path;
  const auto found = std::find_if(all_keys().begin(), all_keys().end(),
                                  [&](const TableKeys& keys) { return keys.table == table; });
  assert(found != all_keys().end());
  return *found;
}

std::vector<std::string> keys_named(const std::string& name) {
  std::vector<std::string> paths;
  for (const TableKeys& keys : all_keys()) {
    if (std::find(keys.allowed.begin(), keys.allowed.end(), name) != keys.allowed.end()) {
      paths.push_back(keys.table.empty() ? name : keys.table + "." + name);
    }
  }
  return paths;
}

}  // namespace graze
