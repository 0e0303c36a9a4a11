#include "graze/bifurcation/cut/detail/release_completion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "graze/base/angle.hpp"
#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/base/vector.hpp"
#include "graze/orbit/closed_form/harmonic_sum.hpp"
#include "graze/system/system.hpp"

namespace graze {
namespace {

// The contact force on a stop while the structure is held on its stops for ever.
//
// With W = diag(omega), C the damping, B the rows, D the directions and a the gaps of the closed
// stops, the response to a harmonic of the forcing is q = q_0 + Re(Q e^{i k theta}), and the
// forces, over the effective masses, are f_0 + Re(F e^{i k theta}), w = k Omega:
//
//   W^2 q_0 + D f_0 = load,     (W^2 - w^2 + i w C) Q + D F = amplitude,
//   B^T q_0 = a,                 B^T Q = 0.
//
// The structure stays at rest where the sum of f_0 and all swings is nowhere negative at every
// closed stop. Returns that sum at `stop`, one of the closed ones, m/s^2; nullopt when the held
// structure is in resonance without damping. Requires forcing.
std::optional<HarmonicSum> constraint_force(const System& system, const std::vector<int>& closed,
                                            int stop) {
  const Eigen::Index n = system.modes(), m = static_cast<Eigen::Index>(closed.size());
  Matrix at_rest = Matrix::Zero(n + m, n + m);
  Vector held = Vector::Zero(n + m);
  if (system.load()) held.head(n) = *system.load();
  at_rest.diagonal().head(n) = system.omega.cwiseAbs2();
  for (Eigen::Index i = 0; i < m; ++i) {
    const Stop& one = system.stops[static_cast<std::size_t>(closed[static_cast<std::size_t>(i)])];
    at_rest.col(n + i).head(n) = one.direction();
    at_rest.row(n + i).head(n) = one.row.transpose();
    held[n + i] = one.gap;
  }
  const Eigen::Index place = n + (std::find(closed.begin(), closed.end(), stop) - closed.begin());
  const auto swing = [&](int order, const ComplexVector& amplitude) {
    const double w = order * system.forcing()->frequency;
    Eigen::MatrixXcd swinging = at_rest.cast<Complex>();
    swinging.diagonal().head(n).array() -= w * w;
    swinging.topLeftCorner(n, n) += Complex(0.0, w) * system.damping().cast<Complex>();
    ComplexVector driven = ComplexVector::Zero(n + m);
    driven.head(n) = amplitude;
    return HarmonicSum::Term{order, solve(swinging, driven)[place]};
  };
  HarmonicSum force{LuFactors(at_rest).solve(held)[place],
                    {swing(1, system.forcing()->amplitude.cast<Complex>())}};
  for (const Harmonic& one : system.forcing()->harmonics)
    force.terms.push_back(swing(static_cast<int>(one.order), one.force()));
  if (!std::isfinite(force.least())) return {};
  return force;
}

// Where the contact force touches zero the stop is open for a time proportional to the square root
// of the distance: that time at 1e-10 of the parameter, in forcing periods.
constexpr double kInterrupted = 1e-5;
// An opening this long, in forcing periods, is known to some 1e-6 of itself.
constexpr double kOpened = 1e-4;
// Largest number of points before a boundary that may be flown once more instead of it, each at
// least half as far from it as the previous one.
constexpr int kMostBack = 8;
// A flight whose excursion, its duration to the power 4, is within rounding does not count: in the
// parameter, as its duration to the power 2, that is some 1e-8 of the range.
constexpr double kTold = 1e-6;
constexpr int kMostSecants = 16;  // each doubles the digits, nearly

// The shortest time for which a stop is open, s; infinite where none is closed again.
double shortest_opening(const ReleaseReturn& back, double period) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const SegmentSticking& first : back.segment.sticking)
    for (const SegmentSticking& next : back.segment.sticking) {
      if (next.from_start || next.stop != first.stop) continue;
      const double open = static_cast<double>(next.from.period - first.to.period) * period +
                          next.from.local - first.to.local;
      if (open >= 0.0) shortest = std::min(shortest, open);
    }
  return shortest;
}

// Whether a stop is released and closed again at once.
bool is_interrupted(const ReleaseReturn& back, double period) {
  return shortest_opening(back, period) <= kInterrupted * period;
}

// Whether the structure is released once in all periods and held again at once.
bool is_at_rest(const ReleaseReturn& back, int periods, double period) {
  return back.sticking.size() == 1 && back.shortest_sticking >= (periods - kInterrupted) * period;
}

// A solution before a boundary: its parameter, and the quantity that vanishes there.
struct NearBoundary {
  double parameter = 0.0, margin = 0.0;
};

constexpr Eigen::Index kMostSolutions = 5;
constexpr double kApart = 1.3;

// The factor by which the slope of the parameter over this power of the margin changes over the
// three nearest solutions.
double bend(const std::vector<NearBoundary>& used, int power) {
  const auto slope = [&](std::size_t k) {
    return (used[k + 1].parameter - used[k].parameter) /
           (std::pow(used[k + 1].margin, power) - std::pow(used[k].margin, power));
  };
  return std::abs(std::log(std::abs(slope(1) / slope(0))));
}

// By the nearest `count` solutions: p_0 of p = p_0 + p_1 m^lowest + p_2 m^(lowest + 1) + ...
double by_polynomial(const std::vector<NearBoundary>& used, Eigen::Index count, int lowest) {
  Matrix powers(count, count);
  Vector ahead(count);
  const NearBoundary& nearest = used.front();
  const double unit = used[static_cast<std::size_t>(count - 1)].margin;
  for (Eigen::Index i = 0; i < count; ++i) {
    const NearBoundary& at = used[static_cast<std::size_t>(i)];
    ahead[i] = at.parameter - nearest.parameter;
    powers(i, 0) = 1.0;
    for (int k = 1; k < count; ++k) powers(i, k) = std::pow(at.margin / unit, lowest + k - 1);
  }
  return nearest.parameter + PivotedLu<double>(powers).solve(ahead)[0];
}

