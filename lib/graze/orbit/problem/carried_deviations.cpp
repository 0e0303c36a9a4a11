#include "graze/orbit/problem/detail/carried_deviations.hpp"

#include <algorithm>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/flow/held/detail/contact_share.hpp"
#include "graze/flow/variation/detail/sprung_deviation.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

Vector spring_push(const System& system, const Motion<double>& motion, int without) {
  if (!motion.is_sprung()) return {};
  Vector push = Vector::Zero(system.modes());
  for (std::size_t i = 0; i < system.stops.size(); ++i)
    if (static_cast<int>(i) != without)
      push -= motion.spring_force(static_cast<int>(i)) * system.stops[i].row;
  return push;
}

// What rubs behind a spring and follows its place from the start on does so in deviated motions
// too.
CarriedDeviations::CarriedDeviations(const System& system, Motion<double>& motion,
                                     Deviations* deviations, ParameterDeviation* parameter)
    : system_(system), motion_(motion), deviations_(deviations), parameter_(parameter) {
  for (std::size_t k = 0; k < system.frictions.size() && deviations_; ++k)
    if (const int i = static_cast<int>(system.stops.size() + k); motion.follows(i)) follow(i);
}

std::vector<int> CarriedDeviations::closed_now() const {
  std::vector<int> closed;
  for (std::size_t i = 0; i < system_.stops.size(); ++i)
    if (motion_.is_closed(static_cast<int>(i))) closed.push_back(static_cast<int>(i));
  for (std::size_t k = 0; k < system_.frictions.size(); ++k)
    if (const int i = static_cast<int>(system_.stops.size() + k); motion_.is_closed(i))
      closed.push_back(i);
    else if (motion_.follows(i))
      closed.push_back(system_.index_of_following(i));
  return closed;
}

State CarriedDeviations::rate_now(const std::vector<int>& closed, int without) const {
  const std::vector<Contact>& all = motion_.state().contacts;
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(system_.stops.size());
  return rate_now(closed, {first, all.end()}, without);
}

State CarriedDeviations::rate_now(const std::vector<int>& closed,
                                  const std::vector<Contact>& frictions, int without) const {
  Vector push = spring_push(system_, motion_, without);
  if (const Vector rubs = friction_push(system_, frictions); rubs.size() > 0)
    push = push.size() > 0 ? Vector(push + rubs) : rubs;
  for (std::size_t k = 0; k < frictions.size(); ++k) {
    const Friction& friction = system_.frictions[k];
    if (friction.stop < 0 || friction.stop == without) continue;
    const double force = friction.sliding * motion_.spring_force(friction.stop);
    if (frictions[k] == Contact::kForward) push -= force * friction.row;
    if (frictions[k] == Contact::kBackward) push += force * friction.row;
  }
  return held_rate(system_, closed, state_now(), motion_.flow().phase(motion_.instant()), push);
}

State CarriedDeviations::rate_flown() const {
  const PhaseKey& key = motion_.flown().key();
  return rate_now(key.closed, key.frictions);
}

// Whether b.dq = 0 holds exactly there. On springs deviations are projected to the time of the
// undisturbed departure, where the deviated motion has not left yet, or is away already.
bool CarriedDeviations::departed_from(int i) const {
  return motion_.departure().contacts[static_cast<std::size_t>(i)] != Contact::kClear &&
         motion_.flown().springs().empty();
}

void CarriedDeviations::project_to_fixed_time(int without) {
  const State rate = rate_now(closed_now(), without);
  if (deviations_) move_instant(*deviations_, rate, -deviations_->delay);
  if (parameter_) parameter_->end(rate);
}

void CarriedDeviations::carry(const Arrival<double>& arrival) {
  const std::vector<int>& closed = motion_.flown().closed();
  if (parameter_) carry_parameter(arrival);
  if (!deviations_) return;
  const Deviations change = change_along(arrival.flight, closed);
  Eigen::RowVectorXd reach(deviations_->count());
  if (arrival.kind == ArrivalKind::kContact) {
    const Stop& s = stop(arrival.stop);
    reach = s.row.transpose() * change.q;
    // A flight that left this stop left it with b.dq = 0 exactly.
    if (!departed_from(arrival.stop)) reach += s.row.transpose() * deviations_->q;
  }
  deviations_->q += change.q;
  deviations_->qdot += change.qdot;
  if (arrival.kind == ArrivalKind::kContact) meet(arrival, reach, false);
  if (arrival.kind == ArrivalKind::kStandstill) stand(arrival.stop);
  if (arrival.kind == ArrivalKind::kSlip) slip(arrival.stop);
}

