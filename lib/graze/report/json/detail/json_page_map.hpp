// Private to this room. What the page of a map has besides the numbers of its cells: the motions
// that some of them settle on, and the loci over them.
#pragma once

#include "graze/record/detail/map_record.hpp"
#include "graze/report/json/detail/json_page.hpp"

namespace graze {

// Adds what the motions of the map do to `orbits`; the cells that they are of, in their order.
Json cell_motions_json(const MapRecord& record, const Scene& scene, Json& orbits);

// The lines of all loci, by kind, and the points of codimension two; null without any.
Json locus_lines_json(const MapRecord& record);

}  // namespace graze
