// Definitions of motion.hpp: dry friction.
//
//   forward, backward: it slides, against the whole of its force, until its speed is zero;
//   closed: it sticks, while what the structure exerts on it is no more than its limit;
//   locked: closed stops keep the structure at rest there, and it exerts nothing; or together with
//      other friction, and it leans on them with all that it can exert.
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
  for (const int i : frictions_) {
    const int at = system_.friction(i).series ? system_.index_of_following(i) : i;
    const RealVector<Real> row = system_.row(at).template cast<Real>();
    stops_.push_back(
        {row, system_.direction(at).template cast<Real>(), Real(0), row.norm(), Real(0), nullptr});
  }
  watched_ = looked_at_;
  watched_.insert(watched_.end(), frictions_.begin(), frictions_.end());
}

// What sticks to belts is carried along for a time that counts from one instant for all of it.
template <class Real>
void Motion<Real>::renew_places() {
  for (const int i : frictions_)
    if (contact(i) == Contact::kClosed && stop(i).belt != 0)
      (*now_.places)[place(i)] = static_cast<double>(stop(i).row.dot(now_.q));
}

// Friction at a spring begins and ends with its contact.
template <class Real>
void Motion<Real>::press_frictions(int at, Contact before) {
  const bool presses = contact(at) == Contact::kCompressed;
  if (system_.is_friction(at) || presses == (before == Contact::kCompressed)) return;
  for (const int i : frictions_) {
    if (system_.friction(i).stop != at) continue;
    const Real speed = approach_speed(i);
    if (!presses)
      set(i, Contact::kClear);
    else if (std::abs(static_cast<double>(speed)) > static_cast<double>(sliding_rounding(i)))
      slide(i, speed > 0, 0);
    else
      stand(i);
    phase_ = nullptr;
  }
}

// Along which a spring pushes, with the friction that slides there.
template <class Real>
RealVector<Real> Motion<Real>::pushing(int at) const {
  RealVector<Real> row = stop(at).row;
  for (const int i : frictions_) {
    if (system_.friction(i).stop != at) continue;
    const Real part = Real(system_.friction(i).sliding);
    if (pushes(i, true)) row += part * stop(i).row;
    if (pushes(i, false)) row -= part * stop(i).row;
  }
  return row;
}

// The force of what slides, but at springs.
template <class Real>
void Motion<Real>::note_rubbing() {
  rubbing_ = RealVector<Real>::Zero(now_.q.size());
  for (const int i : frictions_) {
    if (system_.friction(i).stop >= 0) continue;
    const Real force = Real(system_.friction(i).sliding);
    if (pushes(i, true)) rubbing_ -= force * stop(i).row;
    if (pushes(i, false)) rubbing_ += force * stop(i).row;
  }
  phase_ = nullptr;
}

template <class Real>
void Motion<Real>::slide(int i, bool forward, int multiplicity) {
  const bool follows = system_.friction(i).series.has_value();
  set(i, forward ? Contact::kForward : Contact::kBackward, follows ? 0 : multiplicity);
  note_rubbing();
  if (follows) follow(i);
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
    if (!is_pressed(i)) continue;
    if (system_.friction(i).series) {
      judge_series(i, what);
      continue;
    }
    const Contact before = contact(i);
    const Real speed = approach_speed(i);
    if (what == Jumped::kVelocities &&
        std::abs(static_cast<double>(speed)) > static_cast<double>(sliding_rounding(i))) {
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
  if (system_.friction(i).series) {
    // It is held by what its spring pulls with at this instant, its whole force.
    now_.qdot -= stop(i).direction * approach_speed(i);
    return stick(i, held());
  }
  const int came = before == Contact::kForward    ? kCameForward
                   : before == Contact::kBackward ? kCameBackward
                                                  : 0;
  set(i, Contact::kTouching, came);
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
    stick(i, held());
    return;
  }
  stand(i);
  for (const int k : frictions_)
    if ((contact(k) == Contact::kForward || contact(k) == Contact::kBackward) &&
        abs(approach_speed(k)) <= sliding_rounding(k))
      stand(k);
}

