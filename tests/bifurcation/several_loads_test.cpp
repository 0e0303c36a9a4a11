// Branches under several loads that amount to one: two of one frequency, cos t and sin t, are one
// with another phase. What is followed then has the special points that closed forms find.
#include <gtest/gtest.h>

#include <cmath>

#include "branch_checks.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/orbit/orbit_amplitudes.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

using support::special_points;
using support::trace;

constexpr double kDamping = 0.02, kGap = 0.2;

OrbitBranches branches_under(const std::string& loads) {
  return trace(parse_scene("[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.02]\n"
                           "participation = [1.0]\n" +
                               loads + "[[stop]]\nshape = [1.0]\ngap = 0.2\nrestitution = 0.8\n",
                           "several_loads.toml"),
               "forcing.frequency", 1.2, 6.0, false);
}

TEST(SeveralLoads, ThatAmountToOneHaveItsBranches) {
  const OrbitBranches one =
      branches_under("[forcing]\namplitude = 1.0\nfrequency = 2.6\nphase = 0.3\n");
  const OrbitBranches two = branches_under(
      "[[forcing]]\namplitude = 0.6\nfrequency = 2.6\nphase = 0.3\n"
      "[[forcing]]\namplitude = 0.8\norder = 1\nphase = 1.8707963267948966\n");
  const double ahead = std::atan2(0.8, 0.6);
  const auto doubled_one = special_points(one, SpecialKind::kPeriodDoubling),
             doubled_two = special_points(two, SpecialKind::kPeriodDoubling);
  ASSERT_EQ(doubled_one.size(), 1u);
  ASSERT_EQ(doubled_two.size(), 1u);
  EXPECT_NEAR(doubled_two[0]->at.value, doubled_one[0]->at.value, 1e-12);
  EXPECT_NEAR(doubled_two[0]->impact()->speed, doubled_one[0]->impact()->speed, 1e-12);
  EXPECT_NEAR(doubled_two[0]->impact()->phase, doubled_one[0]->impact()->phase - ahead, 1e-11);
  // (1, 1) begins where the response, 1/sqrt((1 - W^2)^2 + (2 zeta W)^2), reaches the stop.
  const double half = 1.0 - 2.0 * kDamping * kDamping;
  const double reached = std::sqrt(half + std::sqrt(half * half - 1.0 + 1.0 / (kGap * kGap)));
  for (const OrbitBranches* branches : {&one, &two}) {
    const auto grazings = special_points(*branches, SpecialKind::kGrazing);
    ASSERT_EQ(grazings.size(), 1u);
    EXPECT_NEAR(grazings[0]->at.value, reached, 1e-12);
    EXPECT_TRUE(grazings[0]->solution.bracket->converged);
  }
}

// Without impacts, under two harmonics: mean and root mean square of the sum of both responses.
TEST(SeveralLoads, HaveTheAmplitudesOfTheirResponses) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.02]\nparticipation = [1.0]\n"
      "[[forcing]]\namplitude = 1.0\nfrequency = 1.3\n"
      "[[forcing]]\namplitude = 4.0\norder = 2\nphase = 1.0\n"
      "[[stop]]\nshape = [1.0]\ngap = 50.0\nrestitution = 0.8\n",
      "several_loads.toml");
  const SystemFamily family(scene, "forcing.frequency");
  BranchOptions options;
  options.from = 1.2;
  options.to = 1.6;
  options.impacts = 0;
  options.response = true;
  const OrbitBranches traced = trace_orbits(family, options);
  ASSERT_EQ(traced.branches.size(), 1u);
  ASSERT_GT(traced.branches[0].points.size(), 5u);
  for (const OrbitBranchPoint& point : traced.branches[0].points) {
    const System system = *family.at(point.value);
    const Amplitudes at =
        orbit_amplitudes(system, point.orbit, rows_of(measured_places(scene, system)));
    const auto response = [](double amplitude, double w) {
      return amplitude / std::hypot(1.0 - w * w, 2.0 * kDamping * w);
    };
    const double rms =
        std::hypot(response(1.0, point.value), response(4.0, 2.0 * point.value)) / std::sqrt(2.0);
    EXPECT_NEAR(at.rows[0].rms, rms, 1e-11 * rms) << point.value;
    EXPECT_NEAR(at.rows[0].mean, 0.0, 1e-11 * rms) << point.value;
  }
}

}  // namespace
}  // namespace graze
