#include "graze/continuation/normal_form.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/branch/detail/slope.hpp"
#include "graze/continuation/switching.hpp"

namespace graze {
namespace {

// Distances from which an opening is extrapolated, each half of the one before: rounding grows by
// the inverse of their third power.
constexpr double kFarthest = 0.04;
constexpr int kRefinements = 7;
// Step of the differences of a multiplier along its branch.
constexpr double kAlong = 1e-3;
// Residual of solutions beside the point, whose distance from it in the parameter is small.
constexpr double kExact = 1e-14;

// Solutions beside the point, to the last digits.
ContinuationOptions exact(ContinuationOptions options) {
  options.residual_tolerance = std::min(options.residual_tolerance, kExact);
  return options;
}

// a2 of e(x) = a2 x^2 + a4 x^4 + .., from multiples of a distance: the polynomial through e/x^2 at
// 0.
std::optional<double> extrapolated(const std::function<std::optional<double>(double)>& even,
                                   double x) {
  constexpr int kDistances = 5;
  double sum = 0.0;
  for (int k = 1; k <= kDistances; ++k) {
    const std::optional<double> there = even(k * x);
    if (!there) return {};
    double weight = 1.0;
    for (int j = 1; j <= kDistances; ++j)
      if (j != k) weight *= static_cast<double>(j * j) / static_cast<double>(j * j - k * k);
    sum += weight * *there / (k * k * x * x);
  }
  return sum;
}

// Refined until it changes least.
std::optional<NormalForm> opening_of(const std::function<std::optional<double>(double)>& even) {
  std::optional<NormalForm> best;
  std::optional<double> before;
  double x = kFarthest;
  for (int i = 0; i < kRefinements; ++i, x *= 0.5) {
    const std::optional<double> here = extrapolated(even, x);
    if (here && before) {
      const double change = std::abs(*here - *before);
      if (!best || change < best->error) best = NormalForm{0.0, *here, change};
    }
    before = here;
  }
  return best;
}

// The null vectors of A(mu), with -p.closing q = 1 and |q| = 1; q and p are real at mu = 1 and -1.
struct CriticalVectors {
  Vector left, right, by_parameter;
};
std::optional<CriticalVectors> critical_vectors(const ZeroProblem& problem, const SolutionPoint& at,
                                                double multiplier) {
  const std::optional<ZeroEvaluation> here = problem.evaluate(at.u, at.parameters());
  if (!here || here->closing.size() == 0) return {};
  const Matrix critical = here->jacobian + (multiplier - 1.0) * here->closing;
  const auto null = [](const Matrix& of) -> Vector {
    return singular_values<double>(of).right.col(of.cols() - 1);
  };
  CriticalVectors vectors{null(critical.transpose()), null(critical), here->by_parameters.col(0)};
  const double pairing = -vectors.left.dot(here->closing * vectors.right);
  if (pairing == 0.0) return {};
  vectors.left /= pairing;
  return vectors;
}

// How fast the multiplier at -1 changes with the parameter along the branch.
std::optional<double> multiplier_rate(const ZeroProblem& problem,
                                      const ContinuationOptions& options, const SolutionPoint& at) {
  Corrector corrector(problem, options);
  const auto rate = slope_at_zero(kAlong, [&](double s) -> std::optional<double> {
    const auto there = corrector.on_hyperplane(corrector.pack(at) + s * at.tangent, at.tangent);
    if (!there) return {};
    const auto list = problem.multipliers(there->u, there->parameters(), ErrorBounds::kLeftOut);
    const auto critical = nearest_to(list, -1.0);
    return critical == list.end() ? std::nullopt : std::optional(critical->value.real());
  });
  const double moved = at.rate() * corrector.range();
  return rate && moved != 0.0 ? std::optional(*rate / moved) : std::nullopt;
}

}  // namespace

std::optional<NormalForm> fold_form(const ZeroProblem& problem, const ContinuationOptions& options,
                                    const SolutionPoint& fold) {
  const auto vectors = critical_vectors(problem, fold, 1.0);
  if (!vectors) return {};
  const ContinuationOptions beside = exact(options);
  Corrector corrector(problem, beside);
  Vector along(fold.tangent.size());
  along << vectors->right, 0.0;
  const auto even = [&](double x) -> std::optional<double> {
    double sum = 0.0;
    for (const double side : {x, -x}) {
      const auto there = corrector.on_hyperplane(corrector.pack(fold) + side * along, along);
      if (!there) return {};
      sum += 0.5 * (there->parameter - fold.parameter);
    }
    return sum;
  };
  std::optional<NormalForm> form = opening_of(even);
  if (form) form->coefficient = -vectors->left.dot(vectors->by_parameter) * form->opening;
  return form;
}

// Doubled orbits x q away from the branch, first on one side of it and then on the other.
std::optional<NormalForm> doubling_form(const ZeroProblem& problem,
                                        const ContinuationOptions& options,
                                        const SolutionPoint& doubling, const ZeroProblem& doubled,
                                        const SolutionPoint& twice) {
  const auto vectors = critical_vectors(problem, doubling, -1.0);
  const std::optional<double> rate =
      problem.multipliers ? multiplier_rate(problem, options, doubling) : std::nullopt;
  const std::optional<SolutionPoint> start = other_branch(doubled, options, twice);
  if (!vectors || !rate || !start) return {};
  const ContinuationOptions beside = exact(options);
  Corrector corrector(doubled, beside);
  Vector along = start->tangent;
  along[along.size() - 1] = 0.0;
  along /= along.head(doubling.u.size()).norm();
  const double length = along.norm();
  const auto even = [&](double x) -> std::optional<double> {
    const auto there =
        corrector.on_hyperplane(corrector.pack(twice) + x * along, Vector(along / length));
    return there ? std::optional(there->parameter - twice.parameter) : std::nullopt;
  };
  std::optional<NormalForm> form = opening_of(even);
  if (form) form->coefficient = -*rate * form->opening;
  return form;
}

}  // namespace graze
