// How kinds of things look, told to a page.
#pragma once

#include "graze/report/appearance/looks.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

// Id, title, colour, dashes, width, mark, open and size.
Json look_json(const Look& look);

// What a page shows beside charts: lines of orbits by stability, colours of curves, of a motion
// and of grounds.
Json page_looks();

}  // namespace graze