// To where the deviated motion stands still itself: b.dq' = 0.
void CarriedDeviations::stand(int i) {
  const Friction& friction = system_.friction(i);
  const State rate = rate_flown();
  move_instant(*deviations_, rate,
               -(friction.row.transpose() * deviations_->qdot) / friction.row.dot(rate.qdot));
  const Eigen::RowVectorXd left = friction.row.transpose() * deviations_->qdot;
  deviations_->qdot.noalias() -= friction.direction * left;
}

// Where the force is the same before and after, nothing jumps; behind a spring what rubs follows
// its place from there on. Else to where the deviated motion reaches the limit: the force is a
// share of the free acceleration.
void CarriedDeviations::slip(int i) {
  if (system_.friction(i).series) return follow(i);
  if (system_.friction(i).sliding == system_.friction(i).sticking) return;
  const ForceChange change = force_change(system_, motion_.flown().key(), i,
                                          motion_.flow().phase(motion_.instant()), rate_flown());
  const Eigen::RowVectorXd reach = change.by_q.transpose() * deviations_->q +
                                   change.by_qdot.transpose() * deviations_->qdot +
                                   change.by_delay * deviations_->delay;
  move_instant(*deviations_, rate_flown(), -reach / change.rate);
}

void CarriedDeviations::follow(int i) {
  const Friction::Series& spring = *system_.friction(i).series;
  deviations_->q -= spring.direction * (spring.row.transpose() * deviations_->q);
  deviations_->qdot -= spring.direction * (spring.row.transpose() * deviations_->qdot);
}

Deviations CarriedDeviations::change_along(double flight, const std::vector<int>& closed) {
  hold(system_, closed, *deviations_);
  const auto sticks = [this](int i) { return system_.is_friction(i); };
  if (std::any_of(closed.begin(), closed.end(), sticks))
    return held_growth(system_, motion_.flown().key(),
                       motion_.flow().phase(motion_.departure().instant), flight, *deviations_);
  const SpringArc* sprung = motion_.flown().sprung();
  if (!sprung || !motion_.flown().stepped())
    return growth(*motion_.flown().exact(), flight, *deviations_);
  const MotionState<double>& start = motion_.departure();
  const Deviations end =
      sprung_deviations(system_, *sprung, {start.q, start.qdot},
                        motion_.flow().phase(start.instant), flight, *deviations_);
  return {end.q - deviations_->q, end.qdot - deviations_->qdot, end.delay};
}

void CarriedDeviations::carry_parameter(const Arrival<double>& arrival) {
  const MotionState<double>& start = motion_.departure();
  const State from{start.q, start.qdot};
  const double theta = motion_.flow().phase(start.instant);
  if (motion_.flown().sprung())
    parameter_->carry_on_springs(motion_.flown(), from, theta, arrival.flight);
  else
    parameter_->carry(*motion_.flown().exact(), from, theta, arrival.flight);
  if (arrival.kind == ArrivalKind::kContact)
    parameter_->meet(arrival.stop, state_now(), rate_flown(), arrival.speed,
                     departed_from(arrival.stop));
  if (arrival.kind == ArrivalKind::kStandstill)
    parameter_->stand(arrival.stop, state_now(), rate_flown());
  if (arrival.kind == ArrivalKind::kSlip)
    parameter_->slip(motion_.flown().key(), arrival.stop, arrival.forward, state_now(),
                     motion_.flow().phase(motion_.instant()), rate_flown());
}

void CarriedDeviations::meet(const Arrival<double>& arrival, const Eigen::RowVectorXd& reach,
                             bool at_once) {
  const Stop& s = stop(arrival.stop);
  move_instant(*deviations_, at_once ? rate_now(closed_now()) : rate_flown(),
               -reach / arrival.speed);
  const Eigen::RowVectorXd left = s.row.transpose() * deviations_->q / s.row.squaredNorm();
  deviations_->q.noalias() -= s.row * left;
}

void CarriedDeviations::meet_at_once(const Arrival<double>& arrival) {
  if (!any()) return;
  if (deviations_) meet(arrival, stop(arrival.stop).row.transpose() * deviations_->q, true);
  if (parameter_)
    parameter_->meet_at_once(arrival.stop, state_now(), rate_now(closed_now()), arrival.speed);
}

