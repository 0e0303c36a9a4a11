// Loci of orbits on elastic stops, whose contacts begin and end anywhere in the forcing's turn and
// are as short as one likes: every point is shot for again, independently.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "branch_checks.hpp"
#include "elastic_oscillator.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

constexpr double kPi = std::numbers::pi;

LociOptions doublings(double from, double to, double second_from, double second_to) {
  LociOptions options;
  options.branches.from = from;
  options.branches.to = to;
  options.branches.start_values = 3;
  options.branches.finder.from_random = false;
  options.second_from = second_from;
  options.second_to = second_to;
  options.kinds = {OrbitLocusKind::kPeriodDoubling};
  options.slices = 0;
  return options;
}

// An impact oscillator on a moving base, x'' + 0.02 x' + x + 29 (x - 1.26)+ = a w^2 sin(w t +
// turn), or its mirror image: J. Ing, E. Pavlovskaia, M. Wiercigroch, S. Banerjee, Phil. Trans. R.
// Soc. A 366 (2008) 679-704.
Scene on_a_base(double amplitude, bool mirrored, const std::string& damping = "") {
  return parse_scene(
      "units = \"none\"\n[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.01]\n"
      "inertia = [1.0]\n[forcing]\nkind = \"base\"\nfrequency = 0.88\n"
      "phase = -1.5707963267948966\namplitude = " +
          std::to_string(amplitude) + "\n[[stop]]\nshape = [1.0]\ngap = 1.26\n" +
          (mirrored ? "side = \"below\"\n" : "") +
          "[stop.spring]\nstiffness = 29.0\nexponent = 1.0\n" + damping,
      "ing");
}

// Every point of a locus has an orbit of one period with this multiplier, by an independent flow
// from its state at the phase 0 of the forcing. `force`: of both parameters.
template <class Force>
void expect_critical(const OrbitLocus& locus, double multiplier,
                     const support::ElasticOscillator& own, double sign, const Force& force) {
  for (const OrbitLocusPoint& point : locus.points) {
    SCOPED_TRACE(testing::Message() << point.value << " " << point.second);
    ASSERT_TRUE(point.section);
    ASSERT_NEAR(std::remainder(point.section->at.phase, 2.0 * kPi), 0.0, 1e-12);
    const MotionState<double>& at = point.section->states.front();
    const Eigen::Vector2d start(sign * at.q[0], sign * at.qdot[0]);
    const auto flown = own.period(point.value, sign * force(point.value, point.second), start);
    EXPECT_NEAR((flown.state - start).norm(), 0.0, 1e-10);
    EXPECT_NEAR(multiplier * (multiplier - flown.by_start.trace()) + flown.by_start.determinant(),
                0.0, 1e-6);
  }
}

// Of an oscillator and of its mirror image, whose contacts lie half a turn away.
void expect_same(const OrbitLoci& result, const OrbitLoci& mirrored) {
  EXPECT_EQ(result.cut_short + mirrored.cut_short, 0);
  ASSERT_EQ(result.loci.size(), mirrored.loci.size());
  for (std::size_t i = 0; i < result.loci.size(); ++i) {
    const OrbitLocus &locus = result.loci[i], &other = mirrored.loci[i];
    EXPECT_LT(locus.points.size(), 200u);
    EXPECT_GT(locus.points.size(), 20u);
    EXPECT_EQ(locus.ends[0], OrbitLocusEnd::kSecondLimit);
    EXPECT_EQ(locus.ends[1], OrbitLocusEnd::kSecondLimit);
    EXPECT_NEAR(locus.points.front().value, other.points.front().value, 1e-9);
    EXPECT_NEAR(locus.points.back().value, other.points.back().value, 1e-9);
  }
}

// On one locus a contact begins within .003 rad of the phase 0, before it and behind it.
TEST(CompliantLocusSections, PassTheBeginningOfAContact) {
  const support::ElasticOscillator own{0.01, 29.0, 1.26};
  std::vector<OrbitLoci> results;
  for (const bool mirrored : {false, true}) {
    results.push_back(trace_loci(on_a_base(0.38, mirrored), "forcing.frequency",
                                 "forcing.amplitude", doublings(0.87, 0.93, 0.34, 0.4)));
    ASSERT_EQ(results.back().loci.size(), 2u);
    for (const OrbitLocus& locus : results.back().loci)
      expect_critical(locus, -1.0, own, mirrored ? -1.0 : 1.0,
                      [](double w, double amplitude) { return amplitude * w * w; });
  }
  expect_same(results[0], results[1]);
}

