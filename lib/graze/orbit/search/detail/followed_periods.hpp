// A motion followed forcing period by forcing period, through chatter and sticking.
#pragma once

#include <optional>

#include "graze/motion/detail/motion_walk.hpp"
#include "graze/orbit/search/detail/settling.hpp"

namespace graze {

class FollowedPeriods {
 public:
  // Refers to both arguments. Starts in the state of the settling.
  FollowedPeriods(const System& system, Settling& settling);

  // Goes on from this state, in the present period of the settling.
  void go_on_from(const MotionState<double>& state);
  // Follows the motion to the end of the period, and reports it to the settling.
  void follow();
  // Whether every stop is open and not touched.
  bool is_clear() const;

 private:
  bool follow_to_end();
  bool receive(WalkStep step);

  const System& system_;
  Settling& settling_;
  Motion<double> motion_;
  std::optional<MotionWalk<double>> walk_;
  PeriodHistory::Contacts contacts_;
  long long work_ = 0;  // since the settling was asked last whether to stop
};

}  // namespace graze
