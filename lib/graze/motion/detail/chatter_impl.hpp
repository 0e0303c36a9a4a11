// Definitions of motion.hpp: chatter that completes, on one stop or on several that share it.
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/contact/detail/complementarity.hpp"
#include "graze/flow/exact/detail/first_zero.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/motion/detail/shared_chatter.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {

template <class Real>
std::optional<ClosedChatter<Real>> Motion<Real>::close_chatter(
    const std::vector<ImpactShare<Real>>& shares, const Real& closure_speed) {
  const ImpactShare<Real>* fastest = nullptr;
  int hits = 0;
  for (const ImpactShare<Real>& share : shares) {
    if (!share.hit) continue;
    ++hits;
    if (!fastest || share.speed > fastest->speed) fastest = &share;
  }
  if (!fastest || is_sprung()) return {};
  const bool may_be_slow = fastest->speed <= closure_speed || may_be_unresolved(fastest->speed);
  const Real speed = may_be_slow ? std::max<Real>(closure_speed, resolved_speed()) : closure_speed;
  if (!(fastest->speed <= speed)) {
    now_.unsummed = 0;
    return {};
  }
  const RealVector<Real> q = now_.q, qdot = now_.qdot;
  auto closed = close_shared(speed);
  if (!closed && hits == 1 && fastest->speed <= closure_speed)
    closed = close_chatter(fastest->stop, stop(fastest->stop).restitution().at(fastest->speed));
  if (!closed) return {};
  closed->q_before = q;
  closed->qdot_before = qdot;
  return closed;
}

template <class Real>
std::optional<ClosedChatter<Real>> Motion<Real>::close_chatter(int i, const Real& restitution) {
  using std::abs;
  const Real leaving = -approach_speed(i);
  if (!(restitution < 1) || !(stop(i).restitution().at_rest() < 1) || !(leaving > 0)) return {};
  for (const int j : order_)
    if (j != i && contact(j) != Contact::kClear && contact(j) != Contact::kClosed && !is_leaving(j))
      return {};
  const CurvePoint<Real> now = start_phase().gap_rate(i, 2);
  const Real push = -now.value;
  if (!(push > now.noise)) return {};
  const Real duration = 2 * leaving / (push * (1 - restitution));
  // On a rotating hub only the present rate of the push is known.
  const CurvePoint<Real> ahead = phase_->sees_ahead() ? phase_->outlook(i, 2, duration) : now;
  if (!(duration * (abs(ahead.slope) + ahead.bound * duration) <= push / 2)) return {};
  if (!is_quiet(*phase_, {i}, duration)) return {};
  if (has_friction() && !turns_on(duration)) return {};
  // The sum of the tail's impulses: the push that the closed stop would have taken meanwhile, less
  // the speed at which the structure leaves.
  std::vector<int> stops = closed();
  stops.push_back(i);
  const RealVector<Real> before = std::exchange(now_.qdot, at_rest_on(stops).second);
  const auto turned_back = [&](int j) { return is_touched(j) && j != i && !is_leaving(j); };
  if (std::any_of(order_.begin(), order_.end(), turned_back)) {
    now_.qdot = before;
    return {};
  }
  look_at_joint();
  return settled(stops, duration);
}

// Whether the structure touches the stop and is not held there.
template <class Real>
bool Motion<Real>::is_touched(int i) const {
  return contact(i) == Contact::kTouching || contact(i) == Contact::kDeparting;
}

// Whether it leaves a touched stop at a speed that is not rounding.
template <class Real>
bool Motion<Real>::is_leaving(int i) const {
  return is_touched(i) && approach_speed(i) < -speed_rounding(i);
}

// Whether only the chatter happens for so long: no other stop is met, and no closed one released.
template <class Real>
bool Motion<Real>::is_quiet(const ContactPhase<Real>& phase, const std::vector<int>& chattering,
                            const Real& duration) {
  using std::abs;
  // Friction that reverses with each impact is followed.
  for (const int j : frictions_)
    if (contact(j) == Contact::kTouching ||
        (contact(j) != Contact::kClear && !phase.stays_quiet(j, duration)))
      return false;
  for (const int j : order_) {
    if (std::find(chattering.begin(), chattering.end(), j) != chattering.end()) continue;
    if (is_touched(j)) {
      // The stop is being left, and is not met again if its gap keeps rising all the time.
      if (!phase.sees_ahead()) return false;
      const CurvePoint<Real> rate = phase.outlook(j, 1, duration);
      if (!(rate.value - rate.noise > duration * (abs(rate.slope) + rate.bound * duration)))
        return false;
      continue;
    }
    if (!(phase.sees_ahead() ? phase.stays_quiet(j, duration) : is_quiet_meanwhile(j, duration)))
      return false;
  }
  return true;
}

