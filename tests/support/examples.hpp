// The programs of docs/examples: their text, and what they print.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace graze::support {

inline std::string docs_page(const std::string& name) {
  std::ifstream stream(std::filesystem::path(GRAZE_SOURCE_DIR) / "docs" / name);
  EXPECT_TRUE(stream) << name;
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline std::string example_text(const std::string& name) {
  return docs_page("examples/" + name + ".cpp");
}

// Run from the project's root; `words`: what follows the program's name.
inline std::string example_output(const std::string& name, const std::string& words = "") {
  const std::string command = "cd '" + std::string(GRAZE_SOURCE_DIR) + "' && '" +
                              std::string(GRAZE_EXAMPLES) + "/example_" + name + "' " + words;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return "";
  std::string text;
  std::array<char, 256> part;
  while (std::fgets(part.data(), part.size(), pipe)) text += part.data();
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

// The number after each `label`.
inline std::vector<double> values_after(const std::string& text, const std::string& label) {
  std::vector<double> values;
  for (std::size_t at = text.find(label); at != std::string::npos; at = text.find(label, at + 1))
    values.push_back(std::stod(text.substr(at + label.size())));
  return values;
}

// Program text without its blank lines and comments.
inline int lines_of_code(const std::string& text) {
  std::stringstream stream(text);
  int lines = 0;
  for (std::string line; std::getline(stream, line);)
    lines += line.find_first_not_of(' ') != std::string::npos && line.rfind("//", 0) != 0;
  return lines;
}

}  // namespace graze::support
