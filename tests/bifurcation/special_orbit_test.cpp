// Special points of (p, 1) orbits against the closed form and against published numbers.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "branch_checks.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {
namespace {

using support::special_points;
using support::trace;

// P2, arXiv 2510.16218: u'' + .04 u' + u = A cos(w t), u <= 1, r = .9, one impact in two periods.
Scene published(double frequency) {
  return parse_scene(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.02]\nparticipation = [1.0]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 0.36\nfrequency = " +
          std::to_string(frequency) + "\n[[stop]]\nshape = [1.0]\ngap = 1.0\nrestitution = 0.9\n",
      "published.toml");
}

void expect_special(const SpecialPoint& special, double value, double speed, double other) {
  EXPECT_NEAR(special.at.value / value, 1.0, 1e-11);
  // Printed to 13 and 12 digits; beside a fold a speed is known to the square root of rounding.
  EXPECT_NEAR(special.at.orbit.impacts[0].speed, speed, 1e-7);
  double nearest = 1.0;
  for (const Eigenvalue& m : special.at.orbit.multipliers)
    nearest = std::min(nearest, std::abs(m.value - other));
  EXPECT_LE(nearest, 1e-6);
}

TEST(SpecialOrbits, P2FlipAndFoldAsPublished) {
  const OrbitBranches flip = trace(published(0.81), "forcing.amplitude", 0.3, 0.42, false, 2);
  const auto doublings = special_points(flip, SpecialKind::kPeriodDoubling);
  ASSERT_GE(doublings.size(), 1u);
  expect_special(*doublings[0], 0.347533397412, 0.0653039433369, -0.435490392782);
  const OrbitBranches fold = trace(published(0.799), "forcing.amplitude", 0.3, 0.42, false, 2);
  const auto folds = special_points(fold, SpecialKind::kFold);
  ASSERT_GE(folds.size(), 1u);
  expect_special(*folds[0], 0.3628362019809, 0.1240873448523, 0.431785672133);
}

// One of the closed form's two solutions at a value, where it is an orbit: the test functions of
// its multipliers, det(M + I) and the product of mu_i mu_j - 1 over all pairs.
struct ClosedOrbit {
  double flip = 0.0, torus = 0.0;
};

std::optional<ClosedOrbit> closed_orbit(const SystemFamily& family, int period, double value,
                                        std::size_t which) {
  const auto distance = support::fold_distance(family, value, period);
  if (!distance || distance->relative() < support::kBesideFold) return {};
  const System system = *family.at(value);
  const auto solutions = closed_form(system, 0, period).form->solutions(distance->gap);
  const ImpactPattern pattern{period, {0}};
  const std::vector<ImpactPoint> points = {solutions.at(which)};
  if (!admissibility(system, pattern, points).admissible) return {};
  const Matrix m = monodromy_matrix(system, pattern, points);
  Complex pairs = 1.0;
  const auto multipliers = eigenvalues(m);
  for (std::size_t i = 0; i < multipliers.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) pairs *= multipliers[i].value * multipliers[k].value - 1.0;
  return ClosedOrbit{(m + Matrix::Identity(m.rows(), m.cols())).determinant(), pairs.real()};
}

// Values at which a test function of the closed form's orbits changes sign.
std::vector<double> crossings(const SystemFamily& family, int period, double from, double to,
                              double ClosedOrbit::*test, int grid) {
  std::vector<double> values;
  for (const std::size_t which : {0, 1}) {
    std::optional<ClosedOrbit> before;
    for (int i = 0; i <= grid; ++i) {
      const double value = from + (to - from) * i / grid;
      const auto here = closed_orbit(family, period, value, which);
      if (before && here && (*before).*test * ((*here).*test) < 0.0) {
        double low = from + (to - from) * (i - 1) / grid, high = value;
        double at_low = (*before).*test;
        for (int bisection = 0; bisection < 60; ++bisection) {
          const double middle = 0.5 * (low + high);
          const auto at = closed_orbit(family, period, middle, which);
          if (!at) break;
          if ((*at).*test * at_low > 0.0) {
            low = middle;
            at_low = (*at).*test;
          } else {
            high = middle;
          }
        }
        values.push_back(0.5 * (low + high));
      }
      before = here;
    }
  }
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<double> values_of(const std::vector<const SpecialPoint*>& special) {
  std::vector<double> values;
  for (const SpecialPoint* point : special) values.push_back(point->at.value);
  std::sort(values.begin(), values.end());
  return values;
}

struct Traced {
  std::string scene;
  std::vector<std::string> settings;
  int period;
  double from, to;
};

int expect_doublings_of_closed_form(const Traced& c) {
  SCOPED_TRACE(testing::Message() << c.scene << " (" << c.period << ", 1) "
                                  << (c.settings.empty() ? "" : c.settings[0]));
  const Scene scene = support::shipped_scene(c.scene, c.settings);
  const SystemFamily family(scene, "forcing.frequency");
  const OrbitBranches result = trace(scene, "forcing.frequency", c.from, c.to, false, c.period);
  const std::vector<double> found = values_of(special_points(result, SpecialKind::kPeriodDoubling));
  const std::vector<double> expected =
      crossings(family, c.period, c.from, c.to, &ClosedOrbit::flip, 4000);
  EXPECT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
    EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-10);
  return static_cast<int>(expected.size());
}

