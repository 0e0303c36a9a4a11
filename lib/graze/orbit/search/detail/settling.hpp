// Decides what a motion settles on, forcing period by forcing period. The motion itself is followed
// by the caller, alone or in a lane beside others.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/detail/stop_poll.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/motion/detail/clearance.hpp"
#include "graze/orbit/search/detail/nearby_orbit.hpp"
#include "graze/orbit/search/settled_motion.hpp"

namespace graze {

class Settling {
 public:
  // Refers to the system. `start`: at the start of a forcing period.
  Settling(const System& system, const State& start, SettleOptions options);

  bool is_over() const { return over_; }
  // Number of complete forcing periods.
  long long periods() const { return history_.periods(); }
  const ExactFlow<double>& flow() const { return flow_; }
  const SettleOptions& options() const { return options_; }
  double closure_speed() const { return closure_speed_; }
  // The state at the start of the present period.
  State state() const { return history_.state_at_start(history_.periods()); }

  // Adds an impact at `local` s in the present period, in the state just before it. Returns false
  // when that exceeds the budget.
  bool add_impact(int stop, double local, double speed, const Vector& q, const Vector& qdot);
  // Ends the period in this state, and checks whether the motion has settled.
  void end_period(const Vector& q, const Vector& qdot, PeriodHistory::Contacts contacts);
  // Whether it is asked to stop; `work`: multiply-adds since the last call, roughly.
  bool is_stopped(long long work) { return stop_requested(poll_.is_due(work)); }
  // The motion cannot be followed, for this reason.
  void refuse(const std::string& failure);
  // To be called when the search for the next event gave up, perhaps because it was asked to stop.
  bool was_stopped() { return stop_requested(true); }

  // Requires that the settling is over.
  SettledMotion result();

 private:
  struct Pattern {
    ImpactPattern pattern;
    std::vector<ImpactPoint> points;
  };

  bool stop_requested(bool reads_clock);
  void look_back(const Vector& q, const Vector& qdot, bool is_free);
  void come_nearer();
  void conclude_near(int p, double remaining);
  void conclude_repeating(int p, double remaining);
  int repetition() const;
  bool conclude_clear(const Vector& q, const Vector& qdot);
  void end_clear();
  void conclude_periodic(int p);
  Pattern pattern_of_last(int p) const;
  void conclude_unsettled();
  void keep_since(long long from);
  bool end(SettledKind kind, const std::string& what);

  const System& system_;
  const SettleOptions options_;
  ExactFlow<double> flow_;
  double closure_speed_;  // m/s
  PeriodHistory history_;
  MotionScale scale_;
  std::optional<LastingClearance> clearance_;  // once a period passes without a contact
  std::optional<NearbyOrbit> approached_;      // stable; solved for when the motion began to repeat
  double left_ = 0.0;                          // distance from it, one repetition ago at most
  long long solved_at_ = 0, next_solve_ = 0, leaving_until_ = 0;  // periods
  long long in_period_ = 0;                                       // impacts
  StopPoll poll_;
  bool over_ = false;
  SettledMotion result_;
};

}  // namespace graze
