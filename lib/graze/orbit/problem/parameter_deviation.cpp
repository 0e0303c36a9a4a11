#include "graze/orbit/problem/detail/parameter_deviation.hpp"

#include <algorithm>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/flow/detail/phase_choice.hpp"
#include "graze/flow/held/detail/contact_share.hpp"
#include "graze/flow/variation/detail/sprung_deviation.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

ParameterDeviation::ParameterDeviation(const System& system, const System& tangent,
                                       const State& start)
    : system_(&system),
      tangent_(&tangent),
      column_{start.q, start.qdot, Eigen::RowVectorXd::Zero(1)} {}

void ParameterDeviation::carry(const ExactPhase<double>& phase, const State& start, double theta,
                               double s) {
  hold(*system_, *tangent_, phase.closed(), start, column_);
  const PhaseKey& key = phase.key();
  ParameterGrowth growth =
      key.frictions.empty() ? parameter_growth(*system_, *tangent_, phase, start, theta, s, column_)
                            : parameter_growth(under_friction(*system_, key),
                                               under_friction_rate(*system_, *tangent_, key), phase,
                                               start, theta, s, column_);
  column_.q += growth.change.q;
  column_.qdot += growth.change.qdot;
  last_ = std::move(growth.change);
  moved_ = std::move(growth.moved);
}

void ParameterDeviation::carry_on_springs(const ContactPhase<double>& phase, const State& start,
                                          double theta, double s) {
  hold(*system_, *tangent_, phase.closed(), start, column_);
  const PhaseKey& key = phase.key();
  Deviations end = key.frictions.empty()
                       ? sprung_parameter_deviation(*system_, *tangent_, *phase.sprung(), start,
                                                    theta, s, column_)
                       : sprung_parameter_deviation(under_friction(*system_, key),
                                                    under_friction_rate(*system_, *tangent_, key),
                                                    *phase.sprung(), start, theta, s, column_);
  last_ = {end.q - column_.q, end.qdot - column_.qdot, column_.delay};
  State there{Vector(start.q.size()), Vector(start.q.size())};
  phase.state(s, there.q, there.qdot);
  moved_ = there.q - start.q;
  column_ = std::move(end);
}

void ParameterDeviation::cross(int i, const State& at, const Vector& change) {
  const double reach =
      stop(i).row.dot(column_.q.col(0)) + stop_rate(i).row.dot(at.q) - stop_rate(i).gap;
  column_.qdot.col(0) -= reach * change;
}

void ParameterDeviation::meet(int i, const State& at, const State& rate, double v, bool departed) {
  if (!departed) return meet_at_once(i, at, rate, v);
  // It left the stop with b.dq + db.q = da exactly.
  const double reach = stop(i).row.dot(last_.q.col(0)) + stop_rate(i).row.dot(moved_);
  move_to(i, at, rate, -reach / v);
}

void ParameterDeviation::meet_at_once(int i, const State& at, const State& rate, double v) {
  const double reach =
      stop(i).row.dot(column_.q.col(0)) + stop_rate(i).row.dot(at.q) - stop_rate(i).gap;
  move_to(i, at, rate, -reach / v);
}

void ParameterDeviation::move_to(int i, const State& at, const State& rate, double shift) {
  move_instant(column_, rate, Eigen::RowVectorXd::Constant(1, shift));
  const Stop& s = stop(i);
  const double beyond = s.row.dot(column_.q.col(0)) + stop_rate(i).row.dot(at.q) - stop_rate(i).gap;
  column_.q.col(0) -= s.row * (beyond / s.row.squaredNorm());
}

void ParameterDeviation::stand(int i, const State& at, const State& rate) {
  const Friction &friction = system_->friction(i), &moved = tangent_->friction(i);
  const auto speed = [&] {
    return friction.row.dot(column_.qdot.col(0)) + moved.row.dot(at.qdot) - moved.speed;
  };
  move_instant(column_, rate,
               Eigen::RowVectorXd::Constant(1, -speed() / friction.row.dot(rate.qdot)));
  column_.qdot.col(0) -= friction.direction * speed();
}

void ParameterDeviation::slip(const PhaseKey& key, int i, bool forward, const State& at,
                              double theta, const State& rate) {
  if (system_->friction(i).series) {
    // What rubs had no speed before.
    const Friction& rubs = system_->friction(i);
    return follow(i, forward, {at.q, at.qdot + rubs.series->direction * rubs.row.dot(at.qdot)});
  }
  const Friction &friction = system_->friction(i), &moved = tangent_->friction(i);
  if (friction.sliding == friction.sticking) return;
  const System loaded = under_friction(*system_, key),
               tangent = under_friction_rate(*system_, *tangent_, key);
  const ForceChange change = force_change(*system_, key, i, theta, rate);
  // Of the force by the parameter itself: lambda = share.(free acceleration)/(b.b).
  const auto place = std::find(key.closed.begin(), key.closed.end(), i) - key.closed.begin();
  const Vector share = contact_share(*system_, key.closed).row(place);
  const Vector share_rate = contact_share_rate(*system_, *tangent_, key.closed).row(place);
  const Vector free = vector_field(loaded, at, theta).qdot;
  Vector free_rate = -tangent.resistance(at.qdot) -
                     2.0 * system_->omega.cwiseProduct(tangent.omega).cwiseProduct(at.q);
  if (tangent.forcing()) free_rate += tangent.forcing()->at(theta);
  if (tangent.load()) free_rate += *tangent.load();
  const double square = friction.row.squaredNorm(), force = share.dot(free) / square;
  const double by_parameter = (share_rate.dot(free) + share.dot(free_rate)) / square -
                              2.0 * force * friction.row.dot(moved.row) / square;
  const double reach = change.by_q.dot(column_.q.col(0)) + change.by_qdot.dot(column_.qdot.col(0)) +
                       change.by_delay * column_.delay[0] + by_parameter -
                       (forward ? moved.sticking : -moved.sticking);
  move_instant(column_, rate, Eigen::RowVectorXd::Constant(1, -reach / change.rate));
}

