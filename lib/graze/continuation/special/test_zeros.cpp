#include "graze/continuation/special/detail/test_zeros.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/branch/detail/locate.hpp"
#include "graze/continuation/special/detail/margin_interpolant.hpp"

namespace graze {
namespace {

// Finds the zeros of the tests, step by step. A value is computed once at each point, relative to
// the previous one. Where both ends of a step have one sign, the cubic through them, with slopes
// from their neighbours, decides whether to search for a pair of zeros in between.
class TestZeroSearch {
 public:
  TestZeroSearch(const ZeroProblem& problem, const ContinuationOptions& options,
                 const Branch& branch, const BranchTests& tests)
      : problem_(problem),
        options_(options),
        tests_(tests),
        points_(branch.points),
        corrector_(problem, options) {}

  std::vector<TestZero> run() {
    for (std::size_t i = 0; i < points_.size() && !options_.stop.requested(); ++i) {
      values_.push_back(tests_.all(points_[i > 0 ? i - 1 : 0], points_[i]));
      if (i > 0) lengths_.push_back(arclength(corrector_, points_[i - 1], points_[i]));
    }
    for (std::size_t i = 0; i + 1 < values_.size() && !options_.stop.requested(); ++i)
      for (Eigen::Index k = 0; k < std::min(count_at(i), count_at(i + 1)); ++k) search(i, k);
    std::stable_sort(zeros_.begin(), zeros_.end(),
                     [](const TestZero& a, const TestZero& b) { return a.test < b.test; });
    return std::move(zeros_);
  }

 private:
  Eigen::Index count_at(std::size_t i) const { return values_[i] ? values_[i]->size() : 0; }
  double value(std::size_t i, Eigen::Index k) const { return (*values_[i])[k]; }

  std::optional<double> test(std::size_t i, Eigen::Index k, const SolutionPoint& at) const {
    if (tests_.one) return tests_.one(points_[i], at, k);
    const std::optional<Vector> values = tests_.all(points_[i], at);
    return values && k < values->size() ? std::optional((*values)[k]) : std::nullopt;
  }

  // Slope by arclength at point i: of the parabola through it and its neighbours, at an end of the
  // chord.
  double slope(std::size_t i, Eigen::Index k) const {
    const bool before = i > 0 && k < count_at(i - 1);
    const bool behind = i + 1 < values_.size() && k < count_at(i + 1);
    const double left = before ? (value(i, k) - value(i - 1, k)) / lengths_[i - 1] : 0.0;
    const double right = behind ? (value(i + 1, k) - value(i, k)) / lengths_[i] : 0.0;
    if (!before || !behind) return before ? left : right;
    return (left * lengths_[i] + right * lengths_[i - 1]) / (lengths_[i - 1] + lengths_[i]);
  }

  void search(std::size_t i, Eigen::Index k) {
    const SolutionPoint &a = points_[i], &b = points_[i + 1];
    const bool sign = value(i, k) < 0.0;
    if (sign != (value(i + 1, k) < 0.0)) return add(i, k, a, b);
    const double length = lengths_[i];
    const std::optional<double> part = suspected_sign_change({MarginInterpolant::between(
        value(i, k), length * slope(i, k), value(i + 1, k), length * slope(i + 1, k))});
    if (!part) return;
    const std::optional<SolutionPoint> middle =
        point_between(corrector_, a, *part * corrector_.ahead(a, b), a, b);
    const std::optional<double> there = middle ? test(i, k, *middle) : std::nullopt;
    if (!there || (*there < 0.0) == sign) return;
    add(i, k, a, *middle);
    add(i, k, *middle, b);
  }

  void add(std::size_t i, Eigen::Index k, const SolutionPoint& a, const SolutionPoint& b) {
    std::optional<SolutionPoint> point = locate(corrector_, a, b, [&](const SolutionPoint& at) {
      return test(i, k, at).value_or(std::nan(""));
    });
    if (!point) return;
    if (problem_.multipliers)
      point->multipliers = problem_.multipliers(point->u, point->parameters(), ErrorBounds::kGiven);
    zeros_.push_back({static_cast<std::size_t>(k), std::move(*point), i});
  }

  const ZeroProblem& problem_;
  const ContinuationOptions& options_;
  const BranchTests& tests_;
  const std::vector<SolutionPoint>& points_;
  Corrector corrector_;
  std::vector<std::optional<Vector>> values_;  // at the points
  std::vector<double> lengths_;                // of the steps
  std::vector<TestZero> zeros_;
};

}  // namespace

std::vector<TestZero> test_zeros(const ZeroProblem& problem, const ContinuationOptions& options,
                                 const Branch& branch, const BranchTests& tests) {
  return TestZeroSearch(problem, options, branch, tests).run();
}

}  // namespace graze
