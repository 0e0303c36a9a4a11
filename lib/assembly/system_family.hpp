// The systems that a scene becomes while one of its parameters varies.
#pragma once

#include <optional>
#include <string>

#include "graze/assembly/assembly.hpp"

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

// The systems of a family one after the other, as a continuation asks for them: what does not
// change with the parameter is assembled once. One thread at a time.
class SystemCursor {
 public:
  explicit SystemCursor(const SystemFamily& family);
  SystemCursor(const SystemCursor&) = delete;
  SystemCursor& operator=(const SystemCursor&) = delete;

  // As those of the family; they hold until the next value is asked for. Null where the scene does
  // not allow the value.
  const System* at(double value);
  const System* tangent_at(double value);

 private:
  Scene scene_, direction_;
  double* number_;  // the parameter in scene_
  bool fixed_model_;
  bool moved_ = false;               // to any value yet
  std::optional<System> system_;     // at the present value; nothing where it is not allowed
  std::optional<System> tangent_;    // once asked for
  std::optional<ModalModel> model_;  // of the present value, or of all
  std::optional<ModalModel> model_rate_;
};

}  // namespace graze
