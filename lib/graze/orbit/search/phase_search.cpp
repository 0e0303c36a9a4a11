#include "graze/orbit/search/detail/phase_search.hpp"

#include <ceres/tiny_solver.h>
#include <nlopt.h>
#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>

#include "graze/base/angle.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/base/parallel.hpp"
#include "graze/orbit/closed_form/detail/phase_problem.hpp"
#include "graze/orbit/problem/orbit_identity.hpp"
#include "graze/orbit/search/detail/phase_deflation.hpp"

namespace graze {
namespace {

// The lowest point of the phase problem on its whole torus, where local solves found none.
//
// Minimised is the squared residual, deflated and in units of a length, plus the squares of
// negative approach speeds, in units of a speed: of all points where contact holds, orbits are
// those with positive speeds. DIRECT (NLopt's locally biased version; Gablonsky & Kelley, J. Global
// Optim. 21, 2001) divides the torus into boxes and needs neither derivatives nor random numbers,
// so that it is the same everywhere; its answer is only a start for a local solve.

// The value where the equations cannot be evaluated, and the largest value that DIRECT gets: one
// pole among the values must not hide the differences between the others. NLopt accepts no NaN.
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

// The phases, rad, of the lowest of options.global_evaluations values; nullopt when none could be
// evaluated or NLopt refuses.
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
  // NLopt's own result is not used: the lowest value was kept on the way.
  nlopt_optimize(direct.get(), x.data(), &value);
  if (height.where.size() == 0) return {};
  return height.where;
}

// A residual where the equations cannot be evaluated: larger than any other, and its square is
// still a number.
constexpr double kNowhere = 1e100;

// The deflated phase problem, in units of a length.
class DeflatedDefect {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  DeflatedDefect(const PhaseProblem& problem, const PhaseDeflation& deflation, double length)
      : problem_(problem), deflation_(deflation), length_(length) {}

  int NumResiduals() const { return problem_.impacts(); }
  int NumParameters() const { return problem_.impacts(); }

  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    const Eigen::Index k = problem_.impacts();
    const Vector phases = Eigen::Map<const Vector>(parameters, k);
    Matrix by_phases;
    Vector gradient;
    Vector r = problem_.defect(phases, jacobian ? &by_phases : nullptr) / length_;
    const double factor = deflation_.factor(phases, jacobian ? &gradient : nullptr);
    Eigen::Map<Vector> out(residuals, k);
    out = factor * r;
    bool good = out.allFinite() && out.cwiseAbs().maxCoeff() < kNowhere;
    if (jacobian && good) {
      by_phases = (factor / length_) * by_phases + r * gradient.transpose();
      good = by_phases.allFinite();
      if (good) Eigen::Map<Matrix>(jacobian, k, k) = by_phases;
    }
    if (good) return true;
    out.setConstant(kNowhere);
    if (jacobian) Eigen::Map<Matrix>(jacobian, k, k).setZero();
    return true;
  }

 private:
  const PhaseProblem& problem_;
  const PhaseDeflation& deflation_;
  double length_;
};

Vector levenberg_marquardt(const PhaseProblem& problem, const PhaseDeflation& deflation,
                           double length, const Vector& start) {
  // A solve that takes longer is lost; another start costs less.
  constexpr int kMostIterations = 25;
  const DeflatedDefect equations(problem, deflation, length);
  ceres::TinySolver<DeflatedDefect> solver;
  // Newton's method finishes: near enough for it is enough here.
  solver.options.max_num_iterations = kMostIterations;
  solver.options.gradient_tolerance = 1e-10;
  solver.options.parameter_tolerance = 1e-6;
  solver.options.function_tolerance = 0.0;
  solver.options.cost_threshold = 1e-12;
  Vector x = start;
  solver.Solve(equations, &x);
  return x;
}

