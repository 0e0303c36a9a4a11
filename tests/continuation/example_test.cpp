// The programs of docs/continuation.md: what they print, how long they are, that the page shows
// them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/examples.hpp"

namespace {

using graze::support::example_output;
using graze::support::example_text;

void expect_values(const std::string& name, std::vector<double> expected, double tolerance) {
  std::vector<double> printed = graze::support::values_after(example_output(name), "p = ");
  std::sort(printed.begin(), printed.end());
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(printed.size(), expected.size()) << name;
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(printed[i], expected[i], tolerance) << name;
}

TEST(Examples, PrintTheKnownSpecialPoints) {
  expect_values("circle", {-1.0, 1.0}, 1e-12);
  expect_values("cusp", {-2.0, 2.0}, 1e-12);
  // 8 (alpha/cosh alpha)^2, alpha tanh alpha = 1; fourth order in h = 1/80: 4 h^4.
  expect_values("bratu", {3.513830719125}, 1e-7);
  // Third value: see special_point_test.cpp.
  expect_values("logistic_map", {3.0, 1.0 + std::sqrt(6.0), 3.5440903595519}, 1e-11);
  expect_values("henon_map", {-0.1225, 0.3675}, 1e-12);
  expect_values("henon_loci", {-1.0, 3.0}, 1e-10);
}

TEST(Examples, AreShortAndShownAsTheyAre) {
  const std::string page = graze::support::docs_page("continuation.md");
  for (const std::string name :
       {"circle", "cusp", "bratu", "logistic_map", "henon_map", "henon_loci"})
    EXPECT_LT(graze::support::lines_of_code(example_text(name)), 30) << name;
  for (const std::string name : {"circle", "logistic_map", "henon_loci"}) {
    EXPECT_NE(page.find(example_text(name)), std::string::npos) << name;
    EXPECT_NE(page.find(example_output(name)), std::string::npos) << name;
  }
}

}  // namespace
