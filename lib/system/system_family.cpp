#include "graze/system/system_family.hpp"

#include "graze/scene/parameter.hpp"

namespace graze {

SystemFamily::SystemFamily(Scene scene, std::string parameter)
    : scene_(std::move(scene)), parameter_(std::move(parameter)) {
  parameter_direction(scene_, parameter_);  // throws for an unknown name
}

double SystemFamily::value() const { return *find_parameter(scene_, parameter_); }

std::optional<Scene> SystemFamily::scene_at(double value) const {
  try {
    return with_parameter(scene_, parameter_, value);
  } catch (const InputError&) {
    return {};
  }
}

std::optional<System> SystemFamily::at(double value) const {
  const std::optional<Scene> scene = scene_at(value);
  if (!scene) return {};
  return assemble(*scene);
}

std::optional<System> SystemFamily::tangent_at(double value) const {
  const std::optional<Scene> scene = scene_at(value);
  if (!scene) return {};
  return system_tangent(*scene, parameter_);
}

}  // namespace graze
