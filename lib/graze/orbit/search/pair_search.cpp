#include "graze/orbit/search/detail/pair_search.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "graze/base/parallel.hpp"
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

}  // namespace graze
