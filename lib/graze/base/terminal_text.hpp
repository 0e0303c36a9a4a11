// Text on its way to a terminal: what comes from files (titles, names of files, values) is shown
// there, never obeyed.
//
// Written as escapes (\x1b, \u009b) are control characters (C0, DEL and C1), bytes that are not
// UTF-8, and the characters that change the direction of writing, end a line or are invisible:
// U+200B to U+200F, U+2028 to U+202E, U+2060 to U+206F, U+FEFF.
#pragma once

#include <string>
#include <string_view>

namespace graze {

// For several lines: line feeds and tabs are kept.
std::string terminal_text(std::string_view text);

// For one line: line feeds and tabs are escaped, too.
std::string terminal_line(std::string_view text);

// A JSON document, in which these characters stand within strings only: there they become \u009b
// and the like, which means the same.
std::string terminal_json(std::string_view json);

}  // namespace graze
