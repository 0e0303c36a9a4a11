// Impacts with r = 0 leave their stop at rest. Whether the structure departs or sticks is decided
// by the acceleration right after: where the stop pushes back there is no orbit with one bare
// impact.
//
// One mode, (1, 1): from rest at the stop, q = a/b, at the phase phi where the pull b q'' =
// b (A cos(phi) - w^2 a/b) is just zero, back to a after one period. With x the departure from the
// forced response, 0 = x0 (e^{-d T} cos(wd T) - 1) + (x0' + d x0) e^{-d T} sin(wd T)/wd.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "branch_checks.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "graze/orbit/search/finder.hpp"

namespace graze {
namespace {

using support::special_points;

Scene plastic(double frequency) {
  return support::shipped_scene(
      "05_wagg_one_mode", {"stop.restitution=0", "forcing.frequency=" + std::to_string(frequency)});
}

// How far q is from a/b after one period, over a/b, in extended precision.
long double closure(const System& system, double frequency) {
  using Real = long double;
  const Real omega = system.omega[0], delta = system.delta()[0], big = frequency;
  const Real force = system.forcing()->amplitude[0];
  const Real q = system.stops[0].gap / static_cast<Real>(system.stops[0].row[0]);
  const Real phi = std::acos(omega * omega * q / force);
  const std::complex<Real> response =
      force / std::complex<Real>(omega * omega - big * big, 2 * delta * big) *
      std::polar(Real(1), phi);
  const Real x = q - response.real(), rate = -(std::complex<Real>(0, big) * response).real();
  const Real damped = std::sqrt(omega * omega - delta * delta);
  const Real turn = 2 * std::numbers::pi_v<Real> / big, decay = std::exp(-delta * turn);
  return (x * (decay * std::cos(damped * turn) - 1) +
          (rate + delta * x) * decay * std::sin(damped * turn) / damped) /
         q;
}

double zero_of_closure(const SystemFamily& family, double from, double to) {
  const bool rises = closure(*family.at(from), from) < 0;
  EXPECT_NE(closure(*family.at(to), to) < 0, rises);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (from + to);
    ((closure(*family.at(middle), middle) < 0) == rises ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

TEST(PlasticImpact, BranchEndsWhereTheStopBeginsToPushBack) {
  const Scene scene = plastic(28.3);
  const SystemFamily family(scene, "forcing.frequency");
  const double expected[] = {zero_of_closure(family, 28.6, 29.0),
                             zero_of_closure(family, 34.6, 34.9)};
  const OrbitBranches result = support::trace(scene, "forcing.frequency", 25.0, 40.0, false);
  const auto found = special_points(result, SpecialKind::kGrazing);
  ASSERT_EQ(found.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(found[i]->by_push);
    EXPECT_NEAR(found[i]->at.value / expected[i], 1.0, 1e-12);
  }
}

TEST(PlasticImpact, IsNoOrbitWhereTheStopPushesBack) {
  const SystemFamily family(plastic(28.3), "forcing.frequency");
  const double critical = zero_of_closure(family, 28.6, 29.0);
  for (const double offset : {1e-3, 2e-5, 1e-7, 1e-9})
    for (const double side : {-1.0, 1.0}) {
      const Scene scene = plastic(28.3);
      const System system = *family.at(critical + side * offset);
      FinderOptions options;
      options.from_simulation = options.from_random = false;
      const FoundOrbits found = find_orbits(system, {}, options);
      EXPECT_EQ(found.orbits.size(), side < 0.0 ? 1u : 0u) << side * offset;
    }
}

// With one mode a motion that sticks forgets everything: it is released where the pull of the stop
// is zero, at the phase phi of above, whatever came before.
TEST(PlasticImpact, OrbitsThatStickGoOnFromWhereTheStopPushesBack) {
  const Scene scene = plastic(28.3);
  const SystemFamily family(scene, "forcing.frequency");
  const double push = zero_of_closure(family, 28.6, 29.0);
  BranchOptions options;
  options.from = 28.0;
  options.to = 29.5;
  options.start_values = 2;
  options.finder.from_simulation = false;  // which would find them without the grazing
  options.follow_depth = 1;
  const OrbitBranches result = trace_orbits(family, options);
  const auto sticks = std::find_if(result.branches.begin(), result.branches.end(),
                                   [](const OrbitBranch& branch) { return branch.sticks(); });
  ASSERT_NE(sticks, result.branches.end());
  const auto grazing = std::find_if(
      result.branches.begin(), result.branches.end(),
      [&](const OrbitBranch& branch) { return !branch.special.empty() && !branch.sticks(); });
  ASSERT_NE(grazing, result.branches.end());
  EXPECT_EQ(sticks->origin, grazing->special.back().id);
  double nearest = options.to;
  for (const OrbitBranchPoint& point : sticks->points) {
    nearest = std::min(nearest, point.value);
    if (point.orbit.sticking.empty()) continue;
    const System system = *family.at(point.value);
    const double q = system.stops[0].gap / system.stops[0].row[0];
    const double release =
        std::acos(system.omega[0] * system.omega[0] * q / system.forcing()->amplitude[0]);
    const double phase = point.orbit.sticking.back().to.phase;
    EXPECT_LT(
        std::abs(std::remainder(std::abs(std::remainder(phase, 2.0 * std::numbers::pi)) - release,
                                2.0 * std::numbers::pi)),
        1e-9)
        << point.value;
  }
  // The stuck phase shrinks to nothing where the bare impact began to be pushed back.
  EXPECT_NEAR(nearest, push, 1e-6);
}

}  // namespace
}  // namespace graze
