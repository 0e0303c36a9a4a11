// The rigid supports of a line whose numbers change.
#pragma once

#include <optional>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/structure/detail/line_mesh.hpp"

namespace graze {

// The equations C y = 0 of the supports on the unknowns of the mesh, and their rate C'.
class MovingSupports {
 public:
  MovingSupports(const Line& line, const LineMesh& mesh);

  // Where this is false nothing below may be asked for.
  bool any_moves() const { return across_.has_value(); }
  // C' y of each column.
  Matrix moved(const Matrix& y) const { return rate_ * y; }
  // Reactions l with C^T l = f for each column f that the supports bear; supports by columns.
  Matrix reactions(const Matrix& forces) const;
  // The smallest d with C d = -moved.
  Matrix following(const Matrix& moved) const;

 private:
  const Line& line_;
  const LineMesh& mesh_;
  Matrix rate_;
  // C in units of its own, of the strains and, of the left end, what moves the line as much.
  double unit_ = 1.0;
  Matrix basis_;
  std::optional<LuFactors> across_;
};

}  // namespace graze
