// Every file in tests/scenes/bad is refused with exactly the message that expected.txt gives it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "graze/scene/reader.hpp"

namespace graze {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(GRAZE_SOURCE_DIR) / "tests" / "scenes" / "bad";

// File name -> "line:column: key: sentence".
std::map<std::string, std::string> expected_messages() {
  std::map<std::string, std::string> messages;
  std::ifstream stream(kFolder / "expected.txt");
  std::string line;
  while (std::getline(stream, line)) {
    const std::size_t tab = line.find('\t');
    EXPECT_NE(tab, std::string::npos) << line;
    messages[line.substr(0, tab)] = line.substr(tab + 1);
  }
  return messages;
}

std::string message_of(const std::filesystem::path& file) {
  try {
    read_scene(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string message_of_text(const std::string& text) {
  try {
    parse_scene(text, "text");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BadScene, EveryFileIsRefusedWithItsMessage) {
  const auto messages = expected_messages();
  EXPECT_GE(messages.size(), 45u);
  for (const auto& [name, message] : messages) {
    const std::filesystem::path file = kFolder / name;
    EXPECT_EQ(message_of(file), file.string() + ":" + message);
  }
}

TEST(BadScene, EveryFileHasAMessage) {
  const auto messages = expected_messages();
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name == "expected.txt" || messages.count(name) == 1) << name;
  }
}

TEST(BadScene, EveryMessageIsOneLine) {
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".toml") {
      const std::string message = message_of(entry.path());
      EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20;
      })) << message;
    }
  }
}

TEST(BadScene, TextLargerThanTheLimit) {
  const std::string text(16 * 1024 * 1024 + 1, '#');
  EXPECT_EQ(message_of_text(text),
            "text:1:1: toml: the text is larger than 16 MiB, a scene must be smaller");
}

TEST(BadScene, FileLargerThanTheLimit) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "graze_huge_scene.toml";
  std::ofstream(file) << std::string(17 * 1024 * 1024, '\n');
  EXPECT_EQ(message_of(file),
            file.string() + ":1:1: toml: the text is larger than 16 MiB, a scene must be smaller");
  std::filesystem::remove(file);
}

// What brings a recursive parser to the end of its stack.
TEST(BadScene, EndlessNestingIsRefused) {
  const auto repeated = [](const std::string& piece, int times) {
    std::string text;
    for (int k = 0; k < times; ++k) {
      text += piece;
    }
    return text;
  };
  const std::string too_deep = "tables and lists nest too deep here";
  for (const std::string& text :
       {"a = " + repeated("[", 1000000), "a = " + repeated("{a=", 1000000),
        repeated("a.", 1000000) + "a = 1", "[" + repeated("a.", 1000000) + "a]",
        repeated("\"a\".", 1000000) + "a = 1", "a = " + repeated("{a=[", 500000),
        // Strings that a scan without their rules would take for the rest of the line.
        "a = { b = '''c'''', " + repeated("d.", 1000000) + "d = 1 }",
        "a = { b = \"c\\\"\", " + repeated("d.", 1000000) + "d = 1 }",
        "a = { b = '\\', " + repeated("d.", 1000000) + "d = 1 }"}) {
    EXPECT_NE(message_of_text(text).find(too_deep), std::string::npos) << text.substr(0, 40);
  }
}

TEST(BadScene, LongListIsRefusedByItsLength) {
  std::string text = "[modal]\nfrequencies = [1.0";
  for (int k = 0; k < 100000; ++k) {
    text += ", 1.0";
  }
  EXPECT_EQ(message_of_text(text + "]\n"),
            "text:2:1: modal.frequencies: the list has 100001 entries, it must have 1 to 400");
}

}  // namespace
}  // namespace graze
