#include "graze/structure/detail/line_coordinates.hpp"

#include <cmath>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/products.hpp"
#include "graze/structure/detail/line_forms.hpp"

namespace graze {
namespace {

using Eigen::Index;

RigidMotions shifts_or_turns(const RigidMotions& free, bool turns) {
  std::vector<Index> found;
  for (Index i = 0; i < free.cols(); ++i)
    if ((free.rows() == 2 && free(1, i) != 0.0) == turns) found.push_back(i);
  return free(Eigen::all, found);
}

}  // namespace

LineCoordinates::LineCoordinates(const Line& line, const Fineness& fineness)
    : mesh_(line, fineness),
      units_(line, mesh_),
      conditions_(line, mesh_, units_.scaled(mesh_.values_at_nodes(false).value),
                  line.order == 2 ? units_.scaled(mesh_.slopes_at_nodes(false).value) : Matrix()),
      turning_(line.order, 0) {
  const Matrix kinetic = units_.scaled(kinetic_form(line, mesh_, false).factor());
  choose_rigid(line, kinetic);
  // Rows before what is carried along is known, with nothing carried.
  const Index n = turning_.cols() + conditions_.reduced();
  carried_ = Matrix::Zero(rigid_.cols(), n);
  moving_ = before_tension(kinetic);
  const Matrix rigid_rows = product<double>(kinetic.leftCols(line.order), rigid_);
  carried_ = transposed_product<double>(rigid_rows, moving_);
  moving_ -= product<double>(rigid_rows, carried_);
  if (line.tension.value != 0.0) stretch(line);
  if (tension_) tension_->matrixU().solveInPlace<Eigen::OnTheRight>(moving_);
}

// Rotations on which tension acts are no rigid motions.
void LineCoordinates::choose_rigid(const Line& line, const Matrix& kinetic) {
  rigid_ = conditions_.free();
  if (line.tension.value != 0.0) {
    turning_ = shifts_or_turns(conditions_.free(), true);
    rigid_ = shifts_or_turns(conditions_.free(), false);
  }
  Matrix rows = product<double>(kinetic.leftCols(line.order), rigid_);
  for (Index i = 0; i < rigid_.cols(); ++i) {
    for (int pass = 0; pass < 2; ++pass)
      for (Index k = 0; k < i; ++k) {
        const double along = rows.col(k).dot(rows.col(i));
        rows.col(i) -= along * rows.col(k);
        rigid_.col(i) -= along * rigid_.col(k);
      }
    const double size = rows.col(i).norm();
    rows.col(i) /= size;
    rigid_.col(i) /= size;
  }
}

void LineCoordinates::stretch(const Line& line) {
  const Index turned = turning_.cols(), n = turned + conditions_.reduced();
  // A rigid motion that tension does not resist has no slope, so that nothing of it is carried.
  const Matrix slopes = before_tension(units_.scaled(tension_form(line, mesh_, false).factor()));
  if (line.tension.value < 0.0) {
    const double critical =
        turned > 0 ? 0.0 : 1.0 / std::pow(right_singular_vectors(slopes).values[0], 2.0);
    if (!(-line.tension.value < critical)) {
      critical_ = critical;
      return;
    }
  }
  Matrix stiffness = line.tension.value * transposed_product<double>(slopes, slopes);
  stiffness.diagonal().tail(n - turned).array() += 1.0;
  tension_.emplace(stiffness);
}

Matrix LineCoordinates::before_tension(const Matrix& scaled) const {
  const Index order = mesh_.order();
  Matrix reduced(scaled.rows(), turning_.cols() + conditions_.reduced());
  reduced << product<double>(scaled.leftCols(order), turning_), conditions_.reduced_rows(scaled);
  reduced -= product<double>(product<double>(scaled.leftCols(order), rigid_), carried_);
  return reduced;
}

Matrix LineCoordinates::rows(const Matrix& on_y) const {
  Matrix on_x = before_tension(units_.scaled(on_y));
  if (tension_) tension_->matrixU().solveInPlace<Eigen::OnTheRight>(on_x);
  return on_x;
}

Matrix LineCoordinates::unknowns(const Matrix& x) const {
  Matrix v = x;
  if (tension_) tension_->matrixU().solveInPlace(v);
  const Index turned = turning_.cols();
  Matrix y = conditions_.unknowns_of(v.bottomRows(v.rows() - turned));
  y.topRows(mesh_.order()) += product<double>(turning_, v.topRows(turned)) -
                              product<double>(rigid_, product<double>(carried_, v));
  return units_.unscaled(y);
}

}  // namespace graze
