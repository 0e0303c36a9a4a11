// Linear conditions that supports and springs impose on the unknowns of a line (line_modes.hpp).
#pragma once

#include <vector>

#include "graze/structure/detail/line_mesh.hpp"

namespace graze {

// One equation: the value or slope at a node is zero, or equals the deflection of a spring.
struct LineCondition {
  std::size_t node = 0;
  double x = 0.0;
  bool on_slope = false;
  double flexibility = -1.0;  // 1/sqrt(stiffness) of a spring, negative without one

  bool is_rigid() const { return flexibility < 0.0; }
};

// Supports, each place and kind once, then springs.
std::vector<LineCondition> conditions_of(const Line& line, const LineMesh& mesh);

// A rigid motion a + b x, as (a, b); of a line of order 1 (a).
using RigidMotions = Matrix;  // order by count

// Elimination of the conditions: y = E z + F r, where z = H (0, v) holds the scaled strains of the
// mesh and then the springs' own unknowns.
class LineConditions {
 public:
  // `scaled`: rows of the field's values at the nodes and of its slopes (order 2), on the rigid
  // motions and the scaled strains z.
  LineConditions(const Line& line, const LineMesh& mesh, const Matrix& values,
                 const Matrix& slopes);

  // Rigid motions that no condition holds.
  const RigidMotions& free() const { return free_; }
  Eigen::Index reduced() const { return unknowns_ - reflectors_.cols(); }
  // Rows on (rigid motions, z of the mesh) become rows on v.
  Matrix reduced_rows(const Matrix& rows) const;
  // v of each column becomes (rigid motions, z of the mesh), without the free rigid motions.
  Matrix unknowns_of(const Matrix& v) const;

 private:
  void choose_rigid(const Line& line, const std::vector<LineCondition>& all);
  void reflect(Matrix normals);

  Eigen::Index order_ = 2, unknowns_ = 0, springs_ = 0;
  RigidMotions free_, held_;
  Matrix follow_;      // rigid motions from z
  Matrix reflectors_;  // unit vectors, a column each
};

}  // namespace graze
