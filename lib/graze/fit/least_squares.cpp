#include "graze/fit/detail/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/fit/detail/jacobian_factors.hpp"
#include "graze/fit/detail/near_minimum.hpp"

namespace graze {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
// Steps of Gauss and Newton; near the minimum a few do.
constexpr int kMostSteps = 30;
// Halvings of one of them.
constexpr int kMostHalvings = 12;
// Where they come to a stand before the minimum, it is sought directly, so often at most.
constexpr int kMostSearches = 2;

class Solver {
 public:
  Solver(const LeastSquaresProblem& problem, const LeastSquaresOptions& options)
      : problem_(problem),
        options_(options),
        counted_([this](const Vector& p) { return evaluate(p); }),
        free_(static_cast<std::size_t>(problem.start.size()), true) {
    result_.parameters = problem.start;
    result_.at_limit.assign(free_.size(), false);
    steps_ = Vector::Zero(problem.start.size());
    for (Eigen::Index j = 0; j < steps_.size(); ++j) {
      const double range = problem.high[j] - problem.low[j];
      // Adjusted before it is used; a hundredth of what is known of the parameter to begin with.
      steps_[j] = 0.01 * (std::isfinite(range) ? range : std::max(std::abs(problem.start[j]), 1.0));
    }
  }

  LeastSquaresResult solve() {
    if (!problem_.linear) approach();
    if (result_.residuals.size() == 0) {
      const std::optional<Vector> residuals = counted_(result_.parameters);
      if (residuals) result_.residuals = *residuals;
    }
    if (result_.residuals.size() == 0)
      result_.end = is_over() ? why_over() : LeastSquaresEnd::kNoValue;
    else
      finish();
    return std::move(result_);
  }

 private:
  std::optional<Vector> evaluate(const Vector& p) {
    if (is_over()) return {};
    ++result_.evaluations;
    if (options_.progress)
      options_.progress(static_cast<double>(result_.evaluations) /
                        static_cast<double>(options_.evaluations));
    return problem_.residuals(p);
  }

  bool is_over() const {
    return result_.evaluations >= options_.evaluations || options_.stop.requested();
  }
  LeastSquaresEnd why_over() const {
    return options_.stop.requested() ? LeastSquaresEnd::kStopped : LeastSquaresEnd::kBudget;
  }

  void approach() {
    NearMinimumOptions near{options_.global, options_.evaluations, [this] { return is_over(); }};
    const NearMinimum found = near_minimum(problem_, counted_, near);
    result_.method = found.method;
    if (found.residuals.size() == 0) return;
    result_.parameters = found.parameters;
    result_.residuals = found.residuals;
  }

  // Gauss and Newton.
  void finish() {
    result_.method += result_.method.empty() ? "linear least squares" : ", then Gauss-Newton";
    result_.end = LeastSquaresEnd::kNotConverged;
    for (int i = 0; i < kMostSteps; ++i) {
      if (!differentiate()) return;
      const Vector step = bounded_step();
      // What one value's noise is worth, or where there is none, the rounding of the derivative.
      const double enough = std::max(kNoiseStep * residual_noise(problem_, result_.residuals),
                                     std::pow(kEps, 2.0 / 3.0) * problem_.size);
      result_.last_step = (result_.jacobian.matrix * step).norm();
      const bool moved = take(step);
      if (result_.last_step <= enough) {
        result_.end = LeastSquaresEnd::kConverged;
        return;
      }
      if (moved) continue;
      if (is_over()) {
        result_.end = why_over();
        return;
      }
      if (searches_ < kMostSearches) {
        search_directly();
      } else {
        // A minimum at a kink: found to a part of the uncertainties, but no derivative of it is
        // zero. One that asks for more than these is none.
        if (result_.last_step <= residual_noise(problem_, result_.residuals))
          result_.end = LeastSquaresEnd::kConverged;
        return;
      }
    }
  }

