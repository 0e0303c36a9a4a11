// What all commands share: the scene, warnings, progress, the end.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "graze/record/records.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// Set by Ctrl-C; long work polls it and keeps what it finished.
extern std::atomic<bool> interrupted;

// Reads the scene with its settings; prepares the output folder first, so that hours of work do not
// end at a folder that cannot be written.
Scene open_scene(const Command& command);

// Prints warnings on stderr unless quiet.
void warn(const Command& command, const std::vector<std::string>& warnings);

// A progress line on stderr, or nothing when stderr is no terminal or the user wants quiet.
std::function<void(double)> progress_line(const Command& command);

// Writes the result files (name, text) and prints the result; returns the exit code of the outcome.
int conclude(const Command& command, const RunInfo& info, const Outcome& outcome,
             const std::string& json, const std::string& text,
             const std::vector<std::pair<std::string, std::string>>& files);

int run_check(const Command& command);
int run_simulate(const Command& command);
int run_orbit(const Command& command);
int run_continue(const Command& command);

}  // namespace graze