void ParameterDeviation::begin(const State& given, const MotionState<double>& start) {
  for (std::size_t k = 0; k < system_->frictions.size(); ++k) {
    const int i = static_cast<int>(system_->stops.size() + k);
    if (!system_->frictions[k].series) continue;
    const Contact contact = start.contacts[static_cast<std::size_t>(i)];
    if (contact == Contact::kClosed)
      hold_speed(i, given.qdot);
    else
      follow(i, contact == Contact::kForward, given);
  }
}

// What rubs behind a spring is as far from its place from here on as the force tells, and as fast:
// q+ = q - d (b.q - x). `at`: the state before.
void ParameterDeviation::follow(int i, bool forward, const State& at) {
  const Friction &friction = system_->friction(i), &moved = tangent_->friction(i);
  const Friction::Series &spring = *friction.series, &rate = *moved.series;
  const double length = (forward ? 1.0 : -1.0) * friction.sliding / spring.stiffness;
  const double length_rate = (forward ? 1.0 : -1.0) / spring.stiffness *
                             (moved.sliding - friction.sliding * rate.stiffness / spring.stiffness);
  column_.q.col(0) -=
      spring.direction * (spring.row.dot(column_.q.col(0)) + rate.row.dot(at.q) - length_rate) +
      rate.direction * (spring.row.dot(at.q) - length);
  hold_speed(system_->index_of_following(i), at.qdot);
}

// q'+ = q' - d b.q' of what is held from here on.
void ParameterDeviation::hold_speed(int i, const Vector& qdot) {
  const Vector& row = system_->row(i);
  column_.qdot.col(0) -=
      system_->direction(i) * (row.dot(column_.qdot.col(0)) + tangent_->row(i).dot(qdot)) +
      tangent_->direction(i) * row.dot(qdot);
}

ParameterDeviation::Acting ParameterDeviation::acting(const std::vector<int>& stops) const {
  const Matrix rows = rows_of(*system_, stops), directions = directions_of(*system_, stops);
  const Matrix rows_rate = rows_of(*tangent_, stops),
               directions_rate = directions_of(*tangent_, stops);
  return {rows, directions, rows_rate, directions_rate,
          rows_rate.transpose() * directions + rows.transpose() * directions_rate};
}

// Derivative of D p with (B^T D) p = amount, where `rate` is that of amount.
Vector ParameterDeviation::Acting::change(const Vector& p, const Vector& rate) const {
  const Vector p_rate = LuFactors(rows.transpose() * directions).solve(rate - coupling_rate * p);
  return directions_rate * p + directions * p_rate;
}

// q'+ = q'- - D p,   p = (B^T D)^-1 (B^T q'- - target),   over the stops that act; the target is
// -r(v) v where the impact rebounds, 0 where a stop is closed or leaves no room for a rebound.
void ParameterDeviation::jump(const std::vector<ImpactShare<double>>& shares,
                              const Vector& qdot_before) {
  std::vector<int> stops;
  std::vector<double> impulses, rates;
  for (const ImpactShare<double>& share : shares) {
    if (!(share.impulse > 0.0)) continue;
    const Stop &s = stop(share.stop), &rate = stop_rate(share.stop);
    const double speed_rate = s.row.dot(column_.qdot.col(0)) + rate.row.dot(qdot_before);
    const bool rebounds = share.speed_after < 0.0;
    stops.push_back(share.stop);
    impulses.push_back(share.impulse);
    rates.push_back(rebounds ? s.restitution().jump_slope(share.speed) * speed_rate +
                                   s.restitution().jump_rate(share.speed, rate.restitution())
                             : speed_rate);
  }
  if (stops.empty()) return;
  const auto k = static_cast<Eigen::Index>(stops.size());
  column_.qdot.col(0) -=
      acting(stops).change(Vector::Map(impulses.data(), k), Vector::Map(rates.data(), k));
}

// Speeds and open gaps are closed along the directions of the impulses.
void ParameterDeviation::close(const std::vector<int>& stops, const State& before) {
  const Acting at = acting(stops);
  Vector gaps(static_cast<Eigen::Index>(stops.size())), gaps_rate(gaps.size());
  for (std::size_t a = 0; a < stops.size(); ++a) {
    gaps[static_cast<Eigen::Index>(a)] = stop(stops[a]).gap;
    gaps_rate[static_cast<Eigen::Index>(a)] = stop_rate(stops[a]).gap;
  }
  const auto undo = [&](Eigen::Ref<Vector> column, const Vector& value, const Vector& offset,
                        const Vector& offset_rate) {
    const Vector amount = at.rows.transpose() * value - offset;
    const Vector rate =
        at.rows.transpose() * column + at.rows_rate.transpose() * value - offset_rate;
    column -= at.change(LuFactors(at.rows.transpose() * at.directions).solve(amount), rate);
  };
  undo(column_.q.col(0), before.q, gaps, gaps_rate);
  const Vector none = Vector::Zero(gaps.size());
  undo(column_.qdot.col(0), before.qdot, none, none);
}

void ParameterDeviation::end(const State& rate) { move_instant(column_, rate, -column_.delay); }

}  // namespace graze
