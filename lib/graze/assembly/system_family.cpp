#include "graze/assembly/system_family.hpp"

#include <algorithm>

#include "graze/scene/check.hpp"
#include "graze/scene/discrete_matrices.hpp"

namespace graze {
namespace {

// Whether damping couples the modes of a scene's system, there or beside it. Then it counts as
// coupled at all values of its parameters, those among them at which the coupling is zero: orbits
// are of one kind along a branch.
bool couples_modes(const Scene& scene, const std::vector<std::string>& parameters) {
  if (!has_own_matrices(scene)) return false;
  try {
    const ModalModel model = modal_model(scene);
    if (model.coupling.size() > 0) return true;
    return std::any_of(parameters.begin(), parameters.end(), [&](const std::string& name) {
      return !leaves_structure(name) &&
             modal_tangent(scene, model, parameter_direction(scene, name)).coupling.size() > 0;
    });
  } catch (const InputError&) {
    return !discrete_matrices(scene, scene).damping.isZero(0.0);  // without a derivative there
  }
}

void couple(ModalModel& model) {
  if (model.coupling.size() == 0)
    model.coupling = Matrix::Zero(model.omega.size(), model.omega.size());
}

}  // namespace

SystemFamily::SystemFamily(Scene scene, std::string parameter)
    : scene_(std::move(scene)), parameter_(std::move(parameter)) {
  parameter_direction(scene_, parameter_);  // throws for an unknown name
  couples_ = couples_modes(scene_, {parameter_});
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
  return scene ? system_of(*scene) : std::nullopt;
}

std::optional<System> SystemFamily::system_of(const Scene& scene) const {
  try {
    ModalModel model = modal_model(scene);
    if (couples_) couple(model);
    return assemble(scene, model);
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
    parameters_.push_back({{}, 0.0, parameter_direction(scene_, name), {}, {}});
    parameters_.back().numbers = parameter_numbers(scene_, name);
    fixed_model_ = fixed_model_ && leaves_structure(name);
  }
  couples_ = couples_modes(scene_, parameters);
}

const System* SystemCursor::at(std::span<const double> values) {
  bool same = moved_;
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    same = same && parameters_[i].value == values[i];
  if (same) return system_ ? &*system_ : nullptr;
  moved_ = true;
  system_.reset();
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    for (const TiedNumber& tied : parameters_[i].numbers) *tied.number = tied.factor * values[i];
    parameters_[i].value = values[i];
    parameters_[i].tangent.reset();
  }
  try {
    if (!fixed_model_) renew_structure(scene_);
    check_scene(scene_);
    if (!model_ || !fixed_model_) {
      model_ = modal_model(scene_);
      if (couples_) couple(*model_);
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
