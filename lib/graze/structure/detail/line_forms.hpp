// Energies of a line as sums of weighted squares, 2 x energy = sum of w (rows y)^2, and their
// rates.
#pragma once

#include "graze/structure/detail/line_mesh.hpp"

namespace graze {

struct LineForm {
  RatedRows rows;  // the rate is empty where none is asked for
  Vector weight, weight_rate;

  // The rows y' whose squares sum up.
  Matrix factor() const;
  // Form of `modes` (unknowns by any) with `others` (unknowns by any).
  Matrix between(const Matrix& modes, const Matrix& others) const;
  // Its rate at fixed unknowns.
  Matrix rate_between(const Matrix& modes, const Matrix& others) const;
  // Form times `modes`: unknowns by modes.
  Matrix times(const Matrix& modes) const;
};

LineForm kinetic_form(const Line& line, const LineMesh& mesh, bool rates);
// Of springs.
LineForm spring_form(const Line& line, const LineMesh& mesh, bool rates);
// Of 1 N of tension over the rate of its length; of a beam.
LineForm tension_form(const Line& line, const LineMesh& mesh, bool rates);
// Of the strain of the elements, whose rows depend on no length; only its products are formed.
Matrix strain_form_times(const Line& line, const LineMesh& mesh, const Matrix& modes);
Matrix strain_form_rate(const Line& line, const LineMesh& mesh, const Matrix& modes,
                        const Matrix& others);

}  // namespace graze
