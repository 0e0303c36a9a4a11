// What the catalogue of hard cases demands and what was reached, for docs/accuracy.md.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

namespace graze::support {

// Whether a sanitizer slows this build down: long rows of the catalogue run without it only.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSlowBuild = true;
#else
inline constexpr bool kSlowBuild = false;
#endif

// Expects error <= allowed and remembers the worst of each row; at the end of the test program the
// rows are appended to the file that GRAZE_HARD_CASES names, as tag, case, allowed, reached with
// tabs between.
class ReachedTable : public testing::EmptyTestEventListener {
 public:
  static ReachedTable& instance() {
    static ReachedTable* const table = [] {
      auto* made = new ReachedTable;
      testing::UnitTest::GetInstance()->listeners().Append(made);  // which owns it
      return made;
    }();
    return *table;
  }
  void note(const std::string& tag, const std::string& row, double error, double allowed) {
    Entry& entry = rows_.try_emplace({tag, row}, Entry{0.0, allowed}).first->second;
    // Where the tolerance varies, the case that used most of it.
    if (error * entry.allowed > entry.error * allowed) entry = {error, allowed};
  }
  void OnTestProgramEnd(const testing::UnitTest&) override {
    const char* const name = std::getenv("GRAZE_HARD_CASES");
    if (name == nullptr) return;
    std::ofstream file(name, std::ios::app);
    for (const auto& [key, entry] : rows_)
      file << key.first << "\t" << key.second << "\t" << entry.allowed << "\t" << entry.error
           << "\n";
  }

 private:
  struct Entry {
    double error = 0.0, allowed = 1.0;
  };
  std::map<std::pair<std::string, std::string>, Entry> rows_;
};

inline void expect_reached(const std::string& tag, const std::string& row, double error,
                           double allowed) {
  EXPECT_LE(error, allowed) << tag << ": " << row;
  ReachedTable::instance().note(tag, row, error, allowed);
}

// |value - expected| and |value/expected - 1|.
inline double off(double value, double expected) { return std::abs(value - expected); }
inline double relative(double value, double expected) { return std::abs(value / expected - 1.0); }

}  // namespace graze::support
