// Instructions that a simulation takes, counted by valgrind's callgrind, and the functions that it
// calls.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "support/reached.hpp"
#include "support/scratch_folder.hpp"

namespace graze::cost {

struct Counted {
  long long instructions = 0;
  std::set<std::string> functions;  // called within the simulation
  std::string answer;               // what simulated_run printed

  bool calls(const std::string& name) const {
    for (const std::string& function : functions)
      if (function.find(name) != std::string::npos) return true;
    return false;
  }
};

struct CountedRun {
  std::string scene;  // a shipped one, or the path of a file
  int periods = 0;
  int samples = 0;  // a period
  bool energy = false;
  std::vector<std::string> settings{};
};

inline Counted count(const CountedRun& run) {
  namespace fs = std::filesystem;
  const ScratchFolder folder;
  const fs::path file = folder / "callgrind";
  const fs::path scene = fs::exists(run.scene)
                             ? fs::path(run.scene)
                             : fs::path(GRAZE_SOURCE_DIR) / "data/scenes" / (run.scene + ".toml");
  std::string command = "LD_PRELOAD='" GRAZE_PRELOADED
                        "' valgrind --tool=callgrind --toggle-collect='graze::simulate(*' "
                        "--callgrind-out-file='" +
                        file.string() + "' '" + GRAZE_SIMULATED_RUN + "' '" + scene.string() +
                        "' " + std::to_string(run.periods) + " " + std::to_string(run.samples) +
                        (run.energy ? " 1" : " 0");
  for (const std::string& setting : run.settings) command += " '" + setting + "'";
  Counted counted;
  FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
  std::array<char, 256> line{};
  while (pipe && std::fgets(line.data(), line.size(), pipe)) counted.answer += line.data();
  EXPECT_EQ(pipe ? pclose(pipe) : -1, 0) << command;
  std::ifstream stream(file);
  for (std::string text; std::getline(stream, text);) {
    if (text.rfind("summary: ", 0) == 0) counted.instructions = std::stoll(text.substr(9));
    const auto close = text.find(") ");
    if ((text.rfind("fn=(", 0) == 0 || text.rfind("cfn=(", 0) == 0) && close != std::string::npos)
      counted.functions.insert(text.substr(close + 2));
  }
  EXPECT_GT(counted.instructions, 0) << command;
  return counted;
}

// Per forcing period, without what the start of a run costs.
inline double per_period(CountedRun run) {
  const long long once = count(run).instructions;
  run.periods *= 2;
  return static_cast<double>(count(run).instructions - once) / (run.periods / 2);
}

}  // namespace graze::cost
