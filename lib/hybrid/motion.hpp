// The hybrid motion, one certified arc at a time.
//
//   x- -> [contact at stop i: row.q = gap, v = row.q' > 0] -> q'+ = q'- - (1 + r) d v -> x+
//
// A contact happens at the first instant at which the gap reaches zero; the stop belongs to the
// arc that ends there, its departure to the next one, which starts from the known zero.
#pragma once

#include <vector>

#include "graze/flow/gap_curve.hpp"

namespace graze {

enum class ArrivalKind {
  kTime,       // the end of the flight was reached
  kContact,    // at a stop, approaching: `impact` is due
  kTouch,      // at a stop within rounding, not approaching: no impact; fly on
  kRest,       // on a stop, at rest and pushed against it
  kUndecided,  // the search for a contact used up its evaluations
  kNotFinite   // the state left the range of the scalar
};

template <class Real>
struct Arrival {
  ArrivalKind kind = ArrivalKind::kTime;
  int stop = -1;
  Real flight = 0;  // s, length of the arc
  Real speed = 0;   // m/s, approach speed at a contact
};

template <class Real>
class Motion {
 public:
  // `system` is copied into the exact flow. Starts at `instant` with the given state; a stop whose
  // gap is zero within rounding counts as touched.
  Motion(const System& system, const Instant<Real>& instant, const RealVector<Real>& q,
         const RealVector<Real>& qdot);
  Motion(const Motion&) = delete;  // the arc refers to the flow beside it
  Motion& operator=(const Motion&) = delete;

  // Flies from the present instant to the first contact, at most up to `until` (seconds on the
  // local clock, not beyond the period's end), and moves there.
  Arrival<Real> fly(const Real& until);

  // Applies the impulse of stop `stop` to the present velocities.
  void impact(int stop);

  const Instant<Real>& instant() const { return instant_; }
  const RealVector<Real>& q() const { return q_; }
  const RealVector<Real>& qdot() const { return qdot_; }
  const ExactFlow<Real>& flow() const { return flow_; }
  // The arc flown last, from its own start.
  const Arc<Real>& arc() const { return arc_; }
  // The gap at a stop along the arc that starts now, for `window` seconds.
  GapCurve<Real> gap_ahead(int stop, const Real& window);
  // gap - row.q at the present instant.
  Real gap(int stop) const;
  // Approach speed row.q' at the present instant.
  Real approach_speed(int stop) const;

 private:
  enum class Contact { kClear, kTouching, kDeparting };
  struct Stop {
    RealVector<Real> row, direction;
    Real gap = 0, restitution = 0;
    Contact contact = Contact::kClear;
  };

  bool touches(const Stop& stop) const;
  void move(const Real& flight, const Real& until);
  void settle_on(const Stop& stop);

  ExactFlow<Real> flow_;
  Arc<Real> arc_;
  std::vector<Stop> stops_;
  Instant<Real> instant_;
  RealVector<Real> q_, qdot_;
};

}  // namespace graze
