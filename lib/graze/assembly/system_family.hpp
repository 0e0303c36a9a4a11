// The systems of a scene over one of its parameters.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {

class SystemFamily {
 public:
  // Throws InputError when the scene has no such parameter.
  SystemFamily(Scene scene, std::string parameter);

  const Scene& scene() const { return scene_; }
  const std::string& parameter() const { return parameter_; }
  // The scene's own value of the parameter.
  double value() const;

  // System, and its derivative by the parameter, at a value; nullopt when the scene does not allow
  // that value (a negative length, a stop off the beam).
  std::optional<System> at(double value) const;
  // The system of a scene of the family (scene_at), likewise.
  std::optional<System> system_of(const Scene& scene) const;
  // The scene at that value, likewise.
  std::optional<Scene> scene_at(double value) const;
  std::optional<System> tangent_at(double value) const;

 private:
  Scene scene_;
  std::string parameter_;
  bool couples_ = false;  // modes are coupled by damping, at some values
};

// The systems of a scene one after the other, as a continuation in one or several parameters needs
// them: the parts that do not depend on these are assembled once. For one thread at a time.
class SystemCursor {
 public:
  // Values are in the order of the parameters. Throws InputError when the scene has no such
  // parameter.
  SystemCursor(const Scene& scene, const std::vector<std::string>& parameters);
  explicit SystemCursor(const SystemFamily& family)
      : SystemCursor(family.scene(), {family.parameter()}) {}
  SystemCursor(const SystemCursor&) = delete;
  SystemCursor& operator=(const SystemCursor&) = delete;

  // System, and its derivative by one of the parameters; they hold until other values are asked
  // for. Null where the scene does not allow the values.
  const System* at(std::span<const double> values);
  // The scene at the present values, without places in a file.
  const Scene& scene() const { return scene_; }
  const System* tangent_at(std::span<const double> values, std::size_t parameter);

  // For a family of one parameter.
  const System* at(double value) { return at(std::span(&value, 1)); }
  const System* tangent_at(double value) { return tangent_at(std::span(&value, 1), 0); }

 private:
  struct Parameter {
    std::vector<TiedNumber> numbers;  // in scene_
    double value;                     // set there
    Scene direction;                  // that it moves the scene along
    std::optional<ModalModel> model;  // the structure's derivative, of the present values or of all
    std::optional<System> tangent;    // at the present values, once asked for
  };

  Scene scene_;
  std::vector<Parameter> parameters_;
  bool fixed_model_ = true;          // whatever the values
  bool couples_ = false;             // modes are coupled by damping, at some values
  bool moved_ = false;               // to any values yet
  std::optional<System> system_;     // at the present values; nullopt when they are not allowed
  std::optional<ModalModel> model_;  // of the present values, or of all
};

}  // namespace graze
