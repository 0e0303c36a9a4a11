#include "graze/assembly/system_family.hpp"

#include "graze/scene/check.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {

SystemFamily::SystemFamily(Scene scene, std::string parameter)
    : scene_(std::move(scene)), parameter_(std::move(parameter)) {
  parameter_direction(scene_, parameter_);  // throws for an unknown name
}

double SystemFamily::value() const { return *parameter_value(scene_, parameter_); }

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
  try {
    return assemble(*scene);
  } catch (const InputError&) {
    return {};  // a structure that buckles there
  }
}

std::optional<System> SystemFamily::tangent_at(double value) const {
  const std::optional<Scene> scene = scene_at(value);
  if (!scene) return {};
  return system_tangent(*scene, parameter_);
}

SystemCursor::SystemCursor(const Scene& scene, const std::vector<std::string>& parameters)
    : scene_(scene) {
  scene_.origins = nullptr;  // the values are not those in the file
  for (const std::string& name : parameters) {
    parameters_.push_back({nullptr, parameter_direction(scene_, name), {}, {}});
    parameters_.back().value = find_parameter(scene_, name);
    fixed_model_ = fixed_model_ && leaves_structure(name);
  }
}

const System* SystemCursor::at(std::span<const double> values) {
  bool same = moved_;
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    same = same && *parameters_[i].value == values[i];
  if (same) return system_ ? &*system_ : nullptr;
  moved_ = true;
  system_.reset();
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    *parameters_[i].value = values[i];
    parameters_[i].tangent.reset();
  }
  try {
    check_scene(scene_);
    if (!model_ || !fixed_model_) {
      model_ = modal_model(scene_);
      for (Parameter& parameter : parameters_) parameter.model.reset();
    }
  } catch (const InputError&) {
    return nullptr;
  }
  system_ = assemble(scene_, *model_);
  return &*system_;
}

const System* SystemCursor::tangent_at(std::span<const double> values, std::size_t parameter) {
  const System* system = at(values);
  if (system == nullptr) return nullptr;
  Parameter& by = parameters_[parameter];
  if (!by.tangent) {
    if (!by.model) by.model = modal_tangent(scene_, *model_, by.direction);
    by.tangent = system_tangent(scene_, by.direction, *model_, *by.model, *system);
  }
  return &*by.tangent;
}

}  // namespace graze
