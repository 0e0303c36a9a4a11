#include "graze/bifurcation/cut/detail/grazing_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "graze/continuation/branch/detail/locate.hpp"

namespace graze {
namespace {

// Largest number of samples within one step. A grazing pair takes one or two, and each further
// sample at least halves the suspected interval.
constexpr std::size_t kMostSamples = 40;

// A gap with constant curvature that falls to zero and returns to its value within a step begins
// with a rate of four times its size per step; one that falls through zero, with its size. Twice
// what is needed for the latter.
constexpr double kReach = 2.0;

// The approach nearest to where another one is half the piece later (or, backwards, earlier).
const OrbitMargin* partner(const OrbitMargin& margin, const std::vector<OrbitMargin>& others,
                           double half) {
  const OrbitMargin* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const OrbitMargin& other : others) {
    if (other.impact != margin.impact || other.stop != margin.stop) continue;
    const double apart = std::abs((margin.after + half * margin.after_rate) -
                                  (other.after - half * other.after_rate));
    if (apart < least) {
      least = apart;
      nearest = &other;
    }
  }
  return nearest;
}

}  // namespace

double SeenSolution::smallest_speed() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const OrbitMargin& speed : speeds) smallest = std::min(smallest, speed.value);
  return smallest;
}

GrazingSamples::GrazingSamples(const FlightEquations& equations, const ContinuationOptions& options)
    : equations_(equations), corrector_(equations.problem(), options) {}

OrbitDirection GrazingSamples::direction(const SolutionPoint& point) const {
  const Eigen::Index n = point.u.size();
  const System& system = *equations_.system_at(point.parameters());
  return {equations_.shooting().unpack(system, point.tangent.head(n)),
          point.tangent[n] * corrector_.range(), equations_.tangent_at(point.parameters())};
}

SeenSolution GrazingSamples::seen(const SolutionPoint& point, const OrbitBranchPoint& at) const {
  const System& system = *equations_.system_at(point.parameters());
  const OrbitDirection along = direction(point);
  const std::vector<ImpactPoint> impacts = equations_.points(point);
  return {&point, at.orbit.admissible, at.orbit.clearance,
          speed_margins(system, equations_.pattern(), impacts, along),
          gap_drift(system, equations_.pattern(), impacts, along)};
}

std::vector<OrbitMargin> GrazingSamples::approaches(const SeenSolution& solution,
                                                    double level) const {
  const System& system = *equations_.system_at(solution.point->parameters());
  return approach_margins(system, equations_.pattern(), equations_.points(*solution.point),
                          direction(*solution.point), level);
}

// Interpolants of all quantities that may reach zero between a and b; empty where the
// classification cannot change.
std::vector<MarginInterpolant> GrazingSamples::interpolants(const SeenSolution& a,
                                                            const SeenSolution& b) const {
  const double step = arclength(corrector_, *a.point, *b.point);
  const double still = still_speed(*equations_.system_at(a.point->parameters()));
  std::vector<MarginInterpolant> list;
  for (std::size_t i = 0; i < a.speeds.size(); ++i) {
    list.push_back(MarginInterpolant::between(a.speeds[i].value, step * a.speeds[i].rate,
                                              b.speeds[i].value, step * b.speeds[i].rate));
    list.back().rounding = still;
  }
  const double reach = kReach * step * std::max(a.drift, b.drift);
  const double far = std::numeric_limits<double>::infinity();
  const double lowest = std::min(a.clearance.value_or(far), b.clearance.value_or(far));
  // A penetration this deep still exists at the other end.
  if (lowest < -reach) return {};
  // Twice as far, so that an approach near at one end is listed at the other, too.
  if (lowest <= reach) add_approaches(a, b, step, 2.0 * reach, list);
  return list;
}

void GrazingSamples::add_approaches(const SeenSolution& a, const SeenSolution& b, double step,
                                    double level,
                                    std::vector<MarginInterpolant>& interpolants) const {
  const double rounding = still_gap(*equations_.system_at(a.point->parameters()));
  const std::vector<OrbitMargin> at_a = approaches(a, level), at_b = approaches(b, level);
  const auto add = [&](MarginInterpolant interpolant) {
    interpolant.rounding = rounding;
    interpolants.push_back(interpolant);
  };
  for (const OrbitMargin& start : at_a) {
    const OrbitMargin* end = partner(start, at_b, 0.5 * step);
    if (end && partner(*end, at_a, -0.5 * step) == &start)
      add(MarginInterpolant::between(start.value, step * start.rate, end->value, step * end->rate));
    else
      add(MarginInterpolant::from_start(start.value, step * start.rate));
  }
  for (const OrbitMargin& end : at_b) {
    const OrbitMargin* start = partner(end, at_a, -0.5 * step);
    if (!start || partner(*start, at_b, 0.5 * step) != &end)
      add(MarginInterpolant::to_end(end.value, step * end.rate));
  }
}

std::optional<SolutionPoint> GrazingSamples::suspected(const SeenSolution& a,
                                                       const SeenSolution& b) {
  const std::vector<MarginInterpolant> all = interpolants(a, b);
  // Where the classification at an end depends on something else the interpolants do not apply.
  if (all.empty() || all_positive(all, 0.0) != a.admissible ||
      all_positive(all, 1.0) != b.admissible)
    return {};
  const std::optional<double> part = suspected_sign_change(all);
  if (!part) return {};
  return point_between(corrector_, *a.point, *part * corrector_.ahead(*a.point, *b.point), *a.point,
                       *b.point);
}

std::list<GrazingSample> GrazingSamples::between(const SeenSolution& a, const SeenSolution& b) {
  std::list<GrazingSample> samples;
  const SeenSolution* from = &a;
  for (auto to = samples.begin(); samples.size() < kMostSamples;) {
    std::optional<SolutionPoint> point = suspected(*from, to == samples.end() ? b : to->seen);
    if (point && equations_.system_at(point->parameters())) {
      to = samples.insert(to, {std::move(*point), {}, {}});
      to->at = equations_.orbit_at(to->point);
      to->seen = seen(to->point, to->at);
      continue;
    }
    if (to == samples.end()) break;
    from = &to->seen;
    ++to;
  }
  return samples;
}

}  // namespace graze
