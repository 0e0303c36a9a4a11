#include "graze/orbit/search/detail/pair_search.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/base/parallel.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/problem/orbit_identity.hpp"

namespace graze {
namespace {

PairSolutions solve_pair(const TwoImpacts& form, const PeriodicResponse& response,
                         const PhaseJudge& judge, const std::vector<int>& stops,
                         const MotionScale& scale) {
  PairSolutions result;
  std::vector<Orbit> known;
  const PhaseProblem problem(response, stops, scale.speed);
  for (const Vector& phases : form.phases(stops[0], stops[1])) {
    ++result.tried;
    std::optional<PhaseSolution> solution = solution_near(problem, scale.length, phases);
    if (!solution) continue;
    Orbit orbit = outline(*solution);
    const auto is_same = [&](const Orbit& other) { return same_orbit(other, orbit, scale.speed); };
    if (repeated_pattern(orbit) || std::any_of(known.begin(), known.end(), is_same)) continue;
    known.push_back(std::move(orbit));
    ++result.converged;
    if (judge.is_refused(*solution))
      ++result.refused;
    else
      result.solutions.push_back(std::move(*solution));
  }
  return result;
}

}  // namespace

PairSolutions solve_pairs(const TwoImpacts& form, const PeriodicResponse& response,
                          const PhaseJudge& judge, const std::vector<std::vector<int>>& pairs,
                          const MotionScale& scale, int threads, const StopSignal& stop) {
  std::vector<PairSolutions> solved(pairs.size());
  for_each_index(pairs.size(), threads, [&](std::size_t i) {
    if (!stop.requested()) solved[i] = solve_pair(form, response, judge, pairs[i], scale);
  });
  PairSolutions all;
  for (PairSolutions& pair : solved) {
    all.tried += pair.tried;
    all.converged += pair.converged;
    all.refused += pair.refused;
    std::move(pair.solutions.begin(), pair.solutions.end(), std::back_inserter(all.solutions));
  }
  return all;
}

namespace {

// A solution that penetrates by more than this part of a length is no orbit, whatever the error of
// its phases: a thousand times their accuracy.
constexpr double kSurely = 1e3 * kSameOrbit;

// Number of instants at which a motion is checked: 1/2, 1/4, 3/4, 1/8, .. of the orbit, so that
// those far apart come first.
constexpr int kLooks = 31;

double bit_reversed(int n) {
  double part = 0.0;
  for (double bit = 0.5; n > 0; n /= 2, bit *= 0.5) part += (n % 2) * bit;
  return part;
}

// The motion with impacts at given speeds, at which contact need not hold.
State motion_at(const PeriodicResponse& response, const PhaseSolution& solution, double phase) {
  State state = response.forced_state(phase);
  const double lap = kTurn * response.period();
  for (Eigen::Index i = 0; i < solution.phases.size(); ++i) {
    const int stop = solution.pattern.stops[static_cast<std::size_t>(i)];
    const double speed = solution.speeds[i];
    const Stop& met = response.system().stops[static_cast<std::size_t>(stop)];
    const double turn = phase - solution.phases[i];
    const State part =
        response.impulse_state(stop, (turn > 0.0 ? turn : turn + lap) / response.frequency());
    state.q -= met.restitution().jump(speed) * part.q;
  }
  return state;
}

}  // namespace

bool PhaseJudge::is_refused(const PhaseSolution& solution) const {
  if (keep_virtual_) return false;
  if (solution.speeds.minCoeff() < -kSurely * scale_.speed) return true;
  for (int look = 1; look <= kLooks; ++look) {
    const double phase = solution.phases[0] + kTurn * response_.period() * bit_reversed(look);
    const Vector q = motion_at(response_, solution, phase).q;
    for (const Stop& stop : system_.stops)
      if (stop.gap - stop.row.dot(q) < -kSurely * scale_.length) return true;
  }
  return false;
}

bool PhaseJudge::surely_virtual(const PhaseSolution& solution,
                                const std::vector<ImpactPoint>& points) const {
  if (solution.speeds.minCoeff() < -kSurely * scale_.speed) return true;
  const Admissibility classification = admissibility(system_, solution.pattern, points);
  return classification.nearest && classification.nearest->gap < -kSurely * scale_.length;
}

std::optional<Orbit> PhaseJudge::orbit_of(const PhaseSolution& solution) const {
  Orbit orbit = outline(solution);
  if (repeated_pattern(orbit)) return {};
  const PhaseProblem phases(response_, solution.pattern.stops, scale_.speed);
  const std::vector<ImpactPoint> points = phases.points(solution.phases);
  if (!keep_virtual_ && surely_virtual(solution, points)) return orbit;
  const ShootingProblem problem(solution.pattern, scale_);
  std::optional<ShootingSolution> polished = newton(problem, system_, problem.pack(system_, points));
  if (!polished) polished = seek(problem, system_, problem.pack(system_, points));
  if (!polished) return {};
  orbit = make_orbit(system_, problem, polished->x);
  if (repeated_pattern(orbit)) return {};
  return orbit;
}

}  // namespace graze
