// Definitions of motion.hpp: impacts on the touched stops.
#pragma once

#include <cmath>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/stop_scope.hpp"
#include "graze/contact/detail/complementarity.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace impact_detail {

// Roundings of an approach speed b.q'.
inline constexpr int kRoundings = 8;

// Most impacts at one instant that are followed to see whether they end: sequences that end do so
// after about pi over the angle between two stops; the others fall geometrically to the rounding of
// the speeds.
inline constexpr int kMostRepetitions = 1 << 16;

// All are at rest at this many roundings of their speeds: six bits above, where one stop may still
// count as left while the other does not.
inline constexpr int kAtRest = 64;

}  // namespace impact_detail

template <class Real>
int Motion<Real>::lone_stop() const {
  int found = -1;
  for (const int i : order_) {
    if (contact(i) == Contact::kClear) continue;
    if (found >= 0 || is_held(i)) return -1;
    found = i;
  }
  return found >= 0 && approach_speed(found) > speed_rounding(found) ? found : -1;
}

// The impact on a single stop that is approached: p = v- - v+.
template <class Real>
void Motion<Real>::impact_alone(int i) {
  const MetStop& s = stop(i);
  const Real speed = approach_speed(i), target = -s.restitution().at(speed) * speed;
  Real impulse = speed - target;
  push_back(s, impulse);
  // Two passes, as in apply().
  const Real left = approach_speed(i) - target;
  push_back(s, left);
  set(i, Contact::kTouching);
  shares_.assign(1, {i, speed, target, impulse + left, true});
}

template <class Real>
const std::vector<ImpactShare<Real>>& Motion<Real>::impact() {
  const Real before = kinetic_square();
  if (const int alone = lone_stop(); alone >= 0)
    impact_alone(alone);
  else
    impact_together();
  judge_again(Jumped::kVelocities);
  look_at_joint();
  eventful_ = true;
  audit_impact(before);
  return shares_;
}

// The impact on all stops that are touched.
template <class Real>
void Motion<Real>::impact_together() {
  Touched touched = touched_stops();
  Jump jump = jump_of(touched);
  if (drives_back(touched, jump)) {
    const std::optional<RealVector<Real>> solved =
        solve_contacts(touched.acting, touched.speed, touched.rounding);
    // When impacts without end bring the structure to rest, all stops hold it together.
    if (solved && (solved->array() > 0).count() > 1 && comes_to_rest(touched))
      jump = {RealVector<Real>::Zero(touched.speed.size()), *solved};
  }
  // What a stop that is held has of a speed is rounding, and is none of what the impact left.
  RealVector<Real> unfelt = -touched.speed;
  for (Eigen::Index a = 0; a < unfelt.size(); ++a)
    unfelt[a] += approach_speed(touched.stops[static_cast<std::size_t>(a)]);
  apply(touched.stops, jump.target, jump.impulse);
  shares_.clear();
  for (Eigen::Index a = 0; a < touched.speed.size(); ++a) {
    const int i = touched.stops[static_cast<std::size_t>(a)];
    const Real speed = touched.speed[a], impulse = jump.impulse[a];
    if (impulse > 0 || !is_left(touched, a))
      shares_.push_back(
          {i, speed, jump.target[a], impulse, impulse > 0 && speed > touched.rounding[a]});
  }
  touched.rounding += rounding_of_action(touched.acting, jump.impulse);
  for (Eigen::Index a = 0; a < touched.speed.size(); ++a) {
    const int i = touched.stops[static_cast<std::size_t>(a)];
    const bool stays = !(approach_speed(i) - unfelt[a] < -touched.rounding[a]);
    if (!is_held(i)) {
      set(i, Contact::kTouching);
    } else if (contact(i) == Contact::kLocked) {  // at rest, while the others stay
      set(i, Contact::kTouching, stays ? 2 : 0);
      recheck_ = true;
    } else if (!stays) {
      changes_.push_back({ArrivalKind::kRelease, i});
      set(i, Contact::kTouching);
    } else {
      recheck_ = true;
    }
  }
  if (shares_.size() == 1) shares_.front().hit = true;
  phase_ = nullptr;
}

template <class Real>
Real Motion<Real>::speed_rounding(int i) const {
  return graze::speed_rounding(stop(i).row, now_.qdot);
}

template <class Real>
typename Motion<Real>::Touched Motion<Real>::touched_stops() const {
  Touched touched;
  for (const int i : order_)
    if (contact(i) != Contact::kClear) touched.stops.push_back(i);
  const auto k = static_cast<Eigen::Index>(touched.stops.size());
  touched.speed.resize(k);
  touched.rounding.resize(k);
  for (Eigen::Index a = 0; a < k; ++a) {
    const int i = touched.stops[static_cast<std::size_t>(a)];
    // On a closed stop the structure is at rest; any speed is rounding.
    touched.speed[a] = is_held(i) ? Real(0) : approach_speed(i);
    touched.rounding[a] = speed_rounding(i);
  }
  touched.acting = delassus(touched.stops);
  return touched;
}

