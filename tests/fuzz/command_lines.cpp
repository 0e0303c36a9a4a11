#include "fuzz/command_lines.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "fuzz/damage.hpp"

namespace graze {
namespace {

std::string printed_by(const std::string& line) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(line.c_str(), "r"), ::pclose);
  if (!pipe) throw std::runtime_error("cannot run " + line);
  std::string text;
  char piece[4096];
  for (std::size_t n = 0; (n = std::fread(piece, 1, sizeof piece, pipe.get())) > 0;)
    text.append(piece, n);
  return text;
}

// Names of the list below "Subcommands:".
std::vector<std::string> listed_commands(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  std::string line;
  std::getline(lines, line);
  for (std::string name; std::getline(lines, line) && std::istringstream(line) >> name;)
    names.push_back(name);
  return names;
}

std::vector<Option> listed_options(const std::string& help) {
  static const std::regex kOption(R"(^  (?:-\w,)?(--[a-z-]+)(?: (\S+))?)");
  std::vector<Option> options;
  std::istringstream lines(help);
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_search(line, found, kOption)) {
      std::string placeholder = found[2];
      // What follows two spaces says what it does; "Excludes:" and the like are no values.
      const bool is_word = line.find(found[1].str() + "  ") != std::string::npos;
      if (is_word || placeholder == "Excludes:" || placeholder == "Needs:") placeholder.clear();
      options.push_back({found[1], placeholder});
    }
  return options;
}

std::string number(Draw& draw) {
  static const std::vector<std::string> kUsual{"1",   "2",    "3",   "5",  "10",  "0.5",
                                               "0.1", "1e-3", "100", "20", "1e4", "0"};
  return draw.once_in(3) ? odd_number(draw) : draw.of(kUsual);
}

std::string parameter_name(Draw& draw) {
  static const std::vector<std::string> kUsual{"stop.gap", "forcing.frequency", "forcing.amplitude",
                                               "stop.restitution"};
  if (!draw.once_in(4)) return draw.of(kUsual);
  static const std::vector<std::string> kNames{"forcing.frequency",
                                               "forcing.amplitude",
                                               "stop.gap",
                                               "stop.restitution",
                                               "damping.viscous",
                                               "beam.length",
                                               "beam.modes",
                                               "beam.youngs_modulus",
                                               "modal.frequencies.1",
                                               "stop.2.gap",
                                               "initial.q.1",
                                               "stop.spring.stiffness",
                                               "stop.spring.damping.coefficient",
                                               "damping.ratios.1",
                                               "title",
                                               "gravity.acceleration",
                                               "hub.inertia",
                                               "nonsense",
                                               "stop.0.gap",
                                               "stop.99999999999.gap",
                                               "",
                                               "forcing",
                                               "probe"};
  return draw.of(kNames);
}

std::string choice_of(const std::string& placeholder, Draw& draw) {
  std::vector<std::string> words;
  const std::size_t open = placeholder.find('{'), close = placeholder.find('}');
  std::istringstream list(placeholder.substr(open + 1, close - open - 1));
  for (std::string word; std::getline(list, word, ',');) words.push_back(word);
  return words.empty() ? "" : draw.of(words);
}

