// Names that a user may have meant, and lists of names joined for a sentence.
#pragma once

#include <string>
#include <vector>

namespace graze {

// The name closest to `word` (one or two slips of the keyboard, another case, or the beginning or
// the last part of exactly one name), or "" when none is close.
std::string closest_name(const std::string& word, const std::vector<std::string>& names);

// "a", "a or b", "a, b or c" with `last` for "or".
std::string joined(const std::vector<std::string>& words, const std::string& last);

}  // namespace graze
