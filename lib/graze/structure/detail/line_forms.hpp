// Energies of a line as sums of weighted squares, 2 x energy = sum of w (rows y)^2, and their
// rates.
#pragma once

#include <optional>

#include "graze/structure/detail/line_mesh.hpp"

namespace graze {

struct LineForm {
  RatedRows rows;  // the rate is empty where none is asked for
  Vector weight, weight_rate;

  // The rows y' whose squares sum up.
  Matrix factor() const;
  // Form of `modes` (unknowns by any) with `others` (unknowns by any).
  Matrix between(const Matrix& modes, const Matrix& others) const;
  // The rate of that form at fixed unknowns.
  Matrix rate_between(const Matrix& modes, const Matrix& others) const;
  // Form times `modes`: unknowns by modes.
  Matrix times(const Matrix& modes) const;
};

LineForm kinetic_form(const Line& line, const LineMesh& mesh, bool rates);
// The energy of 1 N of tension in a beam.
LineForm tension_form(const Line& line, const LineMesh& mesh, bool rates);

// The whole elastic energy: strains, springs and tension, with rates. Refers to both arguments.
class ElasticForm {
 public:
  ElasticForm(const Line& line, const LineMesh& mesh);

  Matrix times(const Matrix& modes) const;
  Matrix rate_between(const Matrix& modes, const Matrix& others) const;

 private:
  const Line& line_;
  const LineMesh& mesh_;
  LineForm springs_;
  std::optional<LineForm> tension_;
};

}  // namespace graze
