// The grazings of branches on compliant stops that leave the response without contacts: a closed
// form, as the response of a linear structure is one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

struct Structure {
  std::vector<double> frequencies, ratios, shape;  // rad/s, 1, kg^-1/2
  double force = 1.0, gap = 1.0;                   // N kg^-1/2 on every mode, m
  std::string spring;
};

std::string listed(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + std::to_string(value);
  return "[" + text + "]";
}

std::string text_of(const Structure& structure, double frequency) {
  return "[modal]\nfrequencies = " + listed(structure.frequencies) +
         "\ndamping_ratios = " + listed(structure.ratios) +
         "\nparticipation = " + listed(std::vector<double>(structure.ratios.size(), 1.0)) +
         "\n[forcing]\nkind = \"modal\"\namplitude = " + std::to_string(structure.force) +
         "\nfrequency = " + std::to_string(frequency) +
         "\n[[stop]]\nshape = " + listed(structure.shape) +
         "\ngap = " + std::to_string(structure.gap) + "\nspring = {" + structure.spring + "}\n";
}

// As the text has them, to six digits.
Structure rounded(Structure structure) {
  const auto round = [](double& value) { value = std::stod(std::to_string(value)); };
  for (auto* list : {&structure.frequencies, &structure.ratios, &structure.shape})
    std::for_each(list->begin(), list->end(), round);
  round(structure.force);
  round(structure.gap);
  return structure;
}

// Of the linear response at the stop, m.
double amplitude(const Structure& structure, double frequency) {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < structure.shape.size(); ++i) {
    const double w = structure.frequencies[i];
    sum += structure.shape[i] * structure.force /
           std::complex(w * w - frequency * frequency, 2.0 * structure.ratios[i] * w * frequency);
  }
  return std::abs(sum);
}

// Where the amplitude passes the gap between the two, to the last bit.
double grazing_between(const Structure& structure, double from, double to) {
  const bool beyond = amplitude(structure, to) > structure.gap;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (from + to);
    ((amplitude(structure, middle) > structure.gap) == beyond ? to : from) = middle;
  }
  return 0.5 * (from + to);
}

OrbitBranches traced(const Structure& structure, double scene, double from, double to,
                     double step = 0.0) {
  const SystemFamily family(parse_scene(text_of(structure, scene), "touching"),
                            "forcing.frequency");
  BranchOptions options;
  options.from = from;
  options.to = to;
  options.max_step = step;
  options.start_values = 0;
  options.finder.from_random = false;
  return trace_orbits(family, options);
}

std::vector<double> values_of(const OrbitBranches& result, SpecialKind kind) {
  std::vector<double> values;
  for (const OrbitBranch& branch : result.branches)
    for (const SpecialPoint& special : branch.special)
      if (special.kind == kind) values.push_back(special.at.value);
  std::sort(values.begin(), values.end());
  return values;
}

// Of a value: the equations hold to 1e-11 in lengths of the forced motion, and the amplitude
// changes by more than a tenth of itself over a range of one.
constexpr double kAccuracy = 1e-10;

const Structure kOneMode{{1.0}, {0.025}, {1.0}, 0.02, 0.1, "stiffness = 100.0, exponent = 1.0"};

TEST(CompliantGrazing, DependNeitherOnTheRangeNorOnTheStep) {
  const double below = grazing_between(kOneMode, 0.5, 0.95);
  EXPECT_NEAR(below, 0.8972718642, 1e-10);
  struct Range {
    double from, to, step;
  };
  for (const Range& range : {Range{0.88, 1.0, 0.0}, Range{0.8, 1.05, 0.0}, Range{0.85, 0.95, 0.0},
                             Range{0.88, 1.0, 2e-3}, Range{1.02, 0.7, 0.02}}) {
    const OrbitBranches result = traced(kOneMode, 0.94, range.from, range.to, range.step);
    const std::vector<double> found = values_of(result, SpecialKind::kGrazing);
    ASSERT_EQ(found.size(), 1u) << range.from;
    EXPECT_NEAR(found[0], below, kAccuracy) << range.from;
    // The branch ends there, in an orbit whose one contact has no speed.
    const OrbitBranch& branch = result.branches.front();
    const bool first = branch.ends[0] == OrbitBranchEnd::kGrazing;
    const OrbitBranchPoint& end = first ? branch.points.front() : branch.points.back();
    EXPECT_EQ(branch.ends[first ? 0 : 1], OrbitBranchEnd::kGrazing);
    EXPECT_EQ(end.value, found[0]);
    EXPECT_EQ(end.smallest_speed, 0.0);
  }
}

// A fold lies 1.6e-7 before the grazing. Its place was computed apart, the grazing's is the closed
// form.
TEST(CompliantGrazing, AreToldFromTheFoldBesideThem) {
  const double above = grazing_between(kOneMode, 1.0, 2.0);
  for (const double to : {2.0, 1.7}) {
    const OrbitBranches result = traced(kOneMode, 1.4, 1.0, to);
    const std::vector<double> found = values_of(result, SpecialKind::kGrazing),
                              folds = values_of(result, SpecialKind::kFold);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0], above, kAccuracy);
    ASSERT_EQ(folds.size(), 2u);
    EXPECT_NEAR(folds[0], 1.0919720008, 1e-10);
  }
}

TEST(CompliantGrazing, LieWhereTheLinearResponseReachesTheStop) {
  std::mt19937 random(20261123);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const std::vector<std::string> springs{
      "stiffness = 20.0, exponent = 1.0", "stiffness = 60.0, exponent = 1.5",
      "stiffness = 8.0, exponent = 1.0, damping = {model = \"hunt-crossley\", alpha = 0.3}",
      "stiffness = 20.0, exponent = 1.0, damping = {model = \"kelvin-voigt\", coefficient = 0.2}"};
  for (int scene = 0; scene < 8; ++scene) {
    Structure structure{{1.0, 2.5 + 2.0 * unit(random), 5.0 + 2.0 * unit(random)},
                        {0.02 + 0.03 * unit(random), 0.02, 0.03},
                        {1.0, unit(random) - 0.5, unit(random) - 0.5},
                        1.0,
                        0.0,
                        springs[static_cast<std::size_t>(scene) % springs.size()]};
    // The gap is reached half-way up the resonance.
    structure.gap = 0.5 * amplitude(structure, 1.0);
    structure = rounded(structure);
    const double below = grazing_between(structure, 0.5, 1.0);
    const double reach = 0.04 + 0.1 * unit(random);
    const OrbitBranches result = traced(structure, below + 0.02, below - reach, below + reach);
    const std::vector<double> found = values_of(result, SpecialKind::kGrazing);
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [&](double value) { return std::abs(value - below) <= kAccuracy; }))
        << scene << " " << below << " " << found.size();
  }
}

}  // namespace
}  // namespace graze
