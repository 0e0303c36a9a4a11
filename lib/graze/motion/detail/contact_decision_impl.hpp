// Definitions of motion.hpp: the contacts of the stops that the structure touches.
//
// At an instant every touched stop is one of: approached (an impact is due), left at a speed, or at
// rest. Those at rest and the closed ones share the push by complementarity: contact forces >= 0,
// accelerations into the stops <= 0, one of the two zero. Where both vanish, the next derivative
// decides.
#pragma once

#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/products.hpp"
#include "graze/contact/detail/complementarity.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace contact_decision_detail {

// Roundings of a push, sum_j b_j (load + force - damping - stiffness)_j.
inline constexpr int kRoundings = 16;

}  // namespace contact_decision_detail

// Returns an arrival when an impact is due or nothing can be decided; else nullopt, with the
// changes noted.
template <class Real>
std::optional<Arrival<Real>> Motion<Real>::decide() {
  if (compliant_.empty()) return decide_rigid();
  decide_moving_springs();
  not_told_.clear();
  const std::optional<Arrival<Real>> arrival = decide_rigid();
  if (arrival) return arrival;
  decide_resting_springs();
  ask_the_motion();
  return {};
}

template <class Real>
std::optional<Arrival<Real>> Motion<Real>::decide_rigid() {
  using std::abs;
  ContactPhase<Real>& phase = start_phase();
  std::vector<int> resting, lingering;
  for (const int i : order_) {
    // Left at this instant without speed: the forces of the other stops may hold it back now.
    if (contact(i) == Contact::kDeparting && multiplicity(i) > 1 && multiplicity(i) != kLeftUntold)
      lingering.push_back(i);
    if (contact(i) != Contact::kTouching) continue;
    // Known to be at rest, or kept at rest by closed stops: then its rate is mere rounding.
    if (now_.multiplicities[static_cast<std::size_t>(i)] > 1 ||
        !is_independent(i, phase.closed())) {
      resting.push_back(i);
      continue;
    }
    const CurvePoint<Real> rate = phase.gap_rate(i, 1);
    // The phase does not keep velocities that closed stops do not allow: the rounding of b.q'. The
    // instant is known to its rounding too, in which a push changes the speed: at the end of a
    // chatter, where nothing else moves, that is all that is left of the speed.
    const Real located =
        std::numeric_limits<Real>::epsilon() * now_.instant.local * abs(free_push(i));
    const Real rounding = std::max<Real>(rate.noise, speed_rounding(i) + located + unseen_speed(i));
    if (rate.value < -rounding)
      return Arrival<Real>{ArrivalKind::kContact, i, Real(0), approach_speed(i)};
    if (rate.value > rounding)
      set(i, Contact::kDeparting, 1);
    else
      resting.push_back(i);
  }
  undecided_ = false;
  const auto stands = [this](int i) { return contact(i) == Contact::kTouching; };
  recheck_ = recheck_ || std::any_of(frictions_.begin(), frictions_.end(), stands);
  if (resting.empty() && !recheck_) return {};
  recheck_ = false;
  resting.insert(resting.end(), lingering.begin(), lingering.end());
  const bool decided = decide_resting(resting);
  phase_ = nullptr;
  undecided_ = recheck_ = std::any_of(frictions_.begin(), frictions_.end(), stands);
  if (!decided) return Arrival<Real>{ArrivalKind::kUndecided, order_.empty() ? -1 : order_.front()};
  const ContactPhase<Real>& next = phase_of(held());
  refusal_ = next.refusal();
  if (!refusal_.empty()) {
    changes_.clear();
    return Arrival<Real>{ArrivalKind::kRefused, first_of(next)};
  }
  return {};
}

