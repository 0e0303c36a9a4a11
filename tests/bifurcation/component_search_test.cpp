// What is said of how thoroughly components were sought.
#include "graze/bifurcation/bounds/component_search.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "branch_checks.hpp"

namespace graze {
namespace {

OrbitBranches searched(const std::vector<std::string>& settings, bool keep_virtual) {
  BranchOptions options;
  options.from = 1.5;
  options.to = 4.0;
  options.keep_virtual = keep_virtual;
  options.sticking = false;
  return trace_orbits(
      {support::shipped_scene("04_impact_oscillator", settings), "forcing.frequency"}, options);
}

bool says(const OrbitBranches& result, const std::string& words) {
  const auto has = [&](const std::string& note) { return note.find(words) != std::string::npos; };
  return std::any_of(result.notes.begin(), result.notes.end(), has) ||
         std::any_of(result.details.begin(), result.details.end(), has);
}

TEST(ComponentSearches, OfAClosedFormAreComplete) {
  for (const bool keep_virtual : {false, true}) {
    const OrbitBranches result = searched({}, keep_virtual);
    EXPECT_TRUE(result.sought.complete());
    EXPECT_EQ(result.sought.ranges, 1);
    EXPECT_EQ(result.sought.resolution > 0.0, !keep_virtual);
    EXPECT_TRUE(says(result,
                     "the closed form of (1, 1) solutions has 1 interval of forcing.frequency and "
                     "no others"));
  }
}

// With r = 0 an orbit may be none although it penetrates nothing: its impact leaves it pressed on
// the stop.
TEST(ComponentSearches, WithSamplesSayHowFarApartTheseAre) {
  const OrbitBranches result = searched({"stop.restitution=0.0", "stop.gap=0.1"}, false);
  EXPECT_FALSE(result.sought.complete());
  EXPECT_TRUE(result.sought.all_solutions());
  EXPECT_NEAR(result.sought.sample_spacing, 2.5 / 4096, 1e-15);
  EXPECT_TRUE(says(result, "at values 0.00061 apart"));
}

TEST(ComponentSearches, OfARestitutionByTheSpeedStateTheirDensity) {
  const OrbitBranches result = searched({"stop.restitution=[0.9, 0.1]"}, false);
  EXPECT_FALSE(result.sought.complete());
  EXPECT_EQ(result.sought.solved_values, 1025);
  EXPECT_EQ(result.sought.unsolved, 0);
  EXPECT_TRUE(says(result, "at values of forcing.frequency 0.00244 apart"));
  EXPECT_TRUE(says(result, "a connected branch that lies between two of these values is missed"));
}

TEST(ComponentSearches, WithoutTheClosedFormStateTheirStarts) {
  const SystemFamily family(support::shipped_scene("04_impact_oscillator"), "forcing.frequency");
  BranchOptions options;
  options.from = 1.5;
  options.to = 4.0;
  options.start_values = 6;
  options.sticking = false;
  options.finder.from_closed_form = options.finder.from_simulation = false;
  const OrbitBranches result = trace_orbits(family, options);
  EXPECT_FALSE(result.sought.complete());
  EXPECT_EQ(result.sought.start_values, 7);
  EXPECT_EQ(result.sought.start_spacing, 0.5);
  EXPECT_TRUE(says(result,
                   "(1, 1) orbits were searched for at 7 values of forcing.frequency, 0.5 apart, "
                   "from rounds of 16 quasi-random phases with deflation"));
}

// Modal frequency 0, a free mass, begins the range; its poles lie beyond.
TEST(ComponentSearches, ABadValueAtTheStartHidesNoComponent) {
  const Scene scene =
      support::shipped_scene("04_impact_oscillator",
                             {"modal.damping_ratios=[1e-7]", "forcing.frequency=1", "stop.gap=50"});
  std::vector<std::size_t> branches;
  for (const double from : {0.0, 1e-3}) {
    const SystemFamily family(scene, "modal.frequencies.1");
    BranchOptions options;
    options.from = from;
    options.to = 4.0;
    options.keep_virtual = true;
    options.sticking = options.finder.from_simulation = options.finder.from_random = false;
    branches.push_back(trace_orbits(family, options).branches.size());
  }
  EXPECT_EQ(branches[0], branches[1]);
  EXPECT_GE(branches[1], 6u);
}

TEST(ComponentSearches, OneThatWasStoppedSaysSo) {
  const SystemFamily family(support::shipped_scene("04_impact_oscillator"), "forcing.frequency");
  BranchOptions options;
  options.from = 1.5;
  options.to = 4.0;
  options.stop.deadline = std::chrono::steady_clock::now();
  const OrbitBranches result = trace_orbits(family, options);
  EXPECT_FALSE(result.sought.complete());
  EXPECT_TRUE(says(result, "was stopped before its end: connected branches may be missing"));
}

}  // namespace
}  // namespace graze
