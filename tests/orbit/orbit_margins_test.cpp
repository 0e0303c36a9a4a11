// Rates of impact speeds and of smallest gaps along the closed form's orbits, against differences.
#include "graze/orbit/problem/detail/orbit_margins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "graze/assembly/system_family.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

constexpr double kAllGaps = 1e3;  // m

ImpactPoint solution(const System& system) {
  return closed_form(system, 0, 1).form->solutions(system.stops[0].gap).at(0);
}

std::vector<OrbitMargin> margins_at(const System& system, const ImpactPoint& point,
                                    const OrbitDirection& direction) {
  const ImpactPattern pattern{1, {0}};
  std::vector<OrbitMargin> all = speed_margins(system, pattern, {point}, direction);
  for (const OrbitMargin& approach :
       approach_margins(system, pattern, {point}, direction, kAllGaps))
    all.push_back(approach);
  return all;
}

void expect_rates(const std::string& parameter, const std::vector<std::string>& settings) {
  SCOPED_TRACE(parameter);
  const Scene scene = support::shipped_scene("05_wagg_one_mode", settings);
  const SystemFamily family(scene, parameter);
  const double value = family.value(), h = 1e-6 * value;
  const System system = *family.at(value), tangent = *family.tangent_at(value);
  const System low = *family.at(value - h), high = *family.at(value + h);
  const ImpactPoint here = solution(system), below = solution(low), above = solution(high);
  OrbitDirection along;
  along.impacts = {{(above.theta - below.theta) / (2.0 * h),
                    {(above.before.q - below.before.q) / (2.0 * h),
                     (above.before.qdot - below.before.qdot) / (2.0 * h)}}};
  along.parameter = 1.0;
  along.tangent = &tangent;
  const auto at = margins_at(system, here, along), before = margins_at(low, below, along),
             behind = margins_at(high, above, along);
  ASSERT_GT(at.size(), 2u);
  ASSERT_EQ(before.size(), at.size());
  ASSERT_EQ(behind.size(), at.size());
  double lowest = kAllGaps, scale = 0.0;
  for (const OrbitMargin& margin : at) scale = std::max(scale, std::abs(margin.rate));
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double rate = (behind[i].value - before[i].value) / (2.0 * h);
    EXPECT_NEAR(at[i].rate, rate, 1e-6 * scale) << i;
    if (at[i].is_speed) continue;
    lowest = std::min(lowest, at[i].value);
    const double moves = (behind[i].after - before[i].after) / (2.0 * h);
    EXPECT_NEAR(at[i].after_rate, moves, 1e-5 * (1.0 + std::abs(moves))) << i;
  }
  // Found by two searches, at instants that differ by rounding: the gap is flat there, and formed
  // from centimetres.
  EXPECT_NEAR(lowest, *admissibility(system, {1, {0}}, {here}).clearance(), 1e-16);
  // No gap moves much faster than said.
  const double drift = gap_drift(system, {1, {0}}, {here}, along);
  for (const OrbitMargin& margin : at)
    if (!margin.is_speed) {
      EXPECT_LT(std::abs(margin.rate), 4.0 * drift);
    }
}

TEST(OrbitMargins, RatesAreThoseOfTheClosedForm) {
  const std::vector<std::string> settings = {"beam.modes=3", "forcing.frequency=29.5",
                                             "stop.gap=0.005", "stop.position=0.29"};
  for (const char* parameter : {"forcing.frequency", "forcing.amplitude", "stop.gap",
                                "stop.restitution", "damping.viscous", "stop.position"})
    expect_rates(parameter, settings);
}

}  // namespace
}  // namespace graze
