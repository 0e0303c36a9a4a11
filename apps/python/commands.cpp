// Commands with their options, read by the reader of the program's own command line.
#include <pybind11/stl.h>

#include <map>
#include <optional>

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

// What the words say. Calls in a loop say the same again, and to read them takes longer than to do
// some of what they say.
Command command_of(const std::vector<std::string>& words) {
  static std::map<std::vector<std::string>, Command> known;
  constexpr std::size_t kMost = 256;
  auto found = known.find(words);
  if (found == known.end()) {
    if (known.size() == kMost) known.clear();
    found = known.emplace(words, reader().read(words)).first;
  }
  Command command = found->second;
  std::visit([](CommonOptions& common) { common.called = std::chrono::steady_clock::now(); },
             command);
  return command;
}

std::shared_ptr<FoundResult> run_words(const std::vector<std::string>& words,
                                       const NamedScene& scene, const py::object& progress,
                                       const std::optional<std::string>& data) {
  Command command = command_of(words);
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
        if constexpr (requires { given.given_data; }) given.given_data = data;
      },
      command);
  return run_in_process(std::move(command), progress);
}

py::list options(const std::string& command) {
  py::list list;
  for (const CommandDescription& known : reader().descriptions())
    for (const OptionDescription& option : known.options)
      if (known.name == command)
        list.append(
            py::make_tuple(option.name, option.what, option.default_value, option.is_flag()));
  return list;
}

}  // namespace

void bind_commands(py::module_& module) {
  module.def("run", run_words);
  // Of commands that take no scene.
  module.def("run_bare", [](const std::vector<std::string>& words) {
    return run_in_process(command_of(words), py::none());
  });
  module.def("options", options);
}

}  // namespace graze