// Speed at which the structure leaves a stop and comes back within the rounding of the gap, which a
// flow that forms the gap from its state does not see: v^2 = 2 push rounding. The exact flow knows
// the gap from its zero on.
template <class Real>
Real Motion<Real>::unseen_speed(int i) const {
  using std::sqrt;
  if (!steps_ && !is_sprung() && !turning_) return 0;
  const Real push = free_push(i);
  if (!(push > 0)) return 0;
  return sqrt(2 * push * gap_value(stop(i).row, now_.q, stop(i).gap).rounding);
}

// q'' without any rigid stop. `size`: of the terms of the sum.
template <class Real>
RealVector<Real> Motion<Real>::free_acceleration(RealVector<Real>* size) const {
  if (turning_) return turning_acceleration(size);
  const Eigen::Index n = now_.q.size();
  RealVector<Real> acceleration(n);
  if (size) size->resize(n);
  const Real cosine = forcing_cosine();
  for (Eigen::Index j = 0; j < n; ++j)
    acceleration[j] = free_acceleration(j, cosine, size ? &(*size)[j] : nullptr);
  if (!compliant_.empty()) add_spring_forces(acceleration, size);
  return acceleration;
}

template <class Real>
RealVector<Real> Motion<Real>::turning_acceleration(RealVector<Real>* size) const {
  turning_->begin(static_cast<double>(now_.instant.local));
  const Vector q = now_.q.template cast<double>(), qdot = now_.qdot.template cast<double>();
  const TurningMotion at{q, qdot};
  RealVector<Real> force = turning_->force(at, 0.0).template cast<Real>();
  if (size) *size = turning_->force_size(at, 0.0).template cast<Real>();
  if (!compliant_.empty()) add_spring_forces(force, size);
  RealVector<Real> acceleration = accelerated(force);
  if (now_.joint == Joint::kHeld) hold_joint(acceleration);
  return acceleration;
}

// M^-1 f at the present shape.
template <class Real>
RealVector<Real> Motion<Real>::accelerated(const RealVector<Real>& force) const {
  return turning_
      ->accelerated(Vector(force.template cast<double>()), Vector(now_.q.template cast<double>()))
      .template cast<Real>();
}

// Removes the part of an acceleration that a held joint does not allow.
template <class Real>
void Motion<Real>::hold_joint(RealVector<Real>& acceleration) const {
  const RealVector<Real> row = turning_->angle_row().template cast<Real>();
  const RealVector<Real> along = accelerated(row);
  acceleration -= (row.dot(acceleration) / row.dot(along)) * along;
}

// How a force at each of these stops acts on the push at each; unlike an impulse it does not rotate
// a held joint.
template <class Real>
RealMatrix<Real> Motion<Real>::pressing(const std::vector<int>& stops) const {
  Matrix_ matrix = delassus(stops);
  if (!turning_ || now_.joint != Joint::kHeld) return matrix;
  for (std::size_t b = 0; b < stops.size(); ++b) {
    RealVector<Real> direction = stop(stops[b]).direction;
    hold_joint(direction);
    for (std::size_t a = 0; a < stops.size(); ++a)
      matrix(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) =
          stop(stops[a]).row.dot(direction);
  }
  return matrix;
}

// d = M^-1 b/(b.M^-1 b): an impulse along b, which at this shape changes the approach speed by 1.
template <class Real>
void Motion<Real>::turn_directions() {
  if (!turning_) return;
  for (MetStop& stop : stops_) {
    if (stop.is_compliant()) continue;
    stop.direction = accelerated(stop.row);
    stop.direction /= stop.row.dot(stop.direction);
    stop.norm2 = 0;
  }
}

template <class Real>
Real Motion<Real>::free_acceleration(Eigen::Index j, const Real& cosine, Real* size) const {
  using std::abs;
  Real load = linear_.load.size() > 0 ? linear_.load[j] : Real(0);
  if (rubbing_.size() > 0) load += rubbing_[j];
  const Real force = linear_.force(j, cosine, clock_.phase(now_.instant));
  Real damping = 2 * linear_.delta[j] * now_.qdot[j];
  if (linear_.coupling.size() > 0) damping += linear_.coupling.row(j).dot(now_.qdot);
  const Real stiffness = linear_.omega[j] * linear_.omega[j] * now_.q[j];
  if (size)
    *size = abs(load) + linear_.force_size(j) + abs(damping) + abs(stiffness);
  return load + force - damping - stiffness;
}

