// Where lines of text may end. Widths are counted in characters, not in bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace graze {

// Characters of a UTF-8 text.
std::size_t width_of(std::string_view text);

// At blanks into at most so many lines, as narrow as they can be; what stands in brackets stays
// together.
std::vector<std::string> balanced_lines(const std::string& text, std::size_t most_lines);

// A list after its commas, but for those in brackets.
std::vector<std::string> list_lines(const std::string& text);

// Every line of a text that is wider than `most` broken at blanks. What goes on below a line stands
// below its text: behind the "note:" that it begins with, or under its second column. A word that
// is wider than the line stays in one piece.
std::string wrapped_text(std::string_view text, std::size_t most);

}  // namespace graze
