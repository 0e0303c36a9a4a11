// Definitions of motion.hpp: dry friction.
//
//   forward, backward: it slides, against the whole of its force, until its speed is zero;
//   closed: it sticks, while what the structure exerts on it is no more than its limit;
//   locked: closed stops keep the structure at rest there, and it exerts nothing.
//
// Where it comes to rest, the forces of all friction at rest and of all stops that are pressed are
// shared by complementarity: |R| <= limit, and what is at its limit is accelerated against it. An
// impulse is over before friction can act: an impact moves what sticks.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "graze/contact/detail/complementarity.hpp"
#include "graze/motion/detail/motion.hpp"

namespace graze {

template <class Real>
void Motion<Real>::adopt_frictions() {
  for (const Friction& friction : system_.frictions) {
    frictions_.push_back(static_cast<int>(stops_.size()));
    const RealVector<Real> row = friction.row.template cast<Real>();
    stops_.push_back({row, friction.direction.template cast<Real>(), Real(0), row.norm(),
                      row.squaredNorm(), nullptr, Real(friction.speed)});
    on_belts_ = on_belts_ || friction.speed != 0.0;
  }
  watched_ = looked_at_;
  watched_.insert(watched_.end(), frictions_.begin(), frictions_.end());
}

// What sticks to belts is carried along for a time that counts from one instant for all of it.
template <class Real>
void Motion<Real>::renew_places() {
  for (const int i : frictions_)
    if (contact(i) == Contact::kClosed && stop(i).belt != 0)
      now_.places[place(i)] = static_cast<double>(stop(i).row.dot(now_.q));
}

// The force of what slides.
template <class Real>
void Motion<Real>::note_rubbing() {
  rubbing_ = RealVector<Real>::Zero(now_.q.size());
  for (const int i : frictions_) {
    const Real force = Real(system_.friction(i).sliding);
    if (contact(i) == Contact::kForward) rubbing_ -= force * stop(i).row;
    if (contact(i) == Contact::kBackward) rubbing_ += force * stop(i).row;
  }
  phase_ = nullptr;
}

template <class Real>
void Motion<Real>::slide(int i, bool forward, int multiplicity) {
  set(i, forward ? Contact::kForward : Contact::kBackward, multiplicity);
  note_rubbing();
}

// Bound on the rounding of a speed of sliding, also by that of the instant, m/s.
template <class Real>
Real Motion<Real>::sliding_rounding(int i) const {
  using std::abs;
  const Real eps = std::numeric_limits<Real>::epsilon();
  const Real push = turning_ ? Real(0) : abs(free_push(i));
  return speed_rounding(i) + eps * (abs(stop(i).belt) + now_.instant.local * push);
}

// After velocities, or forces, have jumped.
template <class Real>
void Motion<Real>::judge_frictions(Jumped what) {
  for (const int i : frictions_) {
    const Contact before = contact(i);
    const Real speed = approach_speed(i);
    if (what == Jumped::kVelocities && std::abs(static_cast<double>(speed)) >
                                           static_cast<double>(sliding_rounding(i))) {
      const Contact now = speed > 0 ? Contact::kForward : Contact::kBackward;
      if (now != before) {
        if (before == Contact::kClosed)
          changes_.push_back({ArrivalKind::kSlip, i});
        else if (before == Contact::kForward || before == Contact::kBackward)
          changes_.push_back({ArrivalKind::kReversal, i});
      }
      slide(i, speed > 0, 0);
    } else if (before == Contact::kClosed) {
      undecided_ = recheck_ = true;
    } else if (before == Contact::kLocked || what == Jumped::kVelocities) {
      stand(i);
    }
  }
}

// At rest, and to be decided; remembers where it came from.
template <class Real>
void Motion<Real>::stand(int i) {
  const Contact before = contact(i);
  if (before == Contact::kTouching) return;
  set(i, Contact::kTouching,
      before == Contact::kForward    ? kCameForward
      : before == Contact::kBackward ? kCameBackward
                                     : 0);
  recheck_ = true;
  note_rubbing();
}

// What closed stops kept at rest is free to move when one of them is left.
template <class Real>
void Motion<Real>::unlock_frictions() {
  for (const int i : frictions_)
    if (contact(i) == Contact::kLocked) stand(i);
}

// Where it stands still; others that stand still at the same instant, within rounding, with it.
template <class Real>
void Motion<Real>::arrive_at_standstill(int i, bool at_once) {
  using std::abs;
  // Back at once from a speed that rounding hides: it has not left.
  if (at_once && multiplicity(i) > 0) {
    stick(i);
    return;
  }
  stand(i);
  for (const int k : frictions_)
    if ((contact(k) == Contact::kForward || contact(k) == Contact::kBackward) &&
        abs(approach_speed(k)) <= sliding_rounding(k))
      stand(k);
}

// The limit is reached: the speed then begins at zero as the square of time, or, where the friction
// is less as soon as it slides, at once.
template <class Real>
void Motion<Real>::arrive_at_slip(int i, bool forward) {
  const Friction& friction = system_.friction(i);
  const bool drops = friction.sliding != friction.sticking;
  slide(i, forward, drops ? 1 : 2);
  for (const int k : order_)
    if (contact(k) == Contact::kLocked) set(k, Contact::kTouching, 2);
  if (drops) judge_again(Jumped::kForces);
}

template <class Real>
void Motion<Real>::stick(int i) {
  if (contact(i) == Contact::kClosed) return;
  if (!is_independent(i, held())) {
    set(i, Contact::kLocked);
  } else {
    set(i, Contact::kClosed);
    now_.places[place(i)] = static_cast<double>(stop(i).row.dot(now_.q));
    changes_.push_back({ArrivalKind::kStick, i});
  }
  note_rubbing();
}

// Shares the pushes on these stops, and on all friction at rest, among them. Friction that slides
// from here on does so afterwards, the rest sticks; nullopt where they contradict each other.
template <class Real>
std::optional<typename Motion<Real>::PushShares> Motion<Real>::share_pushes(
    const std::vector<int>& stops) {
  std::vector<int> standing, kept;
  for (const int i : frictions_)
    if (contact(i) == Contact::kClosed || contact(i) == Contact::kLocked ||
        contact(i) == Contact::kTouching)
      (is_independent(i, stops) ? standing : kept).push_back(i);
  if (kept.empty()) return share_among(stops, standing);
  // A stop that is pressed keeps the friction there at rest.
  const auto shares = share_among(stops, standing);
  if (!shares) return {};
  std::vector<int> pressed;
  for (std::size_t a = 0; a < stops.size(); ++a)
    if (shares->presses(static_cast<Eigen::Index>(a))) pressed.push_back(stops[a]);
  const auto is_free = [&](int i) { return is_independent(i, pressed); };
  std::vector<int> loose;
  std::copy_if(kept.begin(), kept.end(), std::back_inserter(loose), is_free);
  for (const int i : kept)
    if (!is_free(i)) {
      set(i, Contact::kLocked);
      note_rubbing();
    }
  if (loose.empty()) return shares;
  for (const int i : frictions_)
    if (contact(i) == Contact::kClosed) loose.push_back(i);
  return share_among(stops, loose);
}

template <class Real>
std::optional<typename Motion<Real>::PushShares> Motion<Real>::share_among(
    const std::vector<int>& stops, std::vector<int> standing) {
  using std::abs;
  const auto n = static_cast<Eigen::Index>(stops.size());
  for (;;) {
    std::vector<int> list = stops;
    list.insert(list.end(), standing.begin(), standing.end());
    const auto all = static_cast<Eigen::Index>(list.size()), s = all - n;
    RealVector<Real> size;
    const RealVector<Real> acceleration = free_acceleration(&size);
    if (vanished_ > 0) size += located_size();
    RealVector<Real> push(all), rounding(all), limit(s);
    for (Eigen::Index a = 0; a < all; ++a) {
      const int i = list[static_cast<std::size_t>(a)];
      push[a] = stop(i).row.dot(acceleration);
      rounding[a] = push_rounding(i, size);
      if (a >= n) limit[a - n] = Real(system_.friction(i).sticking) * stop(i).row.squaredNorm();
    }
    const Matrix_ acting = pressing(list);
    const std::optional<RealVector<Real>> forces =
        solve_with_friction<Real>(acting, push, rounding, limit);
    if (!forces) return {};
    const RealVector<Real> into = push - acting * *forces;
    // Forces of friction are found as what they are above the least possible.
    RealVector<Real> known = forces->cwiseAbs();
    known.tail(s) += limit;
    const RealVector<Real> own = rounding + rounding_of_action<Real>(acting, known);
    bool changed = false;
    for (Eigen::Index a = n; a < all; ++a) {
      if (!(abs(into[a]) > own[a])) continue;
      const int i = list[static_cast<std::size_t>(a)];
      start_sliding(i, into[a] > 0);
      std::erase(standing, i);
      changed = changed || system_.friction(i).sliding != system_.friction(i).sticking;
    }
    if (changed) continue;
    for (const int i : standing) stick(i);
    return PushShares{forces->head(n), into.head(n), rounding.head(n), acting.diagonal().head(n)};
  }
}

template <class Real>
void Motion<Real>::start_sliding(int i, bool forward) {
  const int from = multiplicity(i);
  if (contact(i) == Contact::kClosed)
    changes_.push_back({ArrivalKind::kSlip, i});
  else if (from != 0 && from != (forward ? kCameForward : kCameBackward))
    changes_.push_back({ArrivalKind::kReversal, i});
  else if (from == 0)
    changes_.push_back({ArrivalKind::kSlip, i});
  slide(i, forward, 1);
}

}  // namespace graze
