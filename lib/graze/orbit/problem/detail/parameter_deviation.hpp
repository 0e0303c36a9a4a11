// The deviation to the motion of a system that is a little different, event by event, per unit of
// the parameter that moves the system along its tangent: the derivative of a segment by a parameter
// of the scene.
//
// Carried like the deviations of a start (trajectory_segment.hpp), on its own events, with what the
// parameter itself moves:
//   contact  b.dq + db.q = da at the deviated contact,  dt' = dt - (b.dq + db.q - da)/v;
//   impact   the derivative of the jump at fixed position, by its speeds, rows, directions and r;
//   closure  as an impact with r = 0;
//   release  nothing: the contact force vanishes there.
// The clock is the forcing phase, as in parameter_growth.hpp.
#pragma once

#include <vector>

#include "graze/flow/variation/detail/parameter_growth.hpp"
#include "graze/motion/detail/motion.hpp"

namespace graze {

class ParameterDeviation {
 public:
  // `start`: how the state at the start of the segment moves, at a fixed forcing phase. Refers to
  // both systems. Requires forcing.
  ParameterDeviation(const System& system, const System& tangent, const State& start);

  // Of the state at hand; at a fixed forcing phase again once the segment has ended.
  State value() const { return {column_.q.col(0), column_.qdot.col(0)}; }

  // Along a flight of s seconds from `start` at phase theta. What it adds to b.dq + db.q - da at a
  // stop is remembered for a contact at its end.
  void carry(const ExactPhase<double>& phase, const State& start, double theta, double s);
  // The same on compressed springs, at no delay.
  void carry_on_springs(const ContactPhase<double>& phase, const State& start, double theta,
                        double s);
  // A contact with a compliant stop begins at its surface, or ends there with the opposite sign
  // (sprung_deviation.hpp), which changes velocities by `change` times what reaches in; at no
  // delay.
  void cross(int stop, const State& at, const Vector& change);
  // On from a contact of the undisturbed motion to its own: `at` is the state before the impact,
  // `rate` how it moves with time, v the approach speed, `departed`: the flight left this stop.
  void meet(int stop, const State& at, const State& rate, double v, bool departed);
  // Thrown back onto a stop without any flight.
  void meet_at_once(int stop, const State& at, const State& rate, double v);
  void jump(const std::vector<ImpactShare<double>>& shares, const Vector& qdot_before);
  // Put to rest on these stops, at the end of a chatter that was summed.
  void close(const std::vector<int>& stops, const State& before);
  // Back to the undisturbed instant.
  void end(const State& rate);

 private:
  const Stop& stop(int i) const { return system_->stops[static_cast<std::size_t>(i)]; }
  const Stop& stop_rate(int i) const { return tangent_->stops[static_cast<std::size_t>(i)]; }
  struct Acting {
    Matrix rows, directions, rows_rate, directions_rate;  // N x k
    Matrix coupling_rate;                                 // of B^T D
    Vector change(const Vector& p, const Vector& rate) const;
  };
  Acting acting(const std::vector<int>& stops) const;
  void move_to(int stop, const State& at, const State& rate, double shift);

  const System* system_;
  const System* tangent_;
  Deviations column_;  // one
  Deviations last_;    // what the last flight added
  Vector moved_;       // and how far it went
};

}  // namespace graze
