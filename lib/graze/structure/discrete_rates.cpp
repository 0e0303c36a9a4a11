#include "graze/structure/detail/discrete_rates.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "graze/base/linalg/detail/products.hpp"
#include "graze/scene/discrete_matrices.hpp"
#include "graze/scene/matrix_structure.hpp"

namespace graze {
namespace {

using Eigen::Index;

// Frequencies whose squares are as near as this to each other, relative to the larger, are one.
constexpr double kSame = 1e-9;
// Of the sizes of what it is a difference of: some roundings.
constexpr double kNothing = 1e3 * std::numeric_limits<double>::epsilon();

// The coordinates that nothing holds, in the order of the shapes' rows.
std::vector<Index> free_coordinates(const MatrixModes& modes) {
  std::vector<Index> free(static_cast<std::size_t>(modes.free_count()));
  Index coordinate = 0;
  for (const auto& [label, row] : modes.rows) {
    if (row >= 0) free[static_cast<std::size_t>(row)] = coordinate;
    ++coordinate;
  }
  return free;
}
Matrix free_part(const Matrix& whole, const MatrixModes& modes) {
  const std::vector<Index> free = free_coordinates(modes);
  return whole(free, free);
}

class RatedShapes {
 public:
  RatedShapes(const Scene& scene, const Scene& direction)
      : scene_(scene),
        direction_(direction),
        found_(*scene.discrete()->solved),
        kept_(found_.modes) {
    if (kept_.massless > 0)
      fail("degrees of freedom have no mass, of which modes have no derivative");
    if (kept_.count() < found_.free_count())
      all_ = lowest_modes(structural_matrices(scene, {}), found_.free_count());
    // The lowest are those kept, with the same signs.
    if (all_.count() > 0) all_.shapes.leftCols(kept_.count()) = kept_.shapes;
    const DiscreteMatrices rates = discrete_matrices(scene, direction),
                           own = discrete_matrices(scene, scene);
    rates_ = rates;
    mass_rate_ = free_part(rates.mass, found_);
    damping_rate_ = free_part(rates.damping, found_);
    damping_ = free_part(own.damping, found_);
    stiffness_rate_ = free_part(rates.stiffness, found_);
    mass_ = free_part(own.mass, found_);
    square_ = all().omega.cwiseAbs2();
    turn();
  }

  DiscreteRates rates() const {
    const Index m = kept_.count();
    DiscreteRates of;
    of.omega = Vector::Zero(m);
    of.shapes = shapes_rate_.leftCols(m);
    for (Index j = 0; j < m; ++j) of.omega[j] = omega_rate_[j];
    const Matrix half = kept_.shapes.transpose() * damping_ * of.shapes;
    const Matrix other = of.shapes.transpose() * damping_ * kept_.shapes;
    of.damping = half + other + kept_.shapes.transpose() * damping_rate_ * kept_.shapes;
    for (const auto& [along, inertia] : found_.inertia) {
      const Vector ones = moved_by(along);
      of.inertia[along] =
          of.shapes.transpose() * (mass_ * ones) + kept_.shapes.transpose() * (mass_rate_ * ones);
    }
    add_static_rates(of);
    add_supports(of);
    return of;
  }

 private:
  const StructuralModes& all() const { return all_.count() > 0 ? all_ : kept_; }

  [[noreturn]] void fail(const std::string& why) const {
    throw scene_error(scene_, scene_.structure_name(), "there is no derivative: " + why);
  }

  bool is_same(Index i, Index j) const {
    const Index rigid = all().rigid;
    if (i < rigid || j < rigid) return i < rigid && j < rigid;
    return std::abs(square_[i] - square_[j]) <= kSame * std::max(square_[i], square_[j]);
  }

  void turn() {
    const Matrix& shapes = all().shapes;
    const Index n = shapes.cols();
    const Matrix stiffness = shapes.transpose() * stiffness_rate_ * shapes;
    const Matrix mass = shapes.transpose() * mass_rate_ * shapes;
    const Matrix size =
        shapes.cwiseAbs().transpose() * stiffness_rate_.cwiseAbs() * shapes.cwiseAbs();
    omega_rate_ = Vector::Zero(n);
    Matrix along(n, n);
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i) {
        const double a = stiffness(i, j) - square_[j] * mass(i, j);
        const double rounding = kNothing * (size(i, j) + square_[j] * mass_size(i, j));
        along(i, j) = 0.0;
        if (!is_same(i, j)) {
          along(i, j) = a / (square_[j] - square_[i]);
          continue;
        }
        if (j < all().rigid && std::abs(a) > rounding)
          fail("a free motion begins to be held, its frequency grows like a root");
        if (i != j && std::abs(a) > rounding)
          fail(fmt::format("the modes {} and {} of one frequency turn into each other",
                           std::min(i, j) + 1, std::max(i, j) + 1));
        along(i, j) = -0.5 * mass(i, j);
        if (i == j && j >= all().rigid) omega_rate_[j] = 0.5 * a / all().omega[j];
      }
    shapes_rate_ = product<double>(shapes, along);
  }

