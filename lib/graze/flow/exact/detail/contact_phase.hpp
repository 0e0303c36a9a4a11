// A contact phase: the smooth motion while the same stops are closed and the same springs
// compressed (none of either: free flight), up to the first event that ends it.
//
// Eight classes implement this contract, chosen once for each phase (phase_choice.hpp):
//
//   FreePhase         nothing holds the structure: its modes in closed form    exact_phase.hpp
//   ConstrainedPhase  closed stops hold it, and it has real modes there        exact_phase.hpp
//   CoupledPhase      the same where oblique laws or damping couple its modes  coupled_phase.hpp
//   SeriesPhase       closed stops hold many modes                             series_phase.hpp
//   SteppedPhase      any of these, integrated step by step instead            stepped_phase.hpp
//   LinearSpringPhase linear springs are compressed                     linear_spring_phase.hpp
//   SprungPhase       springs of any kind are                                  sprung_phase.hpp
//   TurningPhase      the structure turns on a hub, with springs or without    turning_phase.hpp
//
// In 50 digits there are only the first two, which use closed forms alone.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/exact/motion_state.hpp"

namespace graze {

// How a flight ends: the event that a phase reports to the code that decides on the next phase.
enum class ArrivalKind {
  kTime,        // the end of the flight was reached
  kContact,     // at a stop, approaching: `impact` is due
  kTouch,       // at a stop within rounding, not approaching: no impact; fly on
  kStick,       // at rest on a stop and pushed: it is closed from now on
  kRelease,     // the contact force of a closed stop is gone: it is open from now on
  kEntry,       // a spring is compressed from now on
  kSeparation,  // the force of a compressed spring is gone
  kLeft,        // the surface of a stop whose force was gone before
  kJoint,       // a hub's joint with friction stands still, or is turned again
  kStandstill,  // dry friction that slid is at rest, and not yet decided
  kSlip,        // dry friction that stuck slides from now on
  kReversal,    // dry friction slides the other way
  kUndecided,   // the search for an event used up its evaluations
  kNotFinite,   // the state left the range of the scalar
  kRefused      // the motion on the stop cannot be followed; see refusal()
};

template <class Real>
struct Arrival {
  ArrivalKind kind = ArrivalKind::kTime;
  int stop = -1;              // -1: the event, or what is refused, is at none
  Real flight = 0;            // s, length of the arc
  Real speed = 0;             // m/s, approach speed at a contact
  long long evaluations = 0;  // of gaps and contact forces, in search of the event
  // Smallest gap or contact force at the ends of the steps of a motion that is integrated.
  std::optional<Real> lowest{};
  // Separation: the force is gone below the surface of the stop, which is left later.
  bool below = false;
  bool forward = false;  // joint, slip: what the friction held moves it forward
  // For a spring whose surface the structure was touching at rest: it is entered, or left, from the
  // start of the arc on, and certain for at least this long, s.
  Real sure = 0;
  // The sign of a contact force that was zero at the start is certain `sure` seconds after it.
  bool told = false;

  // Whether the motion does not go on.
  bool fails() const {
    return kind == ArrivalKind::kUndecided || kind == ArrivalKind::kNotFinite ||
           kind == ArrivalKind::kRefused;
  }
};

// The springs that take part, indices of stops, ascending. `loaded`: their force acts. `parted`:
// their force is gone before the structure has left them. `resting`: the structure rests at their
// surface and will move, but no derivative shows to which side; they act once the surface is
// passed.
struct PhaseSprings {
  std::vector<int> loaded, parted, resting{};
  bool empty() const { return loaded.empty() && parted.empty() && resting.empty(); }
  // All of them in the order in which phases store them.
  std::vector<int> all() const {
    std::vector<int> list = loaded;
    list.insert(list.end(), parted.begin(), parted.end());
    list.insert(list.end(), resting.begin(), resting.end());
    return list;
  }
  auto operator<=>(const PhaseSprings&) const = default;
};

// What identifies a phase.
struct PhaseKey {
  std::vector<int> closed;  // indices of stops and frictions with linearly independent rows
  PhaseSprings springs{};
  Joint joint = Joint::kFree;  // of a hub with friction
  // Rigid stops beside springs, closed or open, whose contact force or gap leaves zero in a way
  // that no derivative shows.
  std::vector<int> untold{};
  // Of every dry friction, kForward, kBackward or kClosed; of those among `closed` where they
  // stick, row.q in m.
  std::vector<Contact> frictions{};
  std::vector<double> places{};
  auto operator<=>(const PhaseKey&) const = default;
};

// The limits and options of one flight.
template <class Real>
struct Flight {
  Real until = 0, horizon = 0;   // s from its start: nobody asks beyond `until`; the search goes
                                 // up to `horizon` >= until
  std::span<const int> order{};  // in which stops are looked at
  const StopSignal& stop;        // asked now and then
  double told_depth = 0.0;       // m, see StepFlow::deepest
  // For every stop, s, up to when its gap or force is known to stay positive; empty: not known.
  std::span<const Real> sure{};
  Real sure_of(int i) const { return sure.empty() ? Real(0) : sure[static_cast<std::size_t>(i)]; }
};

template <class Real>
class ExactPhase;
class SeriesPhase;
struct SpringArc;
class StepFlow;

template <class Real>
class ContactPhase {
 public:
  explicit ContactPhase(PhaseKey key) : key_(std::move(key)) {}
  virtual ~ContactPhase() = default;
  ContactPhase(const ContactPhase&) = delete;  // its arc refers to the flow beside it
  ContactPhase& operator=(const ContactPhase&) = delete;

