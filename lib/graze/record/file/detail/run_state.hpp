// A run that was cut, as a file to go on from: TOML, all numbers with all their digits.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "graze/motion/simulation.hpp"

namespace graze {

struct CutRun {
  std::string version;                // of the program
  std::string scene_sha256;           // of the scene in force, as RunInfo has it
  std::string outcome;                // "reached_end", "interrupted", ..
  double time = 0.0;                  // s, where it was cut
  std::optional<double> sample_rate;  // 1/s, of the samples counted in `state`; absent: none
  RunState state;
};

// The name of such a file in an output folder.
inline constexpr const char* kStateFile = "state.toml";

std::string write_run_state(const CutRun& cut);

// Reads back what write_run_state wrote about a run of `system`. Throws FileError when the file
// cannot be read; InputError (file:line:column: key: sentence) when it holds no such state, one in
// another format, of another scene, of other sizes, or of a run that cannot go on.
CutRun read_run_state(const std::filesystem::path& file, const System& system,
                      const std::string& scene_sha256);

// The same for text already in memory; `name` stands for the file in messages.
CutRun parse_run_state(const std::string& text, const std::string& name, const System& system,
                       const std::string& scene_sha256);

}  // namespace graze
