// From TOML text to a tree of nodes.
#pragma once

#include <string>

#include "graze/scene/detail/node.hpp"

namespace graze {

// The text's root table; `name` stands for the file in messages. Throws InputError (key "toml")
// where the text is not TOML.
Node read_document(const std::string& text, const std::string& name);

}  // namespace graze
