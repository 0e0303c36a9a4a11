// The stop signal of what a thread is at, and when its time is over.
//
// Whoever keeps results looks at its own signal, starts nothing new once that is given, and
// concludes what it has. Whatever lies below, however deep, asks is_over() in every loop that a
// millisecond does not bound, and ends as where it does not converge: what it says then is true,
// but less than could be known. The two differ by a grace, so that conclusions are complete and all
// the same end soon. To ask is to read one number, which a thread beside sets: no loop has to
// decide how often it looks at a clock.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>

#include "graze/base/stop_signal.hpp"

namespace graze {

// In this thread from here to the end of the scope; for_each_index hands it to its threads.
class StopScope {
 public:
  // From when the signal is given until the time is over.
  static constexpr std::chrono::milliseconds kGrace{250};

  explicit StopScope(const StopSignal& stop, std::chrono::milliseconds grace = kGrace);
  // That of another thread, which waits for this one.
  struct Handle {
    StopSignal stop;
    const std::atomic<bool>* over = nullptr;
  };
  explicit StopScope(const Handle& other);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  // One that is never given outside of every scope.
  static const StopSignal& current() { return of_this_thread().stop; }
  static Handle handle() { return of_this_thread(); }
  static bool is_over() { return of_this_thread().over->load(std::memory_order_relaxed); }

 private:
  class Watch;

  inline static const std::atomic<bool> kNever{false};
  static Handle& of_this_thread() {
    static constinit thread_local Handle handle{{}, &kNever};
    return handle;
  }

  Handle before_;
  std::unique_ptr<Watch> watch_;
};

}  // namespace graze
