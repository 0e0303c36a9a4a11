// How tables and sentences are fitted into a line, and how numbers are written in them.
#include "graze/report/text/detail/table.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "graze/report/text/detail/folding.hpp"
#include "graze/report/text/detail/line_breaks.hpp"
#include "graze/report/text/detail/number_text.hpp"

namespace graze {
namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Table three_columns() {
  Table table({"point", "stop.gap (m)", "ends"});
  table.add({"LP1", "0.0012", "GR at 1, GR at 2"});
  return table;
}

// 2 + 5 + 3 + 12 + 3 + 16 characters.
TEST(Table, StaysInOnePieceWhereItFits) {
  EXPECT_EQ(lines_of(three_columns().text(41)),
            (Lines{"  point   stop.gap (m)               ends",
                   "    LP1         0.0012   GR at 1, GR at 2"}));
}

// One character less than the table has, and its heads are broken where that makes it narrower.
TEST(Table, BreaksItsHeadsFirst) {
  EXPECT_EQ(
      lines_of(three_columns().text(40)),
      (Lines{"          stop.gap",  //
             "  point        (m)               ends", "    LP1     0.0012   GR at 1, GR at 2"}));
}

TEST(Table, MovesColumnsTogetherNext) {
  EXPECT_EQ(lines_of(three_columns().text(35)),
            (Lines{"         stop.gap",  //
                   "  point       (m)              ends", "    LP1    0.0012  GR at 1, GR at 2"}));
}

TEST(Table, BreaksItsListsThen) {
  EXPECT_EQ(lines_of(three_columns().text(34)),
            (Lines{"  point   stop.gap (m)       ends",  //
                   "    LP1         0.0012   GR at 1,",  //
                   "                          GR at 2"}));
}

// A list in brackets is one thing.
TEST(Table, LeavesWhatStandsInBracketsTogether) {
  EXPECT_EQ(list_lines("(1, 1), GR"), (Lines{"(1, 1),", "GR"}));
  EXPECT_EQ(balanced_lines("force (N s/m)", 2), (Lines{"force", "(N s/m)"}));
}

TEST(Table, IsCutIntoBlocksThatRepeatTheKeys) {
  Table table({"orbit", "phase", "speed", "stable", "multiplier"}, {1, {3}});
  table.add({"1", "0.038003540253", "0.0991854736588", "no", "1.99513 - 2.017754i"});
  table.add({"", "3.179596193843", "0.0991854736588"});
  // The second impact has no part in what is told of the whole orbit.
  EXPECT_EQ(
      lines_of(table.text(50)),
      (Lines{"  orbit           phase            speed", "      1  0.038003540253  0.0991854736588",
             "         3.179596193843  0.0991854736588", "", "  orbit  stable           multiplier",
             "      1      no  1.99513 - 2.017754i"}));
}

TEST(Table, CountsCharactersNotBytes) {
  Table table({"Ω", "ψ"});
  table.add({"1.5", "0.25"});
  EXPECT_EQ(table.text(100), "    Ω      ψ\n  1.5   0.25\n");
  EXPECT_EQ(width_of("Ωψ"), 2U);
}

TEST(WrappedText, GoesOnBelowItself) {
  EXPECT_EQ(wrapped_text("note: one two three\nshort\n", 12),
            "note: one\n      two\n      three\nshort\n");
  EXPECT_EQ(wrapped_text("  flow   exact: as it is", 20), "  flow   exact: as\n         it is");
  EXPECT_EQ(wrapped_text("one two three", 8), "one two\n  three");
  EXPECT_EQ(wrapped_text("a/long/name/of/a/file", 8), "a/long/name/of/a/file");
}

TEST(NumberText, WritesZeroAsZero) {
  for (const double zero : {0.0, -0.0}) {
    EXPECT_EQ(digits_text(zero, 9), "0");
    EXPECT_EQ(decimals_text(zero, 9), "0");
    EXPECT_EQ(power_text(zero, 4), "0");
  }
  EXPECT_EQ(decimals_text(-1e-17, 9), "0");
  EXPECT_EQ(decimals_text(0.001, 9), "0.001000000");
  EXPECT_EQ(power_text(-7.2472e-19, 4), "-7.2472e-19");
}

// What is small beside nothing stays; beside 1 a few last digits, 2e-16 each, are none.
TEST(NumberText, TakesRoundingForZero) {
  EXPECT_EQ(digits_text(1.2e-17, 6), "1.2e-17");
  EXPECT_EQ(digits_text(1.2e-17, 6, 1.0), "0");
  EXPECT_EQ(digits_text(1.2e-12, 6, 1.0), "1.2e-12");
  EXPECT_EQ(complex_text({-1.0, 1e-16}, 7), "-1");
  EXPECT_EQ(complex_text({0.5, -0.25}, 7), "0.5 - 0.25i");
}

TEST(Folding, LeavesOutHundredths) {
  const std::vector<std::size_t> sizes = {960, 30, 4, 3, 2, 1};
  EXPECT_EQ(folded_groups(sizes, 1000), (std::vector<bool>{false, false, true, true, true, true}));
  Folded folded;
  for (const std::size_t members : {4, 3, 2, 1}) folded.add(members);
  EXPECT_EQ(folded.text(1000), "  and 4 more, 1.00 %\n");
}

// A line saved is no reason, nor may nothing be left.
TEST(Folding, LeavesFewGroupsAndAllGroups) {
  EXPECT_EQ(folded_groups({990, 5, 3, 2}, 1000), std::vector<bool>(4, false));
  EXPECT_EQ(folded_groups(std::vector<std::size_t>(200, 5), 1000), std::vector<bool>(200, false));
}

}  // namespace
}  // namespace graze