// Newton's method on the problem itself; nullopt when it does not settle. The residual must vanish
// to the same part of a length as the accuracy of the phases, rad.
std::optional<Vector> newton_phases(const PhaseProblem& problem, double length, Vector phases) {
  constexpr int kMostSteps = 20;
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kMostSteps; ++step) {
    Matrix jacobian;
    const Vector r = problem.defect(phases, &jacobian);
    if (!r.allFinite() || !jacobian.allFinite()) return {};
    const Vector update = LuFactors(jacobian).solve(r);
    const double size = update.cwiseAbs().maxCoeff();
    if (!std::isfinite(size)) return {};
    if (size <= kSameOrbit && !(size < 0.5 * last) &&
        r.cwiseAbs().maxCoeff() <= kSameOrbit * length)
      return phases;
    phases -= update;
    last = size;
  }
  return {};
}

// The solution with its impacts in time order from the smallest phase.
PhaseSolution in_order(const PhaseProblem& problem, const Vector& phases) {
  const int period = problem.response().period();
  const Eigen::Index k = phases.size();
  Vector speeds;
  problem.defect(phases, nullptr, &speeds);
  Eigen::Index first = 0;
  for (Eigen::Index i = 1; i < k; ++i)
    if (wrapped(phases[i]) < wrapped(phases[first])) first = i;
  const auto after = [&](Eigen::Index i) {
    if (i == first) return 0.0;
    const double turn = std::fmod(phases[i] - phases[first], kTurn * period);
    return turn < 0.0 ? turn + kTurn * period : turn;
  };
  std::vector<Eigen::Index> order(static_cast<std::size_t>(k));
  for (Eigen::Index i = 0; i < k; ++i) order[static_cast<std::size_t>(i)] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return after(a) < after(b); });
  PhaseSolution solution{{period, {}}, Vector(k), Vector(k)};
  for (Eigen::Index m = 0; m < k; ++m) {
    const Eigen::Index i = order[static_cast<std::size_t>(m)];
    solution.pattern.stops.push_back(problem.stops()[static_cast<std::size_t>(i)]);
    solution.phases[m] = wrapped(phases[first]) + after(i);
    solution.speeds[m] = speeds[i];
  }
  return solution;
}

}  // namespace

Orbit outline(const PhaseSolution& solution) {
  Orbit orbit;
  orbit.period = solution.pattern.period;
  orbit.residual = std::numeric_limits<double>::infinity();  // not known
  for (Eigen::Index i = 0; i < solution.phases.size(); ++i) {
    const double phase = wrapped(solution.phases[i]);
    orbit.impacts.push_back({solution.pattern.stops[static_cast<std::size_t>(i)],
                             static_cast<int>(std::lround((solution.phases[i] - phase) / kTurn)),
                             phase,
                             solution.speeds[i],
                             {}});
  }
  return orbit;
}

std::optional<PhaseSolution> solution_near(const PhaseProblem& problem, double length,
                                           const Vector& phases) {
  const std::optional<Vector> there = newton_phases(problem, length, phases);
  const PhaseDeflation pairs({problem.response().period(), problem.stops()});
  if (!there || !(pairs.nearest_pair(*there) > kSameOrbit)) return {};
  return in_order(problem, *there);
}

std::optional<PhaseSolution> solve_phases(const PeriodicResponse& response,
                                          const PhaseDeflation& deflation, const Vector& start,
                                          const PhaseSearchOptions& options) {
  const PhaseProblem problem(response, deflation.pattern().stops, options.speed);
  return solution_near(problem, options.length,
                       levenberg_marquardt(problem, deflation, options.length, start));
}

struct PhaseStarts::Sequence {
  explicit Sequence(std::size_t dimension) : numbers(dimension) {}
  boost::random::sobol numbers;
};

PhaseStarts::PhaseStarts(int period, int impacts, std::uint64_t seed)
    : period_(period), sequence_(std::make_shared<Sequence>(static_cast<std::size_t>(impacts))) {
  std::mt19937_64 engine(seed);
  for (int i = 0; i < impacts; ++i) shift_.push_back(engine());
}

