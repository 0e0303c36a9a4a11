#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/structure/detail/line_conditions.hpp"
#include "graze/structure/detail/line_forms.hpp"
#include "graze/structure/detail/line_modes.hpp"
#include "graze/structure/detail/strain_units.hpp"

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
        springs_(spring_form(line, mesh_, true)),
        square_(modes.omega.cwiseAbs2()) {
    if (line.tension.value != 0.0 || line.tension.rate != 0.0)
      tension_ = tension_form(line, mesh_, true);
  }

  LineRatesOrNot rates() {
    if (mesh_.is_torn()) return {{}, {0, 0, true}};
    const Matrix& all = modes_.unknowns;
    const Matrix mass = kinetic_.rate_between(all, asked_);
    Matrix coupling = elastic_rate() - mass * square_.head(modes_.asked).asDiagonal();
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
    rates.unknowns = all * along;
    if (beyond_.size() > 0) rates.unknowns += beyond_ - all * kinetic_.between(all, beyond_);
    return {rates, {}};
  }

 private:
  Matrix elastic_rate() const {
    const Matrix& all = modes_.unknowns;
    Matrix rate = strain_form_rate(line_, mesh_, all, asked_);
    if (!line_.springs.empty()) rate += springs_.rate_between(all, asked_);
    if (tension_)
      rate += line_.tension.value * tension_->rate_between(all, asked_) +
              line_.tension.rate * tension_->between(all, asked_);
    return rate;
  }

  Matrix elastic_times(const Matrix& modes) const {
    Matrix product = strain_form_times(line_, mesh_, modes);
    if (!line_.springs.empty()) product += springs_.times(modes);
    if (tension_) product += line_.tension.value * tension_->times(modes);
    return product;
  }

  // What moving supports add, and the part of the rates that they ask for.
  void add_supports(Matrix& coupling) {
    std::vector<LineCondition> conditions = conditions_of(line_, mesh_);
    std::erase_if(conditions, [](const LineCondition& one) { return !one.is_rigid(); });
    const auto count = static_cast<Index>(conditions.size());
    RatedRows held{Matrix(count, mesh_.unknowns()), Matrix(count, mesh_.unknowns())};
    const RatedRows values = mesh_.values_at_nodes(true);
    const RatedRows slopes = line_.order == 2 ? mesh_.slopes_at_nodes(true) : values;
    for (Index k = 0; k < count; ++k) {
      const LineCondition& one = conditions[static_cast<std::size_t>(k)];
      const RatedRows& from = one.on_slope ? slopes : values;
      const double scale = one.on_slope ? line_.length.value : 1.0;
      held.value.row(k) = scale * from.value.row(static_cast<Index>(one.node));
      held.rate.row(k) = scale * from.rate.row(static_cast<Index>(one.node));
    }
    if (count == 0 || held.rate.isZero(0.0)) return;
    const StrainUnits units(line_, mesh_);
    const Matrix& all = modes_.unknowns;
    // Rows in units of their own: of the strains, and of the left end what moves the line as much.
    Matrix rows = units.scaled(held.value);
    const Index order = line_.order;
    const double unit = rows.rightCols(rows.cols() - order).norm() / rows.leftCols(order).norm();
    rows.leftCols(order) *= unit;
    const Matrix basis = orthonormal_columns<double>(rows.transpose(), count);
    const LuFactors across((basis.transpose() * rows.transpose()).eval());
    Matrix forces = kinetic_.times(all) * square_.asDiagonal();
    forces -= elastic_times(all);
    Matrix left = units.scaled(forces.transpose());
    left.leftCols(order) *= unit;
    const Matrix reactions = across.solve_columns((left * basis).transpose());
    const Matrix moved = held.rate * all;
    coupling += reactions.transpose() * moved.leftCols(modes_.asked) +
                moved.transpose() * reactions.leftCols(modes_.asked);
    Matrix asked(count, modes_.asked);
    for (Index j = 0; j < asked.cols(); ++j) asked.col(j) = -across.solve_transposed(moved.col(j));
    Matrix beyond = basis * asked;
    beyond.topRows(order) *= unit;
    beyond_ = units.unscaled(beyond);
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
  LineForm kinetic_, springs_;
  std::optional<LineForm> tension_;
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
