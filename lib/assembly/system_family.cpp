#include "graze/assembly/system_family.hpp"

#include "graze/scene/check.hpp"
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

SystemCursor::SystemCursor(const SystemFamily& family)
    : scene_(family.scene()),
      direction_(parameter_direction(scene_, family.parameter())),
      number_(find_parameter(scene_, family.parameter())),
      fixed_model_(leaves_structure(family.parameter())) {
  scene_.origins = nullptr;  // the values are not those in the file
}

const System* SystemCursor::at(double value) {
  if (moved_ && *number_ == value) return system_ ? &*system_ : nullptr;
  moved_ = true;
  *number_ = value;
  system_.reset();
  tangent_.reset();
  try {
    check_scene(scene_);
  } catch (const InputError&) {
    return nullptr;
  }
  if (!model_ || !fixed_model_) {
    model_ = modal_model(scene_);
    model_rate_.reset();
  }
  system_ = assemble(scene_, *model_);
  return &*system_;
}

const System* SystemCursor::tangent_at(double value) {
  const System* system = at(value);
  if (system == nullptr) return nullptr;
  if (!tangent_) {
    if (!model_rate_) model_rate_ = modal_tangent(scene_, *model_, direction_);
    tangent_ = system_tangent(scene_, direction_, *model_, *model_rate_, *system);
  }
  return &*tangent_;
}

}  // namespace graze
