#include "graze/scene/detail/keys.hpp"

#include <algorithm>
#include <cassert>

namespace graze {
namespace {

const std::vector<TableKeys>& all_keys() {
  static const std::vector<TableKeys> keys = {
      {"",
       {"title", "beam", "hub", "modal", "damping", "forcing", "gravity", "stop", "probe",
        "initial", "solver"}},
      {"beam",
       {"length", "youngs_modulus", "second_moment", "density", "area", "thickness", "modes",
        "discretisation", "points"}},
      {"hub", {"radius", "inertia", "torque", "equations", "centrifugal", "friction"}},
      {"hub.torque", {"kind", "amplitude", "duration", "file", "times", "values"}},
      {"hub.friction", {"coulomb"}},
      {"modal", {"frequencies", "damping_ratios", "participation", "inertia"}},
      {"damping", {"viscous", "ratios", "rayleigh"}},
      {"damping.rayleigh", {"mass", "stiffness"}},
      {"forcing", {"kind", "amplitude", "frequency", "phase"}},
      {"gravity", {"acceleration"}},
      {"stop", {"position", "shape", "gap", "side", "restitution", "impulse", "spring"}},
      {"stop.spring",
       {"stiffness", "exponent", "radii", "moduli", "poisson", "angle", "damping", "release"}},
      {"stop.spring.damping",
       {"model", "coefficient", "ratio", "alpha", "restitution", "speed", "mass", "onset",
        "sharpness", "inversion"}},
      {"probe", {"position", "shape", "quantity"}},
      {"initial", {"q", "qdot", "angle", "rate"}},
      {"solver", {"flow", "tolerance", "step"}},
  };
  return keys;
}

// "stop.2.spring" is a "stop.spring", "probe.2" a "probe".
std::string without_number(const std::string& path) {
  for (const std::string list : {"stop.", "probe."}) {
    if (path.compare(0, list.size(), list) != 0) continue;
    const std::size_t end = path.find_first_not_of("0123456789", list.size());
    if (end == list.size()) continue;
    const std::string name = list.substr(0, list.size() - 1);
    return end == std::string::npos ? name : name + path.substr(end);
  }
  return path;
}

}  // namespace

const TableKeys& keys_of(const std::string& path) {
  const std::string table = without_number(path);
  const auto found = std::find_if(all_keys().begin(), all_keys().end(),
                                  [&](const TableKeys& keys) { return keys.table == table; });
  assert(found != all_keys().end());
  return *found;
}

std::string numbered_path(const std::string& name, std::size_t number) {
  return number == 1 ? name : name + "." + std::to_string(number);
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
