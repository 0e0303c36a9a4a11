#include "graze/structure/detail/line_modes.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/products.hpp"
#include "graze/structure/detail/line_coordinates.hpp"

namespace graze {
namespace {

using Eigen::Index;

// Solves one discretisation.
LineSolution solve(const Line& line, const Fineness& fineness, int asked) {
  LineSolution solution;
  const LineCoordinates coordinates(line, fineness);
  solution.fault.critical_compression = coordinates.critical_compression();
  if (coordinates.critical_compression()) return solution;
  const SingularValues<double> found = right_singular_vectors(coordinates.moving());
  const LineMesh& mesh = coordinates.mesh();
  const Index rigid = coordinates.rigid().cols(), count = rigid + found.values.size();
  LineModes modes{mesh, asked, {}, {}, static_cast<int>(rigid)};
  modes.omega = Vector::Zero(count);
  modes.omega.tail(found.values.size()) = found.values.cwiseInverse();
  modes.unknowns = Matrix::Zero(mesh.unknowns(), count);
  modes.unknowns.block(0, 0, line.order, rigid) = coordinates.rigid();
  modes.unknowns.rightCols(found.values.size()) =
      coordinates.unknowns(found.right * found.values.cwiseInverse().asDiagonal());
  solution.modes = std::move(modes);
  return solution;
}

// Makes the first of value, slope and strain at the left end positive that is not within rounding
// of 0; where all are, the largest value.
void orient(const Line& line, LineModes& modes) {
  const double length = line.length.value;
  const Matrix values =
      product<double>(modes.mesh.values_inside(false).value, modes.unknowns.leftCols(modes.asked));
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
    LineSolution solution = solve(line, fineness, asked);
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
