// Commands with their options, read by the reader of the program's own command line.
#include <pybind11/stl.h>

#include <algorithm>
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

const char* name_of(OptionKind kind) {
  if (kind == OptionKind::kFlag) return "flag";
  if (kind == OptionKind::kWhole) return "whole";
  return kind == OptionKind::kNumber ? "number" : "word";
}

// With names as keywords have them.
py::list options(const std::string& command) {
  using namespace py::literals;
  py::list list;
  for (const CommandDescription& known : reader().descriptions())
    for (const OptionDescription& option : known.options) {
      if (known.name != command) continue;
      std::string name = option.name;
      std::replace(name.begin(), name.end(), '-', '_');
      list.append(py::dict("name"_a = name, "kind"_a = name_of(option.kind),
                           "what"_a = option.what, "default"_a = option.default_value,
                           "several"_a = option.takes_several, "repeated"_a = option.is_repeated,
                           "placeholder"_a = option.placeholder, "heading"_a = option.heading,
                           "required"_a = option.is_required));
    }
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
