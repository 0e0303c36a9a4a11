// What a result tells of options, by a description of its own.
#include "option_notes.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace graze {
namespace {

struct OwnOptions {
  std::optional<double> speed;
  int count = 3;
  bool fast = false, quiet = false;
  std::vector<std::string> words, keys;
  std::string file;
};

void describe(auto& v, OwnOptions& o) {
  v.heading("Own");
  v.file("FILE", o.file, "a file", kMandatory, kOfResult.named("file"));
  v.option("speed", o.speed, "V", "a speed", kOfPieces);
  v.option("count", o.count, "N", "a number", kOfPieces);
  v.option("words", o.words, "W,..", "words", kWithCommas, kOfResult);
  v.option("keys", o.keys, "K", "keys", kRepeated, kOfResult);
  v.flag("fast", o.fast, "whether", kOfResult);
  v.flag("quiet", o.quiet, "told by nobody");
  v.text(
      "follow", [](const std::string&) {}, "WHAT", "what is followed",
      kOfResult.where(o.fast).as("all"));
}

std::string told(const OwnOptions& options, Recorded::In in) {
  RunInfo info;
  note_options(options, in, info);
  std::string text;
  for (const auto& [name, value] : info.options) {
    text += name + "=";
    if (const auto* number = std::get_if<long long>(&value)) text += std::to_string(*number);
    if (const auto* number = std::get_if<double>(&value)) text += fmt::format("{:.1f}", *number);
    if (const auto* truth = std::get_if<bool>(&value)) text += *truth ? "true" : "false";
    if (const auto* word = std::get_if<std::string>(&value)) text += *word;
    text += ";";
  }
  return text;
}

TEST(OptionNotes, TellWhatIsThere) {
  EXPECT_EQ(told({}, Recorded::In::kPieces), "count=3;");
  EXPECT_EQ(told({}, Recorded::In::kResult), "fast=false;");
  const OwnOptions given{2.5, 4, true, true, {"a", "b"}, {"x=1", "y=2"}, "data.csv"};
  EXPECT_EQ(told(given, Recorded::In::kPieces), "speed=2.5;count=4;");
  EXPECT_EQ(told(given, Recorded::In::kResult),
            "file=data.csv;words=a,b;keys=x=1 y=2;fast=true;follow=all;");
}

}  // namespace
}  // namespace graze