  void search_directly() {
    if (searches_++ == 0) result_.method += " and Nelder-Mead";
    const double noise = residual_noise(problem_, result_.residuals);
    Vector deviations = noise * result_.jacobian.matrix.colwise().norm().cwiseInverse().transpose();
    for (Eigen::Index j = 0; j < deviations.size(); ++j)
      if (!(deviations[j] > 0.0 && std::isfinite(deviations[j]))) deviations[j] = steps_[j];
    const NearMinimum found =
        simplex_minimum(problem_, counted_, result_.parameters, result_.residuals, deviations,
                        kNoiseStep, [this] { return is_over(); });
    result_.parameters = found.parameters;
    result_.residuals = found.residuals;
  }

  bool differentiate() {
    if (problem_.jacobian) {
      const std::optional<Matrix> matrix = problem_.jacobian(result_.parameters);
      if (matrix) {
        result_.jacobian = {*matrix, Vector::Zero(steps_.size()), 0.0};
        return true;
      }
    }
    const double change =
        std::max(residual_noise(problem_, result_.residuals), std::cbrt(kEps) * problem_.size);
    const std::optional<DifferenceJacobian> jacobian = difference_jacobian(
        counted_, result_.parameters, problem_.low, problem_.high, steps_, change);
    if (!jacobian) {
      result_.end = is_over() ? why_over() : LeastSquaresEnd::kNotConverged;
      return false;
    }
    result_.jacobian = *jacobian;
    steps_ = jacobian->steps;
    return true;
  }

  // Parameters on a limit that the step would take beyond it are held there.
  Vector bounded_step() {
    std::fill(free_.begin(), free_.end(), true);
    const Vector& p = result_.parameters;
    for (;;) {
      Vector step = free_step();
      bool held = false;
      for (Eigen::Index j = 0; j < p.size(); ++j) {
        const bool out = (p[j] <= problem_.low[j] && step[j] < 0.0) ||
                         (p[j] >= problem_.high[j] && step[j] > 0.0);
        if (out && free_[static_cast<std::size_t>(j)]) {
          free_[static_cast<std::size_t>(j)] = false;
          held = true;
        }
      }
      if (held) continue;
      for (std::size_t j = 0; j < free_.size(); ++j) result_.at_limit[j] = !free_[j];
      return step;
    }
  }

  Vector free_step() const {
    std::vector<Eigen::Index> columns;
    for (std::size_t j = 0; j < free_.size(); ++j)
      if (free_[j]) columns.push_back(static_cast<Eigen::Index>(j));
    Vector step = Vector::Zero(steps_.size());
    if (columns.empty()) return step;
    const Matrix part = result_.jacobian.matrix(Eigen::all, columns);
    const Vector found = JacobianFactors(part, result_.jacobian.error).step(result_.residuals);
    for (std::size_t k = 0; k < columns.size(); ++k)
      step[columns[k]] = found[static_cast<Eigen::Index>(k)];
    return step;
  }

  // Along the step, as far as the sum of squares falls; whether it does.
  bool take(const Vector& step) {
    const double before = result_.residuals.squaredNorm();
    double part = 1.0;
    for (int i = 0; i < kMostHalvings; ++i, part *= 0.5) {
      const Vector to =
          (result_.parameters + part * step).cwiseMax(problem_.low).cwiseMin(problem_.high);
      if (to == result_.parameters) return false;
      const std::optional<Vector> residuals = counted_(to);
      if (!residuals) {
        if (is_over()) return false;
        continue;
      }
      if (residuals->squaredNorm() < before) {
        result_.parameters = to;
        result_.residuals = *residuals;
        return true;
      }
    }
    return false;
  }

  const LeastSquaresProblem& problem_;
  const LeastSquaresOptions& options_;
  const Residuals counted_;
  std::vector<bool> free_;
  Vector steps_;
  int searches_ = 0;
  LeastSquaresResult result_;
};

}  // namespace

double residual_noise(const LeastSquaresProblem& problem, const Vector& residuals) {
  if (problem.noise > 0.0) return problem.noise;
  const Eigen::Index freedom = std::max<Eigen::Index>(residuals.size() - problem.start.size(), 1);
  return residuals.norm() / std::sqrt(static_cast<double>(freedom));
}

LeastSquaresResult solve_least_squares(const LeastSquaresProblem& problem,
                                       const LeastSquaresOptions& options) {
  return Solver(problem, options).solve();
}

}  // namespace graze