// The limit is reached: the speed then begins at zero as the square of time, or, where the friction
// is less as soon as it slides, at once. Returns false where other friction takes over.
template <class Real>
bool Motion<Real>::arrive_at_slip(int i, bool forward) {
  if (const std::optional<int> other = stands_in(i, forward)) {
    lean(i, forward);
    stick(*other, held());
    changes_.pop_back();  // it stuck before
    return false;
  }
  const Friction& friction = system_.friction(i);
  const bool drops = friction.sliding != friction.sticking;
  slide(i, forward, drops ? 1 : 2);
  for (const int k : order_)
    if (contact(k) == Contact::kLocked) set(k, Contact::kTouching, 2);
  unlock_frictions();
  if (drops) judge_again(Jumped::kForces);
  return true;
}

// Friction whose force changes in place of this one's, which is at its limit. With
// row_k = sum_j a_j row_j over what holds, forces p_k + d/a_i and p_i - d hold as much.
template <class Real>
std::optional<int> Motion<Real>::stands_in(int i, bool forward) const {
  using std::abs;
  const std::vector<int> holding = held();
  const auto own = std::find(holding.begin(), holding.end(), i) - holding.begin();
  for (const int k : frictions_) {
    if (contact(k) != Contact::kLocked) continue;
    const RealVector<Real> parts = parts_of(k, holding);
    if (!(abs(parts[own]) * stop(i).norm >
          std::sqrt(std::numeric_limits<double>::epsilon()) * stop(k).norm))
      continue;
    const bool grows = forward == (parts[own] > 0);
    if (!pushes(k, grows)) return k;
  }
  return {};
}

// `beside`: what else holds the structure.
template <class Real>
void Motion<Real>::stick(int i, const std::vector<int>& beside) {
  if (contact(i) == Contact::kClosed) return;
  if (!is_independent(i, beside)) {
    set(i, Contact::kLocked);
  } else {
    set(i, Contact::kClosed);
    (*now_.places)[place(i)] = static_cast<double>(stop(i).row.dot(now_.q));
    changes_.push_back({ArrivalKind::kStick, i});
  }
  note_rubbing();
}

// Others keep it at rest, and it exerts all that it can.
template <class Real>
void Motion<Real>::lean(int i, bool forward) {
  set(i, Contact::kLocked, forward ? kCameForward : kCameBackward);
  note_rubbing();
}

// Shares the pushes on these stops, and on all friction at rest, among them. Friction that slides
// from here on does so afterwards, the rest sticks; nullopt where they contradict each other.
template <class Real>
std::optional<typename Motion<Real>::PushShares> Motion<Real>::share_pushes(
    const std::vector<int>& stops) {
  std::vector<int> standing, kept;
  for (const int i : frictions_)
    if (!system_.friction(i).series &&
        (contact(i) == Contact::kClosed || contact(i) == Contact::kLocked ||
         contact(i) == Contact::kTouching))
      (is_independent(i, stops) ? standing : kept).push_back(i);
  // What leans on others is asked anew.
  for (const int i : standing)
    if (contact(i) == Contact::kLocked) stand(i);
  if (kept.empty()) return share_among(stops, standing);
  const auto shares = solve_pushes(stops, standing);
  if (!shares) return {};
  // A stop that is pressed keeps the friction there at rest.
  const std::vector<int> pressed = pressed_of(stops, *shares);
  for (const int i : kept) {
    if (is_independent(i, pressed)) {
      if (contact(i) == Contact::kLocked) stand(i);
      standing.push_back(i);
    } else {
      set(i, Contact::kLocked);
      note_rubbing();
    }
  }
  return share_among(stops, standing);
}

template <class Real>
std::vector<int> Motion<Real>::pressed_of(const std::vector<int>& stops,
                                          const PushShares& shares) const {
  std::vector<int> pressed;
  for (std::size_t a = 0; a < stops.size(); ++a)
    if (shares.presses(static_cast<Eigen::Index>(a))) pressed.push_back(stops[a]);
  return pressed;
}

