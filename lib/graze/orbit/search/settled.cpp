#include "graze/orbit/search/settled.hpp"

#include "graze/orbit/search/detail/followed_periods.hpp"
#include "graze/orbit/search/detail/settling.hpp"

namespace graze {

SettledMotion settle(const System& system, const State& start, const SettleOptions& options) {
  Settling settling(system, start, options);
  FollowedPeriods followed(system, settling);
  while (!settling.is_over()) followed.follow();
  return settling.result();
}

}  // namespace graze
