// What a motion settles on: it is followed forcing period by forcing period, through chatter and
// sticking, until it repeats.
#pragma once

#include <cstddef>
#include <optional>

#include "graze/orbit/search/settled_motion.hpp"

namespace graze {

// Follows the motion from `start`, at the start of a forcing period, until it repeats. It counts as
// repeating when phases (rad) and relative speeds of the last three repetitions agree to 1e-6: near
// enough for Newton, which then decides. Requires forcing.
SettledMotion settle(const System& system, const State& start, const SettleOptions& options = {});

// Many motions to be settled, in so many places at a time: those that free flights and impacts make
// up are flown side by side in the lanes of the processor's vector unit, as far as they do. Each
// settles as `settle` has it, with the rounding of its lane, which depends on nothing but itself.
// Systems with other numbers of modes and stops than the first are followed one by one.
struct SettleTask {
  const System* system = nullptr;  // until it has settled
  State start;
  SettleOptions options;
};
class SettleTasks {
 public:
  virtual ~SettleTasks() = default;
  // The next one for a place; nothing where there are no more.
  virtual std::optional<SettleTask> next(std::size_t place) = 0;
  // What the last one there has settled on.
  virtual void take(std::size_t place, SettledMotion motion) = 0;
};
void settle_side_by_side(SettleTasks& tasks);
// One of them by itself: as it settles beside others, to the last bit.
SettledMotion settle_in_lane(const System& system, const State& start,
                             const SettleOptions& options);

}  // namespace graze
