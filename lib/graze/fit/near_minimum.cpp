#include "graze/fit/detail/near_minimum.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace graze {
namespace {

// Both relative to the box, a side of which is 1. A tenth, since limits are usually some ten times
// as wide as the knowledge of the parameter. Below a thousandth Gauss-Newton steps are faster.
constexpr double kFirstStep = 0.1, kNear = 1e-3;
// The part of the sum of squares by which a step has to lower it. With m noisy values an excess of
// m/100 is left then, some standard uncertainties of the parameters: near enough for Gauss-Newton.
constexpr double kFlat = 1e-2;

// Maps the unit box to the parameters.
class Box {
 public:
  explicit Box(const LeastSquaresProblem& problem)
      : problem_(problem), low_(to_scale(problem.low)), high_(to_scale(problem.high)) {}

  Vector parameters(const Vector& unit) const {
    Vector p = low_ + unit.cwiseProduct(high_ - low_);
    for (Eigen::Index j = 0; j < p.size(); ++j) {
      if (is_logarithmic(j)) p[j] = std::exp(p[j]);
      p[j] = std::clamp(p[j], problem_.low[j], problem_.high[j]);
    }
    return p;
  }
  Vector unit(const Vector& parameters) const {
    return (to_scale(parameters) - low_).cwiseQuotient(high_ - low_).cwiseMax(0.0).cwiseMin(1.0);
  }

 private:
  bool is_logarithmic(Eigen::Index j) const {
    return problem_.logarithmic[static_cast<std::size_t>(j)];
  }
  Vector to_scale(Vector p) const {
    for (Eigen::Index j = 0; j < p.size(); ++j)
      if (is_logarithmic(j)) p[j] = std::log(p[j]);
    return p;
  }

  const LeastSquaresProblem& problem_;
  Vector low_, high_;
};

// A sum of squares as an NLopt objective.
struct Search {
  std::function<Vector(const Vector&)> parameters;  // of NLopt's unknowns
  const Residuals& residuals;
  const std::function<bool()>& over;
  double highest;  // value of a model that cannot be evaluated: NLopt accepts no NaN
  nlopt_opt running = nullptr;
  NearMinimum best{};
  double least = HUGE_VAL;

  void start_from(const Vector& p, const Vector& r) {
    least = r.squaredNorm();
    best.parameters = p;
    best.residuals = r;
  }

  double at(const Vector& unit) {
    if (over()) nlopt_force_stop(running);
    const Vector p = parameters(unit);
    const std::optional<Vector> r = residuals(p);
    if (!r) return highest;
    const double sum = r->squaredNorm();
    if (sum < least) start_from(p, *r);
    return std::min(sum, highest);
  }
};

double sum_at(unsigned n, const double* x, double*, void* data) {
  return static_cast<Search*>(data)->at(Eigen::Map<const Vector>(x, n));
}

using Optimiser = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

// Far worse than a model that is zero.
double highest_sum(const LeastSquaresProblem& problem) {
  return 100.0 * std::max(problem.size * problem.size, 1.0);
}

void run(nlopt_algorithm algorithm, Search& search, Vector unit, long long evaluations) {
  const auto n = static_cast<unsigned>(unit.size());
  const Optimiser optimiser(nlopt_create(algorithm, n), &nlopt_destroy);
  if (!optimiser) return;
  search.running = optimiser.get();
  nlopt_set_lower_bounds1(optimiser.get(), 0.0);
  nlopt_set_upper_bounds1(optimiser.get(), 1.0);
  nlopt_set_min_objective(optimiser.get(), sum_at, &search);
  nlopt_set_maxeval(optimiser.get(), static_cast<int>(std::min(evaluations, 1'000'000'000LL)));
  nlopt_set_initial_step1(optimiser.get(), kFirstStep);
  // For a search of the whole box, no progress for a while is no reason to end.
  if (algorithm != NLOPT_GN_DIRECT_L) {
    nlopt_set_xtol_abs1(optimiser.get(), kNear);
    nlopt_set_ftol_rel(optimiser.get(), kFlat);
  }
  double value = 0.0;
  // NLopt's own result is not used: the best values were kept on the way.
  nlopt_optimize(optimiser.get(), unit.data(), &value);
}

}  // namespace

NearMinimum near_minimum(const LeastSquaresProblem& problem, const Residuals& residuals,
                         const NearMinimumOptions& options) {
  const Box box(problem);
  Search search{[&](const Vector& unit) { return box.parameters(unit); }, residuals, options.over,
                highest_sum(problem)};
  const Vector start = box.unit(problem.start);
  // The start itself, not its rounded image in the box.
  if (const std::optional<Vector> r = residuals(problem.start))
    search.start_from(problem.start, *r);
  std::string method;
  if (options.global) {
    run(NLOPT_GN_DIRECT_L, search, start, options.evaluations / 2);
    method = "DIRECT over the box, then ";
  }
  const bool one = problem.start.size() == 1;
  const Vector from = search.best.parameters.size() > 0 ? box.unit(search.best.parameters) : start;
  run(one ? NLOPT_LN_NELDERMEAD : NLOPT_LN_BOBYQA, search, from, options.evaluations);
  search.best.method = method + (one ? "Nelder-Mead" : "BOBYQA");
  return std::move(search.best);
}

NearMinimum simplex_minimum(const LeastSquaresProblem& problem, const Residuals& residuals,
                            const Vector& at, const Vector& residuals_at, const Vector& deviations,
                            double part, const std::function<bool()>& over) {
  Search search{[](const Vector& p) { return p; }, residuals, over, highest_sum(problem)};
  search.start_from(at, residuals_at);
  const Optimiser optimiser(nlopt_create(NLOPT_LN_NELDERMEAD, static_cast<unsigned>(at.size())),
                            &nlopt_destroy);
  if (!optimiser) return std::move(search.best);
  search.running = optimiser.get();
  const Vector ends = part * deviations;
  nlopt_set_lower_bounds(optimiser.get(), problem.low.data());
  nlopt_set_upper_bounds(optimiser.get(), problem.high.data());
  nlopt_set_min_objective(optimiser.get(), sum_at, &search);
  nlopt_set_initial_step(optimiser.get(), deviations.data());
  nlopt_set_xtol_abs(optimiser.get(), ends.data());
  Vector p = at;
  double value = 0.0;
  nlopt_optimize(optimiser.get(), p.data(), &value);
  return std::move(search.best);
}

}  // namespace graze