// The parameter where the margin is zero, by the polynomial through solutions at margins that grow
// by at least kApart, from `reliable` on (two or more). On the side where the margin is positive
// the parameter is a smooth function of it, with or without a linear term. `solutions`: the nearest
// to the boundary last. Returns nullopt when there are fewer than two.
std::optional<double> vanishing_at(const std::vector<NearBoundary>& solutions, double reliable) {
  std::vector<NearBoundary> used;
  for (auto at = solutions.rbegin(); at != solutions.rend() && std::ssize(used) < kMostSolutions;
       ++at)
    if (at->margin >= (used.empty() ? reliable : kApart * used.back().margin)) used.push_back(*at);
  if (used.size() < 2) return {};
  const int lowest = used.size() > 2 && bend(used, 2) < bend(used, 1) ? 2 : 1;
  // As long as a further solution improves it: farther ones need not lie where the margin is
  // smooth.
  double best = used.front().parameter, change = std::numeric_limits<double>::infinity();
  for (Eigen::Index count = 2; count <= std::ssize(used); ++count) {
    const double value = by_polynomial(used, count, lowest);
    if (!(std::abs(value - best) < change)) break;
    change = std::abs(value - best);
    best = value;
  }
  return best;
}

// Where the stop is no longer released, extrapolated from orbits before that: bisection only comes
// as near as an opening can be detected.
double last_opening(const SegmentEquations& equations, const std::vector<SolutionPoint>& reached) {
  std::vector<NearBoundary> near;
  for (const SolutionPoint& point : reached)
    if (const auto back = equations.follow(point))
      near.push_back({point.parameter, shortest_opening(*back, equations.period_at(point))});
  return vanishing_at(near, kOpened * equations.period_at(reached.back()))
      .value_or(reached.back().parameter);
}

// The orbit beyond if its stuck phases differ: of those next to the boundary with the same stuck
// phases, the farthest.
std::optional<SolutionPoint> orbit_beyond(const ReleaseApproach& approach) {
  std::optional<SolutionPoint> other;
  const auto& others = approach.others;
  for (auto known = others.rbegin(); known != others.rend(); ++known) {
    if (known->second.size() == approach.last.sticking.size() ||
        known->second != others.back().second)
      break;
    other = known->first;
  }
  return other;
}

// The last of the points reached whose orbit is found again: on the boundary itself rounding may
// decide otherwise when it is flown again.
std::optional<SolutionPoint> last_orbit(const SegmentEquations& equations,
                                        const std::vector<SolutionPoint>& reached) {
  int back = 0;
  for (auto point = reached.rbegin(); point != reached.rend() && back < kMostBack; ++point, ++back)
    if (equations.judge(*point)) return *point;
  return {};
}

}  // namespace

ReleaseTip completion(const SegmentEquations& equations, const ReleaseApproach& approach) {
  const SolutionPoint& inside = approach.reached.back();
  const ReleaseReturn& here = approach.last;
  const std::optional<ReleaseReturn>& beyond = approach.beyond;
  const double period = equations.period_at(inside);
  const bool one_less = has_shrunk(here, period);
  bool one_more = false, cut_here = is_interrupted(here, period), cut = cut_here;
  if (beyond) {
    const double period_beyond = equations.period_at(approach.at_beyond);
    one_more = beyond->returns && beyond->sticking.size() > here.sticking.size() &&
               has_shrunk(*beyond, period_beyond);
    cut = cut || is_interrupted(*beyond, period_beyond);
  }
  const bool changes = one_less || one_more;
  if ((!changes && !cut) || !approach.settled) return {};
  const bool extrapolated = !changes && cut_here;
  const double value = extrapolated ? last_opening(equations, approach.reached) : inside.parameter;
  const std::optional<SolutionPoint> boundary = last_orbit(equations, approach.reached);
  if (!boundary) return {};
  const int periods = equations.period();
  const OrbitBranchEnd end = is_at_rest(here, periods, period) ? OrbitBranchEnd::kAtRest
                                                               : OrbitBranchEnd::kChatterCompletes;
  return {end,
          boundary,
          false,
          !changes,
          value,
          orbit_beyond(approach),
          bracket_around({inside.parameter, approach.at_beyond.parameter, value}, !extrapolated)};
}

std::optional<std::pair<double, double>> lift_off(const SegmentEquations& equations, double range,
                                                  const ReleaseTip& tip) {
  const double near = tip.value;
  // What the orbits leave open is decided here.
  const double reach = std::max(kTold * range, 2.0 * std::abs(tip.bracket.to - tip.bracket.from));
  const SegmentLayout& layout = equations.layout();
  const auto held_at = [&](double value) {
    const System* system = equations.system_at(value);
    return system ? constraint_force(*system, layout.closed, *layout.released)
                  : std::optional<HarmonicSum>();
  };
  double before = near - reach, value = near;
  for (int step = 0; step < kMostSecants; ++step) {
    const std::optional<HarmonicSum> a = held_at(before), b = held_at(value);
    if (!a || !b) return {};
    if (a->least() == b->least()) break;
    const double next = value - b->least() * (value - before) / (b->least() - a->least());
    if (!(std::abs(next - near) <= reach)) return {};
    before = value;
    value = next;
    if (value == before) break;
  }
  const std::optional<HarmonicSum> there = held_at(value);
  if (!there) return {};
  return std::pair(value, wrapped(there->phase_of_least()));
}

}  // namespace graze
