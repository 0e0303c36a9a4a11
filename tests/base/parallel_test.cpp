#include "graze/base/parallel.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace graze {
namespace {

TEST(ForEachIndex, CallsEveryIndexOnceWhateverTheThreads) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<int> calls(1000, 0);
    for_each_index(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(1000, 1)) << threads;
  }
  for_each_index(0, 4, [](std::size_t) { FAIL(); });
}

TEST(ForEachIndex, ThrowsOnWhatTheWorkThrows) {
  for (const int threads : {1, 4})
    EXPECT_THROW(for_each_index(100, threads,
                                [](std::size_t i) {
                                  if (i == 57) throw std::runtime_error("57");
                                }),
                 std::runtime_error);
}

}  // namespace
}  // namespace graze
