#include "graze/orbit/problem/detail/chatter_completion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "graze/flow/variation/detail/deviation.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Shortest time before the release at which impacts are used, in the shortest time constant: d has
// an error of some s^(k + 2), k > 1.37, and of the rounding of a speed that goes with s^2, times
// s^k.
constexpr double kNearest = 1e-3;
// Impacts slower than this many times the error of speeds are not used.
constexpr double kKnown = 1e5;
// Likeness of impacts: further from the completion, those are used whose speeds are off by some
// 10^-k.
constexpr double kAlike = 10.0;
// The longest time before the release, in 1/Omega.
constexpr double kFarthest = 1.0;
// With r = 0 an impact after the release is searched for during this part of a forcing period.
constexpr double kBeyond = 0.1;

struct Similar {
  double before = 0.0;  // s before the release
  double excess = 0.0;  // v/(w a s^2) - 1
};

// The rate at which the push falls at the release, m/s^3: the third derivative of the released
// motion is the second derivative of its velocity, which does not contain the load.
double falling_push(const System& system, const SegmentLayout& layout, const State& at,
                    double theta) {
  std::vector<int> held = layout.closed;
  std::erase(held, *layout.released);
  const State rate = held_rate(system, held, at, theta);
  System moved = system;
  if (moved.load()) moved.modal().load->setZero();
  // Of a quarter turn later, where the rate of each harmonic is its force here.
  const double frequency = system.forcing()->frequency;
  moved.modal().forcing->amplitude *= frequency;
  for (Harmonic& one : moved.modal().forcing->harmonics) {
    const double c = std::cos(0.5 * std::numbers::pi * one.order),
                 n = std::sin(0.5 * std::numbers::pi * one.order);
    const Vector cosine = one.order * frequency * (n * one.cosine + c * one.sine);
    one.sine = one.order * frequency * (n * one.sine - c * one.cosine);
    one.cosine = cosine;
  }
  const Vector jerk =
      held_rate(moved, held, {rate.q, rate.qdot}, theta + 0.5 * std::numbers::pi).qdot;
  return -system.stops[static_cast<std::size_t>(*layout.released)].row.dot(jerk);
}

// Time from the stop's previous release to this one, s.
double last_release_before(const System& system, const TrajectorySegment& segment, int stop,
                           const Instant<double>& release) {
  // The time of this release satisfies the force equation to the accuracy of a solution.
  const double together = kShootingAccuracy * system.period();
  double since = std::numeric_limits<double>::infinity();
  for (const SegmentSticking& sticking : segment.sticking) {
    const double before = seconds_between(system, sticking.to, release);
    if (sticking.stop == stop && !sticking.to_end && before > together)
      since = std::min(since, before);
  }
  return since;
}

// d by the impacts around a time: with weights that sum to one for impacts in the ratio lambda.
std::optional<double> distance_at(const std::vector<Similar>& impacts, double about, double lambda,
                                  double k) {
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i + 1 < impacts.size(); ++i) {
    const Similar &a = impacts[i], &b = impacts[i + 1];
    if (!(b.before > 0.0)) continue;
    const double away = std::log(std::sqrt(a.before * b.before) / about) / std::log(lambda);
    if (!(std::abs(away) < 1.0)) continue;
    const double ratio = b.before / a.before,
                 weight = 0.5 + 0.5 * std::cos(std::numbers::pi * away);
    weights += weight;
    sum += weight * (b.excess - ratio * a.excess) /
           (std::pow(b.before, -k) - ratio * std::pow(a.before, -k));
  }
  return weights > 0.0 ? std::optional(sum / weights) : std::nullopt;
}

}  // namespace

double completing_ratio(double restitution) {
  double low = 0.0, high = 1.0;
  for (double middle = 0.5; low < middle && middle < high; middle = 0.5 * (low + high))
    (middle * middle * (2.0 + middle) < restitution * (1.0 + 2.0 * middle) ? low : high) = middle;
  return restitution > 0.0 ? low : 0.0;
}

double parting_ratio(double restitution) {
  return restitution * restitution / std::pow(completing_ratio(restitution), 5);
}

std::optional<double> completion_distance(const System& system, const SegmentShooting& shooting,
                                          const Vector& u) {
  const SegmentLayout& layout = shooting.layout();
  const SectionMap& map = shooting.map();
  const Vector x = shooting.at_section(u, 0);
  const auto chart = map.chart_at(system, x);
  const auto start = map.start_of(system, x, shooting.theta_of(u));
  if (!chart || !start) return {};
  const double r = system.stops[static_cast<std::size_t>(*layout.released)].restitution().at_rest();
  const Instant<double> release{layout.period, start->instant.local};
  const Instant<double> end =
      r > 0.0 ? release : later(release, kBeyond * system.period(), system.period());
  const TrajectorySegment segment = pass(system, *start, end, map.options());
  const double push = falling_push(system, layout, chart->state, shooting.theta_of(u));
  if (!segment.failure.empty() || !(push > 0.0)) return {};
  const double frequency = system.forcing()->frequency, lambda = completing_ratio(r);
  const double w = ((1.0 - lambda) / 2.0 - (1.0 - lambda) * (1.0 - lambda) / 6.0) / r;
  std::vector<Similar> impacts;
  const double since = last_release_before(system, segment, *layout.released, release);
  for (const SegmentImpact& one : segment.impacts) {
    const double s = seconds_between(system, one.at, release);
    if (one.stop != *layout.released || s >= since) continue;
    impacts.push_back({frequency * s, one.speed / (w * push * s * s) - 1.0});
  }
  if (impacts.empty()) return {};
  if (r == 0.0)
    return std::ranges::min(impacts, {}, [](const Similar& one) { return std::abs(one.before); })
        .before;
  const double k = std::log(parting_ratio(r)) / std::log(1.0 / lambda);
  const double nearest =
      frequency * std::max(kNearest / std::max(system.omega.maxCoeff(), frequency),
                           std::sqrt(kKnown * still_speed(system) / (w * push)));
  // The nearest time at which impacts are still similar, as far as d leaves them so; further from
  // the completion they are less similar.
  for (const double likeness : {kAlike, 0.3 * kAlike})
    for (double look = nearest; look < kFarthest; look *= 2.0) {
      const std::optional<double> distance = distance_at(impacts, look, lambda, k);
      if (!distance) continue;
      const double alike = likeness * std::pow(std::abs(*distance), 1.0 / k) / std::sqrt(lambda);
      if (alike <= look) return distance_at(impacts, std::max(nearest, alike), lambda, k);
    }
  return {};
}

}  // namespace graze
