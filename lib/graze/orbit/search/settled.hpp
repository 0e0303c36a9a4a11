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

// Many motions to be settled, in a number of places at a time: parts that consist of free flights
// and impacts are flown side by side in the lanes of the processor's vector unit. Each settles as
// by `settle`, with the rounding of its lane, which does not depend on the other lanes. Systems
// with other numbers of modes and stops than the first are followed one by one.
struct SettleTask {
  const System* system = nullptr;  // must live until it has settled
  State start;
  SettleOptions options;
};
class SettleTasks {
 public:
  virtual ~SettleTasks() = default;
  // The next task for a place; nullopt when there are no more.
  virtual std::optional<SettleTask> next(std::size_t place) = 0;
  // Takes the result of the last task of that place.
  virtual void take(std::size_t place, SettledMotion motion) = 0;
};
void settle_side_by_side(SettleTasks& tasks);
// A single motion, with the same result as beside others to the last bit.
SettledMotion settle_in_lane(const System& system, const State& start,
                             const SettleOptions& options);

}  // namespace graze
