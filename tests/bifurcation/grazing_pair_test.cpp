// Grazings that lie together within one step: a gap that dips below zero and recovers, and orbits
// between two solutions that are none. Expected are the values at which the closed form's solutions
// touch, by bisection of their speed and of the smallest gap of their motion, sampled and refined.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <optional>
#include <sstream>

#include "branch_checks.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {
namespace {

using support::special_points;

constexpr double kInverseGolden = 0.61803398874989485;

// The lowest value of f between a and b, where it has one minimum.
template <class F>
double minimum(const F& f, double a, double b, double* place = nullptr) {
  double x = b - kInverseGolden * (b - a), y = a + kInverseGolden * (b - a);
  double at_x = f(x), at_y = f(y);
  for (int i = 0; i < 70; ++i) {
    (at_x < at_y ? b : a) = at_x < at_y ? y : x;
    if (at_x < at_y) {
      y = x;
      at_y = at_x;
      at_x = f(x = b - kInverseGolden * (b - a));
    } else {
      x = y;
      at_x = at_y;
      at_y = f(y = a + kInverseGolden * (b - a));
    }
  }
  if (place) *place = 0.5 * (a + b);
  return std::min(at_x, at_y);
}

// Smallest interior minimum of the gap over the flight of a (1, 1) orbit, m.
double sampled_clearance(const System& system, const ImpactPoint& impact) {
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  const State after = after_impact(system.stops[0], impact.before);
  arc.start(impact.theta, after.q, after.qdot);
  Vector q(system.modes()), qdot(system.modes());
  const auto gap = [&](double s) {
    arc.state(s, q, qdot);
    return system.stops[0].gap - system.stops[0].row.dot(q);
  };
  // Some twenty samples in a period of the third mode.
  constexpr int kSamples = 2000;
  const double step = system.period() / kSamples;
  double lowest = std::numeric_limits<double>::infinity();
  double before = gap(0.0), here = gap(step);
  for (int i = 2; i < kSamples; ++i) {
    const double next = gap(i * step);
    if (here < before && here <= next)
      lowest = std::min(lowest, minimum(gap, (i - 2) * step, i * step));
    before = here;
    here = next;
  }
  return lowest;
}

struct PairCase {
  std::vector<std::string> settings;  // of the beam of scene 05
  std::string parameter;
  double from, to;               // range
  double low = 0.0, high = 0.0;  // where the pair lies
  std::size_t which = 0;         // of the closed form's solutions
};

// The smaller of impact speed and clearance, in units of 1 m/s and 1 m: its sign is the
// classification. Nothing where the closed form has no solution.
std::optional<double> margin(const SystemFamily& family, std::size_t which, double value) {
  const System system = *family.at(value);
  const ClosedFormAnswer answer = closed_form(system, 0, 1);
  if (!answer.form) return {};
  const auto solutions = answer.form->solutions(system.stops[0].gap);
  if (which >= solutions.size()) return {};
  const ImpactPoint& impact = solutions[which];
  return std::min(system.stops[0].row.dot(impact.before.qdot), sampled_clearance(system, impact));
}

// Both values where the margin passes zero in the window, where it turns once.
std::array<double, 2> expected_pair(const SystemFamily& family, const PairCase& c) {
  const auto at = [&](double value) { return margin(family, c.which, value).value(); };
  const bool island = at(c.low) < 0.0;
  double middle = 0.0;
  minimum([&](double value) { return island ? -at(value) : at(value); }, c.low, c.high, &middle);
  EXPECT_LT(at(middle) * at(c.low), 0.0);
  std::array<double, 2> pair{};
  for (const int side : {0, 1}) {
    double outside = side == 0 ? c.low : c.high, inside = middle;
    for (int i = 0; i < 60; ++i) {
      const double half = 0.5 * (outside + inside);
      ((at(half) > 0.0) == island ? inside : outside) = half;
    }
    pair[static_cast<std::size_t>(side)] = 0.5 * (outside + inside);
  }
  return pair;
}

OrbitBranches traced(const SystemFamily& family, const PairCase& c, double max_step) {
  BranchOptions options;
  options.from = c.from;
  options.to = c.to;
  options.max_step = max_step;
  options.keep_virtual = true;
  options.sticking = false;
  return trace_orbits(family, options);
}

void expect_pair(const PairCase& c) {
  SCOPED_TRACE(testing::Message() << c.settings.back() << " near " << c.low);
  const SystemFamily family(support::shipped_scene("05_wagg_one_mode", c.settings), c.parameter);
  const std::array<double, 2> expected = expected_pair(family, c);
  for (const double parts : {0.0, 1000.0}) {
    const double step = parts > 0.0 ? std::abs(c.to - c.from) / parts : 0.0;
    const OrbitBranches result = traced(family, c, step);
    std::vector<double> found;
    for (const SpecialPoint* special : special_points(result, SpecialKind::kGrazing))
      if (special->at.value > c.low && special->at.value < c.high)
        found.push_back(special->at.value);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), 2u) << "parts " << parts;
    // The margin leaves zero on a parabola: what rounding does to it counts by its root.
    for (const std::size_t i : {0, 1}) EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-9);
  }
}

// Orbits between a speed that vanishes and an approach that touches, within one default step.
TEST(GrazingPairs, OfASpeedAndOfAnApproach) {
  PairCase c{{"beam.modes=3", "forcing.frequency=29.491525"}, "stop.gap", 0.0002, 0.006};
  c.low = 0.00561;
  c.high = 0.00571;
  c.which = 1;
  expect_pair(c);
  c.settings.back() = "forcing.frequency=47.118644";
  c.low = 0.00141;
  c.high = 0.00144;
  c.which = 0;
  expect_pair(c);
}

// Where approaches touch in one point of the branch: gap and frequency there, and for a gap that is
// smaller by a part e half the distance of the pair at most, over sqrt(e). In the first the orbits
// between two approaches end, in the second a gap dips below zero, in the third it rises above.
struct Tangency {
  double gap, frequency, half_distance;
  std::size_t which;
};

TEST(GrazingPairs, OfApproachesHoweverNear) {
  for (const Tangency& t :
       {Tangency{0.00227212659, 21.13931, 0.059, 1}, Tangency{0.00433284061, 40.23254, 0.194, 0},
        Tangency{0.00449847689, 24.125595, 0.068, 1}})
    for (const double beside : {1e-4, 1e-5, 1e-7}) {
      std::ostringstream gap;
      gap << "stop.gap=" << std::setprecision(17) << t.gap * (1.0 - beside);
      PairCase c{{"beam.modes=2", gap.str()}, "forcing.frequency", 15.0, 65.0};
      c.low = t.frequency - 1.7 * t.half_distance * std::sqrt(beside);
      c.high = t.frequency + 1.7 * t.half_distance * std::sqrt(beside);
      c.which = t.which;
      expect_pair(c);
    }
}

}  // namespace
}  // namespace graze
