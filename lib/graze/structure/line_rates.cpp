#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/products.hpp"
#include "graze/structure/detail/line_forms.hpp"
#include "graze/structure/detail/line_modes.hpp"
#include "graze/structure/detail/moving_supports.hpp"

namespace graze {
namespace {

using Eigen::Index;

// Modes y_j of a line whose numbers change: with C y = 0 of the supports and the reactions l,
// K y + C^T l = w^2 M y, the derivative of which along the modes i of all there are is
//
//   (w_i^2 - w_j^2) y_i.M y_j' = (w_j^2)' [i = j] - coupling_ij,
//   coupling_ij = y_i.(K' - w_j^2 M') y_j + l_i.C' y_j + y_i.C'^T l_j.
//
// The modes span what the supports allow, and what they ask beyond, C y' = -C' y, is added.
class RatedModes {
 public:
  RatedModes(const Line& line, const LineModes& modes)
      : line_(line),
        modes_(modes),
        mesh_(line, modes.mesh.fineness()),
        asked_(modes.unknowns.leftCols(modes.asked)),
        kinetic_(kinetic_form(line, mesh_, true)),
        elastic_(line, mesh_),
        square_(modes.omega.cwiseAbs2()) {}

  LineRatesOrNot rates() {
    if (mesh_.is_torn()) return {{}, {0, 0, true}};
    const Matrix& all = modes_.unknowns;
    const Matrix mass = kinetic_.rate_between(all, asked_);
    Matrix coupling =
        elastic_.rate_between(all, asked_) - mass * square_.head(modes_.asked).asDiagonal();
    add_supports(coupling);
    LineRates rates{Vector::Zero(modes_.asked), {}};
    for (Index j = modes_.rigid; j < modes_.asked; ++j)
      rates.omega[j] = 0.5 * coupling(j, j) / modes_.omega[j];
    Matrix along(all.cols(), modes_.asked);
    for (Index j = 0; j < along.cols(); ++j)
      for (Index i = 0; i < along.rows(); ++i) {
        if (!is_same(i, j)) {
          along(i, j) = coupling(i, j) / (square_[j] - square_[i]);
          continue;
        }
        if (mixes(coupling, i, j))
          return {{}, {static_cast<int>(std::min(i, j)) + 1, static_cast<int>(std::max(i, j)) + 1}};
        along(i, j) = same_frequency(mass, i, j);
      }
    rates.unknowns = product<double>(all, along);
    if (beyond_.size() > 0)
      rates.unknowns += beyond_ - product<double>(all, kinetic_.between(all, beyond_));
    return {rates, {}};
  }

 private:
  // The contribution of moving supports to `coupling`, and to the rates directly.
  void add_supports(Matrix& coupling) {
    const MovingSupports supports(line_, mesh_);
    if (!supports.any_moves()) return;
    const Matrix& all = modes_.unknowns;
    Matrix forces = kinetic_.times(all) * square_.asDiagonal();
    forces -= elastic_.times(all);
    const Matrix reactions = supports.reactions(forces);
    const Matrix moved = supports.moved(all);
    coupling += transposed_product<double>(reactions, moved.leftCols(modes_.asked)) +
                transposed_product<double>(moved, reactions.leftCols(modes_.asked));
    beyond_ = supports.following(moved.leftCols(modes_.asked));
  }

  bool is_same(Index i, Index j) const {
    if (i < modes_.rigid || j < modes_.rigid) return i < modes_.rigid && j < modes_.rigid;
    return std::abs(square_[i] - square_[j]) <= 1e-9 * std::max(square_[i], square_[j]);
  }

  // Whether modes of one frequency turn into each other along the direction.
  bool mixes(const Matrix& coupling, Index i, Index j) const {
    if (i == j || i < modes_.rigid) return false;
    const double own =
        std::abs(coupling(j, j)) + (i < modes_.asked ? std::abs(coupling(i, i)) : 0.0);
    return std::abs(coupling(i, j)) > 1e-7 * own;
  }

  // Modes stay orthonormal; the first rigid motion has no turning, wherever the second turns about.
  double same_frequency(const Matrix& mass, Index i, Index j) const {
    if (i == j) return -0.5 * mass(j, j);
    if (i < modes_.rigid) return i > j ? 0.0 : -mass(i, j);
    return -0.5 * mass(i, j);
  }

  const Line& line_;
  const LineModes& modes_;
  LineMesh mesh_;
  Matrix asked_;
  LineForm kinetic_;
  ElasticForm elastic_;
  Vector square_;  // of the frequencies
  Matrix beyond_;  // unknowns by asked; empty where no support moves
};

}  // namespace

LineRatesOrNot line_rates(const Line& line, const LineModes& modes) {
  return RatedModes(line, modes).rates();
}

LineLoads line_loads(const Line& line, const LineModes& modes, const LineRates* rates) {
  const LineMesh mesh(line, modes.mesh.fineness());
  const bool rated = rates != nullptr;
  const LineMesh::Weights weights = mesh.weights(line);
  const RatedRows inside = mesh.values_inside(rated);
  const Matrix asked = modes.unknowns.leftCols(modes.asked);
  Vector inertia = inside.value.transpose() * weights.mass;
  const Vector length = inside.value.transpose() * weights.length;
  Vector inertia_rate, length_rate;
  if (rated) {
    inertia_rate =
        inside.value.transpose() * weights.mass_rate + inside.rate.transpose() * weights.mass;
    length_rate =
        inside.value.transpose() * weights.length_rate + inside.rate.transpose() * weights.length;
  }
  const RatedRows nodes = mesh.values_at_nodes(rated);
  for (const LineMass& point : line.masses) {
    const auto node = static_cast<Index>(mesh.node(point.x.value));
    inertia += point.mass.value * nodes.value.row(node).transpose();
    if (rated)
      inertia_rate += point.mass.rate * nodes.value.row(node).transpose() +
                      point.mass.value * nodes.rate.row(node).transpose();
  }
  LineLoads loads{asked.transpose() * inertia, asked.transpose() * length, {}, {}};
  if (rated) {
    loads.inertia_rate = asked.transpose() * inertia_rate + rates->unknowns.transpose() * inertia;
    loads.length_rate = asked.transpose() * length_rate + rates->unknowns.transpose() * length;
  }
  return loads;
}

}  // namespace graze
