// What a newcomer waits for: how many files the compiler is started for, and nothing that the
// program does not need.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace {

// The compiler's command lines that make a target; none where Ninja does not build.
std::vector<std::string> compilations_of(const std::string& target) {
  std::vector<std::string> list;
  FILE* pipe =
      popen(("ninja -C '" GRAZE_BUILD_DIR "' -t commands " + target + " 2>/dev/null").c_str(), "r");
  std::string text;
  std::array<char, 4096> part{};
  while (pipe && std::fgets(part.data(), part.size(), pipe)) {
    text += part.data();
    if (text.empty() || text.back() != '\n') continue;
    if (text.find(" -c ") != std::string::npos) list.push_back(text);
    text.clear();
  }
  if (pipe) pclose(pipe);
  return list;
}

// 71 for the program and 64 for tests when this was written; 518 and 356 with each file by itself.
TEST(BuildSteps, AreFewWhereFilesAreCompiledTogether) {
  const std::vector<std::string> program = compilations_of("graze");
  if (!GRAZE_IN_UNITS || program.empty()) GTEST_SKIP() << "each file is compiled by itself";
  EXPECT_LE(program.size(), 80U);
  std::size_t tests = 0;
  for (const std::string& line : compilations_of("all"))
    if (line.find(" tests/CMakeFiles/") != std::string::npos) ++tests;
  EXPECT_GT(tests, 0U);
  EXPECT_LE(tests, 75U);
}

TEST(BuildSteps, OfTheProgramLeaveOutTestsAndOtherInterfaces) {
  for (const std::string& line : compilations_of("graze"))
    for (const char* other : {" tests/CMakeFiles/", " apps/c/CMakeFiles/", " apps/packaging/"})
      EXPECT_EQ(line.find(other), std::string::npos) << line;
}

}  // namespace
