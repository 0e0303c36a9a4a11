// How kinds of things look, told to a page.
#pragma once

#include "graze/report/appearance/looks.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

// Id, title, colour, dashes, width, mark, open and size.
Json look_json(const Look& look);

// All kinds that a page may show: lines of branches in the order of LineKind, special points by
// label, loci, dots by id, colours of curves, of a motion and of grounds.
Json page_looks();

}  // namespace graze
