#include "graze/continuation/locus/detail/plane_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/continuation/branch.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/branch/detail/locate.hpp"
#include "graze/continuation/special/detail/test_zeros.hpp"

namespace graze {
namespace {

constexpr double kDefaultStep = 0.02;  // of a range
// A curve is upright where it moves this many times faster along p than along q: q is then a bad
// choice of the parameter to hold fixed.
constexpr double kUpright = 10.0;

// A point further away than this from where it was sought, in ranges, is another one.
constexpr double kNearLocus = 0.2;

double length_of(double from, double to) {
  const double length = std::abs(to - from);
  return length > 0.0 ? length : 1.0;
}

bool is_inside(double from, double to, double value) {
  return value >= std::min(from, to) && value <= std::max(from, to);
}

bool is_inside(const ContinuationOptions& options, const SolutionPoint& point) {
  return is_inside(options.from, options.to, point.parameter) &&
         std::all_of(options.ranges.begin(), options.ranges.end(), [&](const UnknownRange& range) {
           return is_inside(range.from, range.to, point.u[range.unknown]);
         });
}

// The solution on the hyperplane through x normal to an axis, or to the direction of the curve by
// the equations at x.
std::optional<SolutionPoint> across(Corrector& corrector, const Vector& x, const Vector& normal) {
  std::optional<SolutionPoint> point = corrector.on_hyperplane(x, normal);
  if (point && point->rate() < 0.0) point->turn_round();
  return point;
}

// The unknown on whose limit, or near it, a branch ended at a point.
std::optional<Eigen::Index> limit_near(const std::vector<UnknownRange>& ranges,
                                       const SolutionPoint& point, double distance) {
  for (const UnknownRange& range : ranges) {
    const double at = point.u[range.unknown];
    if (std::abs(at - range.from) <= distance || std::abs(at - range.to) <= distance)
      return range.unknown;
  }
  return {};
}

// Where several curves of the same equations cross on a limit these are singular, and no step
// reaches it: steps get shorter and shorter from about this distance, in units of the unknown; the
// points are badly determined along the other curves. The tori of a doubled orbit end in this way
// where it shrinks into the orbit that it doubled from.
constexpr double kCreeping = 1e-3;
constexpr std::size_t kFewestCrept = 4;

// Of the points that crept up to such an end (0 or 1) of the branch, keeps the last one.
void drop_crept_points(const PlaneCurveProblem& problem, const Corrector& corrector, Branch& branch,
                       std::size_t end) {
  std::vector<SolutionPoint>& points = branch.points;
  const SolutionPoint last = end == 0 ? points.front() : points.back();
  const bool stuck = branch.ends[end] == BranchEnd::kNotConverged;
  if (!stuck && branch.ends[end] != BranchEnd::kUnknownLimit) return;
  if (!limit_near(problem.ranges, last, kCreeping)) return;
  branch.ends[end] = BranchEnd::kUnknownLimit;
  const double reach = kCreeping * (1.0 + corrector.pack(last).norm());
  std::size_t crept = 0;
  while (crept + 1 < points.size() &&
         corrector.chord(points[end == 0 ? crept : points.size() - 1 - crept], last).norm() <=
             reach)
    ++crept;
  // A curve that simply ends on the limit may have a short last step.
  if (crept < kFewestCrept) return;
  const std::size_t dropped = crept - 1, kept = points.size() - dropped;
  if (end == 0)
    points.erase(points.begin() + 1, points.begin() + static_cast<std::ptrdiff_t>(crept));
  else
    points.erase(points.end() - static_cast<std::ptrdiff_t>(crept), points.end() - 1);
  std::erase_if(branch.critical, [&](const CriticalPoint& critical) {
    return end == 0 ? critical.after < dropped : critical.after + 1 >= kept;
  });
  if (end == 0)
    for (CriticalPoint& critical : branch.critical) critical.after -= dropped;
}

}  // namespace

double first_range(const LocusOptions& options) {
  return length_of(options.first_from, options.first_to);
}

double second_range(const LocusOptions& options) {
  return length_of(options.second_from, options.second_to);
}

ContinuationOptions branch_options(const PlaneCurveProblem& problem, const LocusOptions& options) {
  const double range = first_range(options);
  const double step = options.max_step > 0.0 ? options.max_step : kDefaultStep;
  ContinuationOptions result;
  result.from = options.second_from;
  result.to = options.second_to;
  result.max_step = step * second_range(options);
  result.ranges.push_back(
      {problem.first, options.first_from / range, options.first_to / range, step});
  result.ranges.insert(result.ranges.end(), problem.ranges.begin(), problem.ranges.end());
  result.max_distance = options.max_distance;
  result.max_turn = options.max_turn;
  result.residual_tolerance = options.residual_tolerance;
  result.max_points = options.max_points;
  result.stop = options.stop;
  result.resolves = problem.resolves;
  result.proceed = problem.proceed;
  return result;
}

std::optional<SolutionPoint> point_on_curve(const PlaneCurveProblem& problem,
                                            const LocusOptions& options, const Vector& unknown,
                                            double second) {
  const ContinuationOptions along = branch_options(problem, options);
  Corrector corrector(problem.problem, along);
  const Eigen::Index n = unknown.size();
  Vector x(n + 1);
  x << unknown, second / corrector.range();
  const std::optional<Matrix> slope = corrector.slope_at(x);
  if (!slope) return {};
  const Vector runs = null_vector(*slope);
  const auto at_second = [&] {
    std::optional<SolutionPoint> point = corrector.at_parameter(x);
    if (point) point->parameter = second;
    return point;
  };
  const auto at_first = [&] { return across(corrector, x, Vector::Unit(n + 1, problem.first)); };
  const auto suits = [&](const std::optional<SolutionPoint>& point) {
    return point && is_inside(along, *point) &&
           std::abs(point->u[problem.first] - unknown[problem.first]) <= kNearLocus &&
           std::abs(point->parameter - second) <= kNearLocus * corrector.range();
  };
  const bool upright = std::abs(runs[problem.first]) > kUpright * std::abs(runs[n]);
  std::optional<SolutionPoint> point = upright ? at_first() : at_second();
  if (!suits(point)) point = upright ? at_second() : at_first();
  if (!suits(point)) point = across(corrector, x, runs);
  if (!suits(point)) return {};
  return point;
}

PlaneCurve trace_curve(const PlaneCurveProblem& problem, const LocusOptions& options,
                       const SolutionPoint& start) {
  const ContinuationOptions along = branch_options(problem, options);
  PlaneCurve curve;
  curve.branch = trace_branch(problem.problem, along, start);
  const Corrector corrector(problem.problem, along);
  for (const std::size_t end : {0u, 1u}) drop_crept_points(problem, corrector, curve.branch, end);
  if (problem.tests.all)
    curve.zeros = test_zeros(problem.problem, along, curve.branch, problem.tests);
  for (const std::size_t end : {0u, 1u}) {
    if (curve.branch.ends[end] != BranchEnd::kUnknownLimit) continue;
    const std::vector<SolutionPoint>& points = curve.branch.points;
    const SolutionPoint& last = end == 0 ? points.front() : points.back();
    curve.left_range[end] = limit_near(along.ranges, last, 0.0);
    if (!curve.left_range[end]) curve.left_range[end] = limit_near(problem.ranges, last, kCreeping);
  }
  return curve;
}

}  // namespace graze
