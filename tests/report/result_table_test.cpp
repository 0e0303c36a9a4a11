// Tables of results: the types of their columns, and their text.
#include "graze/report/csv/result_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace graze {
namespace {

using Whole = std::vector<std::int64_t>;
using Numbers = std::vector<double>;
using Truths = std::vector<std::int8_t>;

TEST(ResultTable, ColumnsHaveTheTypeOfTheirCells) {
  ResultTable table("id,stable,speed,label,period");
  table.add(1, true, 2.0, "LP", std::optional(3));
  table.add(std::size_t{7}, false, NAN, std::string("PD"), std::optional<int>());
  table.add(-4LL, true).skip(1).add("LP", 5);
  const std::vector<ResultColumn> columns = table.take_columns();
  ASSERT_EQ(columns.size(), 5U);
  EXPECT_EQ(columns[0].name, "id");
  EXPECT_EQ(std::get<Whole>(columns[0].values), (Whole{1, 7, -4}));
  EXPECT_EQ(std::get<TruthColumn>(columns[1].values).codes, (Truths{1, 0, 1}));
  // Numbers that happen to be whole are numbers all the same.
  const auto& speed = std::get<Numbers>(columns[2].values);
  EXPECT_EQ(speed[0], 2.0);
  EXPECT_TRUE(std::isnan(speed[1]) && std::isnan(speed[2]));
  const auto& label = std::get<WordColumn>(columns[3].values);
  EXPECT_EQ(label.words, (std::vector<std::string>{"LP", "PD"}));
  EXPECT_EQ(label.codes, (std::vector<std::int32_t>{0, 1, 0}));
  // Whole numbers of which one is missing are numbers, before it and behind it.
  const auto& period = std::get<Numbers>(columns[4].values);
  EXPECT_EQ(period[0], 3.0);
  EXPECT_TRUE(std::isnan(period[1]));
  EXPECT_EQ(period[2], 5.0);
}

TEST(ResultTable, EmptyWordsAreNoValueWhereverTheyStand) {
  ResultTable table("word");
  table.add("").skip(1).add("a").add("").skip(1);
  EXPECT_EQ(csv_text(table), "word\n\n\na\n\n\n");
  const std::vector<ResultColumn> columns = table.take_columns();
  EXPECT_EQ(std::get<WordColumn>(columns[0].values).codes,
            (std::vector<std::int32_t>{-1, -1, 0, -1, -1}));
}

TEST(ResultTable, TruthsThatAreNotKnownAreMissingWhereverTheyStand) {
  ResultTable table("stable,sure");
  table.add(std::optional<bool>(), true).add(false, false).add(std::optional<bool>(), true);
  EXPECT_EQ(csv_text(table), "stable,sure\n,1\n0,0\n,1\n");
  const std::vector<ResultColumn> columns = table.take_columns();
  EXPECT_EQ(std::get<TruthColumn>(columns[0].values).codes, (Truths{-1, 0, -1}));
  EXPECT_EQ(std::get<TruthColumn>(columns[1].values).codes, (Truths{1, 0, 1}));
}

TEST(ResultTable, ColumnsOfAnEmptyTableAreNumbers) {
  ResultTable table("a,b");
  EXPECT_EQ(csv_text(table), "a,b\n");
  for (const ResultColumn& column : table.take_columns())
    EXPECT_TRUE(std::get<Numbers>(column.values).empty());
}

TEST(ResultTable, TextHasAllDigitsAndQuotesWhatNeedsThem) {
  ResultTable table("n,x,y,word\n");
  table.add(3, 0.1, 1e300, "plain");
  table.add(9'007'199'254'740'993LL, -INFINITY, 5e-324, "(1,1) \"quoted\"");
  EXPECT_EQ(csv_text(table),
            "n,x,y,word\n"
            "3,0.1,1e+300,plain\n"
            "9007199254740993,,5e-324,\"(1,1) \"\"quoted\"\"\"\n");
}

TEST(ResultTable, IsReadInPiecesThatMakeItsText) {
  ResultTable table("i,root");
  std::string expected = "i,root\n";
  for (int i = 0; i < 50'000; ++i) {
    table.add(i, 0.5 * i);
    expected += std::to_string(i) + "," + std::to_string(i / 2) + (i % 2 == 1 ? ".5\n" : "\n");
  }
  int pieces = 0;
  std::string text;
  table.write_csv([&](std::string_view piece) {
    ++pieces;
    text += piece;
  });
  EXPECT_GT(pieces, 5);
  EXPECT_TRUE(text == expected);
}

}  // namespace
}  // namespace graze
