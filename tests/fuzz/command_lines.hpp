// Command lines of the program, drawn from the options that its own --help lists.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fuzz/draw.hpp"

namespace graze {

// What a command line may name: files and folders that are there.
struct Materials {
  std::vector<std::string> scenes;        // sound ones
  std::vector<std::string> measurements;  // pairs of a scene and its data, one after the other
  std::vector<std::string> shares;        // folders of runs with --shard
  std::vector<std::string> runs;          // folders of other runs
};

struct Option {
  std::string name;         // "--impacts"
  std::string placeholder;  // "K|any"; empty for one without a value
};

class CommandLines {
 public:
  // Reads `PROGRAM COMMAND --help` of every command.
  explicit CommandLines(const std::string& program);

  const std::vector<std::string>& commands() const { return commands_; }

  // Words after the program's name. `scene`: the file that the command reads; `folder`: where it
  // may write.
  std::vector<std::string> drawn(const std::string& command, const std::string& scene,
                                 const std::string& folder, const Materials& materials,
                                 Draw& draw) const;

 private:
  std::vector<std::string> commands_;
  std::map<std::string, std::vector<Option>> options_;
};

}  // namespace graze