  double mass_size(Index i, Index j) const {
    return all().shapes.col(i).cwiseAbs().dot(mass_rate_.cwiseAbs() *
                                              all().shapes.col(j).cwiseAbs());
  }

  // The coordinates that a uniform motion along this direction moves.
  Vector moved_by(int along) const {
    Vector moved = Vector::Zero(mass_.rows());
    for (const auto& [label, row] : found_.rows)
      if (row >= 0 && label.direction == along) moved[row] = 1.0;
    return moved;
  }

  // By all modes: sum phi phi^T/w^2 on the rows of the stops, and under the inertia.
  void add_static_rates(DiscreteRates& of) const {
    const auto stops = static_cast<Index>(scene_.stops.size());
    const Matrix rows = found_.points.leftCols(stops).transpose();
    const Vector& omega = all().omega;
    Vector compliance = Vector::Zero(omega.size()), compliance_rate = compliance;
    for (Index j = all().rigid; j < omega.size(); ++j) {
      compliance[j] = 1.0 / square_[j];
      compliance_rate[j] = -2.0 * omega_rate_[j] / (omega[j] * square_[j]);
    }
    const Matrix seen = rows * all().shapes, seen_rate = rows * shapes_rate_;
    const Matrix turned = seen_rate * compliance.asDiagonal() * seen.transpose();
    of.flexibility =
        turned + turned.transpose() + seen * compliance_rate.asDiagonal() * seen.transpose();
    if (found_.under_gravity.size() == 0) return;
    const Vector ones = moved_by(scene_.matrices() ? scene_.matrices()->direction : 0);
    const Vector load = all().shapes.transpose() * (mass_ * ones);
    const Vector load_rate =
        shapes_rate_.transpose() * (mass_ * ones) + all().shapes.transpose() * (mass_rate_ * ones);
    of.under_gravity =
        seen_rate * compliance.cwiseProduct(load) +
        seen * (compliance_rate.cwiseProduct(load) + compliance.cwiseProduct(load_rate));
  }

  // Of the forces of supports: of the matrices between what they hold and what is free, or of the
  // springs that stand on the ground.
  Matrix support_rate(const HarmonicLoad& load, const MovedSupport& support) const {
    Matrix rate = Matrix::Zero(found_.free_count(), 3);
    const std::vector<Index> free = free_coordinates(found_);
    for (const Index held : support.coordinates) {
      rate.col(0) -= rates_.stiffness(free, held);
      rate.col(1) -= rates_.damping(free, held);
      rate.col(2) -= rates_.mass(free, held);
    }
    if (!scene_.lumped()) return rate;
    const std::array<double, 2> springs = support_of(direction_, load);
    const Index mass = *mass_named(*scene_.lumped(), load.at.node);
    rate(mass, 0) = springs[0];
    rate(mass, 1) = springs[1];
    return rate;
  }

  void add_supports(DiscreteRates& of) const {
    std::size_t next = 0;
    for (const HarmonicLoad* load : scene_.harmonic_loads()) {
      if (load->kind != ForcingKind::kSupport) continue;
      const MovedSupport& support = found_.supports[next++];
      of.supports.push_back(of.shapes.transpose() * support.forces +
                            kept_.shapes.transpose() * support_rate(*load, support));
    }
  }

  const Scene &scene_, &direction_;
  const MatrixModes& found_;
  const StructuralModes& kept_;
  DiscreteMatrices rates_;
  StructuralModes all_;  // empty where those kept are all
  Matrix mass_, damping_, mass_rate_, damping_rate_, stiffness_rate_;
  Vector square_, omega_rate_;
  Matrix shapes_rate_;
};

}  // namespace

DiscreteRates discrete_rates(const Scene& scene, const Scene& direction) {
  return RatedShapes(scene, direction).rates();
}

}  // namespace graze