// The same for one stop on a rotating hub, from twice the present change of its gap or force.
template <class Real>
bool Motion<Real>::is_quiet_meanwhile(int j, const Real& duration) {
  using std::abs;
  if (contact(j) == Contact::kClosed) return force(j) > 2 * duration * abs(phase_->force_rate(j));
  return gap(j) > 2 * duration * (abs(approach_speed(j)) + duration * abs(free_push(j)));
}

// Whether a hub with friction keeps its direction of rotation for so long, impacts or not.
template <class Real>
bool Motion<Real>::turns_on(const Real& duration) const {
  using std::abs;
  return abs(hub_rate(now_.qdot)) > 2 * duration * abs(hub_rate(free_acceleration()));
}

// Whether resolved_speed() may be that large, judged by the sizes of its terms, since with many
// stops it costs a loop over the modes for each. A factor of two covers the rounding of the sizes.
template <class Real>
bool Motion<Real>::may_be_unresolved(const Real& speed) const {
  using std::abs;
  using std::sqrt;
  if (order_.size() < 2) return false;
  if (turning_) return true;
  // Only called when no spring is compressed.
  const Real cosine = forcing_cosine(), shape = now_.q.norm();
  Real square = 0;
  for (Eigen::Index j = 0; j < now_.q.size(); ++j) {
    const Real acceleration = free_acceleration(j, cosine, nullptr);
    square += acceleration * acceleration;
  }
  const Real push = sqrt(square);
  const Real eps = Real(static_cast<int>(now_.q.size()) + 2) * std::numeric_limits<Real>::epsilon();
  for (const int i : order_) {
    const Real norm = stop(i).norm, rounding = eps * (abs(stop(i).gap) + norm * shape);
    if (speed * speed <= 4 * norm * push * rounding) return true;
  }
  return false;
}

// A speed below which falls onto a stop are within the rounding of its gap, like rest on it.
template <class Real>
Real Motion<Real>::resolved_speed() const {
  using std::sqrt;
  if (order_.size() < 2) return 0;
  Real square = 0;
  for (const int i : order_) {
    const Real push = free_push(i);
    const Real rounding = gap_value(stop(i).row, now_.q, stop(i).gap).rounding;
    square = std::max<Real>(square, 2 * push * rounding);
  }
  return sqrt(square);
}

// The stops on which the structure would be at rest: those touched, and those within the height of
// fall that gives the closure speed. Empty where not all touched ones would press.
template <class Real>
std::vector<int> Motion<Real>::chattering_together(const Real& closure_speed) const {
  RealVector<Real> size;
  const RealVector<Real> acceleration = free_acceleration(&size);
  Real most = 0;
  for (const int i : order_) most = std::max<Real>(most, stop(i).row.dot(acceleration));
  std::vector<int> near;
  std::vector<Real> pushes, roundings;
  for (const int i : order_) {
    if (contact(i) == Contact::kClear && !(2 * most * gap(i) <= closure_speed * closure_speed))
      continue;
    // The structure leaves this stop for longer than the tail lasts.
    if (is_touched(i) && approach_speed(i) < -closure_speed) continue;
    if (!(stop(i).restitution().at_rest() < 1)) return {};
    near.push_back(i);
    pushes.push_back(stop(i).row.dot(acceleration));
    roundings.push_back(push_rounding(i, size));
  }
  const auto k = static_cast<Eigen::Index>(near.size());
  if (k < 2) return {};
  const RealVector<Real> push = RealVector<Real>::Map(pushes.data(), k);
  const RealVector<Real> rounding = RealVector<Real>::Map(roundings.data(), k);
  const Matrix_ shares = delassus(near);
  const std::optional<RealVector<Real>> forces = solve_contacts(shares, push, rounding);
  if (!forces) return {};
  std::vector<int> pressed;
  for (Eigen::Index a = 0; a < k; ++a) {
    const int i = near[static_cast<std::size_t>(a)];
    if ((*forces)[a] * shares(a, a) > rounding[a])
      pressed.push_back(i);
    else if (contact(i) != Contact::kClear)
      return {};
  }
  return pressed.size() < 2 ? std::vector<int>() : pressed;
}

