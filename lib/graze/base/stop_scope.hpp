// The stop signal of the work that a thread is doing, and when its time is over.
//
// A caller that keeps results polls its own signal: once that is given, it starts nothing new and
// concludes what it has. The functions below it, however deep, ask is_over() in every loop that may
// take longer than a millisecond, and then end as if they had not converged: what they return is
// true, but less than could be known. Between the signal and is_over() lies a grace, so that
// conclusions are complete and everything still ends soon. is_over() reads one number, which
// another thread sets, so that no loop has to decide how often it looks at a clock.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>

#include "graze/base/stop_signal.hpp"

namespace graze {

// Holds in this thread to the end of the scope; for_each_index passes it on to its threads.
class StopScope {
 public:
  // The time between the signal and is_over().
  static constexpr std::chrono::milliseconds kGrace{250};

  explicit StopScope(const StopSignal& stop, std::chrono::milliseconds grace = kGrace);
  // The scope of another thread, which waits for this one.
  struct Handle {
    StopSignal stop;
    const std::atomic<bool>* over = nullptr;
  };
  explicit StopScope(const Handle& other);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  // A signal that is never given, outside of every scope.
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
