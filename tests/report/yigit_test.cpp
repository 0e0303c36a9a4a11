// What docs/yigit_1990.md says its program prints is what it prints.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "support/examples.hpp"

namespace graze {
namespace {

// Times of computing are those of a machine; chaos leaves little of the third and later sets in the
// last digits of another one.
TEST(Yigit1990, ThePageShowsWhatTheProgramPrints) {
  const std::string page = support::docs_page("yigit_1990.md");
  std::stringstream printed(support::example_output("yigit_1990"));
  int lines = 0;
  for (std::string line; std::getline(printed, line);) {
    if (line.find("computing time") != std::string::npos) continue;
    const std::size_t first = line.find(" s ("), second = line.find(" s (", first + 1);
    const std::string told = first == std::string::npos || second == std::string::npos
                                 ? line
                                 : line.substr(0, second + 2);
    EXPECT_NE(page.find(told), std::string::npos) << line;
    ++lines;
  }
  EXPECT_GT(lines, 50);
}

}  // namespace
}  // namespace graze