template <class Real>
typename Motion<Real>::Jump Motion<Real>::jump_of(const Touched& touched) const {
  const Eigen::Index k = touched.speed.size();
  Jump jump{RealVector<Real>::Zero(k), RealVector<Real>::Zero(k)};
  std::vector<Eigen::Index> partakes;
  RealVector<Real> undone = RealVector<Real>::Zero(k);
  for (Eigen::Index a = 0; a < k; ++a) {
    if (is_left(touched, a)) continue;
    partakes.push_back(a);
    const Real speed = touched.speed[a];
    if (!(speed > 0)) continue;
    const MetStop& s = stop(touched.stops[static_cast<std::size_t>(a)]);
    jump.target[a] = -s.restitution().at(speed) * speed;
    undone[a] = speed - jump.target[a];
  }
  if (partakes.size() == 1) {
    jump.impulse = undone;
    return jump;
  }
  const Matrix_ acting = touched.acting(partakes, partakes);
  const RealVector<Real> rounding = touched.rounding(partakes);
  std::optional<RealVector<Real>> solved = solve_contacts<Real>(acting, undone(partakes), rounding);
  // Stops that leave no room between them cannot all be left: then there is no rebound.
  if (!solved) {
    undone += jump.target;
    jump.target.setZero();
    solved = solve_contacts<Real>(acting, undone(partakes), rounding);
  }
  if (solved) jump.impulse(partakes) = *solved;
  return jump;
}

template <class Real>
bool Motion<Real>::drives_back(const Touched& touched, const Jump& jump) const {
  const RealVector<Real> rounding =
      touched.rounding + rounding_of_action(touched.acting, jump.impulse);
  for (Eigen::Index a = 0; a < touched.speed.size(); ++a)
    if (is_left(touched, a) &&
        touched.speed[a] - touched.acting.row(a).dot(jump.impulse) > rounding[a])
      return true;
  return false;
}

template <class Real>
bool Motion<Real>::comes_to_rest(Touched touched) const {
  using std::abs;
  const Eigen::Index k = touched.speed.size();
  std::vector<bool> hit(static_cast<std::size_t>(k), false);
  for (int i = 0; i < impact_detail::kMostRepetitions && !StopScope::is_over(); ++i) {
    const Jump jump = jump_of(touched);
    touched.speed -= touched.acting * jump.impulse;
    touched.rounding += rounding_of_action(touched.acting, jump.impulse);
    bool approached = false, resting = true;  // any of them; all of them
    for (Eigen::Index a = 0; a < k; ++a) {
      const auto place = static_cast<std::size_t>(a);
      hit[place] = hit[place] || jump.impulse[a] > 0;
      approached = approached || touched.speed[a] > touched.rounding[a];
      resting = resting &&
                (hit[place] ? abs(touched.speed[a]) <= impact_detail::kAtRest * touched.rounding[a]
                            : !(touched.speed[a] > touched.rounding[a]));
    }
    if (resting || !approached) return resting;
  }
  return false;
}

template <class Real>
RealMatrix<Real> Motion<Real>::delassus(const std::vector<int>& stops) const {
  const auto k = static_cast<Eigen::Index>(stops.size());
  Matrix_ matrix(k, k);
  for (Eigen::Index a = 0; a < k; ++a)
    for (Eigen::Index b = 0; b < k; ++b)
      matrix(a, b) = stop(stops[static_cast<std::size_t>(a)])
                         .row.dot(stop(stops[static_cast<std::size_t>(b)]).direction);
  return matrix;
}

// Uses the row itself if possible: a rounded direction has the same error at every impact.
template <class Real>
void Motion<Real>::push_back(const MetStop& s, const Real& amount) {
  if (s.norm2 > 0)
    now_.qdot -= (amount / s.norm2) * s.row;
  else
    now_.qdot -= amount * s.direction;
}

template <class Real>
void Motion<Real>::push_back_from(const std::vector<int>& stops, const RealVector<Real>& amounts) {
  for (std::size_t a = 0; a < stops.size(); ++a)
    push_back(stop(stops[a]), amounts[static_cast<Eigen::Index>(a)]);
}

// Two passes: row.direction = 1 and the solution of several contacts hold to rounding only, with
// the same error at every impact. `impulse` becomes the impulse that was applied.
template <class Real>
void Motion<Real>::apply(const std::vector<int>& touched, const RealVector<Real>& target,
                         RealVector<Real>& impulse) {
  std::vector<int> active;
  std::vector<Eigen::Index> places;
  for (Eigen::Index a = 0; a < impulse.size(); ++a) {
    if (!(impulse[a] > 0)) continue;
    active.push_back(touched[static_cast<std::size_t>(a)]);
    places.push_back(a);
  }
  if (active.empty()) return;
  RealVector<Real> amounts = impulse(places);
  push_back_from(active, amounts);
  RealVector<Real> left(amounts.size());
  for (std::size_t a = 0; a < active.size(); ++a)
    left[static_cast<Eigen::Index>(a)] = approach_speed(active[a]) - target[places[a]];
  // The diagonal of one stop's matrix is 1 to rounding; of several the directions overlap.
  const RealVector<Real> more =
      active.size() == 1 ? left : PivotedLu<Real>(delassus(active)).solve(left);
  push_back_from(active, more);
  impulse(places) = amounts + more;
}

}  // namespace graze