template <class Real>
Real Motion<Real>::forcing_cosine() const {
  using std::cos;
  return linear_.forced ? Real(cos(clock_.phase(now_.instant))) : Real(0);
}

template <class Real>
Real Motion<Real>::free_push(int i) const {
  if (turning_) return stop(i).row.dot(free_acceleration());
  const Real cosine = forcing_cosine();
  Real push = 0;
  for (Eigen::Index j = 0; j < now_.q.size(); ++j)
    push += stop(i).row[j] * free_acceleration(j, cosine, nullptr);
  for (const int k : compliant_)
    if (contact(k) == Contact::kCompressed) push -= spring_force(k) * stop(i).row.dot(pushing(k));
  return push;
}

template <class Real>
Real Motion<Real>::push_rounding(int i, const RealVector<Real>& size) const {
  return contact_decision_detail::kRoundings * std::numeric_limits<Real>::epsilon() *
         stop(i).row.cwiseAbs().dot(size);
}

template <class Real>
bool Motion<Real>::decide_resting(const std::vector<int>& resting) {
  std::vector<int> candidates;
  for (const int i : order_)
    if (contact(i) == Contact::kClosed || contact(i) == Contact::kLocked ||
        std::find(resting.begin(), resting.end(), i) != resting.end())
      candidates.push_back(i);
  const std::optional<PushShares> shares = share_pushes(candidates);
  if (!shares) return false;
  std::vector<int> pressed, degenerate;
  for (std::size_t place = 0; place < candidates.size(); ++place) {
    const auto a = static_cast<Eigen::Index>(place);
    const int i = candidates[place];
    if (shares->presses(a))
      pressed.push_back(i);
    else if (shares->into[a] < -shares->rounding[a])
      let_go(i, 2);
    else
      degenerate.push_back(i);
  }
  // Stops that are left are decided first: an open stop keeps nothing in place.
  std::vector<int> sticking = pressed;
  for (const int i : frictions_)
    if (contact(i) == Contact::kClosed) sticking.push_back(i);
  const std::vector<int> kept = decide_degenerate(sticking, std::move(degenerate));
  // A closed stop that others now keep in place gives way to them: of two that face each other the
  // one that is pressed holds.
  for (const int i : kept)
    if (contact(i) == Contact::kClosed && !is_independent(i, sticking)) {
      changes_.push_back({ArrivalKind::kRelease, i});
      set(i, Contact::kLocked);
    }
  for (const int i : pressed) hold(i);
  for (const int i : kept) hold(i);
  rest_on_closed();
  return true;
}

// 1/s: bound on the ratio of a derivative of a free motion to the previous one, term by term.
template <class Real>
Real Motion<Real>::quickest_rate() const {
  using std::max;
  Real rate = linear_.forced ? linear_.highest_frequency() : Real(0);
  for (Eigen::Index j = 0; j < linear_.omega.size(); ++j)
    rate = max(rate, max<Real>(linear_.omega[j], 2 * linear_.delta[j]));
  return linear_.coupling.size() > 0 ? Real(rate + linear_.coupling.norm()) : rate;
}

