// What is stable in a plane of two parameters, against formulas of the one-mode beam that stand
// here: the amplitude of its linear response and the fold of its (1, 1) orbit.
#include "graze/study/plane/stable_regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "graze/study/plane/region_boundaries.hpp"

namespace graze {
namespace {

const MotionName kOneOne{AttractorKind::kOrbit, 1, 1};
const MotionName kNoImpact{AttractorKind::kClear, 0, 0};
const MotionName kResting{AttractorKind::kAtRest, 0, 0};

Scene scene_of(const std::string& name, const std::vector<std::string>& settings = {}) {
  return read_scene(GRAZE_SOURCE_DIR "/data/scenes/" + name + ".toml", settings);
}

Scene one_mode(const std::vector<std::string>& settings = {}) {
  return scene_of("05_wagg_one_mode", settings);
}

StableRegionsOptions plane(double from, double to, double second_from, double second_to,
                           int places) {
  StableRegionsOptions options;
  options.from = from;
  options.to = to;
  options.second_from = second_from;
  options.second_to = second_to;
  options.columns = options.rows = places;
  options.threads = 2;
  return options;
}

StableRegions regions(const Scene& scene, const StableRegionsOptions& options,
                      const char* second = "stop.gap") {
  return find_stable_regions(scene, "forcing.frequency", second, options);
}

bool has(const RegionPlace& place, const MotionName& name) {
  return std::find(place.stable.begin(), place.stable.end(), name) != place.stable.end();
}

// One oscillator q'' + 2 d q' + w^2 q = f cos(O t), contact where b q = gap.
struct Oscillator {
  double w, d, f, b, r;
  std::complex<double> response(double frequency) const {
    return b * f / std::complex<double>(w * w - frequency * frequency, 2.0 * d * frequency);
  }
  // The largest gap at which it can hit the stop once a period T. With y = e^(-d t) (A cos v t +
  // B sin v t) beside the steady response Y, that the displacement at T is that at 0 takes
  // B = A (e^(d T) - C)/S, that the velocity at 0 is -r times that at T then A = g Y'(0), and
  // contact b q(0) = Re((1 + i O g) Y^ e^(i phase)).
  double fold(double frequency) const {
    const double v = std::sqrt(w * w - d * d), T = 2.0 * M_PI / frequency;
    const double C = std::cos(v * T), S = std::sin(v * T), E = std::exp(-d * T);
    const double beta = (1.0 / E - C) / S;
    const double g = -(1.0 + r) / (v * (beta + r * E * (beta * C - S)) - (1.0 + r) * d);
    return std::abs(response(frequency)) * std::hypot(1.0, frequency * g);
  }
};

Oscillator oscillator(const Scene& scene) {
  const System system = assemble(scene);
  return {system.omega[0], system.delta()[0], system.forcing()->amplitude[0],
          system.stops[0].row[0], system.stops[0].restitution().at(1.0)};
}

// The forcing of a moving clamp grows with the square of its frequency.
Oscillator oscillator_at(const Scene& scene, double frequency) {
  return oscillator(with_parameter(scene, "forcing.frequency", frequency));
}

RegionPlace place_at(const Scene& scene, double frequency, double gap) {
  return regions(scene, plane(frequency - 1.0, frequency + 1.0, gap - 1e-5, gap + 1e-5, 1))
      .places[0];
}

TEST(StableRegions, OfTheOneModeBeamKeepToItsFormulas) {
  const Scene scene = one_mode();
  const StableRegions found = regions(scene, plane(20.0, 120.0, 2e-4, 0.01, 16));
  EXPECT_EQ(found.finished, 256);
  EXPECT_TRUE(found.settled);
  int clear = 0, simple = 0;
  for (const RegionPlace& place : found.places) {
    const Oscillator beam = oscillator_at(scene, place.value);
    EXPECT_EQ(has(place, kNoImpact), place.second > std::abs(beam.response(place.value)))
        << place.value << " " << place.second;
    if (place.second > beam.fold(place.value)) {
      EXPECT_FALSE(has(place, kOneOne)) << place.value << " " << place.second;
    }
    EXPECT_EQ(place.message, "");
    EXPECT_FALSE(place.stable.empty());
    clear += has(place, kNoImpact) ? 1 : 0;
    simple += has(place, kOneOne) ? 1 : 0;
  }
  // Both are seen, and not everywhere.
  EXPECT_TRUE(clear > 20 && clear < 236) << clear;
  EXPECT_TRUE(simple > 20 && simple < 236) << simple;
  // What was solved for and what was simulated tell the same.
  EXPECT_TRUE(found.refuted.empty());
  EXPECT_TRUE(found.missed.empty());
  EXPECT_EQ(found.undecided, 0);
  EXPECT_GE(found.confirmed, simple);
  EXPECT_EQ(found.searched, 256);
  std::size_t places = 0;
  for (const RegionArea& area : found.areas) places += area.places;
  EXPECT_EQ(places, 256u);
}

// docs/period_one.md: the orbit's largest multiplier at 60 rad/s is -4.7 at 1.1 mm.
TEST(StableRegions, HoldTheMotionsOfTheAtlas) {
  const Scene scene = one_mode();
  EXPECT_EQ(label_of(place_at(scene, 50.0, 1.5e-3).stable), "(1,1) + no impact");
  EXPECT_EQ(label_of(place_at(scene, 60.0, 1.0e-3).stable), "(1,1)");
  EXPECT_FALSE(has(place_at(scene, 60.0, 1.1e-3), kOneOne));
}

TEST(StableRegions, DoNotDependOnTheNumberOfThreads) {
  const Scene scene = one_mode();
  StableRegionsOptions options = plane(20.0, 120.0, 5e-4, 0.01, 8);
  options.threads = 1;
  const StableRegions one = regions(scene, options);
  options.threads = 3;
  const StableRegions three = regions(scene, options);
  ASSERT_EQ(one.places.size(), three.places.size());
  for (std::size_t i = 0; i < one.places.size(); ++i) {
    EXPECT_EQ(one.places[i].stable, three.places[i].stable) << i;
    EXPECT_EQ(one.places[i].area, three.places[i].area) << i;
  }
  EXPECT_EQ(one.simulated, three.simulated);
  EXPECT_EQ(one.rounds, three.rounds);
}

// A range may be given from its upper end; the places are the same. (Where motions wander for long
// before they settle, the last bit of a place decides whether they do in time: here none does.)
TEST(StableRegions, OfAReversedRangeAreTheSame) {
  const Scene scene = one_mode();
  const StableRegions up = regions(scene, plane(36.0, 52.0, 1e-3, 3e-3, 4));
  const StableRegions down = regions(scene, plane(52.0, 36.0, 3e-3, 1e-3, 4));
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(up.places[i].stable, down.places[15 - i].stable);
}

TEST(StableRegions, KeepWhatIsFinishedWhenInterrupted) {
  std::atomic<bool> interrupted{false};
  StableRegionsOptions options = plane(20.0, 120.0, 5e-4, 0.01, 8);
  options.search.stop.interrupted = &interrupted;
  int told = 0;
  options.progress = [&](double) { interrupted = ++told >= 20; };
  const StableRegions found = regions(one_mode(), options);
  EXPECT_EQ(found.stopped, StopReason::kInterrupted);
  EXPECT_GE(found.finished, 20);
  EXPECT_LT(found.finished, 64);
  const StableRegions whole = regions(one_mode(), plane(20.0, 120.0, 5e-4, 0.01, 8));
  for (std::size_t i = 0; i < 64; ++i) {
    const RegionPlace& place = found.places[i];
    EXPECT_EQ(place.finished, place.area >= 0);
    // The rounds only add.
    for (const MotionName& name : place.stable) EXPECT_TRUE(has(whole.places[i], name));
  }
}

// A mass pressed on a stop with restitution 0 stays there where its spring presses harder than the
// forcing pulls: w^2 |gap| > b |f|.
TEST(StableRegions, AreAtRestWherePressedHarderThanPulled) {
  const Scene scene = one_mode({"stop.restitution=0", "stop.gap=-1e-4", "initial.q=[-1.0]"});
  const StableRegions found = regions(scene, plane(10.0, 24.0, -4e-3, -1e-4, 8));
  int resting = 0;
  for (const RegionPlace& place : found.places) {
    const Oscillator beam = oscillator_at(scene, place.value);
    const bool stays = beam.w * beam.w * std::abs(place.second) > std::abs(beam.b * beam.f);
    // Another motion may be stable besides.
    if (stays) ++resting;
    if (!stays) {
      EXPECT_FALSE(has(place, kResting)) << place.value << " " << place.second;
    }
  }
  EXPECT_GE(resting, 8);
  int seen = 0;
  for (const RegionPlace& place : found.places) seen += has(place, kResting) ? 1 : 0;
  EXPECT_GE(seen, 8);
}

TEST(StableRegions, SayWhereTheSceneAllowsNothing) {
  const StableRegions found =
      regions(one_mode(), plane(40.0, 60.0, 0.5, 1.5, 4), "stop.restitution");
  for (const RegionPlace& place : found.places) {
    EXPECT_EQ(place.stable.empty(), place.second > 1.0);
    EXPECT_EQ(place.message.empty(), place.second < 1.0) << place.message;
  }
}

// Nothing repeats without damping but what impacts take energy from; nothing is made up for it.
TEST(StableRegions, OfAnUndampedBeamAreFound) {
  const Scene scene = one_mode({"damping.viscous=0"});
  const StableRegions found = regions(scene, plane(35.0, 65.0, 1e-3, 4e-3, 6));
  EXPECT_EQ(found.finished, 36);
  for (const RegionPlace& place : found.places) {
    EXPECT_FALSE(place.stable.empty()) << place.message;
    // Started at rest, the undamped mass swings to the sum of the forced and its own amplitude.
    if (place.second > 2.0 * std::abs(oscillator_at(scene, place.value).response(place.value))) {
      EXPECT_TRUE(has(place, kNoImpact)) << place.value << " " << place.second;
    }
  }
  EXPECT_TRUE(found.refuted.empty());
}

// With r = 1 the map over a period shrinks areas by e^(-2 d T) alone, so no pair of multipliers is
// less than e^(-d T): with hardly any damping an orbit is stable, and nothing comes near it within
// the periods given. It is listed, and not counted as confirmed.
TEST(StableRegions, SayWhichOrbitsForgetTooSlowlyToBeConfirmed) {
  const Scene scene = one_mode({"stop.restitution=1", "damping.viscous=1e-5"});
  StableRegionsOptions options = plane(49.0, 51.0, 1.49e-3, 1.51e-3, 1);
  const double shrinks = oscillator_at(scene, 50.0).d * 2.0 * M_PI / 50.0;
  ASSERT_LT(static_cast<double>(options.search.most_periods) * shrinks, 0.5);
  const StableRegions found = regions(scene, options);
  EXPECT_TRUE(has(found.places[0], kOneOne));
  EXPECT_EQ(found.undecided, 1);
  EXPECT_EQ(found.confirmed, 0);
  EXPECT_TRUE(found.refuted.empty());
}

TEST(StableRegions, OfMirroredStopsAreClearBelowTheLinearAmplitude) {
  const Scene scene = scene_of("07_two_stops", {"beam.modes=1"});
  StableRegionsOptions options = plane(40.0, 70.0, 1e-4, 6e-4, 6);
  const StableRegions found = regions(scene, options, "forcing.amplitude");
  for (const RegionPlace& place : found.places) {
    const Oscillator beam =
        oscillator_at(with_parameter(scene, "forcing.amplitude", place.second), place.value);
    EXPECT_EQ(has(place, kNoImpact), std::abs(beam.response(place.value)) < 1.05e-3);
  }
  EXPECT_TRUE(found.refuted.empty());
  EXPECT_TRUE(found.missed.empty());
}

OrbitLoci loci(const Scene& scene, const StableRegionsOptions& plane) {
  LociOptions options;
  options.branches.from = plane.from;
  options.branches.to = plane.to;
  options.branches.finder.from_simulation = options.branches.finder.from_random = false;
  options.second_from = plane.second_from;
  options.second_to = plane.second_to;
  options.kinds = {OrbitLocusKind::kFold, OrbitLocusKind::kPeriodDoubling, OrbitLocusKind::kTorus,
                   OrbitLocusKind::kGrazing};
  return trace_loci(scene, "forcing.frequency", "stop.gap", options);
}

// The loci know nothing of the places, nor these of them: where the (1, 1) orbit is stable at one
// place and not at the one beside it, a locus passes between.
TEST(StableRegions, OfTheSimpleOrbitEndAtItsLoci) {
  const Scene scene = one_mode({"stop.gap=2e-3", "forcing.frequency=40"});
  const StableRegionsOptions options = plane(21.0, 70.0, 6e-4, 6e-3, 16);
  const StableRegions found = regions(scene, options);
  OrbitLoci traced = loci(scene, options);
  const RegionBoundaries boundaries = region_boundaries(found, traced);
  EXPECT_GE(boundaries.count, 20);
  EXPECT_TRUE(boundaries.open.empty());
  // Without the folds the boundary between 42 and 54 rad/s is open, and nothing else.
  const auto is_fold = [](const OrbitLocus& locus) { return locus.kind == OrbitLocusKind::kFold; };
  traced.loci.erase(std::remove_if(traced.loci.begin(), traced.loci.end(), is_fold),
                    traced.loci.end());
  const RegionBoundaries without = region_boundaries(found, traced);
  EXPECT_EQ(without.count, boundaries.count);
  EXPECT_GE(without.open.size(), 5u);
  for (const auto& [i, other] : without.open) {
    const RegionPlace& place = found.places[i];
    const double a = place.second - oscillator_at(scene, place.value).fold(place.value);
    const RegionPlace& beside = found.places[other];
    const double b = beside.second - oscillator_at(scene, beside.value).fold(beside.value);
    EXPECT_LT(a * b, 0.0) << place.value << " " << place.second;
  }
}

// On a plane with one locus, straight across, and places that were set by hand.
TEST(RegionBoundaries, AreOpenWhereNoLocusPasses) {
  StableRegions found;
  found.columns = found.rows = 2;
  for (const auto& [value, second, stable] :
       {std::tuple(0.25, 0.25, true), std::tuple(0.75, 0.25, false), std::tuple(0.25, 0.75, true),
        std::tuple(0.75, 0.75, true)}) {
    RegionPlace place;
    place.value = value;
    place.second = second;
    place.finished = true;
    if (stable) place.stable = {kOneOne};
    found.places.push_back(place);
  }
  OrbitLoci traced;
  EXPECT_EQ(region_boundaries(found, traced).count, 2);
  EXPECT_EQ(region_boundaries(found, traced).open.size(), 2u);
  OrbitLocus locus;
  for (const double second : {0.0, 0.4, 1.0}) {
    OrbitLocusPoint point;
    point.value = 0.5;
    point.second = second;
    point.admissible = true;
    locus.points.push_back(point);
  }
  traced.loci = {locus};
  const RegionBoundaries boundaries = region_boundaries(found, traced);
  ASSERT_EQ(boundaries.open.size(), 1u);
  EXPECT_EQ(boundaries.open[0], (std::pair<std::size_t, std::size_t>(1, 3)));
  for (OrbitLocusPoint& point : traced.loci[0].points) point.admissible = false;
  EXPECT_EQ(region_boundaries(found, traced).open.size(), 2u);
}

// Labels list each motion once, in the order of their names.
TEST(StableRegions, LabelsAreWords) {
  EXPECT_EQ(label_of(StableNames{}), "");
  EXPECT_EQ(label_of(StableNames{{AttractorKind::kOrbit, 1, 1},
                                 {AttractorKind::kOrbit, 2, 2},
                                 kNoImpact,
                                 {AttractorKind::kSticks, 0, 0},
                                 kResting,
                                 {AttractorKind::kOther, 0, 0}}),
            "(1,1) + (2,2) + no impact + sticks + at rest + other");
}

// Where the response stays below the gap, F/|w0^2 - w^2 + 2 i zeta w0 w| of the oscillator, that is
// stable whatever the law of the stop, and nowhere else.
TEST(StableRegionsOnCompliantStops, AreClearWhereTheResponseIs) {
  const Scene scene = scene_of(
      "12_spring_dashpot_oscillator",
      {"stop.spring={stiffness=400.0,exponent=1.5,damping={model=\"hunt-crossley\",alpha=0.6}}"});
  StableRegionsOptions options = plane(2.3, 2.9, 0.12, 0.28, 3);
  options.search.periods = 300;
  options.search.most_periods = 600;
  const StableRegions found = regions(scene, options);
  int clear = 0;
  for (const RegionPlace& place : found.places) {
    EXPECT_TRUE(place.message.empty()) << place.message;
    EXPECT_FALSE(place.stable.empty());
    const double w = place.value;
    const bool stays = 1.0 / std::hypot(1.0 - w * w, 0.1 * w) < place.second;
    EXPECT_EQ(has(place, kNoImpact), stays) << w << " " << place.second;
    clear += stays ? 1 : 0;
  }
  EXPECT_GT(clear, 2);
  EXPECT_LT(clear, 9);
  EXPECT_TRUE(found.refuted.empty());
  EXPECT_TRUE(found.missed.empty());
}

// Linear springs at no gap know no size: what is stable does not depend on the force.
TEST(StableRegionsOnCompliantStops, DoNotDependOnTheForceAtNoGap) {
  const Scene scene = scene_of("12_spring_dashpot_oscillator");
  StableRegionsOptions options = plane(2.2, 2.6, 0.5, 2.5, 2);
  options.search.periods = 300;
  options.search.most_periods = 600;
  const StableRegions found = regions(scene, options, "forcing.amplitude");
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(label_of(found.places[i].stable), label_of(found.places[i + 2].stable));
  EXPECT_TRUE(has(found.places[0], kOneOne)) << label_of(found.places[0].stable);
  EXPECT_GT(found.confirmed, 0);
}

}  // namespace
}  // namespace graze
