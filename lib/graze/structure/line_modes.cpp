#include "graze/structure/detail/line_modes.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/structure/detail/line_conditions.hpp"
#include "graze/structure/detail/line_forms.hpp"
#include "graze/structure/detail/strain_units.hpp"

namespace graze {
namespace {

using Eigen::Index;

// The free rigid motions of unit modal mass, the first without turning where it is free to, and
// their rows.
struct RigidPart {
  Matrix motions, rows;
};

RigidPart rigid_part(const RigidMotions& free, const Matrix& kinetic) {
  RigidPart part{free, kinetic.leftCols(free.rows()) * free};
  for (Index i = 0; i < free.cols(); ++i) {
    for (int pass = 0; pass < 2; ++pass)
      for (Index k = 0; k < i; ++k) {
        const double along = part.rows.col(k).dot(part.rows.col(i));
        part.rows.col(i) -= along * part.rows.col(k);
        part.motions.col(i) -= along * part.motions.col(k);
      }
    const double size = part.rows.col(i).norm();
    part.rows.col(i) /= size;
    part.motions.col(i) /= size;
  }
  return part;
}

// One discretisation.
class LineProblem {
 public:
  LineProblem(const Line& line, const Fineness& fineness)
      : line_(line),
        mesh_(line, fineness),
        units_(line, mesh_),
        conditions_(
            line, mesh_, units_.scaled(mesh_.values_at_nodes(false).value),
            line.order == 2 ? units_.scaled(mesh_.slopes_at_nodes(false).value) : Matrix()) {}

  LineSolution solve(int asked) const;

 private:
  // Turns on which tension acts are no rigid motions.
  RigidMotions unresisted() const {
    return line_.tension.value == 0.0 ? conditions_.free() : shifts();
  }
  RigidMotions turns() const {
    const RigidMotions& free = conditions_.free();
    std::vector<Index> found;
    for (Index i = 0; i < free.cols(); ++i)
      if (free.rows() == 2 && free(1, i) != 0.0) found.push_back(i);
    return free(Eigen::all, found);
  }
  RigidMotions shifts() const {
    const RigidMotions& free = conditions_.free();
    std::vector<Index> found;
    for (Index i = 0; i < free.cols(); ++i)
      if (free.rows() == 1 || free(1, i) == 0.0) found.push_back(i);
    return free(Eigen::all, found);
  }

