// What a text must be before the TOML parser sees it.
#pragma once

#include <cstddef>
#include <string>

namespace graze {

// A scene of 400 modes with every list written out needs less than 0.1 MiB.
inline constexpr std::size_t kLargestText = 16 * 1024 * 1024;

// Throws InputError (key "toml") unless the text is plain UTF-8 of at most kLargestText bytes, with
// nothing that toml++ 3.3 has no defined answer to. Outside strings and comments, characters beyond
// ASCII, headers without a name and mismatched brackets run into its "unreachable" branches;
// endless nesting runs its recursion (even that of the destructors) off the stack.
void check_text(const std::string& text, const std::string& name);

}  // namespace graze
