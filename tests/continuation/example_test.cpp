// The programs of docs/examples: what they print, how long they are, that the page shows them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

const std::filesystem::path kSource = std::filesystem::path(GRAZE_SOURCE_DIR) / "docs";

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string output_of(const std::string& name) {
  FILE* pipe = popen((std::string(GRAZE_EXAMPLES) + "/example_" + name).c_str(), "r");
  if (!pipe) return "";
  std::string text;
  std::array<char, 256> part;
  while (std::fgets(part.data(), part.size(), pipe)) text += part.data();
  EXPECT_EQ(pclose(pipe), 0);
  return text;
}

// The number after each "p = ".
std::vector<double> values_in(const std::string& text) {
  std::vector<double> values;
  for (std::size_t at = text.find("p = "); at != std::string::npos; at = text.find("p = ", at + 1))
    values.push_back(std::stod(text.substr(at + 4)));
  return values;
}

void expect_values(const std::string& name, std::vector<double> expected, double tolerance) {
  std::vector<double> printed = values_in(output_of(name));
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
}

// Program text without its blank lines and comments.
int lines_of_code(const std::string& text) {
  std::stringstream stream(text);
  int lines = 0;
  for (std::string line; std::getline(stream, line);)
    lines += line.find_first_not_of(' ') != std::string::npos && line.rfind("//", 0) != 0;
  return lines;
}

TEST(Examples, AreShortAndShownAsTheyAre) {
  const std::string page = content(kSource / "continuation.md");
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "examples"))
    EXPECT_LT(lines_of_code(content(entry.path())), 30) << entry.path();
  for (const std::string name : {"circle", "logistic_map"}) {
    EXPECT_NE(page.find(content(kSource / "examples" / (name + ".cpp"))), std::string::npos)
        << name;
    EXPECT_NE(page.find(output_of(name)), std::string::npos) << name;
  }
}

}  // namespace
