#include "graze/orbit/problem/detail/solve.hpp"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>

#include <mutex>
#include <utility>

#include "graze/base/stop_scope.hpp"

namespace graze {
namespace {

// The shooting equations as one dense residual block.
class ShootingCost : public ceres::CostFunction {
 public:
  ShootingCost(const ShootingProblem& problem, const System& system)
      : problem_(problem), system_(system) {
    const int n = static_cast<int>(problem.size(system));
    set_num_residuals(n);
    mutable_parameter_block_sizes()->push_back(n);
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Index n = problem_.size(system_);
    const Vector x = Eigen::Map<const Vector>(parameters[0], n);
    const bool wants_jacobian = jacobians != nullptr && jacobians[0] != nullptr;
    Matrix jacobian;
    const Vector r = problem_.residual(system_, x, wants_jacobian ? &jacobian : nullptr);
    ++evaluations;
    if (!r.allFinite()) return false;
    Eigen::Map<Vector>(residuals, n) = r;
    if (wants_jacobian) {
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      Eigen::Map<RowMajor>(jacobians[0], n, n) = jacobian;
    }
    return true;
  }

  mutable int evaluations = 0;

 private:
  const ShootingProblem& problem_;
  const System& system_;
};

// Stops Ceres once is_over() of the stop scope is true.
class EndWithScope : public ceres::IterationCallback {
 public:
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return StopScope::is_over() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }
};

// Ceres writes its complaints through glog, to stderr unless configured otherwise.
void quiet_glog() {
  static std::once_flag once;
  std::call_once(once, [] {
    FLAGS_minloglevel = 3;
    FLAGS_logtostderr = true;
  });
}

}  // namespace

std::optional<ShootingSolution> newton(const ShootingProblem& problem, const System& system,
                                       const Vector& start) {
  struct Equations {
    Vector residual;
    Matrix jacobian;
  };
  auto solution = polish(start, [&](const Vector& x) -> std::optional<Equations> {
    if (StopScope::is_over()) return {};
    Equations at;
    at.residual = problem.residual(system, x, &at.jacobian);
    return at;
  });
  if (!solution) return {};
  return ShootingSolution{std::move(solution->u), solution->residual, solution->evaluations};
}

std::optional<ShootingSolution> seek(const ShootingProblem& problem, const System& system,
                                     const Vector& start) {
  quiet_glog();
  Vector x = start;
  ShootingCost cost(problem, system);
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem least_squares(ownership);
  least_squares.AddResidualBlock(&cost, nullptr, x.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 200;
  // Runs until the gradient vanishes; the residual below decides whether that is a solution.
  options.function_tolerance = 0.0;
  options.parameter_tolerance = 0.0;
  options.gradient_tolerance = 1e-13;
  EndWithScope end;
  options.callbacks.push_back(&end);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &least_squares, &summary);
  std::optional<ShootingSolution> solution = newton(problem, system, x);
  if (solution) solution->evaluations += cost.evaluations;
  return solution;
}

}  // namespace graze