  const Line& line_;
  LineMesh mesh_;
  StrainUnits units_;
  LineConditions conditions_;
};

LineSolution LineProblem::solve(int asked) const {
  LineSolution solution;
  const Matrix kinetic = units_.scaled(kinetic_form(line_, mesh_, false).factor());
  const RigidPart rigid = rigid_part(unresisted(), kinetic);
  const bool tensioned = line_.tension.value != 0.0;
  const RigidMotions turning = tensioned ? turns() : RigidMotions(line_.order, 0);
  const Index turned = turning.cols(), n = turned + conditions_.reduced();
  const auto on_coordinates = [&](const Matrix& rows) {
    Matrix reduced(rows.rows(), n);
    reduced << rows.leftCols(line_.order) * turning, conditions_.reduced_rows(rows);
    return reduced;
  };
  Matrix moving = on_coordinates(kinetic);
  const Matrix carried = rigid.rows.transpose() * moving;  // rigid motion within each coordinate
  moving.noalias() -= rigid.rows * carried;
  std::optional<Eigen::LLT<Matrix>> factor;
  if (tensioned) {
    const Matrix slopes = on_coordinates(units_.scaled(tension_form(line_, mesh_, false).factor()));
    if (line_.tension.value < 0.0) {
      const double critical =
          turned > 0 ? 0.0 : 1.0 / std::pow(right_singular_vectors(slopes).values[0], 2.0);
      if (!(-line_.tension.value < critical)) {
        solution.fault.critical_compression = critical;
        return solution;
      }
    }
    Matrix stiffness = line_.tension.value * (slopes.transpose() * slopes);
    stiffness.diagonal().tail(n - turned).array() += 1.0;
    factor.emplace(stiffness);
    factor->matrixU().solveInPlace<Eigen::OnTheRight>(moving);
  }
  const SingularValues<double> found = right_singular_vectors(moving);
  LineModes modes{mesh_, asked, {}, {}, static_cast<int>(rigid.motions.cols())};
  const Index count = modes.rigid + found.values.size();
  modes.omega = Vector::Zero(count);
  modes.omega.tail(found.values.size()) = found.values.cwiseInverse();
  Matrix v = found.right * found.values.cwiseInverse().asDiagonal();
  if (factor) factor->matrixU().solveInPlace(v);
  Matrix y = conditions_.unknowns_of(v.bottomRows(n - turned));
  y.topRows(line_.order) += turning * v.topRows(turned) - rigid.motions * (carried * v);
  modes.unknowns = Matrix::Zero(mesh_.unknowns(), count);
  modes.unknowns.block(0, 0, line_.order, modes.rigid) = rigid.motions;
  modes.unknowns.rightCols(found.values.size()) = units_.unscaled(y);
  solution.modes = std::move(modes);
  return solution;
}

// What the left end is free to do is positive there: the first of value, slope and strain that is
// not within rounding of 0; where all are, the largest value.
void orient(const Line& line, LineModes& modes) {
  const double length = line.length.value;
  const Matrix values =
      modes.mesh.values_inside(false).value * modes.unknowns.leftCols(modes.asked);
  const Matrix ends[] = {modes.mesh.row(0.0, 0).transpose() * modes.unknowns,
                         modes.mesh.row(0.0, 1).transpose() * modes.unknowns * length,
                         line.order == 2 ? Matrix(modes.mesh.row(0.0, 2).transpose() *
                                                  modes.unknowns * length * length)
                                         : Matrix::Zero(1, modes.unknowns.cols())};
  for (Index j = 0; j < modes.asked; ++j) {
    Index largest = 0;
    const double size = values.col(j).cwiseAbs().maxCoeff(&largest);
    double sign = values(largest, j);
    for (const Matrix& end : ends)
      if (std::abs(end(0, j)) > 1e-6 * size) {
        sign = end(0, j);
        break;
      }
    if (sign < 0.0) modes.unknowns.col(j) *= -1.0;
  }
}

double largest_change(const Vector& before, const Vector& now, Index first, Index last) {
  double change = 0.0;
  for (Index j = first; j < last; ++j)
    if (now[j] > 0.0) change = std::max(change, std::abs(before[j] / now[j] - 1.0));
  return change;
}

}  // namespace

LineSolution line_modes(const Line& line, int asked) {
  // Degrees of the field before and after the step of the order, and how many unknowns are too
  // many.
  constexpr int kLow = 20, kHigh = 24, kMostUnknowns = 3000;
  const double half_waves = asked > 2 * kWellResolved ? 7.0 : 5.0;
  Fineness fineness{kLow - line.order + 1, asked, half_waves, 0};
  std::optional<Vector> before;
  for (bool first = true;; first = false) {
    const LineProblem problem(line, fineness);
    LineSolution solution = problem.solve(asked);
    if (!solution.modes) return solution;
    LineModes& modes = *solution.modes;
    const bool enough = modes.omega.size() >= asked;
    if (before && enough) {
      const Index well = std::min(asked, kWellResolved);
      modes.change = largest_change(*before, modes.omega, 0, well);
      modes.change_beyond = largest_change(*before, modes.omega, well, asked);
      if (modes.change <= 1e-10 && modes.change_beyond <= 1e-6) {
        orient(line, modes);
        return solution;
      }
    }
    before = enough ? std::optional<Vector>(modes.omega) : std::nullopt;
    fineness.functions = kHigh - line.order + 1;
    if (!first) ++fineness.halvings;
    if (!first && 2 * modes.mesh.unknowns() > kMostUnknowns) {
      LineSolution none;
      none.fault.unresolved = true;
      return none;
    }
  }
}

}  // namespace graze