// Stops that neither press nor are left: decided by the rate of the push, which depends on the
// other closed stops, or, where that vanishes too, by the next rate. Without any rate they stay as
// they are. Lets go of those that are left; returns the rest.
template <class Real>
std::vector<int> Motion<Real>::decide_degenerate(std::vector<int> held, std::vector<int> stops) {
  std::vector<int> kept;
  constexpr int kUntold = 0, kStays = -1;
  // The multiplicity of the zero at which the structure leaves the stop, if it does.
  const auto leaves = [&](int i) {
    if (!is_independent(i, held)) return kStays;  // kept there by others
    ContactPhase<Real>& phase = phase_of(held);
    if (!phase.refusal().empty()) return kStays;
    start_at_now(phase);
    const CurvePoint<Real> jerk = phase.gap_rate(i, 3);
    if (jerk.value > jerk.noise) return 3;
    if (jerk.value < -jerk.noise) return kStays;
    // No further rate is known without a closed form; beside springs the motion itself decides.
    if (!phase.sees_ahead() || is_sprung()) return kUntold;
    return jerk.slope > quickest_rate() * jerk.noise ? 4 : kUntold;
  };
  const auto stays = [&](int i) { return leaves(i) <= 0; };
  // Each pass keeps one stop, so there are no more passes than stops.
  for (auto next = stops.begin(); next != stops.end(); next = stops.begin()) {
    next = std::find_if(stops.begin(), stops.end(), stays);
    if (next == stops.end()) break;
    if (leaves(*next) == kUntold) not_told_.push_back(*next);
    if (is_independent(*next, held)) held.push_back(*next);
    kept.push_back(*next);
    stops.erase(next);
  }
  for (const int i : stops) let_go(i, leaves(i));
  return kept;
}

template <class Real>
void Motion<Real>::hold(int i) {
  if (contact(i) == Contact::kClosed) {
    if (multiplicity(i) == kHeldUntold) changes_.push_back({ArrivalKind::kStick, i});
    set(i, Contact::kClosed);
    return;
  }
  if (!is_independent(i, held())) {
    set(i, Contact::kLocked);
    return;
  }
  set(i, Contact::kClosed);
  changes_.push_back({ArrivalKind::kStick, i});
}

template <class Real>
void Motion<Real>::let_go(int i, int multiplicity) {
  if (contact(i) == Contact::kClosed && this->multiplicity(i) != kHeldUntold)
    changes_.push_back({ArrivalKind::kRelease, i});
  set(i, Contact::kDeparting, multiplicity);
  unlock_frictions();
}

// The stop's row as nearly as those in the list form it: their parts.
template <class Real>
RealVector<Real> Motion<Real>::parts_of(int i, const std::vector<int>& list) const {
  Matrix_ rows(now_.q.size(), static_cast<Eigen::Index>(list.size()));
  for (std::size_t a = 0; a < list.size(); ++a)
    rows.col(static_cast<Eigen::Index>(a)) = stop(list[a]).row;
  return PivotedLu<Real>(transposed_product<Real>(rows, rows))
      .solve(transposed_image<Real>(rows, stop(i).row));
}

// Whether the stop's row is linearly independent of those in the list.
template <class Real>
bool Motion<Real>::is_independent(int i, const std::vector<int>& list) const {
  if (list.empty()) return true;
  const RealVector<Real> parts = parts_of(i, list);
  RealVector<Real> left = stop(i).row;
  for (std::size_t a = 0; a < list.size(); ++a)
    left -= parts[static_cast<Eigen::Index>(a)] * stop(list[a]).row;
  // Half of the digits: the forces of nearer rows could not be separated.
  return left.squaredNorm() > std::numeric_limits<double>::epsilon() * stop(i).row.squaredNorm();
}

// Sets b.q' = 0 at every closed stop, and to the speed of its belt where friction sticks.
template <class Real>
void Motion<Real>::rest_on_closed() {
  const std::vector<int> stops = held();
  if (stops.empty()) return;
  RealVector<Real> speeds(static_cast<Eigen::Index>(stops.size()));
  for (std::size_t a = 0; a < stops.size(); ++a)
    speeds[static_cast<Eigen::Index>(a)] = approach_speed(stops[a]);
  push_back_from(stops, PivotedLu<Real>(delassus(stops)).solve(speeds));
  look_at_joint();
}

}  // namespace graze
