// Texts that are nearly right: what others wrote, with a few places changed.
#pragma once

#include <string>

#include "fuzz/draw.hpp"

namespace graze {

// A number as a scene or an option may give it: of everyday size, at the ends of what a double
// holds, or none.
std::string odd_number(Draw& draw);

// The text with one or two numbers of another size: sound, and absurd as a rule.
std::string stretched(std::string text, Draw& draw);

// The text with one to four numbers, lines or bytes changed, doubled or left out.
std::string damaged(std::string text, Draw& draw);

}  // namespace graze
