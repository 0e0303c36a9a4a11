#include "graze/fit/detail/least_squares.hpp"

#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/fit/detail/jacobian_factors.hpp"
#include "graze/fit/detail/near_minimum.hpp"

namespace graze {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
// Largest number of direct searches for the minimum, where Gauss-Newton steps stall before it.
constexpr int kMostSearches = 2;

class BoundedSolver : private ceres::CostFunction, private ceres::IterationCallback {
 public:
  BoundedSolver(const LeastSquaresProblem& problem, const LeastSquaresOptions& options)
      : problem_(problem),
        options_(options),
        counted_([this](const Vector& p) { return evaluate(p); }) {
    result_.parameters = problem.start;
    result_.at_limit.assign(static_cast<std::size_t>(problem.start.size()), false);
    steps_ = Vector::Zero(problem.start.size());
    for (Eigen::Index j = 0; j < steps_.size(); ++j) {
      const double range = problem.high[j] - problem.low[j];
      // Adjusted before it is used; initially a hundredth of the parameter's range or size.
      steps_[j] = 0.01 * (std::isfinite(range) ? range : std::max(std::abs(problem.start[j]), 1.0));
    }
    units_ = steps_.unaryExpr([](double step) { return std::ldexp(1.0, std::ilogb(step)); });
  }

  LeastSquaresResult solve() {
    if (!problem_.linear) approach();
    if (result_.residuals.size() == 0)
      result_.residuals = counted_(result_.parameters).value_or(Vector());
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

  // Finishes by Gauss-Newton steps.
  void finish() {
    result_.method += result_.method.empty() ? "linear least squares" : ", then Gauss-Newton";
    for (; !descend(); search_directly()) {
      result_.end = is_over() ? why_over() : LeastSquaresEnd::kNotConverged;
      if (is_over() || result_.jacobian.matrix.size() == 0) return;
      if (searches_ < kMostSearches) continue;
      // A minimum at a kink is found to a part of the uncertainties, but its derivative is not
      // zero. If the remaining step exceeds these, it is no minimum.
      if (result_.last_step > residual_noise(problem_, result_.residuals)) return;
      break;
    }
    result_.end = LeastSquaresEnd::kConverged;
  }

  // Takes Ceres' steps; returns whether they lead to the minimum.
  bool descend() {
    is_last_ = false;
    tried_ = result_.parameters;
    tried_residuals_ = result_.residuals;
    Vector p = tried_.cwiseQuotient(units_);
    set_num_residuals(static_cast<int>(tried_residuals_.size()));
    *mutable_parameter_block_sizes() = {static_cast<int>(p.size())};
    ceres::Problem squares({.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP});
    squares.AddResidualBlock(this, nullptr, p.data());
    for (int j = 0; j < p.size(); ++j) {
      squares.SetParameterLowerBound(p.data(), j, problem_.low[j] / units_[j]);
      squares.SetParameterUpperBound(p.data(), j, problem_.high[j] / units_[j]);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.callbacks = {this};
    // Gauss-Newton steps, without directions of less than 1e-5 of a column's length, which
    // differences cannot resolve, and halved where the sum does not fall.
    options.initial_trust_region_radius = problem_.linear ? 1.0 / kEps : 1e10;
    options.min_lm_diagonal = options.min_line_search_step_size = 1e-200;
    options.line_search_interpolation_type = ceres::BISECTION;
    options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0.0;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &squares, &summary);
    return is_last_;
  }

  // Ceres requires a constant functor, but evaluations are counted and kept on the way.
  bool Evaluate(double const* const* at, double* residuals, double** derivative) const override {
    return const_cast<BoundedSolver*>(this)->try_at(
        Eigen::Map<const Vector>(at[0], steps_.size()).cwiseProduct(units_), residuals, derivative);
  }

  // The residuals and, only when Ceres has accepted the step, their derivative: zero, which ends
  // the iteration, after the last step and where it does not exist.
  bool try_at(const Vector& p, double* residuals, double** derivative) {
    if (p != tried_) {
      const std::optional<Vector> found = counted_(p);
      if (!found || !found->allFinite()) return false;
      tried_ = p;
      tried_residuals_ = *found;
    }
    const Eigen::Index m = tried_residuals_.size(), n = p.size();
    Eigen::Map<Vector>(residuals, m) = tried_residuals_;
    if (derivative == nullptr) return true;
    result_.parameters = tried_;
    result_.residuals = tried_residuals_;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor>(derivative[0], m, n) =
        !is_last_ && differentiate() ? inward_derivative() : Matrix::Zero(m, n);
    return true;
  }

  // The derivative without parameters on a limit beyond which the sum would fall.
  Matrix inward_derivative() {
    Matrix inward = result_.jacobian.matrix;
    const Vector gradient = inward.transpose() * result_.residuals;
    for (Eigen::Index j = 0; j < gradient.size(); ++j) {
      const double limit = gradient[j] > 0.0 ? problem_.low[j] : problem_.high[j];
      const bool held = result_.parameters[j] == limit;
      if (held) inward.col(j).setZero();
      result_.at_limit[static_cast<std::size_t>(j)] = held;
    }
    const JacobianFactors factors(inward, result_.jacobian.error);
    result_.last_step = (inward * factors.step(result_.residuals)).norm();
    // Compared with the noise of one value or, without noise, with the rounding of the derivative.
    is_last_ =
        result_.last_step <= std::max(kNoiseStep * residual_noise(problem_, result_.residuals),
                                      std::pow(kEps, 2.0 / 3.0) * problem_.size);
    return inward * units_.asDiagonal();
  }

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    return step.iteration == 0 || step.step_is_successful ? ceres::SOLVER_CONTINUE
                                                          : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
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
    const Vector& p = result_.parameters;
    if (problem_.jacobian) {
      result_.jacobian = {problem_.jacobian(p), Vector::Zero(p.size()), 0.0};
      return true;
    }
    const double change =
        std::max(residual_noise(problem_, result_.residuals), std::cbrt(kEps) * problem_.size);
    result_.jacobian = difference_jacobian(counted_, p, problem_.low, problem_.high, steps_, change)
                           .value_or(DifferenceJacobian{{}, steps_});
    steps_ = result_.jacobian.steps;
    return result_.jacobian.matrix.size() > 0;
  }

  const LeastSquaresProblem& problem_;
  const LeastSquaresOptions& options_;
  const Residuals counted_;
  Vector steps_;
  Vector units_;                    // of Ceres' unknowns: powers of two, so that limits are exact
  Vector tried_, tried_residuals_;  // the last point that Ceres asked for
  bool is_last_ = false;            // the step from result_ is too short for another
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
  return BoundedSolver(problem, options).solve();
}

}  // namespace graze
