// --set NAME=VALUE: a change to the document before any of it is checked.
#pragma once

#include <string>

#include "graze/scene/detail/node.hpp"

namespace graze {

// Replaces or adds the key that `setting` ("NAME=VALUE") names, with the tables above it. VALUE is
// a TOML value or one bare word, which serves as a string. Errors about the value stand at
// "--set NAME=VALUE". Throws InputError when the setting cannot be applied.
void apply_setting(Node& root, const std::string& setting);

}  // namespace graze