// The derivative of q'+ = q'- - D (B^T D)^-1 (v- - target) over the stops that act.
void CarriedDeviations::jump(const std::vector<ImpactShare<double>>& shares,
                             const Vector& qdot_before) {
  if (parameter_) {
    parameter_->jump(shares, qdot_before);
    Vector qdot = qdot_before;
    for (const ImpactShare<double>& share : shares)
      qdot -= share.impulse * stop(share.stop).direction();
    for (const int i : closed_now())
      if (system_.is_friction(i) && system_.friction(i).series) parameter_->hold_speed(i, qdot);
  }
  if (!deviations_) return;
  std::vector<int> acting;
  Vector slopes(static_cast<Eigen::Index>(shares.size()));
  for (const ImpactShare<double>& share : shares) {
    if (!(share.impulse > 0.0)) continue;
    // A closed stop absorbs what comes; so does one that leaves no room for a rebound.
    slopes[static_cast<Eigen::Index>(acting.size())] =
        share.speed_after < 0.0 ? stop(share.stop).restitution().jump_slope(share.speed) : 1.0;
    acting.push_back(share.stop);
  }
  undo(acting, slopes.head(static_cast<Eigen::Index>(acting.size())), deviations_->qdot);
}

void CarriedDeviations::close(const std::vector<int>& stops, const State& before) {
  if (deviations_) {
    const Vector all = Vector::Ones(static_cast<Eigen::Index>(stops.size()));
    undo(stops, all, deviations_->q);
    undo(stops, all, deviations_->qdot);
  }
  if (parameter_) parameter_->close(stops, before);
}

// Removes these parts from the deviations along the rows of the stops, by impulses along the stops'
// directions.
void CarriedDeviations::undo(const std::vector<int>& stops, const Vector& parts,
                             Matrix& columns) const {
  if (columns.cols() == 0) return;
  if (stops.size() == 1) {
    const Stop& s = stop(stops.front());
    const double part = parts[0] / s.row.dot(s.direction());
    const Eigen::RowVectorXd undone = part * (s.row.transpose() * columns);
    columns.noalias() -= s.direction() * undone;
    return;
  }
  const Matrix rows = rows_of(system_, stops), directions = directions_of(system_, stops);
  const Matrix undone = parts.asDiagonal() * (rows.transpose() * columns);
  columns -= directions * LuFactors(rows.transpose() * directions).solve_columns(undone);
}

void CarriedDeviations::cross_surface(int i, double sign) {
  const Stop& s = stop(i);
  const double resistance = sign * s.force().jump_at_surface(sign > 0.0);
  if (resistance == 0.0 || !any()) return;
  project_to_fixed_time(i);
  const Vector change = resistance * held(system_, closed_now(), s.row);
  if (deviations_) deviations_->qdot -= change * (s.row.transpose() * deviations_->q);
  if (parameter_) parameter_->cross(i, state_now(), change);
}

double CarriedDeviations::gap_rate(const SegmentDirection& along, int i, double s) const {
  const MotionState<double>& departure = motion_.departure();
  Deviations one{deviations_->q * along.deviations, deviations_->qdot * along.deviations,
                 deviations_->delay * along.deviations};
  hold(system_, motion_.flown().closed(), one);
  ParameterDeviation by_parameter = *parameter_;
  const ExactPhase<double>& phase = *motion_.flown().exact();
  by_parameter.carry(phase, {departure.q, departure.qdot}, motion_.flow().phase(departure.instant),
                     s);
  const Vector q = one.q + growth(phase, s, one).q + along.parameter * by_parameter.value().q;
  State there{Vector(system_.modes()), Vector(system_.modes())};
  phase.state(s, there.q, there.qdot);
  const Stop& rate = along.tangent->stops[static_cast<std::size_t>(i)];
  return along.parameter * (rate.gap - rate.row.dot(there.q)) - stop(i).row.dot(q);
}

double CarriedDeviations::speed_rate(const SegmentDirection& along, int i,
                                     const State& before) const {
  const Stop& rate = along.tangent->stops[static_cast<std::size_t>(i)];
  return stop(i).row.dot(deviations_->qdot * along.deviations) +
         along.parameter * (stop(i).row.dot(parameter_->value().qdot) + rate.row.dot(before.qdot));
}

}  // namespace graze