  const PhaseKey& key() const { return key_; }
  const std::vector<int>& closed() const { return key_.closed; }
  const PhaseSprings& springs() const { return key_.springs; }
  // Why the phase cannot be followed, or empty: the held motion grows without bound (possible with
  // an oblique law), or has no real modes and the scalar is not double.
  virtual std::string refusal() const { return {}; }

  // Starts an arc at the state and forcing phase theta; s counts from here. `time`: of that
  // instant, s, for the torque on a hub.
  virtual void start(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot,
                     const Real& time) = 0;
  void start(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot) {
    start(theta, q, qdot, Real(0));
  }
  // Displacements and velocities s seconds after the start.
  virtual void state(const Real& s, RealVector<Real>& q, RealVector<Real>& qdot) const = 0;
  // The first event of the arc, which starts at `now`; kTime when there is none up to the horizon,
  // or up to where the flight has to be cut.
  virtual Arrival<Real> first_event(const MotionState<Real>& now, const Flight<Real>& flight) = 0;

  // At the start of the arc, a derivative of the gap of an open stop with its slope and rounding;
  // order 1..3.
  virtual CurvePoint<Real> gap_rate(int stop, int order) const = 0;
  // The contact force of a closed stop at a state s seconds after the start, and its rate at the
  // start; N, N/s in units of the modal mass.
  virtual Real force_at(int stop, const Real& s, const RealVector<Real>& q,
                        const RealVector<Real>& qdot) const = 0;
  virtual Real force_rate(int stop) const = 0;
  // Error bound of a contact force, N in units of the modal mass, where the last search ended
  // because the sign of one of them became certain (Arrival::told).
  virtual Real force_error(int /*stop*/) const { return 0; }
  // Whether the motion is known ahead, with bounds; outlook() and stays_quiet() require it.
  virtual bool sees_ahead() const { return false; }
  // At the start of the arc, a derivative of the gap of an open stop that the structure touches, or
  // of the contact force of a closed one; its bounds hold for `ahead` seconds.
  virtual CurvePoint<Real> outlook(int /*stop*/, int /*order*/, const Real& /*ahead*/) const {
    return {};
  }
  // Whether an open stop is not met in that time, or a closed one not released.
  virtual bool stays_quiet(int /*stop*/, const Real& /*duration*/) const { return false; }
  // Number of evaluations of the equations of motion, where they are integrated.
  virtual long long evaluations() const { return 0; }

  // The closed form of the arc; null where it has none.
  virtual const ExactPhase<Real>* exact() const { return nullptr; }
  // The motion on compressed springs or on a hub; null for others.
  virtual const SpringArc* sprung() const { return nullptr; }
  // The phase itself where it uses power series; null for others.
  virtual const SeriesPhase* series() const { return nullptr; }
  // Its integrator; null where the closed form is used.
  virtual StepFlow* stepped() const { return nullptr; }

  // Longest flight without a cut, s; finite only with matrix exponentials, and with a torque up to
  // its next jump or kink.
  virtual Real longest_flight() const { return std::numeric_limits<Real>::infinity(); }

 private:
  PhaseKey key_;
};

}  // namespace graze
