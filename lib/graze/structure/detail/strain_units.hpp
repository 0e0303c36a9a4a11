// Strains of a mesh in units in which the elastic energy of an element is |z|^2/2: c = L^-T z with
// L L^T the element's matrix of the stiffness.
#pragma once

#include <vector>

#include "graze/structure/detail/line_mesh.hpp"

namespace graze {

class StrainUnits {
 public:
  StrainUnits(const Line& line, const LineMesh& mesh);

  // Rows on the unknowns y become rows on (motion of the left end, z).
  Matrix scaled(Matrix rows) const;
  // (motion of the left end, z) becomes y.
  Matrix unscaled(Matrix y) const;

 private:
  Eigen::Index order_;
  std::vector<Matrix> upper_;  // L^T of each element
};

}  // namespace graze