TEST(SpecialOrbits, DoublingsAreWhereTheClosedFormHasThem) {
  const std::vector<Traced> cases = {
      {"04_impact_oscillator", {"modal.damping_ratios=[0.05]"}, 1, 1.6, 5.0},
      {"04_impact_oscillator", {"stop.gap=0.3"}, 2, 2.0, 7.0},
      {"04_impact_oscillator", {"stop.restitution=0.5", "stop.gap=-0.1"}, 1, 1.6, 6.0},
      {"05_wagg_one_mode", {}, 1, 15.0, 120.0},
      {"05_wagg_one_mode", {"stop.gap=0.0004"}, 2, 15.0, 120.0},
      {"05_wagg_one_mode", {"beam.modes=2"}, 1, 15.0, 120.0},
      {"05_wagg_one_mode", {"beam.modes=4", "stop.gap=0.005"}, 1, 30.0, 120.0},
      {"05_wagg_one_mode", {"beam.modes=4", "stop.gap=0.005"}, 2, 80.0, 140.0}};
  int doublings = 0;
  for (const Traced& c : cases) doublings += expect_doublings_of_closed_form(c);
  EXPECT_GE(doublings, 10);
}

// Tori need more than one mode: with one the product of the two multipliers is r^2 e^{-2 delta T}.
TEST(SpecialOrbits, ToriAreWhereTheClosedFormHasThem) {
  int tori = 0;
  for (const char* gap : {"stop.gap=0.005", "stop.gap=0.001"})
    for (const char* modes : {"beam.modes=2", "beam.modes=4"}) {
      SCOPED_TRACE(testing::Message() << gap << " " << modes);
      const Scene scene = support::shipped_scene("05_wagg_one_mode", {gap, modes});
      const SystemFamily family(scene, "forcing.frequency");
      const OrbitBranches result = trace(scene, "forcing.frequency", 15.0, 140.0, false);
      for (const SpecialPoint* torus : special_points(result, SpecialKind::kTorus)) {
        ++tori;
        // A complex pair on the circle, also of the closed form's own orbit at that value.
        double on_circle = 1.0;
        for (const Eigenvalue& m : torus->at.orbit.multipliers)
          if (m.value.imag() != 0.0)
            on_circle = std::min(on_circle, std::abs(std::abs(m.value) - 1.0));
        EXPECT_LE(on_circle, 1e-10);
        const auto expected = crossings(family, 1, torus->at.value * (1.0 - 1e-4),
                                        torus->at.value * (1.0 + 1e-4), &ClosedOrbit::torus, 200);
        double nearest = 1.0;
        for (const double value : expected)
          nearest = std::min(nearest, std::abs(torus->at.value / value - 1.0));
        EXPECT_LE(nearest, 1e-10) << torus->at.value;
      }
    }
  EXPECT_GE(tori, 1);
}

