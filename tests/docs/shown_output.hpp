// What a page shows of a command's output against what the program prints.
//
// A number shown is the rounding of the number printed to the digits shown; numbers below 1e-12 in
// size, which are rounding, only have to be below it both. How many blanks stand between words does
// not matter. A line ".." stands for any number of lines, and so does " .." at the end of a line
// for the rest of that line.
#pragma once

#include <string>
#include <vector>

namespace graze::support {

// The numbers of a text as they are written.
std::vector<std::string> numbers_in(const std::string& text);

// Whether `shown` is what `printed` becomes when it is rounded to the digits of `shown`; both are
// numbers as they are written.
bool is_rounding(const std::string& shown, const std::string& printed);

// Whether one line of a page shows one line of output.
bool shows_line(const std::string& shown, const std::string& printed);

// Why `shown` does not stand in `printed`, as a sentence; empty where it does. With `from_start`
// the first line shown is the first one printed and the last line the last one; otherwise the lines
// shown stand together anywhere.
std::string difference(const std::vector<std::string>& shown,
                       const std::vector<std::string>& printed, bool from_start);

}  // namespace graze::support
