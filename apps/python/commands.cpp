// Commands with their options, read by the reader of the program's own command line.
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "command.hpp"
#include "in_process.hpp"

namespace graze {
namespace {

namespace py = pybind11;

// The same for all calls: to make one takes longer than most simulations. Used under the
// interpreter's lock.
CommandReader& reader() {
  static CommandReader only;
  return only;
}

std::shared_ptr<FoundResult> run_words(std::vector<std::string> words, const NamedScene& scene,
                                       const py::object& progress) {
  Command command = reader().read(words);
  std::visit(
      [&](auto& given) {
        if constexpr (requires { given.given; }) {
          given.scene = scene.name;
          given.given = scene.scene;
          given.settings = scene.settings;
          if (given.arguments.size() > 1) given.arguments[1] = scene.name;
          for (const std::string& setting : scene.settings)
            given.arguments.push_back("--set=" + setting);
        }
      },
      command);
  return run_in_process(std::move(command), progress);
}

py::list options(const std::string& command) {
  py::list list;
  for (const CommandReader::Option& option : reader().options(command))
    list.append(py::make_tuple(option.name, option.what, option.default_value, option.is_flag));
  return list;
}

}  // namespace

void bind_commands(py::module_& module) {
  module.def("run", run_words);
  module.def("options", options);
}

}  // namespace graze