// Slow impacts of the four-mode beam: within 1e-5 of the frequency the large multiplier runs from
// 500 to -2000, and where it passes the circle doublings and tori follow one another by 2e-8.
TEST(SpecialOrbits, AreAllFoundWhereALargeMultiplierRunsThroughTheCircle) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode", {"beam.modes=4"});
  const SystemFamily family(scene, "forcing.frequency");
  const double from = 102.8244, to = 102.8258;
  constexpr int kSamples = 7000;  // 2e-7 rad/s apart
  std::size_t expected = 0;
  for (const std::size_t which : {0, 1}) {
    int before = 0;
    for (int i = 0; i <= kSamples; ++i) {
      const System system = *family.at(from + (to - from) * i / kSamples);
      const auto solutions = closed_form(system, 0, 1).form->solutions(system.stops[0].gap);
      int here = 0;  // multipliers outside the circle
      for (const Eigenvalue& m : orbit_multipliers(system, {1, {0}}, {solutions.at(which)}))
        here += std::abs(m.value) > 1.0 ? 1 : 0;
      if (i > 0 && here != before) ++expected;
      before = here;
    }
  }
  const OrbitBranches result = trace(scene, "forcing.frequency", 102.0, 104.0, true);
  std::size_t found = 0;
  for (const SpecialKind kind : {SpecialKind::kPeriodDoubling, SpecialKind::kTorus})
    for (const double value : values_of(special_points(result, kind)))
      found += value >= from && value <= to ? 1 : 0;
  EXPECT_EQ(found, expected);
  EXPECT_GE(expected, 12u);
}

// Multipliers outside the circle of the closed form's two solutions at each value of a grid, where
// they are orbits: the cells of the grid in which that number changes.
struct Cell {
  double from, to;
};

std::vector<Cell> cells_with_crossings(const SystemFamily& family, double from, double to,
                                       int grid) {
  std::vector<Cell> cells;
  for (const std::size_t which : {0, 1}) {
    std::optional<int> before;
    for (int i = 0; i <= grid; ++i) {
      const double value = from + (to - from) * i / grid;
      const System system = *family.at(value);
      const std::vector<ImpactPoint> points = {
          closed_form(system, 0, 1).form->solutions(system.stops[0].gap).at(which)};
      std::optional<int> here;
      if (admissibility(system, {1, {0}}, points).admissible) {
        here = 0;
        for (const Eigenvalue& m : orbit_multipliers(system, {1, {0}}, points))
          *here += std::abs(m.value) > 1.0 ? 1 : 0;
      }
      if (before && here && *here != *before)
        cells.push_back({from + (to - from) * (i - 1) / grid, value});
      before = here;
    }
  }
  return cells;
}

// The default step is 0.14 rad/s; pairs of tori lie as near as 0.003 rad/s to one another while the
// multipliers of the fourth mode turn by a radian in a step.
TEST(SpecialOrbits, AreFoundWhereTheyCrossAndReturnWithinAStep) {
  const Scene scene = support::shipped_scene("02_wagg_momentum");
  const SystemFamily family(scene, "forcing.frequency");
  const OrbitBranches result = trace(scene, "forcing.frequency", 25.0, 32.0, false);
  std::vector<double> found = values_of(special_points(result, SpecialKind::kTorus));
  for (const double value : values_of(special_points(result, SpecialKind::kPeriodDoubling)))
    found.push_back(value);
  const auto found_within = [&](double from, double to) {
    return std::count_if(found.begin(), found.end(),
                         [&](double value) { return value >= from && value <= to; });
  };
  std::ptrdiff_t expected = 0;
  for (const double from : {26.7, 29.1, 30.4, 31.05}) {
    for (const Cell& cell : cells_with_crossings(family, from, from + 0.1, 400)) {
      EXPECT_EQ(found_within(cell.from, cell.to), 1) << cell.from;
      ++expected;
    }
    EXPECT_EQ(found_within(from, from + 0.1), expected) << from;
    EXPECT_GE(expected, 2) << from;
    expected = 0;
  }
}

// With gap 0 orbits scale with the amplitude. At amplitude 0 they shrink to rest at the stop, a
// solution of the equations at every phase, and end there; no other orbits cross.
TEST(SpecialOrbits, AmplitudeZeroIsAnEndAndNoBranchPoint) {
  const OrbitBranches result =
      trace(support::shipped_scene("04_impact_oscillator"), "forcing.amplitude", -1.0, 1.0, false);
  EXPECT_EQ(result.branches.size(), 2u);
  EXPECT_TRUE(special_points(result, SpecialKind::kBranchPoint).empty());
  const auto ends = special_points(result, SpecialKind::kGrazing);
  EXPECT_EQ(ends.size(), 2u);
  for (const SpecialPoint* end : ends) EXPECT_LE(std::abs(end->at.value), 1e-15);
}

}  // namespace
}  // namespace graze