// While the pushes hardly change, the tail is that of a structure under constant pushes and contact
// forces alone: it is followed as such, on its own scale. The motion after it follows from the sum
// of its impulses and their first moment: those that the stops would have given had they held the
// structure from now on, and those that bring it to rest on them now.
template <class Real>
std::optional<ClosedChatter<Real>> Motion<Real>::close_shared(const Real& closure_speed) {
  using std::abs;
  if (turning_) return {};  // no curve of it is known ahead
  const auto sticks = [this](int i) { return contact(i) == Contact::kClosed; };
  if (std::any_of(frictions_.begin(), frictions_.end(), sticks)) return {};
  const std::vector<int> stops = chattering_together(closure_speed);
  if (stops.empty()) return {};
  ContactPhase<Real>& held = phase_of(stops);
  if (!held.refusal().empty()) return {};
  const auto k = static_cast<Eigen::Index>(stops.size());
  const auto n = now_.q.size();
  SharedChatter chatter{Matrix(n, k), Matrix(n, k), Vector(k), Vector(k), Vector(k), {}};
  RealVector<Real> size;
  const RealVector<Real> acceleration = free_acceleration(&size);
  for (Eigen::Index a = 0; a < k; ++a) {
    const int i = stops[static_cast<std::size_t>(a)];
    const bool apart = contact(i) == Contact::kClear;
    chatter.rows.col(a) = stop(i).row.template cast<double>();
    chatter.directions.col(a) = stop(i).direction.template cast<double>();
    chatter.gaps[a] = apart ? static_cast<double>(gap(i)) : 0.0;
    chatter.speeds[a] = is_held(i) ? 0.0 : static_cast<double>(approach_speed(i));
    chatter.pushes[a] = static_cast<double>(stop(i).row.dot(acceleration));
    chatter.restitutions.push_back(stop(i).restitution());
  }
  // Following the tail costs as much as a thousand impacts.
  const Real left = Real(speed_left(chatter));
  std::optional<double> found;
  if (!(now_.unsummed > 0 && 2 * left > now_.unsummed)) {
    now_.unsummed = left;
    found = time_to_rest(chatter, static_cast<double>(closure_speed));
  }
  // A tail that does not differ from rest within rounding is over at once.
  if (!found && left <= resolved_speed()) found = 0.0;
  if (!found) return {};
  const Real duration = Real(*found);
  const auto [q, qdot] = at_rest_on(stops);
  held.start(clock_.phase(now_.instant), q, qdot);
  for (const int i : stops) {
    const CurvePoint<Real> force = held.outlook(i, 0, duration);
    if (!(force.value > force.noise &&
          duration * (abs(force.slope) + force.bound * duration) <= force.value / 2))
      return {};
  }
  if (!is_quiet(held, stops, duration)) return {};
  now_.q = q;
  now_.qdot = qdot;
  now_.unsummed = 0;
  return settled(stops, duration);
}

template <class Real>
bool Motion<Real>::rest_together(const Real& speed) {
  using std::abs;
  const std::vector<int> stops = chattering_together(speed);
  if (stops.empty()) return false;
  for (const int i : stops)
    if (!is_held(i) && !(abs(approach_speed(i)) <= speed)) return false;
  std::tie(now_.q, now_.qdot) = at_rest_on(stops);
  settled(stops, Real(0));
  return true;
}

// Velocities, and positions where a stop is still to be reached, after the impulses that put the
// structure to rest on these stops.
template <class Real>
std::pair<RealVector<Real>, RealVector<Real>> Motion<Real>::at_rest_on(
    const std::vector<int>& stops) const {
  RealVector<Real> q = now_.q, qdot = now_.qdot;
  const auto k = static_cast<Eigen::Index>(stops.size());
  const PivotedLu<Real> factors(delassus(stops));
  RealVector<Real> amounts(k);
  const auto shift = [&](RealVector<Real>& vector) {
    amounts = factors.solve(amounts);
    for (Eigen::Index a = 0; a < k; ++a)
      vector -= amounts[a] * stop(stops[static_cast<std::size_t>(a)]).direction;
  };
  for (Eigen::Index a = 0; a < k; ++a) {
    const int i = stops[static_cast<std::size_t>(a)];
    amounts[a] = contact(i) == Contact::kClear ? Real(-gap(i)) : Real(0);
  }
  if (!amounts.isZero(0)) shift(q);
  // Two passes: row.direction = 1 holds only to rounding.
  for (int pass = 0; pass < 2; ++pass) {
    for (Eigen::Index a = 0; a < k; ++a)
      amounts[a] = stop(stops[static_cast<std::size_t>(a)]).row.dot(qdot);
    shift(qdot);
  }
  return {q, qdot};
}

// Records that the structure has been put to rest on these stops.
template <class Real>
ClosedChatter<Real> Motion<Real>::settled(const std::vector<int>& stops, const Real& duration) {
  ClosedChatter<Real> closed{{}, stops, duration};
  for (const int i : stops) {
    if (contact(i) == Contact::kClosed) continue;
    closed.stops.push_back(i);
    set(i, Contact::kTouching);
  }
  judge_again(Jumped::kVelocities);
  std::sort(closed.stops.begin(), closed.stops.end());
  return closed;
}

}  // namespace graze
