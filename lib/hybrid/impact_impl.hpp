// Definitions of motion.hpp: impacts on the touched stops, and chatter that completes.
#pragma once

#include <Eigen/LU>
#include <cmath>

#include "graze/contact/complementarity.hpp"
#include "graze/hybrid/first_zero.hpp"
#include "graze/hybrid/motion.hpp"

namespace graze {
namespace impact_detail {

// Roundings of an approach speed b.q'.
inline constexpr int kRoundings = 8;

}  // namespace impact_detail

template <class Real>
std::vector<ImpactShare<Real>> Motion<Real>::impact() {
  std::vector<int> touched;
  for (const int i : order_)
    if (contact(i) != Contact::kClear) touched.push_back(i);
  const auto k = static_cast<Eigen::Index>(touched.size());
  std::vector<ImpactShare<Real>> shares(touched.size());
  RealVector<Real> undone(k), rounding(k), target(k);
  for (Eigen::Index a = 0; a < k; ++a) {
    ImpactShare<Real>& share = shares[static_cast<std::size_t>(a)];
    share.stop = touched[static_cast<std::size_t>(a)];
    const Stop& s = stop(share.stop);
    rounding[a] = impact_detail::kRoundings * std::numeric_limits<Real>::epsilon() *
                  s.row.cwiseAbs().dot(now_.qdot.cwiseAbs());
    // A closed stop is at rest; what is left of its speed is rounding.
    share.speed = contact(share.stop) == Contact::kClosed ? Real(0) : approach_speed(share.stop);
    target[a] = share.speed > 0 ? Real(-s.restitution.at(share.speed) * share.speed) : Real(0);
    share.speed_after = target[a];
    undone[a] = share.speed - target[a];
  }
  RealVector<Real> impulse = undone;
  if (k > 1) {
    const Matrix_ acting = delassus(touched);
    std::optional<RealVector<Real>> solved = solve_contacts(acting, undone, rounding);
    // Stops that leave no room between them cannot all be left: then nothing rebounds.
    if (!solved) {
      undone += target;
      target.setZero();
      solved = solve_contacts(acting, undone, rounding);
      for (ImpactShare<Real>& share : shares) share.speed_after = 0;
    }
    impulse = solved ? *solved : RealVector<Real>(RealVector<Real>::Zero(k));
  }
  apply(touched, target, impulse);
  for (Eigen::Index a = 0; a < k; ++a) {
    ImpactShare<Real>& share = shares[static_cast<std::size_t>(a)];
    share.impulse = impulse[a];
    share.hit = share.impulse > 0 && share.speed > rounding[a];
    if (contact(share.stop) != Contact::kClosed) {
      set(share.stop, Contact::kTouching);
    } else if (approach_speed(share.stop) < -rounding[a]) {
      changes_.push_back({ArrivalKind::kRelease, share.stop});
      set(share.stop, Contact::kTouching);
    } else {
      recheck_ = true;
    }
  }
  if (k == 1) shares.front().hit = true;
  phase_ = nullptr;
  return shares;
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

template <class Real>
void Motion<Real>::push_back_from(const std::vector<int>& stops, const RealVector<Real>& amounts) {
  for (std::size_t a = 0; a < stops.size(); ++a)
    now_.qdot -= amounts[static_cast<Eigen::Index>(a)] * stop(stops[a]).direction;
}

// Twice: row.direction = 1 and the solution of several contacts hold to rounding only, and err to
// the same side at every impact. `impulse` becomes what was applied.
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
  RealVector<Real> amounts = impulse(places);
  push_back_from(active, amounts);
  RealVector<Real> left(amounts.size());
  for (std::size_t a = 0; a < active.size(); ++a)
    left[static_cast<Eigen::Index>(a)] = approach_speed(active[a]) - target[places[a]];
  // The diagonal of one stop's matrix is 1 to rounding; of several the directions overlap.
  const RealVector<Real> more =
      active.size() == 1 ? left : RealVector<Real>(delassus(active).fullPivLu().solve(left));
  push_back_from(active, more);
  impulse(places) = amounts + more;
}

template <class Real>
std::optional<Real> Motion<Real>::close_chatter(int i, const Real& restitution) {
  using std::abs;
  const Real leaving = -approach_speed(i);
  if (!changes_.empty() || !(restitution < 1) || !(leaving > 0)) return {};
  for (const int j : order_)
    if (j != i && contact(j) != Contact::kClear && contact(j) != Contact::kClosed) return {};
  const ContactPhase<Real>& phase = start_phase();
  const CurvePoint<Real> now = phase.gap(i, Real(0), true).at(Real(0), 2);
  const Real push = -now.value;
  if (!(push > now.noise)) return {};
  const Real duration = 2 * leaving / (push * (1 - restitution));
  const CurvePoint<Real> ahead = phase.gap(i, duration, true).at(Real(0), 2);
  if (!(duration * (abs(ahead.slope) + ahead.bound * duration) <= push / 2)) return {};
  for (const int j : order_) {
    if (j == i) continue;
    const FirstZero<Real> zero = contact(j) == Contact::kClosed
                                     ? first_release(phase.force(j, duration))
                                     : first_contact(phase.gap(j, duration, false), 0);
    if (zero.kind != ZeroKind::kNone) return {};
  }
  // What the tail's impulses add up to: the part of the push that the closed stop would have taken,
  // less the speed at which the structure leaves.
  for (int pass = 0; pass < 2; ++pass) now_.qdot -= approach_speed(i) * stop(i).direction;
  set(i, Contact::kTouching);
  return duration;
}

}  // namespace graze
