#include "graze/continuation/locus/detail/locus_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace graze {
namespace {

// Number of evaluations that are kept, one of which may become a point of the locus: those since
// the last point, at most the iterations of a corrector and the way back.
constexpr std::size_t kRecent = 16;

// A branch point is interpolated over a step of kShortest (1e-6), and misses the branch by less.
constexpr double kOnLocus = 1e-7;

// Number of points in a box, by which their distances are tested together.
constexpr std::size_t kBlock = 32;

Matrix critical_matrix(const ZeroEvaluation& at, double mu) {
  return at.jacobian + (mu - 1.0) * at.closing;
}

Eigen::MatrixXcd critical_matrix(const ZeroEvaluation& at, const Complex& mu) {
  return at.jacobian.cast<Complex>() + (mu - 1.0) * at.closing.cast<Complex>();
}

// Sum of the sizes of all terms in the entries of A(mu).
double size_of_entries(const ZeroEvaluation& at) {
  return std::hypot((at.jacobian - at.closing).norm(), at.closing.norm());
}

// Without conjugation.
Complex product(const ComplexVector& left, const ComplexVector& right) {
  return left.cwiseProduct(right).sum();
}

}  // namespace

Vector LocusEquations::pack(const Vector& u, double first, double angle) const {
  Vector y(u.size() + (is_torus() ? 2 : 1));
  y.head(u.size()) = u;
  y[u.size()] = first / range_;
  if (is_torus()) y[u.size() + 1] = angle;
  return y;
}

double LocusEquations::angle_of(const Vector& y) const {
  if (is_torus()) return y[y.size() - 1];
  return kind_ == LocusKind::kFold ? 0.0 : std::numbers::pi;
}

Complex LocusEquations::multiplier_of(const Vector& y) const {
  if (!is_torus()) return kind_ == LocusKind::kFold ? 1.0 : -1.0;
  return std::polar(1.0, angle_of(y));
}

std::optional<ZeroEvaluation> LocusEquations::evaluate_plane(const Vector& y, double second) {
  ++evaluations_;
  std::optional<ZeroEvaluation> at =
      problem_.evaluate(y.head(size_of(y)), parameters_of(y, second));
  if (!at || !at->residual.allFinite() || !at->jacobian.allFinite() || !at->closing.allFinite())
    return {};
  return at;
}

const Borders& LocusEquations::borders_near(const Vector& y, double second) const {
  const double across = second / second_range_;
  const auto distance = [&](const Anchor& anchor) {
    return std::pow(anchor.second / second_range_ - across, 2) + (anchor.y - y).squaredNorm();
  };
  // The nearest box bounds the distance of the nearest point.
  std::vector<double> to_box(blocks_.size());
  std::size_t start = 0;
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    to_box[block] = blocks_[block].squared_distance(y, across);
    if (to_box[block] <= to_box[start]) start = block;
  }
  const Anchor* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  const auto search = [&](std::size_t block) {
    const std::size_t first = block * kBlock;
    // From the last one: where a locus passes again, the points traced last are meant.
    for (std::size_t i = std::min(anchors_.size(), first + kBlock); i-- > first;) {
      const double here = distance(anchors_[i]);
      if (nearest && !(here < least)) continue;
      least = here;
      nearest = &anchors_[i];
    }
  };
  search(start);
  for (std::size_t block = blocks_.size(); block-- > 0;)
    if (block != start && to_box[block] < least) search(block);
  return nearest->borders;
}

void LocusEquations::Block::add(const Vector& y, double across) {
  if (low.size() == 0) {
    low = high = y;
    low_across = high_across = across;
  }
  low = low.cwiseMin(y);
  high = high.cwiseMax(y);
  low_across = std::min(low_across, across);
  high_across = std::max(high_across, across);
}

double LocusEquations::Block::squared_distance(const Vector& y, double across) const {
  const double beside = std::max({low_across - across, across - high_across, 0.0});
  return beside * beside + (low - y).cwiseMax(y - high).cwiseMax(0.0).squaredNorm();
}

void LocusEquations::add_anchor(Anchor anchor) {
  if (anchors_.size() % kBlock == 0) blocks_.emplace_back();
  blocks_.back().add(anchor.y, anchor.second / second_range_);
  anchors_.push_back(std::move(anchor));
}

void LocusEquations::forget_anchors() {
  anchors_.clear();
  blocks_.clear();
}

