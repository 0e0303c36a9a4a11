// When a motion counts as repeating, on histories that are made up: the period of the sequence is
// known.
#include "graze/orbit/search/repetition.hpp"

#include <gtest/gtest.h>

#include "graze/assembly/assembly.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

constexpr double kTolerance = 1e-6;

struct Given {
  int impacts = 0;
  double phase = 1.0, state = 0.0;  // rad, of the first impact; kg^1/2 m, at the end
};

// The repetition of three times the given periods.
int repetition_of(const std::vector<Given>& periods, int longest = 32) {
  const System system = assemble(support::shipped_scene("05_wagg_one_mode"));
  const Vector zero = Vector::Zero(1);
  PeriodHistory history(system, {zero, zero}, 1000);
  for (const Given& given : periods) {
    for (int i = 0; i < given.impacts; ++i)
      history.add_impact({history.periods(), 0, given.phase + 0.01 * i, 0.05}, zero, zero);
    history.end_period(Vector::Constant(1, given.state), zero, {});
  }
  return history.repetition(longest, 3, kTolerance);
}

std::vector<Given> repeated(const std::vector<Given>& periods, int times) {
  std::vector<Given> list;
  for (int i = 0; i < times; ++i) list.insert(list.end(), periods.begin(), periods.end());
  return list;
}

// Periods that differ from each other by how many impacts they have, beyond a byte of them too, or
// by when the first is.
TEST(Repetition, IsTheShortestOfWhatRepeats) {
  for (int p = 1; p <= 32; ++p) {
    std::vector<Given> by_number, by_phase, by_many;
    for (int i = 0; i < p; ++i) {
      by_number.push_back({1 + i});
      by_phase.push_back({1, 1.0 + 0.01 * i});
      by_many.push_back({300 + i});
    }
    for (const std::vector<Given>& periods : {by_number, by_phase, by_many}) {
      EXPECT_EQ(repetition_of(repeated(periods, 3)), p);
      EXPECT_EQ(repetition_of(repeated(periods, 3), p - 1), 0);
    }
  }
}

TEST(Repetition, TakesThreeTimes) {
  const std::vector<Given> periods{{1}, {2}, {1, 1.5}};
  std::vector<Given> list = repeated(periods, 3);
  EXPECT_EQ(repetition_of(list), 3);
  list.erase(list.begin());
  EXPECT_EQ(repetition_of(list), 0);
}

TEST(Repetition, IsToldFromWhatDiffersAnywhereInIt) {
  const std::vector<Given> list = repeated(std::vector<Given>(12, Given{1}), 3);
  EXPECT_EQ(repetition_of(list), 1);
  for (std::size_t back = 1; back <= 3; ++back)
    for (const Given& other : {Given{1, 1.0 + 1e-5}, Given{2}, Given{0}}) {
      std::vector<Given> changed = list;
      changed[changed.size() - back] = other;
      EXPECT_EQ(repetition_of(changed), 0) << back;
    }
  std::vector<Given> near = list;
  near.back().phase += 1e-7;
  EXPECT_EQ(repetition_of(near), 1);
}

TEST(Repetition, OfPeriodsWithoutImpactsIsThatOfTheirStates) {
  EXPECT_EQ(repetition_of(repeated({{0, 1.0, 1e-3}, {0, 1.0, 2e-3}}, 4)), 2);
  EXPECT_EQ(repetition_of({{0, 1.0, 1e-3}, {0, 1.0, 2e-3}, {0, 1.0, 3e-3}, {0, 1.0, 4e-3}}), 0);
}

}  // namespace
}  // namespace graze
