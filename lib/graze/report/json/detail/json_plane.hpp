// Private to this room. The axes of a plane.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "graze/report/json/detail/json_value.hpp"
#include "graze/study/plane/detail/plane.hpp"

namespace graze {

inline Json axis_json(const PlaneAxis& axis, const std::string& unit) {
  return {{"parameter", axis.name},
          {"unit", unit},
          {"from", axis.from},
          {"to", axis.to},
          {"points", axis.points}};
}

// The cells that a document tells of: those that were run. Of a plane with others the document says
// which they are, `index`, counted from 0 row by row.
template <class Cell>
std::vector<const Cell*> told_cells(const std::vector<Cell>& cells, Json& document) {
  std::vector<const Cell*> told;
  Json index = Json::array();
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i].is_known) {
      told.push_back(&cells[i]);
      index.push_back(i);
    }
  if (told.size() < cells.size()) document["cells"]["index"] = std::move(index);
  return told;
}

}  // namespace graze