void LocusEquations::remember(const Vector& y, double second, Borders borders) {
  if (recent_.size() < kRecent) {
    recent_.push_back({y, second, std::move(borders)});
    return;
  }
  recent_[oldest_] = {y, second, std::move(borders)};
  oldest_ = (oldest_ + 1) % kRecent;
}

bool LocusEquations::start_at(const Vector& y, double second) {
  const std::optional<ZeroEvaluation> at = evaluate_plane(y, second);
  if (!at) return false;
  const Complex mu = multiplier_of(y);
  const double size = size_of_entries(*at);
  if (!(size > 0.0)) return false;
  forget_anchors();
  recent_.clear();
  oldest_ = 0;
  add_anchor({y, second,
              is_torus() ? first_borders<Complex>(critical_matrix(*at, mu), size)
                         : first_borders<double>(critical_matrix(*at, mu.real()), size)});
  return anchors_.front().borders.left.allFinite() && anchors_.front().borders.right.allFinite();
}

void LocusEquations::start_at(const SolutionPoint& point) {
  add(point);
  Anchor here = std::move(anchors_.back());
  forget_anchors();
  add_anchor(std::move(here));
}

void LocusEquations::add(const SolutionPoint& point) {
  const auto is_here = [&](const Anchor& anchor) {
    return anchor.second == point.parameter && anchor.y == point.u;
  };
  auto found = std::find_if(recent_.begin(), recent_.end(), is_here);
  if (found == recent_.end()) {
    if (!evaluate(point.u, point.parameter)) return;
    found = std::find_if(recent_.begin(), recent_.end(), is_here);
  }
  add_anchor(*found);
}

double LocusEquations::turn(const SolutionPoint& from, const SolutionPoint& to) const {
  if (is_torus()) return 0.0;
  const auto found = std::find_if(recent_.begin(), recent_.end(), [&](const Anchor& anchor) {
    return anchor.second == to.parameter && anchor.y == to.u;
  });
  if (found == recent_.end()) return 0.0;
  const Borders& before = borders_near(from.u, from.parameter);
  const double least = std::min(std::abs(before.left.dot(found->borders.left)),
                                std::abs(before.right.dot(found->borders.right)));
  return std::acos(std::min(least, 1.0));
}

bool LocusEquations::is_on_locus(const SolutionPoint& point) {
  const std::optional<ZeroEvaluation> at = evaluate_plane(point.u, point.parameter);
  if (!at) return false;
  const Complex mu = multiplier_of(point.u);
  const double size = size_of_entries(*at);
  const auto test = [&](const auto& matrix) {
    using Scalar = typename std::decay_t<decltype(matrix)>::Scalar;
    return std::abs(BorderedMatrix<Scalar>(matrix, first_borders<Scalar>(matrix, size)).test());
  };
  const double g = is_torus() ? test(Eigen::MatrixXcd(critical_matrix(*at, mu)))
                              : test(Matrix(critical_matrix(*at, mu.real())));
  return g <= kOnLocus;
}

std::optional<LocusEquations::TestRows> LocusEquations::real_rows(const ZeroEvaluation& at,
                                                                  const Vector& y, double second) {
  const double mu = multiplier_of(y).real();
  const Matrix matrix = critical_matrix(at, mu);
  const BorderedMatrix<double> bordered(matrix, borders_near(y, second));
  if (!bordered.finite()) return {};
  const auto slope = problem_.curvature(y.head(size_of(y)), parameters_of(y, second),
                                        {{bordered.left(), bordered.right(), mu}});
  if (!slope) return {};
  remember(y, second, bordered.renewed(size_of_entries(at)));
  const double side = bordered.side();
  return TestRows{Vector::Constant(1, side * bordered.test()),
                  -side * slope->real() / bordered.scale(), Vector::Zero(1)};
}

