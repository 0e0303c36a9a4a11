// A motion evaluated where it was measured: its state at given instants, each as exact as the
// motion itself, and its impacts.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/base/vector.hpp"
#include "graze/system/system.hpp"

namespace graze {

struct Observed {
  std::size_t index = 0;  // of the instant
  Vector q, qdot;         // kg^1/2 m, kg^1/2 m/s, N each
  Vector forces;          // of every stop, N, 0 where it is open; empty unless asked for
};

struct Observation {
  double end = 0.0;                              // s: the motion is followed from t = 0 up to here
  std::vector<double> times;                     // s, ascending, from 0 to `end`
  bool forces = false;                           // whether they are asked for
  std::function<void(const Observed&)> state{};  // called for each of them in order
  // Called at every impact on a rigid stop and every entry into a compliant one; false ends the
  // motion.
  std::function<bool(int stop, double time)> impact{};
  double closure_speed = 0.0;  // m/s, below which a chatter is summed (default_closure_speed)
  long long max_impacts = 0;
  StopSignal stop;
};

// Follows the system from `start` at t = 0 as `simulate` does with the exact flow. Returns why it
// could not be followed to its end, a sentence; empty where it was.
std::string observe(const System& system, const State& start, const Observation& observation);

}  // namespace graze
