// Connected areas of a grid, on grids small enough to be told by eye.
#include "graze/study/plane/detail/grid_areas.hpp"

#include <gtest/gtest.h>

namespace graze {
namespace {

TEST(GridAreas, AreConnectedAcrossEdgesOnly) {
  const std::vector<int> keys = {0, 1, 1,  //
                                 1, 0, 1,  //
                                 1, 1, 0};
  const GridAreas found = grid_areas(keys, 3);
  ASSERT_EQ(found.areas.size(), 5u);  // three zeros along the diagonal touch at corners only
  EXPECT_EQ(found.areas[0].cells, 3u);
  EXPECT_EQ(found.areas[0].key, 1);
  EXPECT_EQ(found.areas[1].cells, 3u);
  for (std::size_t i = 2; i < 5; ++i) EXPECT_EQ(found.areas[i].cells, 1u);
  EXPECT_EQ(found.area_of, (std::vector<int>{2, 0, 0, 1, 3, 0, 1, 1, 4}));
}

TEST(GridAreas, ARingHoldsTogetherAndLeavesItsMiddleOut) {
  const std::vector<int> keys = {7, 7, 7, 7,  //
                                 7, 2, 2, 7,  //
                                 7, 7, 7, 7};
  const GridAreas found = grid_areas(keys, 4);
  ASSERT_EQ(found.areas.size(), 2u);
  EXPECT_EQ(found.areas[0].cells, 10u);
  EXPECT_EQ(found.areas[1].cells, 2u);
}

TEST(GridAreas, NegativeKeysPartWhatTheyLieBetween) {
  const GridAreas found = grid_areas({4, -1, 4, 4}, 4);
  ASSERT_EQ(found.areas.size(), 2u);
  EXPECT_EQ(found.areas[0].cells, 2u);
  EXPECT_EQ(found.area_of, (std::vector<int>{1, -1, 0, 0}));
  EXPECT_TRUE(grid_areas({-1, -1}, 2).areas.empty());
}

TEST(GridAreas, TheInnermostCellIsTheFurthestFromTheBoundary) {
  // A square of 5, and a bar beside it.
  std::vector<int> keys(35, 1);
  for (std::size_t row = 0; row < 5; ++row)
    for (std::size_t column = 0; column < 5; ++column) keys[row * 7 + column] = 0;
  const GridAreas found = grid_areas(keys, 7);
  ASSERT_EQ(found.areas.size(), 2u);
  EXPECT_EQ(found.areas[0].innermost, 2u * 7 + 2);
  // Of the bar, two wide, every cell is at a boundary: the one in its middle.
  const std::size_t row = found.areas[1].innermost / 7;
  EXPECT_EQ(row, 2u);
  // In a row of cells all are at a boundary.
  EXPECT_EQ(grid_areas({3, 3, 3, 3, 3}, 5).areas[0].innermost, 2u);
}

}  // namespace
}  // namespace graze