// With s of M(mu) [s; .] = [closing v(conj mu); 0] and r of M(conj mu)^T [r; .] = [closing^T w; 0],
// M the bordered matrix, a d changes by
//
//   w^T dA(mu) s + r^T dA(conj mu) v(conj mu) - w^T dclosing v(conj mu).
std::optional<LocusEquations::TestRows> LocusEquations::torus_rows(const ZeroEvaluation& at,
                                                                   const Vector& y, double second) {
  const Complex mu = multiplier_of(y), i(0.0, 1.0);
  const Eigen::MatrixXcd matrix = critical_matrix(at, mu), closing = at.closing.cast<Complex>();
  const BorderedMatrix<Complex> bordered(matrix, borders_near(y, second));
  if (!bordered.finite()) return {};
  const ComplexVector &w = bordered.left(), &v = bordered.right();
  const ComplexVector other = v.conjugate();  // v(conj mu)
  const ComplexVector closed = closing * other, s = bordered.solve(closed);
  const ComplexVector r_conjugate = bordered.solve_transposed(closing.transpose() * w.conjugate());
  const auto products = problem_.curvature(
      y.head(size_of(y)), parameters_of(y, second),
      {{w, v, mu}, {w, s, mu}, {r_conjugate, v, mu}, {w, other, 1.0}, {w, other, -1.0}});
  if (!products) return {};
  const double scale = bordered.scale();
  TestRows rows{Vector(2), Matrix(2, products->cols()), Vector(2)};
  rows.value << bordered.test().real(), -product(w, closed).real() / scale;
  rows.slope.row(0) = -products->row(0).real() / scale;
  rows.slope.row(1) = (products->row(1) + products->row(2).conjugate() -
                       0.5 * (products->row(3) - products->row(4)))
                          .real() /
                      scale;
  const Complex by_angle = -i * mu * product(w, closing * v);
  const Complex turned =
      i * mu * product(w, closing * s) + std::conj(i * mu * product(r_conjugate, closing * v));
  rows.by_angle << by_angle.real() / scale, turned.real() / scale;
  remember(y, second, bordered.renewed(size_of_entries(at)));
  return rows;
}

std::optional<ZeroEvaluation> LocusEquations::evaluate(const Vector& y, double second) {
  const std::optional<ZeroEvaluation> at = evaluate_plane(y, second);
  if (!at) return {};
  const std::optional<TestRows> rows =
      is_torus() ? torus_rows(*at, y, second) : real_rows(*at, y, second);
  if (!rows) return {};
  const Eigen::Index n = size_of(y), tests = rows->value.size();
  ZeroEvaluation result{Vector(n + tests), Matrix::Zero(n + tests, n + tests), Vector(n + tests)};
  result.residual << at->residual, rows->value;
  result.jacobian.topLeftCorner(n, n) = at->jacobian;
  result.jacobian.col(n).head(n) = range_ * at->by_parameters.col(0);
  result.jacobian.bottomLeftCorner(tests, n) = rows->slope.leftCols(n);
  result.jacobian.col(n).tail(tests) = range_ * rows->slope.col(n);
  if (is_torus()) result.jacobian.col(n + 1).tail(tests) = rows->by_angle;
  result.by_parameters << at->by_parameters.col(1), rows->slope.col(n + 1);
  return result;
}

std::vector<Eigenvalue> LocusEquations::other_multipliers(const Vector& y, double second,
                                                          ErrorBounds errors) const {
  std::vector<Eigenvalue> list =
      problem_.multipliers(y.head(size_of(y)), parameters_of(y, second), errors);
  const Complex mu = multiplier_of(y);
  if (list.size() < (is_torus() ? 2u : 1u)) return {};
  const auto critical = nearest_to(list, mu);
  const Complex value = critical->value;
  list.erase(critical);
  if (is_torus()) {
    list.erase(nearest_to(list, std::conj(mu)));
  } else if (value.imag() != 0.0) {
    // Next to R1 and R2 rounding makes a pair of the critical multiplier and its neighbour, whose
    // sum is still right: the neighbour is real.
    nearest_to(list, std::conj(value))->value = 2.0 * value.real() - mu.real();
    sort_eigenvalues(list);
  }
  return list;
}

std::optional<std::array<double, 2>> LocusEquations::degeneracies(const SolutionPoint& from,
                                                                  const SolutionPoint& at) {
  const std::optional<ZeroEvaluation> plane = evaluate_plane(at.u, at.parameter);
  if (!plane) return {};
  const double mu = multiplier_of(at.u).real();
  const BorderedMatrix<double> bordered(critical_matrix(*plane, mu),
                                        borders_near(from.u, from.parameter));
  if (!bordered.finite()) return {};
  const Vector w = bordered.left().normalized(), v = bordered.right().normalized();
  const auto slope =
      problem_.curvature(at.u.head(w.size()), parameters_of(at.u, at.parameter), {{w, v, mu}});
  if (!slope) return {};
  return std::array<double, 2>{slope->real().row(0).head(v.size()).dot(v),
                               w.dot(plane->closing * v)};
}

}  // namespace graze
