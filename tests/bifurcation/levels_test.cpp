// Points of branches, and curves in the plane, at which a number of the orbits takes a value or is
// extreme: against closed forms, slices, and a polynomial through the branch.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>

#include "graze/assembly/probes.hpp"
#include "graze/base/angle.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/orbit/orbit_amplitudes.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

Scene oscillator(const std::string& stop, double ratio = 0.05) {
  return parse_scene(fmt::format("[modal]\nfrequencies = [1.0]\ndamping_ratios = [{}]\n"
                                 "participation = [1.0]\n[forcing]\namplitude = 1.0\n"
                                 "frequency = 2.8\n[[stop]]\nshape = [1.0]\n{}",
                                 ratio, stop),
                     "oscillator");
}

std::optional<double> first_speed(const Scene&, const System&, const Orbit& orbit) {
  return orbit.impacts.empty() ? std::nullopt : std::optional(orbit.impacts.front().speed);
}

// At the first place of the scene.
OrbitNumber measured(std::function<std::optional<double>(const Amplitudes&)> of) {
  return [of](const Scene& scene, const System& system, const Orbit& orbit) {
    return of(orbit_amplitudes(system, orbit, rows_of(measured_places(scene, system))));
  };
}
const OrbitNumber kHighest = measured([](const Amplitudes& at) { return at.rows[0].highest; });
const OrbitNumber kRms = measured([](const Amplitudes& at) { return at.rows[0].rms; });
const OrbitNumber kPeakForce =
    measured([](const Amplitudes& at) { return at.stops[0].peak_force; });
const OrbitNumber kStuck = measured([](const Amplitudes& at) { return at.stops[0].held; });

BranchOptions over(double from, double to, std::vector<OrbitLevel> levels) {
  BranchOptions options;
  options.from = from;
  options.to = to;
  options.levels = std::move(levels);
  return options;
}

std::vector<const SpecialPoint*> points_of(const OrbitBranches& traced, SpecialKind kind) {
  std::vector<const SpecialPoint*> points;
  for (const OrbitBranch& branch : traced.branches)
    for (const SpecialPoint& special : branch.special)
      if (special.kind == kind) points.push_back(&special);
  return points;
}

std::vector<double> sorted_values(const std::vector<const SpecialPoint*>& points) {
  std::vector<double> values;
  for (const SpecialPoint* point : points) values.push_back(point->at.value);
  std::sort(values.begin(), values.end());
  return values;
}

double bisect(const std::function<double(double)>& of, double low, double high) {
  const bool rises = of(low) < 0.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    ((of(middle) < 0.0) == rises ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// |H| = 1/|1 - W^2 + 2 i zeta W|.
double size_at(double frequency) {
  return 1.0 / std::abs(Complex(1.0 - frequency * frequency, 0.1 * frequency));
}

TEST(Levels, OfTheResponseAreThoseOfItsTransferFunction) {
  const SystemFamily family(oscillator("gap = 20.0\nrestitution = 0.8\n"), "forcing.frequency");
  BranchOptions options = over(0.3, 2.0, {{"max=1.5", kHighest, 1.5}, {"max", kHighest}});
  options.impacts = 0;
  options.response = true;
  const OrbitBranches traced = trace_orbits(family, options);
  const auto beyond = [](double frequency) { return size_at(frequency) - 1.5; };
  const std::vector<double> found = sorted_values(points_of(traced, SpecialKind::kLevel));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], bisect(beyond, 0.3, 0.9), 1e-12);
  EXPECT_NEAR(found[1], bisect(beyond, 1.1, 2.0), 1e-12);
  const auto peak = points_of(traced, SpecialKind::kExtreme);
  ASSERT_EQ(peak.size(), 1u);
  EXPECT_NEAR(peak[0]->at.value, std::sqrt(1.0 - 2.0 * 0.05 * 0.05), 1e-9);
  EXPECT_EQ(peak[0]->level, 1u);
  EXPECT_EQ(traced.levels, (std::vector<std::string>{"max=1.5", "max"}));
}

