// What the shells complete: commands, options, their words, files, and the parameters of the scene
// that is on the line.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace graze {

using Commands = std::vector<CommandDescription>;

std::string bash_completion(const Commands& commands);
std::string zsh_completion(const Commands& commands);
std::string fish_completion(const Commands& commands);

// What a value is, for the shells to look it up.
enum class ValueKind { kAny, kChoice, kCommand, kFile, kScene, kFolder, kParameter, kSetting };
ValueKind value_kind(const OptionDescription& option);

// The first of what an option says of itself, short enough to stand beside it.
std::string in_brief(const std::string& what);

}  // namespace graze
