// The derivative of a segment by a parameter of the scene, event by event: the deviation to the
// motion of the system that the parameter changes along its tangent, per unit of the parameter.
//
// Carried like the deviations of a start (trajectory_segment.hpp), at its own events, with the
// changes by the parameter itself:
//   contact  b.dq + db.q = da at the deviated contact,  dt' = dt - (b.dq + db.q - da)/v;
//   impact   the derivative of the jump at fixed position, by its speeds, rows, directions and r;
//   closure  as an impact with r = 0;
//   release  no change: the contact force vanishes there.
// The clock is the forcing phase, as in parameter_growth.hpp.
#pragma once

#include <vector>

#include "graze/flow/variation/detail/parameter_growth.hpp"
#include "graze/motion/detail/motion.hpp"

namespace graze {

class ParameterDeviation {
 public:
  // `start`: derivative of the state at the start of the segment, at a fixed forcing phase. Refers
  // to both systems. Requires forcing.
  ParameterDeviation(const System& system, const System& tangent, const State& start);

  // The derivative of the present state; at a fixed forcing phase again once the segment has ended.
  State value() const { return {column_.q.col(0), column_.qdot.col(0)}; }

  // Along a flight of s seconds from `start` at phase theta. Its change of b.dq + db.q - da at a
  // stop is kept for a contact at the end.
  void carry(const ExactPhase<double>& phase, const State& start, double theta, double s);
  // The same on compressed springs, at no delay.
  void carry_on_springs(const ContactPhase<double>& phase, const State& start, double theta,
                        double s);
  // A contact with a compliant stop begins at its surface, or ends there with the opposite sign
  // (sprung_deviation.hpp), which changes velocities by `change` times the depth of the deviation;
  // at no delay.
  void cross(int stop, const State& at, const Vector& change);
  // From a contact of the undisturbed motion to its own: `at` is the state before the impact,
  // `rate` its rate in time, v the approach speed, `departed`: the flight left this stop.
  void meet(int stop, const State& at, const State& rate, double v, bool departed);
  // To a contact at the same instant: thrown back onto a stop without any flight.
  void meet_at_once(int stop, const State& at, const State& rate, double v);
  void jump(const std::vector<ImpactShare<double>>& shares, const Vector& qdot_before);
  // From where a friction of the undisturbed motion stands still, or slips under less force than it
  // stuck with, to its own.
  void stand(int friction, const State& at, const State& rate);
  // What rubs behind springs is put to rest, or to where it follows its place, at a start that was
  // `given` otherwise.
  void begin(const State& given, const MotionState<double>& start);
  // What rubs behind a spring follows its place from here on.
  void follow(int friction, bool forward, const State& at);
  // Of what rubs behind a spring, after an impulse has left this velocity. `i`: as in a PhaseKey.
  void hold_speed(int i, const Vector& qdot);
  void slip(const PhaseKey& key, int friction, bool forward, const State& at, double theta,
            const State& rate);
  // The structure is put to rest on these stops, at the end of a chatter that was summed.
  void close(const std::vector<int>& stops, const State& before);
  // Refers the deviation to the undisturbed instant.
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
