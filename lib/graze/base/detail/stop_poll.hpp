// When a loop should look at its stop signal (stop_signal.hpp): the clock costs as much as some ten
// pieces of work, and pieces differ by orders of magnitude, so work is counted and not rounds.
#pragma once

#include <algorithm>

namespace graze {

class StopPoll {
 public:
  // `first`: work until the first look.
  explicit StopPoll(long long first = 0) : left_(first) {}

  // `work`: multiply-adds done since the last call, roughly. True whenever enough came together
  // that a look at the clock does not count.
  bool is_due(long long work) {
    left_ -= std::max(work, 1LL);
    if (left_ > 0) return false;
    left_ = kWorkPerLook;
    return true;
  }

 private:
  // At some 5 ns each a look every 80 us, of which it takes 30 ns.
  static constexpr long long kWorkPerLook = 1 << 14;
  long long left_;
};

}  // namespace graze
