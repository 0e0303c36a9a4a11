// Runs the program as a user would.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/picture_texts.hpp"
#include "support/scratch_folder.hpp"

namespace graze {

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

struct Finished {
  int code = 0;  // exit code; 128 + n after signal n
  std::string out, err;
};

// The picture that a command has drawn, where it is one in SVG, can be read.
inline void expect_readable_picture(const std::string& arguments) {
  static const std::regex plot("(^| )(--plot|-p)[ =](\\S+\\.svg)( |$)");
  std::smatch match;
  if (!std::regex_search(arguments, match, plot)) return;
  const std::string picture = read_text(match[3].str());
  if (picture.empty()) return;
  EXPECT_EQ(support::unreadable_texts(picture), "") << "graze " << arguments;
}

// Runs `graze ARGUMENTS` through the shell (quote what needs it), after `prefix`.
inline Finished run_graze(const std::string& arguments, const std::string& prefix = "") {
  const ScratchFolder scratch;
  const std::string out = (scratch / "out").string(), err = (scratch / "err").string();
  const std::string line =
      prefix + std::string(GRAZE_PROGRAM) + " " + arguments + " >" + out + " 2>" + err;
  const int status = std::system(line.c_str());
  if (status == 0) expect_readable_picture(arguments);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(out),
          read_text(err)};
}

// The most memory that `graze ARGUMENTS` holds at one time, MiB; its output goes nowhere.
inline double peak_memory(const std::string& arguments) {
  const std::string line =
      "exec " + std::string(GRAZE_PROGRAM) + " " + arguments + " >/dev/null 2>&1";
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0
             ? static_cast<double>(usage.ru_maxrss) / 1024.0
             : -1.0;
}

// The lines of a file without their ends.
inline std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The names of what a folder holds, sorted.
inline std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

inline std::string scene(const std::string& name) {
  return std::string(GRAZE_SOURCE_DIR) + "/data/scenes/" + name;
}

// A scene of tests/reference/cases.
inline std::string reference_case(const std::string& name) {
  return std::string(GRAZE_SOURCE_DIR) + "/tests/reference/cases/" + name;
}

// A scene of measurements, or their table.
inline std::string measured(const std::string& name) {
  return std::string(GRAZE_SOURCE_DIR) + "/data/measurements/" + name;
}

// Scenes of many of these tests.
inline const std::string kOneMode = scene("05_wagg_one_mode.toml");
inline const std::string kOscillator = scene("04_impact_oscillator.toml");
inline const std::string kBall = scene("06_bouncing_ball.toml");
inline const std::string kMomentum = scene("02_wagg_momentum.toml");
inline const std::string kForcedChatter = reference_case("sticking/Z2b.toml");

}  // namespace graze
