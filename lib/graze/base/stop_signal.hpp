// When long work has to stop before its end. The work polls the signal and keeps what is finished.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>

namespace graze {

enum class StopReason { kNone, kInterrupted, kOutOfTime };

struct StopSignal {
  const std::atomic<bool>* interrupted = nullptr;                 // set from outside
  std::optional<std::chrono::steady_clock::time_point> deadline;  // wall clock

  bool is_interrupted() const {
    return interrupted && interrupted->load(std::memory_order_relaxed);
  }
  // Reads the clock: some 30 ns.
  bool is_late() const { return deadline && std::chrono::steady_clock::now() >= *deadline; }
  StopReason reason() const {
    if (is_interrupted()) return StopReason::kInterrupted;
    return is_late() ? StopReason::kOutOfTime : StopReason::kNone;
  }
  bool requested() const { return reason() != StopReason::kNone; }
};

}  // namespace graze
