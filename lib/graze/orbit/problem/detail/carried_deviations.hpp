// The deviations that a segment (trajectory_segment.hpp) carries along with its motion, event by
// event: those of its start and the derivative by a parameter.
#pragma once

#include <vector>

#include "graze/flow/variation/detail/deviation.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/orbit/problem/detail/parameter_deviation.hpp"

namespace graze {

// A direction in which the start and the parameter move: weights of the deviations, and of the
// derivative by the parameter.
struct SegmentDirection {
  Vector deviations;
  double parameter = 0.0;
  const System* tangent = nullptr;  // derivative of the system by the parameter
};

// The push of the compressed springs except one of them; empty where there are none.
Vector spring_push(const System& system, const Motion<double>& motion, int without = -1);

class CarriedDeviations {
 public:
  // Refers to all arguments; null: not requested.
  CarriedDeviations(const System& system, Motion<double>& motion, Deviations* deviations,
                    ParameterDeviation* parameter);

  bool any() const { return deviations_ || parameter_; }
  bool by_parameter() const { return parameter_; }

  // Carries them along the flight just flown; at a contact, to the deviated motion's own contact.
  void carry(const Arrival<double>& arrival);
  // To a contact at the same instant: thrown back onto a stop without any flight.
  void meet_at_once(const Arrival<double>& arrival);
  void jump(const std::vector<ImpactShare<double>>& shares, const Vector& qdot_before);
  // The structure is put to rest on these stops, at the end of a chatter that was summed.
  void close(const std::vector<int>& stops, const State& before);
  // Into a contact with a compliant stop at its surface; with the sign -1 out of it.
  void cross_surface(int stop, double sign);
  // Refers the deviations to the instant of the undisturbed motion, along the rate of the motion
  // without the spring at stop `without`; -1: with all springs.
  void project_to_fixed_time(int without = -1);

  // Derivative along a direction of the gap at a stop, s after the departure of the flight just
  // flown.
  double gap_rate(const SegmentDirection& along, int stop, double s) const;
  // Derivative of the speed of an impact, from the deviations at the contact.
  double speed_rate(const SegmentDirection& along, int stop, const State& before) const;

  // Stops, and friction that sticks.
  std::vector<int> closed_now() const;
  // The rate of the motion, held so, without the spring at stop `without`.
  State rate_now(const std::vector<int>& closed, int without = -1) const;
  // The same at the end of the flight just flown, before what happens there.
  State rate_flown() const;

 private:
  const Stop& stop(int i) const { return system_.stops[static_cast<std::size_t>(i)]; }
  State state_now() const { return {motion_.q(), motion_.qdot()}; }
  State rate_now(const std::vector<int>& closed, const std::vector<Contact>& frictions,
                 int without = -1) const;
  void stand(int friction);
  void slip(int friction);
  void follow(int friction);
  bool departed_from(int stop) const;
  Deviations change_along(double flight, const std::vector<int>& closed);
  void carry_parameter(const Arrival<double>& arrival);
  // `reach`: b.dq at the undeviated contact; `at_once`: without a flight.
  void meet(const Arrival<double>& arrival, const Eigen::RowVectorXd& reach, bool at_once);
  void undo(const std::vector<int>& stops, const Vector& parts, Matrix& columns) const;

  const System& system_;
  Motion<double>& motion_;
  Deviations* deviations_;
  ParameterDeviation* parameter_;
};

}  // namespace graze
