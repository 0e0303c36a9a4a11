// A plane of two numbers of a scene in cells: two parameters, or coordinates of its start.
#pragma once

#include <cstddef>
#include <string>

#include "graze/scene/scene.hpp"

namespace graze {

struct PlaneAxis {
  std::string name;  // of a parameter, or "initial.q.1", "initial.qdot.1", ..
  double from = 0.0, to = 0.0;
  int points = 100;  // cells from `from` to `to`, both the middle of one; at least 2

  double value(int i) const;
};

struct Plane {
  PlaneAxis x, y;

  // Row by row: x runs within a row, y from row to row.
  std::size_t cells() const;
  std::size_t cell(int column, int row) const;
  // Values in the middle of a cell.
  double x_at(std::size_t cell) const;
  double y_at(std::size_t cell) const;
};

// Throws InputError for a name that the scene does not have, the same name twice, or an empty
// range.
void require_plane(const Scene& scene, const Plane& plane);

// Throws InputError where the scene does not allow the cell's values.
Scene scene_at(const Scene& scene, const Plane& plane, std::size_t cell);

}  // namespace graze
