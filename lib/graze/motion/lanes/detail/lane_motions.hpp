// Motions of systems of the same shape, flown side by side: free flights in closed form, first
// contacts certified as by first_zero.hpp, impacts on one stop at a time. Rarer events (a stop
// within its rounding, two at once, the end of a chatter, rest on a stop) are left to the caller;
// the lane takes the motion up again at the start of a forcing period.
#pragma once

#include <Eigen/Core>

#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/exact/motion_state.hpp"
#include "graze/motion/lanes/detail/lane_kernels.hpp"

namespace graze {

// Whether lanes can follow its motions: forced, underdamped modes, few of them, rigid stops of
// constant restitution r > 0. `flow` is that of the system.
bool has_lane(const System& system, const ExactFlow<double>& flow);

class LaneMotions {
 public:
  LaneMotions(int modes, int stops) : columns_(modes, stops) {}

  bool has_shape(const System& system) const {
    return columns_.modes() == static_cast<std::size_t>(system.modes()) &&
           columns_.stops() == system.stops.size();
  }
  // Requires has_lane of the system; impacts slower than `closure_speed`, m/s, are left to the
  // caller.
  void adopt(std::size_t lane, const System& system, const ExactFlow<double>& flow,
             double closure_speed);
  // Starts a motion from this state at the start of a forcing period, clear of every stop.
  void begin(std::size_t lane, const Vector& q, const Vector& qdot);
  void drop(std::size_t lane);

  bool is_idle() const { return busy_ == 0; }
  // Flies until some lanes have arrived. Requires that not all are idle.
  LaneArrivals fly();

  // After an arrival: its time, s since the start of the forcing period (0 at its end), the state,
  // and the approach speed (m/s) and the stop.
  double local(std::size_t lane) const { return columns_.row(LaneRow::kLocal)[lane]; }
  void end_state(std::size_t lane, Vector& q, Vector& qdot) const;
  double speed(std::size_t lane) const { return columns_.row(LaneRow::kSpeed)[lane]; }
  int stop(std::size_t lane) const { return static_cast<int>(columns_.row(LaneRow::kHit)[lane]); }
  // The start of the last flight of a lane that left, in `period`.
  MotionState<double> departure(std::size_t lane, long long period) const;

 private:
  LaneColumns columns_;
  LaneSet busy_ = 0;
};

}  // namespace graze
