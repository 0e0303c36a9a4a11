// Scenes: read, changed by the names of their parameters, looked into.
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "graze/record/file/files.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

namespace py = pybind11;

NamedScene loaded(const std::string& file, const std::vector<std::string>& settings) {
  const py::gil_scoped_release release;
  const auto scene = std::make_shared<const Scene>(read_scene(file, settings));
  constexpr std::size_t kLargest = std::size_t{1} << 30;  // read_scene takes none as large
  return {file, read_file(file, kLargest), settings, scene};
}

NamedScene parsed(const std::string& text, const std::string& name,
                  const std::vector<std::string>& settings) {
  const py::gil_scoped_release release;
  return {name, text, settings, std::make_shared<const Scene>(parse_scene(text, name, settings))};
}

NamedScene changed(const NamedScene& before, const std::vector<std::string>& settings) {
  std::vector<std::string> all = before.settings;
  all.insert(all.end(), settings.begin(), settings.end());
  return parsed(before.text, before.name, all);
}

py::dict parameters(const Scene& scene) {
  py::dict values;
  for (const std::string& name : parameter_names(scene))
    if (const std::optional<double> value = parameter_value(scene, name))
      values[py::str(name)] = *value;
  return values;
}

}  // namespace

void bind_scenes(py::module_& module) {
  py::class_<NamedScene>(module, "NamedScene")
      .def("changed", changed)
      .def_readonly("name", &NamedScene::name)
      .def_readonly("settings", &NamedScene::settings)
      .def_property_readonly("title", [](const NamedScene& self) { return self.scene->title; })
      .def_property_readonly("text",
                             [](const NamedScene& self) { return write_scene(*self.scene); })
      .def("value", [](const NamedScene& self,
                       const std::string& name) { return parameter_value(*self.scene, name); })
      .def("unit", [](const NamedScene& self,
                      const std::string& name) { return parameter_unit(*self.scene, name); })
      .def("parameters", [](const NamedScene& self) { return parameters(*self.scene); })
      .def_property_readonly("modes", [](const NamedScene& self) { return self.scene->modes(); })
      .def_property_readonly("is_forced",
                             [](const NamedScene& self) { return self.scene->forcing.has_value(); })
      .def_property_readonly("stops",
                             [](const NamedScene& self) { return self.scene->stops.size(); });
  module.def("load_scene", loaded);
  module.def("parse_scene", parsed);
}

}  // namespace graze
