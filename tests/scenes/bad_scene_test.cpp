// Every scene of bad_scenes.txt is refused with exactly the message that stands below it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "graze/scene/reader.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

struct BadScene {
  std::string name, text;
  std::string message;  // "line:column: key: sentence"
};

std::vector<BadScene> bad_scenes() {
  std::vector<BadScene> list;
  std::ifstream stream(std::string(GRAZE_SOURCE_DIR) + "/tests/scenes/bad_scenes.txt");
  bool open = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("== ", 0) == 0) {
      EXPECT_FALSE(open) << line << " comes before the message of the scene above";
      list.push_back({line.substr(3), "", ""});
      open = true;
    } else if (line.rfind("-> ", 0) == 0) {
      EXPECT_TRUE(open) << line << " belongs to no scene";
      list.back().message = line.substr(3);
      open = false;
    } else if (open) {
      list.back().text += line + "\n";
    }
  }
  EXPECT_FALSE(open);
  // Bytes that no text file should have.
  const auto bytes = [](const char* begin, std::size_t size) { return std::string(begin, size); };
  list.push_back({"binary", bytes("[beam]\nlength = 0.3\n\177ELF\002\001\000\000", 28),
                  "3:1: toml: the byte 0x7F is not text, a scene must be plain UTF-8"});
  list.push_back({"nul byte", bytes("[beam]\nlength = 0.3\000\n", 21),
                  "2:13: toml: the byte 0x00 is not text, a scene must be plain UTF-8"});
  list.push_back({"latin1", bytes("title = \"schwingt gegen Anschlag \374\"\n", 36),
                  "1:34: toml: the byte 0xFC is not text, a scene must be plain UTF-8"});
  list.push_back({"overlong utf8", bytes("# \303\251 is fine\n# \300\257 is not\n", 25),
                  "2:3: toml: the byte 0xC0 is not text, a scene must be plain UTF-8"});
  list.push_back(
      {"byte order mark",
       bytes("\357\273\277[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = "
             "24.4e-14\ndensity = 8500.0\narea = 12.4e-6\nmodes = 4\n",
             113),
       "1:1: toml: the text starts with a byte order mark, it must be plain UTF-8 without one"});
  list.push_back({"utf16", bytes("\377\376[\000b\000e\000a\000m\000]\000\n\000", 16),
                  "1:1: toml: the text is UTF-16, it must be plain UTF-8"});
  return list;
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

TEST(BadScene, IsRefusedWithItsMessage) {
  const std::vector<BadScene> scenes = bad_scenes();
  EXPECT_GE(scenes.size(), 180u);
  std::set<std::string> names;
  for (const BadScene& scene : scenes) {
    EXPECT_EQ(message_of_text(scene.text), "text:" + scene.message) << scene.name;
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    EXPECT_TRUE(std::none_of(scene.message.begin(), scene.message.end(), [](char c) {
      return static_cast<unsigned char>(c) < 0x20;
    })) << scene.name;
  }
}

TEST(BadScene, IsNamedByItsFile) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "scene.toml";
  const BadScene scene = bad_scenes().front();
  std::ofstream(file) << scene.text;
  EXPECT_EQ(message_of(file), file.string() + ":" + scene.message);
}

TEST(BadScene, TextLargerThanTheLimit) {
  const std::string text(16 * 1024 * 1024 + 1, '#');
  EXPECT_EQ(message_of_text(text),
            "text:1:1: toml: the text is larger than 16 MiB, a scene must be smaller");
}

TEST(BadScene, FileLargerThanTheLimit) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "scene.toml";
  std::ofstream(file) << std::string(17 * 1024 * 1024, '\n');
  EXPECT_EQ(message_of(file),
            file.string() + ":1:1: toml: the text is larger than 16 MiB, a scene must be smaller");
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
            "text:2:1: modal.frequencies: the list has 100001 entries, it must have 1 to 2000");
}

}  // namespace
}  // namespace graze
