// Everything needed to repeat a result.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "graze/base/sha256.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

using OptionValue = std::variant<bool, long long, double, std::string>;

struct RunInfo {
  std::string version;
  std::string command;                                       // "simulate"
  std::string scene_file;                                    // as given
  std::string scene_title;                                   // of the scene; empty: none
  std::string scene_text;                                    // the scene in force, as TOML
  std::string scene_sha256;                                  // of scene_text
  std::vector<std::pair<std::string, OptionValue>> options;  // those that were given or used
  // The arguments of the program, and "NAME=VALUE" of what was set in the scene.
  std::vector<std::string> arguments{}, settings{};
  std::string folder{};      // that the result is in; empty: none
  Units units = Units::kSi;  // of the scene, in which its results are given
};

// "0.1.0"
std::string version();

// Info for a command on a scene, options still empty.
RunInfo run_info(const std::string& command, const std::string& scene_file, const Scene& scene);

}  // namespace graze
