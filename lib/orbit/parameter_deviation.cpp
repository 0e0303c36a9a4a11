#include "graze/orbit/parameter_deviation.hpp"

#include <Eigen/LU>

#include "graze/orbit/shooting.hpp"

namespace graze {

ParameterDeviation::ParameterDeviation(const System& system, const System& tangent,
                                       const State& start)
    : system_(&system),
      tangent_(&tangent),
      column_{start.q, start.qdot, Eigen::RowVectorXd::Zero(1)} {}

void ParameterDeviation::carry(const ContactPhase<double>& phase, const State& start, double theta,
                               double s) {
  hold(*system_, *tangent_, phase.closed(), start, column_);
  ParameterGrowth growth = parameter_growth(*system_, *tangent_, phase, start, theta, s, column_);
  column_.q += growth.change.q;
  column_.qdot += growth.change.qdot;
  last_ = std::move(growth.change);
  moved_ = std::move(growth.moved);
}

void ParameterDeviation::meet(int i, const State& at, const State& rate, double v, bool departed) {
  if (!departed) return meet_at_once(i, at, rate, v);
  // It left with b.dq + db.q = da, as an identity.
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
  const RigidStop& s = stop(i);
  const double beyond = s.row.dot(column_.q.col(0)) + stop_rate(i).row.dot(at.q) - stop_rate(i).gap;
  column_.q.col(0) -= s.row * (beyond / s.row.squaredNorm());
}

// q'+ = q'- - D p,   p = (B^T D)^-1 (B^T q'- - target),   over the stops that act; the target is
// -r(v) v where the impact rebounds, 0 where a stop is closed or leaves no room for a rebound.
void ParameterDeviation::jump(const std::vector<ImpactShare<double>>& shares,
                              const Vector& qdot_before) {
  std::vector<const ImpactShare<double>*> acting;
  for (const ImpactShare<double>& share : shares)
    if (share.impulse > 0.0) acting.push_back(&share);
  const auto k = static_cast<Eigen::Index>(acting.size());
  if (k == 0) return;
  const Eigen::Index n = qdot_before.size();
  Matrix rows(n, k), directions(n, k), rows_rate(n, k), directions_rate(n, k);
  Vector impulses(k), change(k);
  for (Eigen::Index a = 0; a < k; ++a) {
    const ImpactShare<double>& share = *acting[static_cast<std::size_t>(a)];
    const RigidStop &s = stop(share.stop), &rate = stop_rate(share.stop);
    rows.col(a) = s.row;
    directions.col(a) = s.direction;
    rows_rate.col(a) = rate.row;
    directions_rate.col(a) = rate.direction;
    impulses[a] = share.impulse;
    const bool rebounds = share.speed_after < 0.0;
    const double speed_rate = s.row.dot(column_.qdot.col(0)) + rate.row.dot(qdot_before);
    change[a] = rebounds ? jump_slope(s, share.speed) * speed_rate +
                               s.restitution.rate_at(share.speed, rate.restitution) * share.speed
                         : speed_rate;
  }
  const Matrix acting_rate =
      rows_rate.transpose() * directions + rows.transpose() * directions_rate;
  const Vector impulses_rate =
      (rows.transpose() * directions).partialPivLu().solve(change - acting_rate * impulses);
  column_.qdot.col(0) -= directions_rate * impulses + directions * impulses_rate;
}

void ParameterDeviation::close(int i, const Vector& qdot_before) {
  const RigidStop &s = stop(i), &rate = stop_rate(i);
  const double speed_rate = s.row.dot(column_.qdot.col(0)) + rate.row.dot(qdot_before);
  column_.qdot.col(0) -= s.direction * speed_rate + rate.direction * s.row.dot(qdot_before);
}

void ParameterDeviation::end(const State& rate) { move_instant(column_, rate, -column_.delay); }

}  // namespace graze
