// The stop signal of what a thread is at. Long computations deep below whoever was asked to stop
// (eigenvalues of many modes, the minima of a gap over many oscillations) look at it, and end as
// where they do not converge: what they say then is true, but less than could be known. Who keeps
// results looks at its own signal.
#pragma once

#include "graze/base/detail/stop_poll.hpp"
#include "graze/base/stop_signal.hpp"

namespace graze {

// In this thread from here to the end of the scope; for_each_index hands it to its threads.
class StopScope {
 public:
  explicit StopScope(const StopSignal& stop);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  // One that is never given outside of every scope.
  static const StopSignal& current();

 private:
  StopSignal before_;
};

// Within one long computation. A short one is always finished: what is kept after a stop is judged
// by thousands of them.
class ScopedPoll {
 public:
  // After so many multiply-adds, roughly.
  bool requested_after(long long work) {
    return poll_.is_due(work) && StopScope::current().requested();
  }

 private:
  // Some 20 ms.
  static constexpr long long kShort = 1 << 22;
  StopPoll poll_{kShort};
};

}  // namespace graze
