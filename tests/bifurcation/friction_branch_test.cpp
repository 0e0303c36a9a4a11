// Branches of orbits with dry friction: where they begin to stick, where a self-excited one ends.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "graze/bifurcation/cut/detail/sliding_order.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

constexpr double kPi = std::numbers::pi;

// A mass of 1 on a spring of 1.
Scene oscillator(double damping, const std::string& more) {
  return parse_scene(
      "[lumped]\nmasses = [1.0]\n[[lumped.spring]]\nbetween = [0, 1]\n"
      "stiffness = 1.0\ndamping = " +
          std::to_string(damping) + "\n" + more,
      "oscillator");
}

std::string forced(double frequency) {
  return "[forcing]\nkind = \"point\"\nmass = 1\namplitude = 1.0\nfrequency = " +
         std::to_string(frequency) + "\n[[friction]]\nmass = 1\nforce = 0.2\n";
}

OrbitBranches traced(const Scene& scene, const std::string& parameter, double from, double to,
                     int start_values = 3) {
  const SystemFamily family(scene, parameter);
  BranchOptions options;
  options.from = from;
  options.to = to;
  options.impacts = 0;
  options.start_values = start_values;
  return trace_orbits(family, options);
}

// The friction up to which Den Hartog's motion has no stops: V/sqrt(U^2 + 1/b^4).
TEST(FrictionBranch, BeginsToStickAtDenHartogsLimit) {
  for (const double b : {0.7, 0.8, 1.25, 1.5, 2.0}) {
    const double v = 1.0 / (1.0 - b * b), u = std::sin(kPi / b) / (b * (1.0 + std::cos(kPi / b)));
    const double limit = std::sqrt(v * v / (u * u + 1.0 / std::pow(b, 4)));
    const OrbitBranches found =
        traced(oscillator(0.0, forced(b)), "friction.force", 0.5 * limit, 1.05 * limit);
    ASSERT_EQ(found.branches.size(), 1u) << b;
    ASSERT_EQ(found.branches[0].special.size(), 1u) << b;
    const SpecialPoint& special = found.branches[0].special[0];
    EXPECT_EQ(special.kind, SpecialKind::kCrossingSliding) << b;
    EXPECT_NEAR(special.at.value, limit, 1e-10) << b;
  }
}

// Up to a friction of pi/4 of the force the amplitude grows without bound towards resonance (Den
// Hartog): a branch that ends there, where rounding decides, does not come back to its start.
TEST(FrictionBranch, DoesNotCloseThroughResonance) {
  const OrbitBranches found =
      traced(oscillator(0.0, forced(0.992)), "forcing.frequency", 0.99, 1.0, 1);
  ASSERT_EQ(found.branches.size(), 1u);
  EXPECT_EQ(found.branches[0].ends[0], OrbitBranchEnd::kParameterLimit);
  EXPECT_EQ(found.branches[0].ends[1], OrbitBranchEnd::kNotConverged);
}

// Beside each special point the orbits slide and stick in another order.
TEST(FrictionBranch, ChangesTheOrderAtItsSpecialPoints) {
  const Scene scene = oscillator(0.1, forced(0.3));
  const OrbitBranches found = traced(scene, "forcing.frequency", 0.06, 1.2);
  ASSERT_EQ(found.branches.size(), 1u);
  const std::vector<SpecialPoint>& special = found.branches[0].special;
  ASSERT_GE(special.size(), 4u);
  const SystemFamily family(scene, "forcing.frequency");
  SegmentOptions options;
  for (const SpecialPoint& at : special) {
    std::vector<Orbit> beside;
    for (const double step : {-1e-6, 1e-6}) {
      const auto near =
          followed_orbit(*family.at(at.at.value + step), turns_of(at.at.orbit), options);
      ASSERT_TRUE(near.orbit) << near.why_not;
      beside.push_back(*near.orbit);
    }
    EXPECT_FALSE(has_same_sliding(beside[0], beside[1])) << at.id << " " << at.at.value;
  }
}

// Where |force| of the first friction would peak at the end of its first rest, N: of the parabola
// through the last three samples before it slips.
double peak_of_rest(const System& system, const Orbit& orbit, double sliding) {
  constexpr double kSamples = 20000;
  RunState from;
  from.motion = orbit.section->states.front();
  from.streaks.resize(system.stops.size());
  from.contacts.resize(system.stops.size());
  SimulationOptions options;
  const double begin = seconds_at(from.motion.instant, system.period());
  options.duration = begin + system.period();
  std::vector<double> force;
  RunListeners listeners;
  listeners.sample_rate = kSamples / system.period();
  listeners.sample_from = begin;
  listeners.sample = [&](const Sample& at) { force.push_back(std::abs(at.frictions[0])); };
  resume(system, from, options, listeners);
  std::size_t last = 3;
  while (last + 1 < force.size() && (force[last - 2] == sliding || force[last + 1] != sliding))
    ++last;
  const double a = force[last - 2], b = force[last - 1], c = force[last];
  return b + (a - c) * (a - c) / (8.0 * (2.0 * b - a - c));
}

