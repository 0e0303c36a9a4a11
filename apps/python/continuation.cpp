// Continuation of a Python function F(u, p) = 0.
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <chrono>
#include <cmath>
#include <exception>
#include <limits>

#include "bindings.hpp"
#include "graze/base/errors.hpp"
#include "graze/continuation/branch.hpp"

namespace graze {
namespace {

namespace py = pybind11;

// The function and, where they are given, its derivatives, called with (u, p).
struct PythonProblem {
  py::object function, jacobian, by_parameter;  // None: not given
  Eigen::Index unknowns = 0;

  // What Python raised on the way; the branch ends there and it is raised again.
  std::shared_ptr<std::exception_ptr> raised = std::make_shared<std::exception_ptr>();

  // A list of numbers of that many rows; nothing where the function returns None or no number.
  std::optional<Matrix> called(const py::object& what, const Vector& u, double p,
                               Eigen::Index columns, const char* name) const {
    const py::object value = what(py::cast(Vector(u)), p);
    if (value.is_none()) return {};
    const auto array =
        py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
    if (!array) throw py::value_error(std::string(name) + " must return numbers");
    if (array.size() != unknowns * columns)
      throw py::value_error(std::string(name) + " must return " +
                            std::to_string(unknowns * columns) + " numbers for " +
                            std::to_string(unknowns) + " unknowns, not " +
                            std::to_string(array.size()));
    const Matrix values =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            array.data(), unknowns, columns);
    if (!values.allFinite()) return {};
    return values;
  }

  std::optional<Vector> residual(const Vector& u, double p) const {
    const std::optional<Matrix> values = called(function, u, p, 1, "F");
    return values ? std::optional<Vector>(values->col(0)) : std::nullopt;
  }

  // The step of a central difference whose errors by rounding and by curvature are alike.
  static double step(double at) {
    return std::cbrt(std::numeric_limits<double>::epsilon()) * (1.0 + std::abs(at));
  }

  std::optional<Vector> difference(const Vector& u, double p, const Vector& du, double dp) const {
    const std::optional<Vector> ahead = residual(u + du, p + dp), behind = residual(u - du, p - dp);
    if (!ahead || !behind) return {};
    return Vector((*ahead - *behind) / (2.0 * (du.sum() + dp)));
  }

  std::optional<Matrix> slopes(const Vector& u, double p) const {
    if (!jacobian.is_none()) return called(jacobian, u, p, unknowns, "jacobian");
    Matrix slopes(unknowns, unknowns);
    for (Eigen::Index j = 0; j < unknowns; ++j) {
      Vector du = Vector::Zero(unknowns);
      du[j] = step(u[j]);
      const std::optional<Vector> column = difference(u, p, du, 0.0);
      if (!column) return {};
      slopes.col(j) = *column;
    }
    return slopes;
  }

  std::optional<ZeroEvaluation> evaluate(const Vector& u, double p) const {
    if (*raised) return {};
    try {
      const std::optional<Vector> value = residual(u, p);
      if (!value) return {};
      const std::optional<Matrix> by_u = slopes(u, p);
      if (!by_u) return {};
      std::optional<Matrix> by_p;
      if (!by_parameter.is_none())
        by_p = called(by_parameter, u, p, 1, "by_parameter");
      else if (const auto column = difference(u, p, Vector::Zero(unknowns), step(p)))
        by_p = Matrix(*column);
      if (!by_p) return {};
      return ZeroEvaluation{*value, *by_u, *by_p};
    } catch (...) {
      *raised = std::current_exception();
      return {};
    }
  }
};

const char* end_name(BranchEnd end) {
  switch (end) {
    case BranchEnd::kParameterLimit:
      return "parameter_limit";
    case BranchEnd::kUnknownLimit:
      return "unknown_limit";
    case BranchEnd::kClosed:
      return "closed";
    case BranchEnd::kStart:
      return "start";
    case BranchEnd::kStepLimit:
      return "step_limit";
    case BranchEnd::kNotConverged:
      return "not_converged";
    case BranchEnd::kHalted:
      return "halted";
    case BranchEnd::kOutOfTime:
      return "out_of_time";
    case BranchEnd::kStopped:
      break;
  }
  return "stopped";
}

py::dict branch_dict(const Branch& branch, Eigen::Index unknowns) {
  using namespace py::literals;
  const auto count = static_cast<Eigen::Index>(branch.points.size());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> u(count, unknowns);
  Vector p(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const SolutionPoint& point = branch.points[static_cast<std::size_t>(i)];
    u.row(i) = point.u.transpose();
    p[i] = point.parameter;
  }
  py::list special;
  for (const CriticalPoint& at : branch.critical)
    special.append(py::dict("label"_a = label_of(at.kind), "p"_a = at.point.parameter,
                            "u"_a = py::cast(at.point.u), "after"_a = at.after));
  return py::dict("p"_a = py::cast(p), "u"_a = py::cast(u), "special"_a = special,
                  "ends"_a = py::make_tuple(end_name(branch.ends[0]), end_name(branch.ends[1])),
                  "evaluations"_a = branch.evaluations, "rejected"_a = branch.rejected);
}

// Nothing where no solution was found near the start.
std::optional<py::dict> trace(const py::object& function, const py::object& start_at, double p,
                              const py::object& jacobian, const py::object& by_parameter,
                              const py::dict& wanted) {
  const auto u = start_at.cast<Vector>();
  const PythonProblem problem{function, jacobian, by_parameter, u.size()};
  ZeroProblem equations;
  equations.evaluate = [&](const Vector& at, Parameters parameters) {
    return problem.evaluate(at, parameters[0]);
  };
  ContinuationOptions options;
  options.from = wanted["from"].cast<double>();
  options.to = wanted["to"].cast<double>();
  options.max_step = wanted["max_step"].cast<double>();
  options.max_distance = wanted["max_distance"].cast<double>();
  options.max_turn = wanted["max_turn"].cast<double>();
  options.residual_tolerance = wanted["residual_tolerance"].cast<double>();
  options.max_points = wanted["max_points"].cast<int>();
  using Clock = std::chrono::steady_clock;
  options.stop.deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(
                         std::chrono::duration<double>(wanted["max_seconds"].cast<double>()));
  // Python looks for Ctrl-C while it runs F; a compiled F does not.
  options.proceed = [&](const SolutionPoint&, const SolutionPoint&) {
    if (!*problem.raised && PyErr_CheckSignals() != 0)
      *problem.raised = std::make_exception_ptr(py::error_already_set());
    return !*problem.raised;
  };
  const std::optional<SolutionPoint> start = solve_at(equations, options, u, p);
  if (*problem.raised) std::rethrow_exception(*problem.raised);
  if (!start) return {};
  const Branch branch = trace_branch(equations, options, *start);
  if (*problem.raised) std::rethrow_exception(*problem.raised);
  return branch_dict(branch, u.size());
}

}  // namespace

void bind_continuation(py::module_& module) { module.def("trace", trace); }

}  // namespace graze