TEST(Levels, OfTheResponseAreCurvesInThePlane) {
  LociOptions options;
  options.branches = over(0.5, 2.5, {{"max=1.2", kHighest, 1.2}, {"max", kHighest}});
  options.branches.impacts = 0;
  options.branches.response = true;
  options.second_from = 0.02;
  options.second_to = 1.2;
  options.kinds = {OrbitLocusKind::kLevel, OrbitLocusKind::kExtreme};
  const OrbitLoci loci = trace_loci(oscillator("gap = 1.5\nrestitution = 0.8\n"),
                                    "forcing.frequency", "forcing.amplitude", options);
  ASSERT_EQ(loci.loci.size(), 2u);  // each once
  for (const OrbitLocus& locus : loci.loci) {
    EXPECT_GT(locus.points.size(), 10u);
    for (const OrbitLocusPoint& point : locus.points)
      if (locus.kind == OrbitLocusKind::kLevel)
        EXPECT_NEAR(point.second * size_at(point.value), 1.2, 1e-11);
      else
        EXPECT_NEAR(point.value, std::sqrt(1.0 - 2.0 * 0.05 * 0.05), 1e-9);
  }
  // The peak touches the stop where F |H| = 1.5 there.
  const auto& met = loci.loci[loci.loci[0].kind == OrbitLocusKind::kLevel ? 1 : 0].special;
  ASSERT_EQ(met.size(), 1u);
  EXPECT_EQ(met[0].label, "EXGR");
  EXPECT_NEAR(met[0].at.second, 1.5 * 0.1 * std::sqrt(1.0 - 0.05 * 0.05), 1e-10);
}

// With v and -r v before and after the impact the free part y of the motion satisfies (M - 1)(y, w)
// = (0, (1 + r) v) over a period: y = alpha v, w = beta v, and the forced part has (a - alpha v)^2
// +
// ((r + beta) v/W)^2 = |P|^2.
double excess_of_speed(double speed, double frequency, double gap, double restitution) {
  constexpr double kDelta = 0.05;
  const double damped = std::sqrt(1.0 - kDelta * kDelta), period = kTurn / frequency;
  const double e = std::exp(-kDelta * period), c = std::cos(damped * period),
               s = std::sin(damped * period) / damped;
  const double m[2][2] = {{e * (c + kDelta * s) - 1.0, e * s},
                          {-e * s, e * (c - kDelta * s) - 1.0}};
  const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  const double alpha = -m[0][1] * (1.0 + restitution) / determinant;
  const double beta = m[0][0] * (1.0 + restitution) / determinant;
  const double p = gap - alpha * speed, rate = (restitution + beta) * speed / frequency;
  return std::hypot(p, rate) - size_at(frequency);
}

TEST(Levels, OfImpactSpeedsAreThoseOfTheClosedForm) {
  const Scene scene = oscillator("gap = 0.1\nrestitution = 0.8\n");
  const struct {
    const char* parameter;
    double from, to, speed;
    std::function<double(double)> excess;
  } cases[] = {
      {"forcing.frequency", 2.3, 3.2, 0.2,
       [](double value) { return excess_of_speed(0.2, value, 0.1, 0.8); }},
      {"stop.gap", -0.1, 0.14, 0.3,
       [](double value) { return excess_of_speed(0.3, 2.8, value, 0.8); }},
      {"stop.restitution", 0.5, 0.95, 0.11,
       [](double value) { return excess_of_speed(0.11, 2.8, 0.1, value); }},
  };
  for (const auto& one : cases) {
    SCOPED_TRACE(one.parameter);
    const OrbitBranches traced =
        trace_orbits(SystemFamily(scene, one.parameter),
                     over(one.from, one.to, {{"speed", first_speed, one.speed}}));
    const auto found = points_of(traced, SpecialKind::kLevel);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0]->at.value, bisect(one.excess, one.from, one.to), 1e-11);
    EXPECT_TRUE(found[0]->solution.bracket->converged);
  }
}

// A spring of 100 N/m behind a gap, as of NLvib's oscillator: where its largest force is 20 N,
// against orbits that the finder solves for beside it.
TEST(Levels, OfForcesAreThoseOfOrbitsFoundAlone) {
  const SystemFamily family(
      parse_scene("[lumped]\nmasses = [1]\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 1\n"
                  "damping = 0.02\n[forcing]\nmass = 1\namplitude = 0.1\nfrequency = 1.1\n"
                  "[[stop]]\nmass = 1\ngap = 1.0\n[stop.spring]\nstiffness = 100\n",
                  "oscillator"),
      "forcing.frequency");
  const OrbitBranches traced = trace_orbits(family, over(1.0, 1.6, {{"force", kPeakForce, 20.0}}));
  const auto found = points_of(traced, SpecialKind::kLevel);
  ASSERT_FALSE(found.empty());
  for (const SpecialPoint* point : found) {
    const MotionState<double>& start = point->at.orbit.section->states[0];
    const auto force = [&](double value) {
      FinderOptions finder;
      finder.from_random = false;
      double nearest = 0.0;
      for (const Orbit& orbit :
           find_orbits(*family.at(value), State{start.q, start.qdot}, finder).orbits) {
        const double one = kPeakForce(*family.scene_at(value), *family.at(value), orbit).value();
        if (std::abs(one - 20.0) < std::abs(nearest - 20.0)) nearest = one;
      }
      return nearest - 20.0;
    };
    const double slope = (force(point->at.value + 1e-4) - force(point->at.value - 1e-4)) / 2e-4;
    EXPECT_NEAR(force(point->at.value) / slope, 0.0, 1e-10);
  }
}

