// Definitions of motion.hpp: the audit (contact_audit.hpp).
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/products.hpp"
#include "graze/base/units.hpp"
#include "graze/motion/detail/contact_audit.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/system/scale.hpp"

namespace graze {
template <class Real>
void Motion<Real>::fail_audit(int i, std::string what) {
  refusal_ = std::move(what) + "; this is an error of the program, please report it";
  broken_ = Arrival<Real>{ArrivalKind::kRefused, i};
}

// Bound on the rounding of a gap after a flight, m: of its terms at either end, and of the
// distances that velocities cover in that time, or in its rounding. Springs and closed stops couple
// the modes, so that the rounding of one reaches all.
template <class Real>
Real Motion<Real>::passing_rounding(int i, const Real& flight) const {
  using std::abs;
  const MetStop& s = stop(i);
  const Real time = now_.instant.local + flight;
  const Real size =
      now_.q.norm() + departure_.q.norm() + time * (now_.qdot.norm() + departure_.qdot.norm());
  return kAuditAmplification * std::numeric_limits<Real>::epsilon() *
         (abs(s.gap) + s.row.norm() * size);
}

// The same for the displacement by the forces, and for the forced displacement that free motion may
// cancel.
template <class Real>
Real Motion<Real>::pushing_rounding(int i, const Real& flight) const {
  const Real time = now_.instant.local + flight;
  RealVector<Real> size;
  free_acceleration(&size);
  const Real forced = system_.forcing() ? still_gap(system_) : 0.0;
  return forced + kAuditAmplification * std::numeric_limits<Real>::epsilon() * stop(i).row.norm() *
                      time * time * size.norm();
}

// After a flight, before the event at its end is decided. Motions integrated by the scene's steps
// are only checked at the ends of steps.
template <class Real>
void Motion<Real>::audit_gaps(const Real& flight) {
  if (steps_) return;
  for (const int i : looked_at_) {
    const Contact now = contact(i);
    const bool is_beyond = now == Contact::kCompressed || now == Contact::kParted;
    // A spring whose surface is touched at rest acts once that is passed.
    const bool is_resting = now == Contact::kLocked && multiplicity(i) > 0;
    if (stop(i).is_compliant() ? is_beyond || is_resting : is_held(i)) continue;
    const Real gap = this->gap(i);
    if (!(gap < 0)) continue;
    const Real before = stop(i).gap - stop(i).row.dot(departure_.q);
    const Real rounding = passing_rounding(i, flight);
    if (!passes(before, gap, rounding)) continue;
    if (passes<Real>(before, gap, rounding + pushing_rounding(i, flight))) {
      return fail_audit(i, fmt::format("its gap became {:.3g}{} without a contact",
                                       static_cast<double>(gap), unit_behind(system_.units, "m")));
    }
  }
}

// After an event, before the next flight.
template <class Real>
void Motion<Real>::audit_forces() {
  using std::abs;
  constexpr double kRoundings = kAuditAmplification * std::numeric_limits<double>::epsilon();
  for (const int i : compliant_) {
    if (contact(i) != Contact::kCompressed || !stop(i).force().parts_early()) continue;
    const double x = static_cast<double>(depth(i)), v = static_cast<double>(approach_speed(i));
    const ContactForce& law = stop(i).force();
    if (!(law.grip(x, v) < 0.0) || !(x > 0.0)) continue;
    const double push =
        static_cast<double>(stop(i).row.cwiseAbs().dot(free_acceleration().cwiseAbs()));
    const double moved = static_cast<double>(now_.instant.local) * abs(law.grip_rate(x, v, push));
    if (law.grip(x, v) < -kRoundings * (law.grip_size(x, v) + moved))
      return fail_audit(i, fmt::format("its spring pulls with {:.3g}{}", -law.at(x, v),
                                       unit_behind(system_.units, "N")));
  }
  const std::vector<int> held = closed();
  for (const int i : held) {
    if (!(force(i) < 0)) continue;
    if (pulls())
      return fail_audit(i,
                        fmt::format("its contact force is {:.3g}{}", static_cast<double>(force(i)),
                                    unit_behind(system_.units, "N")));
  }
}

// Whether one of the closed stops pulls, beyond the rounding of the forces that they share with
// what sticks.
template <class Real>
bool Motion<Real>::pulls() const {
  const std::vector<int> held = this->held();
  RealVector<Real> size;
  const RealVector<Real> acceleration = free_acceleration(&size);
  if (vanished_ > 0) size += located_size();
  const auto k = static_cast<Eigen::Index>(held.size());
  RealVector<Real> push(k), rounding(k);
  // The instant is rounded too, and forces change within that rounding.
  const Real located = 1 + quickest_rate() * now_.instant.local;
  for (Eigen::Index a = 0; a < k; ++a) {
    const RealVector<Real>& row = stop(held[static_cast<std::size_t>(a)]).row;
    push[a] = row.dot(acceleration);
    rounding[a] = kAuditAmplification * std::numeric_limits<Real>::epsilon() * located *
                  row.cwiseAbs().dot(size);
  }
  const Matrix_ sharing = PivotedLu<Real>(pressing(held)).inverse();
  const auto stops = static_cast<Eigen::Index>(closed().size());
  const RealVector<Real> most =
      image<Real>(sharing, push) + image<Real>(sharing.cwiseAbs(), rounding);
  return (most.head(stops).array() < 0).any();
}

// q'.M q', twice the kinetic energy.
template <class Real>
Real Motion<Real>::kinetic_square() const {
  const Real square = now_.qdot.squaredNorm();
  if (!turning_) return square;
  const Real rate = hub_rate(now_.qdot);
  return square +
         Real(added_inertia(*system_.rotation(), now_.q.template cast<double>())) * rate * rate;
}

// Checks the impact in shares_; `before`: kinetic_square() before it.
template <class Real>
void Motion<Real>::audit_impact(const Real& before) {
  using std::sqrt;
  const Real after = kinetic_square();
  if (!(after > before)) return;
  // Impulses that cancel have a rounding each.
  Real size = sqrt(before);
  std::optional<Real> restitution;
  for (const ImpactShare<Real>& share : shares_) {
    const MetStop& s = stop(share.stop);
    if (!(share.impulse > 0)) continue;
    if (!turning_ && !(s.norm2 > 0)) return;
    size += share.impulse * s.direction.norm();
    if (!share.hit) continue;
    const Real r = s.restitution().at(share.speed);
    if (restitution && r != *restitution) return;
    restitution = r;
  }
  if (adds_energy(before, after, size, now_.q.size()))
    fail_audit(shares_.front().stop, fmt::format("an impact added {:.3g}{} of kinetic energy",
                                                 static_cast<double>((after - before) / 2),
                                                 unit_behind(system_.units, "J")));
}

}  // namespace graze
