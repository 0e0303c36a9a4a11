// Components of (1, 1) orbits where the restitution depends on the speed, r(v) = a0 - a1 v. The
// referee is a scalar equation of its own: for a constant r the two solutions at a value have the
// speeds V1(r) and V2(r), by the formulas of an oscillator solved by hand; with r(v) the speeds are
// the fixed points v = V1(r(v)) and v = V2(r(v)), found by a scan.
#include "graze/bifurcation/bounds/detail/speed_survey.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "branch_checks.hpp"
#include "impacting_oscillator.hpp"

namespace graze {
namespace {

using support::Real;

// Unit mass, frequency and force; its stop at `gap`.
struct SurveyedOscillator {
  Real ratio, gap, at_rest, falling;  // r = at_rest - falling v

  // Impact speeds at a constant r, or nothing: NaN.
  std::array<Real, 2> speeds(Real frequency, Real r) const {
    const auto [kappa, speed] = support::impact_response(ratio, r, frequency);
    const Real half = std::acos(gap / std::abs(kappa));
    const auto at = [&, kappa = kappa, speed = speed](Real side) {
      return (speed * std::polar(Real(1), side - std::arg(kappa))).real();
    };
    return {at(half), at(-half)};
  }

  // Positive speeds v = V(r(v)), by the zeros of (V1 - v)(V2 - v): smooth where the two meet.
  int orbits(Real frequency, Real most) const {
    constexpr int kSamples = 20'000;
    int count = 0;
    Real before = std::nanl("");
    for (int i = 1; i <= kSamples; ++i) {
      const Real v = most * i / kSamples;
      const Real r = std::min(std::max(at_rest - falling * v, Real(0)), Real(1));
      const auto [a, b] = speeds(frequency, r);
      const Real here = (a - v) * (b - v);
      if (here * before < 0) ++count;
      before = here;
    }
    return count;
  }
};

OrbitBranches traced(double max_step) {
  const Scene scene = support::shipped_scene("04_impact_oscillator",
                                             {"stop.gap=0.15", "stop.restitution=[0.9, 0.12]"});
  BranchOptions options;
  options.from = 1.2;
  options.to = 4.0;
  options.max_step = max_step;
  options.keep_virtual = true;
  options.sticking = false;
  options.finder.from_simulation = options.finder.from_random = false;
  return trace_orbits(SystemFamily(scene, "forcing.frequency"), options);
}

// How often branches pass a value at positive speed.
int positive_segments(const OrbitBranches& result, double value) {
  int count = 0;
  for (const OrbitBranch& branch : result.branches)
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
      const OrbitBranchPoint &a = branch.points[i], &b = branch.points[i + 1];
      count += (a.value - value) * (b.value - value) < 0.0 && a.orbit.impacts[0].speed > 0.0 &&
               b.orbit.impacts[0].speed > 0.0;
    }
  return count;
}

TEST(SpeedDependentRestitution, EveryOrbitIsTracedWhateverTheStep) {
  const SurveyedOscillator oscillator{0.05L, 0.15L, 0.9L, 0.12L};
  for (const double max_step : {0.0, 0.01, 2.8}) {
    const OrbitBranches result = traced(max_step);
    EXPECT_EQ(result.sought.left_out, 1);
    EXPECT_EQ(result.sought.solved_values, 1025);
    EXPECT_NEAR(result.sought.solved_spacing, 2.8 / 1024, 1e-15);
    EXPECT_FALSE(result.sought.complete());
    int total = 0;
    for (int i = 1; i < 40; ++i) {
      const double value = 1.2 + 2.8 * i / 40.0 + 1e-4;
      const int expected = oscillator.orbits(value, 20.0L);
      total += expected;
      EXPECT_EQ(positive_segments(result, value), expected) << value << " step " << max_step;
    }
    EXPECT_GT(total, 20);
  }
}

TEST(SpeedDependentRestitution, StartsAreOrbitsAlready) {
  const SystemFamily family(
      support::shipped_scene("05_wagg_one_mode",
                             {"beam.modes=3", "stop.gap=2e-3", "stop.restitution=[0.8, 0.3]"}),
      "forcing.frequency");
  const SpeedSurvey survey = survey_speeds(family, 0, 1, 20.0, 60.0, false);
  EXPECT_EQ(survey.unsolved, 0);
  EXPECT_GT(survey.starts.size(), 100u);
  const ImpactPattern pattern{1, {0}};
  for (const SpeedSurvey::Start& start : survey.starts) {
    const System system = *family.at(start.value);
    const ShootingProblem problem(pattern, motion_scale(system));
    EXPECT_LE(problem.residual(system, problem.pack(system, {start.point})).cwiseAbs().maxCoeff(), 1e-8)
        << start.value;
  }
}

}  // namespace
}  // namespace graze
