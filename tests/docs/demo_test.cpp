// The demo's closing table: how much of the parameter's range has a stable (1, 1) orbit.
//
// Over the frequency an independent closed-form computation finds 784, 154 and 5 stable orbits with
// 1, 2 and 4 modes on a grid of 0.05 rad/s (the table of docs/period_one.md, held by
// tests/physics). Over the gap at 40 rad/s the one-mode orbit is stable from 0 to its fold
// (tests/reference, closed_form_folds.csv), and with more modes nowhere. The demo counts steps
// between stable points, each 0.2 rad/s at most, so it lacks less than one step at either end of a
// stable stretch.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "apps/program.hpp"

namespace graze {
namespace {

struct Row {
  double frequency = -1.0, gap = -1.0;
};

// The row of the closing table that begins with `modes`; NaN where it does not hold two numbers.
Row row_of(const std::string& text, const std::string& modes) {
  const std::size_t table = text.find("modes   over frequency");
  const std::size_t at = text.find("\n  " + modes + " ", table);
  if (table == std::string::npos || at == std::string::npos) return {NAN, NAN};
  std::istringstream stream(text.substr(at + 3 + modes.size()));
  Row row{NAN, NAN};
  stream >> row.frequency >> row.gap;
  return row;
}

TEST(Demo, ClosingTableAgreesWithTheClosedForm) {
  constexpr double kGrid = 0.05, kStep = 0.2;
  const ScratchFolder folder;
  const std::string line = "cd '" GRAZE_SOURCE_DIR "' && bash apps/demo_runs.sh '" GRAZE_PROGRAM
                           "' '" +
                           folder.string() + "/demo' > '" + folder.string() + "/text' 2> '" +
                           folder.string() + "/errors'";
  ASSERT_EQ(std::system(line.c_str()), 0) << read_text(folder / "errors");
  const std::string text = read_text(folder / "text");

  const Row one = row_of(text, "one"), two = row_of(text, "2"), four = row_of(text, "4");
  // One stable stretch; the count of its grid is right to one place.
  EXPECT_LE(one.frequency, 785 * kGrid);
  EXPECT_GE(one.frequency, 783 * kGrid - 2.0 * kStep);
  // Every branch has a stretch or two; five of them have any.
  EXPECT_LE(two.frequency, 154 * kGrid + 8 * kGrid);
  EXPECT_GE(two.frequency, 154 * kGrid - 8 * (kGrid + 2.0 * kStep));
  EXPECT_GT(four.frequency, 0.0);
  EXPECT_LE(four.frequency, 5 * kGrid + 5 * kGrid);

  // The table prints four digits; the last step before the fold is below range/50.
  constexpr double kFold = 0.013592831124393897793;
  EXPECT_LE(one.gap, kFold * (1.0 + 5e-4));
  EXPECT_GE(one.gap, kFold - 0.02 / 50.0);
  EXPECT_EQ(two.gap, 0.0);
  EXPECT_EQ(four.gap, 0.0);
}

}  // namespace
}  // namespace graze
