// The systems that a scene becomes while one of its parameters varies.
#pragma once

#include <optional>
#include <string>

#include "graze/system/system.hpp"

namespace graze {

class SystemFamily {
 public:
  // Throws InputError when the scene has no such parameter.
  SystemFamily(Scene scene, std::string parameter);

  const Scene& scene() const { return scene_; }
  const std::string& parameter() const { return parameter_; }
  // The scene's own value of the parameter.
  double value() const;

  // System, and its derivative by the parameter, at a value; nothing where the scene does not allow
  // that value (a negative length, a stop off the beam).
  std::optional<System> at(double value) const;
  std::optional<System> tangent_at(double value) const;

 private:
  std::optional<Scene> scene_at(double value) const;

  Scene scene_;
  std::string parameter_;
};

}  // namespace graze
