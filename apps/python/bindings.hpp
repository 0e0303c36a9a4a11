// What the module _core holds, a file each.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "graze/scene/scene.hpp"

namespace graze {

// A scene with what it was read from.
struct NamedScene {
  std::string name;  // file as given, or what stands for it
  std::string text;
  std::vector<std::string> settings;  // "NAME=VALUE"
  std::shared_ptr<const Scene> scene;
};

void bind_errors(pybind11::module_& module);
void bind_scenes(pybind11::module_& module);
void bind_results(pybind11::module_& module);
void bind_commands(pybind11::module_& module);
void bind_continuation(pybind11::module_& module);

}  // namespace graze