std::string value_of(const Option& option, const std::string& folder, const Materials& materials,
                     Draw& draw) {
  // No program is to be kept busy by its threads alone.
  if (option.name == "--threads") return draw.once_in(4) ? number(draw) : "2";
  if (option.name == "--out") return folder + (draw.once_in(20) ? "/scene.toml" : "/out");
  if (option.name == "--restart") return draw.of(materials.runs);
  if (option.name == "--label") return draw.of<std::string>({"GR1", "PD1", "LP1", "BP1", "x"});
  if (option.name == "--resume") return draw.of(materials.runs);
  if (option.name == "--plot") {
    static const std::vector<std::string> kEnds{".svg", ".png", ".html", ".txt", ""};
    return folder + "/picture" + draw.of(kEnds);
  }
  if (draw.once_in(40)) return draw.of<std::string>({"", "-", "--", "\x1b[31m", "a b", "1:2", "'"});
  if (option.placeholder.find('{') != std::string::npos) return choice_of(option.placeholder, draw);
  if (option.placeholder.starts_with("NAME=LOW"))
    return parameter_name(draw) + "=" + number(draw) + ":" + number(draw);
  if (option.placeholder.find("=VALUE") != std::string::npos)
    return parameter_name(draw) + "=" + number(draw);
  if (option.placeholder.starts_with("NAME")) return parameter_name(draw);
  if (option.placeholder == "k/n") return draw.of<std::string>({"1/2", "2/2", "3/2", "0/0", "1"});
  if (option.placeholder.starts_with("A:B")) return draw.of<std::string>({"1:3", "3:1", "0:9999"});
  return number(draw);
}

// Without these a command only says what is missing.
std::vector<std::string> needed_by(const std::string& command, Draw& draw) {
  static const std::vector<std::vector<std::string>> kRanges{
      {"--parameter", "stop.gap", "--from", "1e-4", "--to", "1.5"},
      {"--parameter", "forcing.frequency", "--from", "1e-3", "--to", "200"},
      {"--parameter", "forcing.amplitude", "--from", "1e-6", "--to", "1"}};
  std::vector<std::string> words;
  const auto add = [&](const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  if (command == "continue" || command == "diagram" || command == "map") add(draw.of(kRanges));
  if (command == "map")
    add({"--second", "stop.restitution", "--second-from", "0.3", "--second-to", "1"});
  if (command == "map" || command == "diagram") add({"--points", "6"});
  if (command == "compare") {
    static const std::vector<std::vector<std::string>> kWhat{
        {"--against", "stop.gap=2e-3"},
        {"--modes", "1:3"},
        {"--sensitivity", "--duration", "1", "--parameter", "stop.gap", "--from", "1e-3", "--to",
         "1"}};
    add(draw.of(kWhat));
  }
  if (command == "simulate" && draw.once_in(2)) add({"--duration", number(draw)});
  return words;
}

}  // namespace

CommandLines::CommandLines(const std::string& program)
    : commands_(listed_commands(printed_by(program + " --help"))) {
  for (const std::string& command : commands_)
    options_[command] = listed_options(printed_by(program + " " + command + " --help"));
}

std::vector<std::string> CommandLines::drawn(const std::string& command, const std::string& scene,
                                             const std::string& folder, const Materials& materials,
                                             Draw& draw) const {
  std::vector<std::string> words{command};
  if (command == "merge") {
    for (std::size_t left = 1 + draw.below(2); left > 0; --left)
      words.push_back(draw.of(materials.shares));
    words.insert(words.end(), {"--out", folder + "/out"});
  } else if (command == "fit" && !draw.once_in(4)) {
    const std::size_t pair = 2 * draw.below(materials.measurements.size() / 2);
    words.push_back(draw.once_in(2) ? scene : materials.measurements[pair]);
    words.push_back(materials.measurements[pair + 1]);
  } else {
    words.push_back(scene);
  }
  const std::vector<std::string> needed = needed_by(command, draw);
  if (!draw.once_in(20)) words.insert(words.end(), needed.begin(), needed.end());
  const std::vector<Option>& options = options_.at(command);
  for (std::size_t left = draw.once_in(2) ? 0 : 1 + draw.below(3); left > 0 && !options.empty();
       --left) {
    const Option& option = draw.of(options);
    if (option.name == "--help" && !draw.once_in(8)) continue;
    // Twice the same is refused; to find that out now and then is enough.
    if (std::find(words.begin(), words.end(), option.name) != words.end() && !draw.once_in(20))
      continue;
    words.push_back(option.name);
    if (!option.placeholder.empty() && !draw.once_in(100))
      words.push_back(value_of(option, folder, materials, draw));
  }
  return words;
}

}  // namespace graze
