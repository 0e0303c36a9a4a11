// Where lines of text may end. Widths are counted in characters, not in bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace graze {

// Characters of a UTF-8 text.
std::size_t width_of(std::string_view text);

// Breaks the text at blanks into at most `most_lines` lines, as narrow as possible; text in
// brackets stays together.
std::vector<std::string> balanced_lines(const std::string& text, std::size_t most_lines);

// Breaks a list after its commas, except those in brackets.
std::vector<std::string> list_lines(const std::string& text);

// Breaks every line of a text that is wider than `most` at blanks. Continued lines are indented to
// the text: behind the "note:" that it begins with, or under its second column. A word that is
// wider than the line is not broken.
std::string wrapped_text(std::string_view text, std::size_t most);

}  // namespace graze
