#include "graze/scene/detail/start_coordinate.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "graze/base/errors.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

constexpr const char *kAngle = "initial.angle", *kRate = "initial.rate";

bool is_rate(const std::string& name) { return name.starts_with("initial.qdot"); }

bool is_of_hub(const std::string& name) { return name == kAngle || name == kRate; }

}  // namespace

bool names_start_coordinate(const std::string& name) { return name.starts_with("initial."); }

double& start_coordinate(Scene& scene, const std::string& name) {
  const std::string list = is_rate(name) ? "initial.qdot." : "initial.q.";
  const bool of_hub = is_of_hub(name) && scene.hub;
  char* end = nullptr;
  const long number =
      name.starts_with(list) ? std::strtol(name.c_str() + list.size(), &end, 10) : 0;
  if (!of_hub && (number < 1 || number > scene.modes() || *end != '\0'))
    throw InputError(fmt::format(
        "{}: the scene has no such number of its start; allowed are initial.q.1..{} and "
        "initial.qdot.1..{}{}",
        name, scene.modes(), scene.modes(), scene.hub ? ", initial.angle and initial.rate" : ""));
  const auto modes = static_cast<std::size_t>(scene.modes());
  if (!scene.initial) scene.initial = Initial{};
  scene.initial->q.resize(modes, 0.0);
  scene.initial->qdot.resize(modes, 0.0);
  if (of_hub) return name == kAngle ? scene.initial->angle : scene.initial->rate;
  std::vector<double>& numbers = is_rate(name) ? scene.initial->qdot : scene.initial->q;
  return numbers[static_cast<std::size_t>(number - 1)];
}

std::string start_coordinate_unit(const std::string& name) {
  if (is_of_hub(name)) return name == kAngle ? "rad" : "rad/s";
  return is_rate(name) ? "kg^1/2 m/s" : "kg^1/2 m";
}

Scene with_number(const Scene& scene, const std::string& name, double value) {
  if (!names_start_coordinate(name)) return with_parameter(scene, name, value);
  Scene changed = scene;
  start_coordinate(changed, name) = value;
  return changed;
}

std::string number_unit(const Scene& scene, const std::string& name) {
  if (!names_start_coordinate(name)) return parameter_unit(scene, name);
  Scene copy = scene;
  start_coordinate(copy, name);  // throws for a name that it does not have
  return start_coordinate_unit(name);
}

}  // namespace graze