Vector PhaseStarts::next() {
  // Bits are converted to [0, 1) by hand: results shall not depend on a library's distributions.
  std::vector<double> u;
  for (const std::uint64_t shift : shift_)
    u.push_back(static_cast<double>((sequence_->numbers() ^ shift) >> 11) * 0x1p-53);
  std::sort(u.begin() + 1, u.end());
  Vector phases(static_cast<Eigen::Index>(u.size()));
  phases[0] = kTurn * u[0];
  for (std::size_t i = 1; i < u.size(); ++i)
    phases[static_cast<Eigen::Index>(i)] = phases[0] + kTurn * period_ * u[i];
  return phases;
}

PhaseSearch::PhaseSearch(const PeriodicResponse& response, const ImpactPattern& pattern,
                         const PhaseSearchOptions& options)
    : response_(&response),
      options_(options),
      deflation_(pattern),
      starts_(pattern.period, pattern.impacts(), options.seed),
      known_{PhaseDeflation(pattern)} {}

void PhaseSearch::know(const std::vector<int>& stops, const Vector& phases) {
  deflation_.add(stops, phases);
  for (PhaseDeflation& known : known_)
    if (known.pattern().stops == stops) {
      known.add(stops, phases);
      return;
    }
  known_.emplace_back(ImpactPattern{deflation_.pattern().period, stops});
  known_.back().add(stops, phases);
}

bool PhaseSearch::learn(const PhaseSolution& solution) {
  for (const PhaseDeflation& known : known_)
    if (known.pattern().stops == solution.pattern.stops && known.knows(solution.phases, kSameOrbit))
      return false;
  know(solution.pattern.stops, solution.phases);
  return true;
}

std::vector<Vector> PhaseSearch::starts_of_a_round() {
  // After this many draws a start is used even if not every stop is approached.
  constexpr int kMostDraws = 64;
  const std::vector<int>& stops = deflation_.pattern().stops;
  const PhaseProblem problem(*response_, stops, options_.speed);
  std::vector<Vector> starts;
  for (int draw = 0; draw < kMostDraws * options_.starts; ++draw) {
    if (static_cast<int>(starts.size()) == options_.starts || options_.stop.requested()) break;
    const Vector phases = starts_.next();
    Vector speeds;
    if (options_.approaching) problem.defect(phases, nullptr, &speeds);
    if (!options_.approaching || speeds.minCoeff() > 0.0) starts.push_back(phases);
  }
  return starts;
}

std::vector<PhaseSolution> PhaseSearch::local() {
  constexpr int kBarrenRounds = 2;
  std::vector<PhaseSolution> found;
  int barren = 0;  // rounds in a row without anything new
  for (int round = 0; round < options_.rounds && barren < kBarrenRounds; ++round) {
    if (options_.stop.requested()) break;
    const std::vector<Vector> starts = starts_of_a_round();
    std::vector<std::optional<PhaseSolution>> solved(starts.size());
    for_each_index(starts.size(), options_.threads, [&](std::size_t i) {
      if (!options_.stop.requested())
        solved[i] = solve_phases(*response_, deflation_, starts[i], options_);
    });
    tried_ += static_cast<int>(starts.size());
    const std::size_t before = found.size();
    for (const std::optional<PhaseSolution>& solution : solved) {
      if (!solution) continue;
      ++converged_;
      if (learn(*solution)) found.push_back(*solution);
    }
    barren = found.size() == before ? barren + 1 : 0;
  }
  return found;
}

std::optional<PhaseSolution> PhaseSearch::global() {
  const std::vector<int>& stops = deflation_.pattern().stops;
  const PhaseProblem problem(*response_, stops, options_.speed);
  const std::optional<Vector> lowest = lowest_phases(problem, deflation_, options_);
  if (!lowest) return {};
  std::optional<PhaseSolution> solution = solve_phases(*response_, deflation_, *lowest, options_);
  if (solution && learn(*solution)) return solution;
  // No solution lies in this valley: the next minimisation shall search elsewhere.
  deflation_.add(stops, *lowest);
  return {};
}

}  // namespace graze
