#include "graze/scene/start_coordinate.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "graze/base/errors.hpp"

namespace graze {
namespace {

bool is_rate(const std::string& name) { return name.starts_with("initial.qdot"); }

}  // namespace

bool names_start_coordinate(const std::string& name) { return name.starts_with("initial."); }

double& start_coordinate(Scene& scene, const std::string& name) {
  const std::string list = is_rate(name) ? "initial.qdot." : "initial.q.";
  char* end = nullptr;
  const long number =
      name.starts_with(list) ? std::strtol(name.c_str() + list.size(), &end, 10) : 0;
  if (number < 1 || number > scene.modes() || *end != '\0')
    throw InputError(fmt::format(
        "{}: the scene has no such number of its start; allowed are initial.q.1..{} and "
        "initial.qdot.1..{}",
        name, scene.modes(), scene.modes()));
  const auto modes = static_cast<std::size_t>(scene.modes());
  if (!scene.initial) scene.initial = Initial{};
  scene.initial->q.resize(modes, 0.0);
  scene.initial->qdot.resize(modes, 0.0);
  std::vector<double>& numbers = is_rate(name) ? scene.initial->qdot : scene.initial->q;
  return numbers[static_cast<std::size_t>(number - 1)];
}

std::string start_coordinate_unit(const std::string& name) {
  return is_rate(name) ? "kg^1/2 m/s" : "kg^1/2 m";
}

}  // namespace graze