struct Plane {
  const char* name;
  Scene scene;
  const char *first, *second;
  std::array<double, 4> range;  // of the first, of the second
  OrbitLevel level;
  int slices = 10;  // fewer where one takes a second
};

Scene with_spring(const std::string& spring) {
  return oscillator("gap = 0.2\n[stop.spring]\n" + spring);
}

std::vector<Plane> planes() {
  const char *frequency = "forcing.frequency", *amplitude = "forcing.amplitude";
  const std::string rigid = "gap = 0.0\nrestitution = ";
  const OrbitLevel force{"force", kPeakForce, 6.0};
  return {{"rigid",
           oscillator(rigid + "0.8\n"),
           frequency,
           "stop.gap",
           {2.0, 3.2, -0.1, 0.15},
           {"speed", first_speed, 1.0}},
          {"rms",
           oscillator(rigid + "0.6\n"),
           frequency,
           "stop.restitution",
           {2.0, 3.2, 0.4, 0.8},
           {"rms", kRms, 0.5}},
          {"linear spring",
           with_spring("stiffness = 40\n"),
           frequency,
           amplitude,
           {1.6, 2.6, 0.8, 1.2},
           force},
          {"Hertz",
           with_spring("stiffness = 60\nexponent = 1.5\n"),
           frequency,
           amplitude,
           {1.75, 2.0, 0.9, 1.1},
           force,
           3},
          {"sticks",
           oscillator("gap = -0.3\nrestitution = 0.3\n", 0.1),
           frequency,
           "stop.gap",
           {0.6, 1.2, -0.4, -0.2},
           {"stuck", kStuck, 1.5}}};
}

BranchOptions slice_of(const Plane& plane, int starts) {
  BranchOptions options = over(plane.range[0], plane.range[1], {plane.level});
  options.start_values = starts;
  options.finder.from_random = false;
  return options;
}

OrbitLoci loci_of(const Plane& plane, int slices) {
  LociOptions options;
  options.branches = slice_of(plane, 4);
  options.second_from = plane.range[2];
  options.second_to = plane.range[3];
  options.kinds = {OrbitLocusKind::kLevel};
  options.slices = slices;
  return trace_loci(plane.scene, plane.first, plane.second, options);
}

TEST(Levels, OfLociAreThoseOfSlices) {
  for (const Plane& plane : planes()) {
    SCOPED_TRACE(plane.name);
    const OrbitLoci loci = loci_of(plane, 1);
    ASSERT_FALSE(loci.loci.empty());
    int compared = 0;
    for (const OrbitLocus& locus : loci.loci) {
      const std::size_t stride =
          std::max<std::size_t>(1, locus.points.size() / static_cast<std::size_t>(plane.slices));
      for (std::size_t i = stride / 2; i < locus.points.size(); i += stride) {
        const OrbitLocusPoint& point = locus.points[i];
        BranchOptions near = slice_of(plane, 1);
        near.from = point.value - 0.01;
        near.to = point.value + 0.01;
        const OrbitBranches traced = trace_orbits(
            SystemFamily(with_parameter(plane.scene, plane.second, point.second), plane.first),
            near);
        double nearest = 1.0;
        for (const double value : sorted_values(points_of(traced, SpecialKind::kLevel)))
          nearest = std::min(nearest, std::abs(value - point.value));
        EXPECT_LE(nearest, 1e-9) << point.value << " " << point.second;
        ++compared;
      }
    }
    EXPECT_GE(compared, plane.slices);
  }
}

