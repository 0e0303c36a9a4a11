// A run of the program that is asked to end when it takes long, and killed when it does not.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace graze {

struct WatchedRun {
  int code = -1;         // exit code
  int signal = 0;        // that ended it; 0: none did
  bool asked = false;    // SIGTERM was sent
  bool killed = false;   // it did not end within the bound
  double ending = 0.0;   // seconds from SIGTERM to the end
  double busy = 0.0;     // seconds of processor time, from SIGTERM where that was sent
  std::string out, err;  // the first megabyte of each
};

struct RunLimits {
  std::chrono::milliseconds patience{300};  // until it is asked
  std::chrono::seconds bound{10};           // from then on
  bool memory = true;  // a limited address space; a program with sanitizers needs all of it
};

// Runs `arguments` (the program first, its path absolute) in `folder`; out and err pass through
// files there.
WatchedRun watched_run(const std::vector<std::string>& arguments, const std::string& folder,
                       const RunLimits& limits);

}  // namespace graze