// With a dashpot, whose force sets in with a jump, so that not even first derivatives are smooth.
TEST(CompliantLocusSections, PassTheBeginningOfAForceThatJumps) {
  const char* dashpot = "damping = {model = \"kelvin-voigt\", coefficient = 0.3}\n";
  const LociOptions options = doublings(0.87, 0.93, 0.34, 0.4);
  expect_same(trace_loci(on_a_base(0.38, false, dashpot), "forcing.frequency", "forcing.amplitude",
                         options),
              trace_loci(on_a_base(0.38, true, dashpot), "forcing.frequency", "forcing.amplitude",
                         options));
}

// The shipped oscillator with an elastic stop: one locus lies a thousandth of its range beside a
// grazing and nearer, where slopes go with the root of the distance, the other one passes contacts
// at the section.
TEST(CompliantLocusSections, LieBesideGrazings) {
  const Scene scene = support::shipped_scene("21_elastic_stop_pure_numbers");
  const support::ElasticOscillator own{0.025, 100.0, 0.1};
  const OrbitLoci result =
      trace_loci(scene, "forcing.frequency", "forcing.amplitude", doublings(0.8, 0.96, 0.02, 0.04));
  EXPECT_EQ(result.cut_short, 0);
  ASSERT_EQ(result.loci.size(), 2u);
  for (const OrbitLocus& locus : result.loci) {
    EXPECT_LT(locus.points.size(), 400u);
    expect_critical(locus, -1.0, own, 1.0, [](double, double amplitude) { return amplitude; });
  }
}

// Loci that run all along a grazing, 2 % of the response away from it: tangents that are known as
// well as the points make a hundred of them enough.
TEST(CompliantLocusSections, RunAlongGrazings) {
  struct Case {
    double damping, stiffness, frequency, part;  // of the amplitude of the response: the gap
  };
  for (const Case& one : {Case{0.0563, 297.0, 0.8562, 0.979}, Case{0.04, 150.0, 0.8, 0.97},
                          Case{0.08, 400.0, 0.9, 0.985}}) {
    SCOPED_TRACE(one.stiffness);
    const double w = one.frequency;
    const double response = 1.0 / std::hypot(1.0 - w * w, 2.0 * one.damping * w);
    const support::ElasticOscillator own{one.damping, one.stiffness, one.part * response};
    std::ostringstream text;
    text.precision(17);
    text << "units = \"none\"\n[modal]\nfrequencies = [1.0]\ndamping_ratios = [" << one.damping
         << "]\nparticipation = [1.0]\n[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = "
         << w << "\n[[stop]]\nshape = [1.0]\ngap = " << own.gap
         << "\n[stop.spring]\nstiffness = " << one.stiffness << "\nexponent = 1.0\n";
    const OrbitLoci result =
        trace_loci(parse_scene(text.str(), "along"), "forcing.frequency", "forcing.amplitude",
                   doublings(0.93 * w, 1.07 * w, 0.8, 1.25));
    EXPECT_EQ(result.cut_short, 0);
    ASSERT_GE(result.loci.size(), 1u);
    for (const OrbitLocus& locus : result.loci) {
      EXPECT_LT(locus.points.size(), 250u);
      expect_critical(locus, -1.0, own, 1.0, [](double, double amplitude) { return amplitude; });
    }
  }
}

// Of two folds one lies 1.6e-7 beside a grazing.
TEST(CompliantLocusSections, OfFoldsLieBesideGrazings) {
  const Scene scene = support::shipped_scene("21_elastic_stop_pure_numbers");
  const support::ElasticOscillator own{0.025, 100.0, 0.1};
  LociOptions options = doublings(1.05, 1.6, 0.018, 0.022);
  options.kinds = {OrbitLocusKind::kFold};
  const OrbitLoci result = trace_loci(scene, "forcing.frequency", "forcing.amplitude", options);
  EXPECT_EQ(result.cut_short, 0);
  EXPECT_EQ(result.lost_starts, 0);
  ASSERT_EQ(result.loci.size(), 2u);
  for (const OrbitLocus& locus : result.loci) {
    EXPECT_LT(locus.points.size(), 400u);
    expect_critical(locus, 1.0, own, 1.0, [](double, double amplitude) { return amplitude; });
  }
}

}  // namespace
}  // namespace graze
