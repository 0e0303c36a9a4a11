// Coordinates x of a line in which its elastic energy, tension included, is |x|^2/2. They exclude
// the unresisted rigid motions: every field of x is orthogonal to these in the mass. line_modes.hpp
// describes how they come about.
#pragma once

#include <Eigen/Cholesky>
#include <optional>

#include "graze/structure/detail/line_conditions.hpp"
#include "graze/structure/detail/line_mesh.hpp"
#include "graze/structure/detail/strain_units.hpp"

namespace graze {

class LineCoordinates {
 public:
  LineCoordinates(const Line& line, const Fineness& fineness);

  const LineMesh& mesh() const { return mesh_; }
  // The compression beyond which the line buckles; nothing else may be asked for when it is
  // reached.
  std::optional<double> critical_compression() const { return critical_; }
  // Rigid motions of unit modal mass, the first a pure translation where it is free; order by
  // count.
  const RigidMotions& rigid() const { return rigid_; }
  // Maps velocities x' to generalised ones: 2 x kinetic energy = |moving x'|^2 + |r'|^2, r' rigid.
  const Matrix& moving() const { return moving_; }
  // Rows on the unknowns y of the mesh become rows on x.
  Matrix rows(const Matrix& on_y) const;
  // The y of each column x.
  Matrix unknowns(const Matrix& x) const;

 private:
  void choose_rigid(const Line& line, const Matrix& kinetic);
  void stretch(const Line& line);
  // Of rows in the strains' own units, before tension.
  Matrix before_tension(const Matrix& scaled) const;

  LineMesh mesh_;
  StrainUnits units_;
  LineConditions conditions_;
  RigidMotions rigid_, turning_;  // turning: the turns on which tension acts
  Matrix carried_;                // rigid motion within each coordinate
  Matrix moving_;
  std::optional<double> critical_;
  std::optional<Eigen::LLT<Matrix>> tension_;  // 1 + T S^T S
};

}  // namespace graze