// Where a curve of a level meets a fold the level is that of the fold, on rigid and on elastic
// stops.
TEST(Levels, MeetFoldsWhereTheseHaveThem) {
  Plane rigid = planes()[0], elastic = planes()[2];
  rigid.range = {1.6, 3.2, 0.1, 0.5};
  rigid.level.value = 1.1;
  elastic.scene = parse_scene(
      "[lumped]\nmasses = [1]\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 1\ndamping = 0.05\n"
      "[forcing]\nmass = 1\namplitude = 0.02\nfrequency = 1.2\n"
      "[[stop]]\nmass = 1\ngap = 0.1\n[stop.spring]\nstiffness = 100\n",
      "oscillator");
  elastic.range = {1.3, 1.6, 0.012, 0.02};
  elastic.level.value = 2.0;
  for (const Plane& plane : {rigid, elastic}) {
    SCOPED_TRACE(plane.name);
    const OrbitLoci loci = loci_of(plane, 3);
    ASSERT_EQ(loci.loci.size(), 1u);  // whatever slices it was started from
    const auto& special = loci.loci[0].special;
    const auto met = std::find_if(special.begin(), special.end(),
                                  [](const auto& one) { return one.label == "LPUZ"; });
    ASSERT_NE(met, special.end());
    const SystemFamily family(with_parameter(plane.scene, plane.second, met->at.second),
                              plane.first);
    const OrbitBranches traced = trace_orbits(family, slice_of(plane, 4));
    double nearest = 1.0;
    for (const SpecialPoint* fold : points_of(traced, SpecialKind::kFold))
      if (std::abs(fold->at.value - met->at.value) < 1e-7)
        nearest = std::abs(*plane.level.number(*family.scene_at(fold->at.value),
                                               *family.at(fold->at.value), fold->at.orbit) -
                           *plane.level.value);
    EXPECT_LE(nearest, 1e-7);
  }
}

// The largest root mean square along a branch, against the polynomial of Chebyshev's points of it.
TEST(Levels, AreExtremeWhereAPolynomialIs) {
  const SystemFamily family(oscillator("gap = 0.0\nrestitution = 0.8\n"), "forcing.frequency");
  const OrbitBranches traced = trace_orbits(family, over(1.7, 3.0, {{"speed", first_speed}}));
  const auto found = points_of(traced, SpecialKind::kExtreme);
  ASSERT_EQ(found.size(), 1u);
  const double middle = found[0]->at.value, reach = 0.05;
  constexpr int kPoints = 40;
  std::vector<double> at, of;
  for (int k = 0; k < kPoints; ++k) {
    at.push_back(middle + reach * std::cos((k + 0.5) * kTurn / (2.0 * kPoints)));
    of.push_back(bisect([&](double speed) { return excess_of_speed(speed, at.back(), 0.0, 0.8); },
                        0.1, 5.0));
  }
  // Its derivative in Chebyshev's polynomials, at x = (value - middle)/reach.
  const auto slope = [&](double x) {
    double sum = 0.0;
    for (int n = 1; n < 16; ++n) {
      double coefficient = 0.0;
      for (int k = 0; k < kPoints; ++k)
        coefficient += 2.0 / kPoints * of[static_cast<std::size_t>(k)] *
                       std::cos(n * (k + 0.5) * kTurn / (2.0 * kPoints));
      const double angle = std::acos(x);
      sum += coefficient * n * std::sin(n * angle) / std::sin(angle);
    }
    return sum;
  };
  EXPECT_NEAR(middle + reach * bisect(slope, -0.5, 0.5), middle, 1e-8);
}

TEST(Levels, EndABranchWhereTheyAreToldTo) {
  const SystemFamily family(oscillator("gap = 0.0\nrestitution = 0.8\n"), "forcing.frequency");
  BranchOptions options = over(2.0, 4.0, {{"speed", first_speed, 1.0, 0.0, true}});
  options.start_values = 0;  // from the scene's own frequency alone
  const OrbitBranches traced = trace_orbits(family, options);
  ASSERT_EQ(traced.branches.size(), 1u);
  const OrbitBranch& branch = traced.branches[0];
  EXPECT_EQ(branch.ends[0], OrbitBranchEnd::kLevel);
  EXPECT_NEAR(branch.points.front().value,
              bisect([](double value) { return excess_of_speed(1.0, value, 0.0, 0.8); }, 2.0, 2.8),
              1e-11);
  EXPECT_EQ(branch.points.front().orbit.impacts.front().speed,
            branch.special.front().at.orbit.impacts.front().speed);
  EXPECT_EQ(branch.special.front().id, "UZ1");
}

// A number that jumps through the value has it nowhere.
TEST(Levels, AreNotWhereANumberJumps) {
  const SystemFamily family(oscillator("gap = 0.0\nrestitution = 0.8\n"), "forcing.frequency");
  const OrbitNumber jump = [](const Scene& scene, const System&, const Orbit&) {
    return std::optional(scene.forcing->frequency < 2.9123 ? -1.0 : 2.0);
  };
  EXPECT_TRUE(
      points_of(trace_orbits(family, over(2.7, 3.0, {{"jump", jump, 0.0}})), SpecialKind::kLevel)
          .empty());
}

}  // namespace
}  // namespace graze
