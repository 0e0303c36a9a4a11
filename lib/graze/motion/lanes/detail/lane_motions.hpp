// Motions of systems of the same shape, flown side by side: free flights in closed form, first
// contacts certified as by first_zero.hpp, impacts on one stop at a time. Rarer events (a stop
// within its rounding, two at once, the end of a chatter, rest on a stop) are left to the caller;
// the lane takes the motion up again at the start of a forcing period.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/exact/motion_state.hpp"
#include "graze/motion/lanes/detail/lane_kernels.hpp"

namespace graze {

// A system as lanes take it.
struct LaneForm {
  using Responses = std::vector<PlanarNumber<double>>;  // P of each mode
  struct Part {
    double order;  // multiple of the forcing's frequency
    Responses responses;
  };
  std::vector<Part> harmonics;
  Vector forces;  // largest modal forces, kg^1/2 m/s^2, N
};

// None where lanes cannot follow its motions; they can with underdamped modes, few of them, forced
// by harmonics that repeat, and rigid stops of constant restitution r > 0. `flow` is that of the
// system.
std::optional<LaneForm> lane_form(const System& system, const ExactFlow<double>& flow);

class LaneMotions {
 public:
  LaneMotions(const System& system, const LaneForm& form)
      : columns_(static_cast<std::size_t>(system.modes()), system.stops.size(),
                 form.harmonics.size()) {}

  bool has_shape(const System& system, const LaneForm& form) const {
    return columns_.modes() == static_cast<std::size_t>(system.modes()) &&
           columns_.stops() == system.stops.size() && columns_.harmonics() == form.harmonics.size();
  }
  // Requires this shape; impacts slower than `closure_speed`, m/s, are left to the caller.
  void adopt(std::size_t lane, const System& system, const ExactFlow<double>& flow,
             const LaneForm& form, double closure_speed);
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
  void adopt_stop(std::size_t lane, const Stop& stop, std::size_t i, const ExactFlow<double>& flow,
                  const LaneForm& form);

  LaneColumns columns_;
  LaneSet busy_ = 0;
};

}  // namespace graze
