#include "graze/orbit/search/detail/global_phases.hpp"

#include <nlopt.h>

#include <memory>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

// Where the equations cannot be evaluated, and the most that DIRECT is shown: one pole among the
// values must not hide the differences between the others. NLopt takes no NaN.
constexpr double kHighest = 1e6;

struct Height {
  const PhaseProblem& problem;
  const PhaseDeflation& deflation;
  const PhaseSearchOptions& options;
  nlopt_opt search;  // that is forced to stop with the rest
  double lowest = kHighest;
  Vector where;

  double at(const Vector& phases) {
    if (options.stop.requested()) nlopt_force_stop(search);
    Vector speeds;
    const Vector r = problem.defect(phases, nullptr, &speeds) / options.length;
    const double factor = deflation.factor(phases);
    const double height =
        factor * factor * r.squaredNorm() + (speeds / options.speed).cwiseMin(0.0).squaredNorm();
    if (!(height < kHighest)) return kHighest;
    if (height < lowest) {
      lowest = height;
      where = phases;
    }
    return height;
  }
};

double height_at(unsigned n, const double* x, double*, void* data) {
  return static_cast<Height*>(data)->at(Eigen::Map<const Vector>(x, n));
}

}  // namespace

std::optional<Vector> lowest_phases(const PhaseProblem& problem, const PhaseDeflation& deflation,
                                    const PhaseSearchOptions& options) {
  const auto k = static_cast<unsigned>(problem.impacts());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> direct(
      nlopt_create(NLOPT_GN_DIRECT_L, k), &nlopt_destroy);
  if (!direct) return {};
  Height height{problem, deflation, options, direct.get(), kHighest, {}};
  const Vector low = Vector::Zero(k);
  Vector high = Vector::Constant(k, kTurn * problem.response().period());
  high[0] = kTurn;  // a whole orbit later by a forcing period is the same orbit
  nlopt_set_lower_bounds(direct.get(), low.data());
  nlopt_set_upper_bounds(direct.get(), high.data());
  nlopt_set_min_objective(direct.get(), height_at, &height);
  nlopt_set_maxeval(direct.get(), options.global_evaluations);
  Vector x = 0.5 * high;
  double value = 0.0;
  // Its word is not asked for: the lowest value was kept on the way.
  nlopt_optimize(direct.get(), x.data(), &value);
  if (height.where.size() == 0) return {};
  return height.where;
}

}  // namespace graze