// Where friction at rest may be larger than in sliding, a branch ends where a rest would not break:
// the force there only touches the limit.
TEST(FrictionBranch, EndsWhereARestIsAboutToBreak) {
  const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/39_friction_damper.toml");
  const OrbitBranches found = traced(scene, "forcing.frequency", 6.9, 7.3);
  ASSERT_EQ(found.branches.size(), 1u);
  const OrbitBranch& branch = found.branches[0];
  ASSERT_EQ(branch.ends[1], OrbitBranchEnd::kSliding);
  EXPECT_EQ(branch.special.back().kind, SpecialKind::kAddingSliding);
  const SystemFamily family(scene, "forcing.frequency");
  const OrbitBranchPoint& end = branch.points.back();
  EXPECT_NEAR(peak_of_rest(*family.at(end.value), end.orbit, 0.4), 0.5, 1e-9);
}

// A mass behind a Jenkins element no longer slips where its spring, as one of the structure, pulls
// with less than the friction: k/|K + k - W^2 + i c W| = L.
TEST(FrictionBranch, EndsWhereASpringInSeriesNoLongerSlips) {
  const double k = 2.0, damping = 0.02, limit = 0.8;
  const OrbitBranches found =
      traced(oscillator(damping,
                        "[forcing]\nkind = \"point\"\nmass = 1\namplitude = 1.0\n"
                        "frequency = 1.2\n[[friction]]\nmass = 1\nforce = 0.8\n"
                        "series = 2.0\n"),
             "forcing.frequency", 0.5, 2.0, 1);
  ASSERT_EQ(found.branches.size(), 1u);
  double low = 0.5, high = 1.0;
  for (int i = 0; i < 100; ++i) {
    const double w = 0.5 * (low + high);
    (k / std::hypot(1.0 + k - w * w, damping * w) < limit ? low : high) = w;
  }
  const OrbitBranch& branch = found.branches[0];
  EXPECT_EQ(branch.ends[0], OrbitBranchEnd::kSliding);
  EXPECT_NEAR(branch.points.front().value, low, 1e-7);
}

std::string on_belt(double speed) {
  return "[[friction]]\nmass = 1\nforce = 1.0\nstatic_force = 1.5\nspeed = " +
         std::to_string(speed);
}

Scene on_belt(double damping, double speed) {
  Scene scene = oscillator(damping, on_belt(speed));
  scene.forcing = Forcing();
  scene.forcing->kind = ForcingKind::kNone;
  scene.forcing->frequency = 1.0;
  return scene;
}

// Slip lasts 2 (pi - atan((S - R)/(m w V)))/w, the belt carries the mass back in 2 (S - R)/(k V).
TEST(SelfExcited, HasThePeriodOfStickAndSlip) {
  const OrbitBranches found = traced(on_belt(0.0, 0.3), "friction.speed", 0.1, 2.0, 1);
  ASSERT_EQ(found.branches.size(), 1u);
  ASSERT_GE(found.branches[0].points.size(), 10u);
  for (const OrbitBranchPoint& point : found.branches[0].points) {
    const double v = point.value;
    EXPECT_NEAR(*point.orbit.lasts, 2.0 * (kPi - std::atan(0.5 / v)) + 1.0 / v, 1e-10) << v;
  }
}

// With damping the slip comes back to the speed of the belt only up to a speed: where the largest
// velocity of q'' + c q' + q = R from q' = V, q'' = R - S - .. is V again.
TEST(SelfExcited, EndsWhereTheMassNoLongerReachesTheBelt) {
  for (const double c : {0.05, 0.1, 0.2}) {
    const double d = 0.5 * c, w = std::sqrt(1.0 - d * d);
    const auto velocity = [&](double v, double t) {
      return std::exp(-d * t) * (v * std::cos(w * t) + (-0.5 + d * v) / w * std::sin(w * t));
    };
    const auto missed = [&](double v) {
      // The velocity is largest where it no longer rises, in the second half of the swing.
      double low = kPi / w, high = 2.0 * kPi / w;
      for (int i = 0; i < 200; ++i) {
        const double t = 0.5 * (low + high);
        const double a = v, b = (-0.5 + d * v) / w;
        const double rate = -d * (a * std::cos(w * t) + b * std::sin(w * t)) +
                            w * (b * std::cos(w * t) - a * std::sin(w * t));
        (rate > 0.0 ? low : high) = t;
      }
      return v - velocity(v, low);
    };
    double low = 0.01, high = 2.0;
    for (int i = 0; i < 200; ++i) {
      const double v = 0.5 * (low + high);
      (missed(v) < 0.0 ? low : high) = v;
    }
    const OrbitBranches found = traced(on_belt(c, 0.1), "friction.speed", 0.05, 2.0, 1);
    ASSERT_EQ(found.branches.size(), 1u) << c;
    EXPECT_EQ(found.branches[0].ends[1], OrbitBranchEnd::kSliding) << c;
    EXPECT_NEAR(found.branches[0].points.back().value, low, 1e-9) << c;
  }
}

}  // namespace
}  // namespace graze