template <class Real>
std::optional<typename Motion<Real>::PushShares> Motion<Real>::solve_pushes(
    const std::vector<int>& stops, const std::vector<int>& standing) const {
  std::vector<int> list = stops;
  list.insert(list.end(), standing.begin(), standing.end());
  const auto all = static_cast<Eigen::Index>(list.size()),
             n = static_cast<Eigen::Index>(stops.size());
  RealVector<Real> size;
  const RealVector<Real> acceleration = free_acceleration(&size);
  if (vanished_ > 0) size += located_size();
  RealVector<Real> push(all), limit(all - n);
  PushShares shares;
  shares.rounding.resize(all);
  for (Eigen::Index a = 0; a < all; ++a) {
    const int i = list[static_cast<std::size_t>(a)];
    push[a] = stop(i).row.dot(acceleration);
    shares.rounding[a] = push_rounding(i, size);
    if (a >= n) limit[a - n] = rubbing_force(i, true) * stop(i).row.squaredNorm();
  }
  const Matrix_ acting = pressing(list);
  std::optional<RealVector<Real>> forces =
      solve_with_friction<Real>(acting, push, shares.rounding, limit);
  if (!forces) return {};
  shares.forces = std::move(*forces);
  shares.into = std::move(push);
  shares.into.noalias() -= acting * shares.forces;
  shares.own = acting.diagonal();
  shares.acting = shares.rounding + rounding_of_action<Real>(acting, shares.forces);
  if (all == n) return shares;
  // Forces of friction are found as what they are above the least possible.
  RealVector<Real> above = RealVector<Real>::Zero(all);
  above.tail(all - n) = limit;
  shares.acting += rounding_of_action<Real>(acting, above);
  shares.left = limit - shares.forces.tail(all - n).cwiseAbs();
  return shares;
}

template <class Real>
std::optional<typename Motion<Real>::PushShares> Motion<Real>::share_among(
    const std::vector<int>& stops, std::vector<int> standing) {
  using std::abs;
  const auto n = static_cast<Eigen::Index>(stops.size());
  for (;;) {
    auto shares = solve_pushes(stops, standing);
    if (!shares) return {};
    bool changed = false;
    std::vector<int> rest;
    for (std::size_t k = 0; k < standing.size(); ++k) {
      const int i = standing[k];
      const Eigen::Index a = n + static_cast<Eigen::Index>(k);
      if (abs(shares->into[a]) > shares->acting[a]) {
        start_sliding(i, shares->into[a] > 0);
        changed = changed || system_.friction(i).sliding != system_.friction(i).sticking;
      } else {
        rest.push_back(i);
      }
    }
    if (!changed) {
      rest_on(stops, standing, *shares);
      return shares;
    }
    standing = std::move(rest);
  }
}

// What does not slide: within its limit it sticks, at it it leans on the others where these hold
// it.
template <class Real>
void Motion<Real>::rest_on(const std::vector<int>& stops, const std::vector<int>& standing,
                           const PushShares& shares) {
  const auto n = static_cast<Eigen::Index>(stops.size());
  std::vector<int> holding = pressed_of(stops, shares);
  for (const bool at_limit : {false, true})
    for (std::size_t k = 0; k < standing.size(); ++k) {
      const int i = standing[k];
      const auto own = static_cast<Eigen::Index>(k);
      if (contact(i) == Contact::kForward || contact(i) == Contact::kBackward ||
          at_limit != !(shares.left[own] > shares.acting[n + own]))
        continue;
      if (at_limit && rubbing_force(i, true) > 0 && !is_independent(i, holding)) {
        lean(i, shares.forces[n + own] > 0);
        continue;
      }
      stick(i, holding);
      holding.push_back(i);
    }
}

template <class Real>
void Motion<Real>::start_sliding(int i, bool forward) {
  const int from = multiplicity(i);
  if (contact(i) == Contact::kClosed || from == 0)
    changes_.push_back({ArrivalKind::kSlip, i});
  else if (from != (forward ? kCameForward : kCameBackward))
    changes_.push_back({ArrivalKind::kReversal, i});
  slide(i, forward, 1);
}

}  // namespace graze
