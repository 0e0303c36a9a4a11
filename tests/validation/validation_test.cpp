// Graze against numbers that others published: every row of data/validation/published.toml.
// GRAZE_VALIDATION names a file to which each case appends what it reached, for docs/validation.md
// (table.sh).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "apps/program.hpp"
#include "validation/published.hpp"
#include "validation/result_path.hpp"

namespace graze::support {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = GRAZE_SOURCE_DIR;

const PublishedTable& table() {
  static const PublishedTable read = published_table(kRoot / "data/validation/published.toml");
  return read;
}

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const PublishedCase& one : table().cases) names.push_back(one.name);
  return names;
}

std::string rounded(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.15g", value);
  return text;
}

// What stands in the column of published numbers.
std::string shown(const PublishedValue& value) {
  return value.published ? *value.published : value.formula.empty() ? "-" : value.formula;
}

// The command of a case as one would type it.
std::string command_line(const PublishedCase& one) {
  const std::size_t word = std::min(one.command.find(' '), one.command.size());
  return one.command.substr(0, word) + " data/validation/" + one.scene + one.command.substr(word);
}

// Lines of fields with tabs between: the place of the case in the table and one letter for what
// stands there, so that they can be sorted. They are appended at once: cases run side by side.
class Notes {
 public:
  explicit Notes(std::size_t place) : place_(place) {}

  void add(char kind, const std::vector<std::string>& fields) {
    char head[16];
    std::snprintf(head, sizeof head, "%03zu%c%03d", place_, kind, lines_++);
    text_ += head;
    for (const std::string& field : fields) text_ += '\t' + field;
    text_ += '\n';
  }
  void write() const {
    if (const char* const name = std::getenv("GRAZE_VALIDATION"))
      std::ofstream(name, std::ios::app) << text_;
  }

 private:
  std::size_t place_;
  int lines_ = 0;
  std::string text_;
};

class Published : public testing::TestWithParam<std::string> {};

TEST_P(Published, IsMet) {
  const auto& cases = table().cases;
  const auto one = std::find_if(cases.begin(), cases.end(),
                                [&](const PublishedCase& c) { return c.name == GetParam(); });
  const PublishedSource& source = table().source_of(*one);
  Notes notes(static_cast<std::size_t>(one - cases.begin()));
  notes.add('a', {source.title, source.link, one->title, one->scene, command_line(*one)});

  fs::current_path(kRoot);
  const Finished run = run_graze(command_line(*one) + " --json --quiet");
  ASSERT_EQ(run.code, 0) << run.err;
  const nlohmann::json document = nlohmann::json::parse(run.out);
  for (const PublishedValue& value : one->values) {
    SCOPED_TRACE(value.what);
    const nlohmann::json at = result_at(document, value.at);
    ASSERT_TRUE(at.is_number()) << value.at << " is " << at;
    const double here = at.get<double>(), off = std::abs(here - value.expected());
    EXPECT_LE(off, value.allowed()) << rounded(here) << " in place of " << value.expected();
    const double printed = value.published ? std::stod(*value.published) : value.expected();
    notes.add('b',
              {value.what, shown(value), rounded(here), rounded(here - printed), rounded(printed),
               rounded(off), rounded(value.allowed()), value.independent.value_or(""), value.script,
               value.because, value.published ? "printed" : ""});
  }
  notes.write();
}

std::string test_name(const testing::TestParamInfo<std::string>& of) {
  std::string name = of.param;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Cases, Published, testing::ValuesIn(case_names()), test_name);

// A scene that no case runs, or a script that no number is from, is not looked after.
TEST(PublishedTable, UsesEveryScene) {
  std::set<std::string> used{"published.toml"};
  for (const PublishedCase& one : table().cases) used.insert(one.scene);
  for (const fs::directory_entry& entry : fs::directory_iterator(kRoot / "data/validation"))
    EXPECT_TRUE(used.count(entry.path().filename().string())) << entry.path();
}

TEST(PublishedTable, UsesEveryScript) {
  const fs::path folder = kRoot / "tests/reference/validation";
  std::set<fs::path> used;
  for (const PublishedCase& one : table().cases)
    for (const PublishedValue& value : one.values)
      if (!value.script.empty()) {
        EXPECT_TRUE(fs::exists(kRoot / value.script)) << value.script;
        used.insert(kRoot / value.script);
      }
  std::string imports;
  for (const fs::path& script : used) imports += read_text(script);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path& script = entry.path();
    if (script.extension() != ".py") continue;
    EXPECT_TRUE(used.count(script) ||
                imports.find("import " + script.stem().string()) != std::string::npos ||
                imports.find("from " + script.stem().string() + " ") != std::string::npos)
        << script;
  }
}

// A published number that is not exact to its digits says who errs.
TEST(PublishedTable, SaysWhoErrs) {
  for (const PublishedCase& one : table().cases)
    for (const PublishedValue& value : one.values)
      if (value.published &&
          std::abs(std::stod(*value.published) - value.expected()) > last_digit(*value.published)) {
        EXPECT_FALSE(value.because.empty()) << one.name << ": " << value.what;
      }
}

std::string quoted(std::string text) {
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '"');
  return '"' + text + '"';
}

// Page and numbers are written by `bash tests/validation.sh`; they are as new as the table.
TEST(PublishedTable, StandsOnThePage) {
  const std::string page = read_text(kRoot / "docs/validation.md"),
                    numbers = read_text(kRoot / "docs/validation.csv");
  for (const PublishedCase& one : table().cases) {
    EXPECT_NE(page.find("(../data/validation/" + one.scene + ") |"), std::string::npos) << one.name;
    for (const PublishedValue& value : one.values)
      EXPECT_NE(numbers.find("," + quoted("graze " + command_line(one)) + "," + quoted(value.what) +
                             "," + quoted(shown(value)) + ","),
                std::string::npos)
          << one.name << ": " << value.what;
  }
}

TEST(LastDigit, IsThatOfTheNumberAsItIsWritten) {
  EXPECT_DOUBLE_EQ(last_digit("0.352"), 1e-3);
  EXPECT_DOUBLE_EQ(last_digit("-3.5e3"), 1e2);
  EXPECT_DOUBLE_EQ(last_digit("4.966E-3"), 1e-6);
  EXPECT_DOUBLE_EQ(last_digit("360"), 1.0);
  EXPECT_DOUBLE_EQ(last_digit("2e-5"), 1e-5);
}

TEST(ResultPath, GoesByKeysIndicesAndFilters) {
  const nlohmann::json document = nlohmann::json::parse(
      R"({"events": [{"kind": "impact", "t": 1}, {"kind": "stick", "t": 2}, {"kind": "impact", "t": 3}],
          "rms": [3, 4]})");
  EXPECT_EQ(result_at(document, "events/1/t"), 2);
  EXPECT_EQ(result_at(document, "events/kind=impact/1/t"), 3);
  EXPECT_EQ(result_at(document, "rms/0 + rms/1"), 5);
  EXPECT_THROW(result_at(document, "events/kind=impact/2/t"), std::out_of_range);
  EXPECT_THROW(result_at(document, "runs"), std::out_of_range);
}

}  // namespace
}  // namespace graze::support
