// A contact phase: the smooth motion while the same stops are closed and the same springs
// compressed (none of either: free flight), up to the first event that ends it.
//
// Eight of them stand behind this contract, chosen once for each phase (phase_choice.hpp):
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
// In 50 digits there are the first two, which have nothing but closed forms.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/exact/detail/arrival.hpp"

namespace graze {

// The springs that the structure compresses: those whose force acts, those whose force is gone
// before the structure has left them, and those at whose surface it rests though something moves it
// there, by how much and to which side no derivative tells yet: they press where it gets beyond.
// Indices of stops, ascending.
struct PhaseSprings {
  std::vector<int> loaded, parted, resting{};
  bool empty() const { return loaded.empty() && parted.empty() && resting.empty(); }
  // In the order in which phases have them.
  std::vector<int> all() const {
    std::vector<int> list = loaded;
    list.insert(list.end(), parted.begin(), parted.end());
    list.insert(list.end(), resting.begin(), resting.end());
    return list;
  }
  auto operator<=>(const PhaseSprings&) const = default;
};

// What makes a phase what it is.
struct PhaseKey {
  std::vector<int> closed;  // indices of stops with linearly independent rows
  PhaseSprings springs{};
  Joint joint = Joint::kFree;  // of a hub with friction
  // Beside springs: rigid stops, closed or open, of which no derivative tells how the contact force
  // or the gap leaves zero.
  std::vector<int> untold{};
  auto operator<=>(const PhaseKey&) const = default;
};

// What a flight is asked for.
template <class Real>
struct Flight {
  Real until = 0, horizon = 0;   // s from its start: nobody asks beyond `until`; the search goes
                                 // up to `horizon` >= until
  std::span<const int> order{};  // in which stops are looked at
  const StopSignal& stop;        // asked now and then
  double told_depth = 0.0;       // m, see StepFlow::deepest
  // Of every stop, up to when it is known to stay on its side of the surface, s; empty: of none.
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
  // Why it cannot be followed, or empty: the motion that is held grows without bound (an oblique
  // law can do that), or has no real modes and the scalar is not double.
  virtual std::string refusal() const { return {}; }

  // An arc begins: the state at forcing phase theta; s counts from here. `time`: of the instant on
  // its clock, s, which a torque on a hub goes by.
  virtual void start(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot,
                     const Real& time) = 0;
  void start(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot) {
    start(theta, q, qdot, Real(0));
  }
  // Displacements and velocities s seconds after the start.
  virtual void state(const Real& s, RealVector<Real>& q, RealVector<Real>& qdot) const = 0;
  // The first event of the arc, which starts at `now`; kTime at the end of the horizon, or where a
  // flight is to be cut, if there is none.
  virtual Arrival<Real> first_event(const MotionState<Real>& now, const Flight<Real>& flight) = 0;

  // At the start of the arc, a derivative of the gap of an open stop with its slope and rounding;
  // order 1..3.
  virtual CurvePoint<Real> gap_rate(int stop, int order) const = 0;
  // The contact force of a closed stop at a state s seconds after the start, and its rate at the
  // start; N, N/s in units of the modal mass.
  virtual Real force_at(int stop, const Real& s, const RealVector<Real>& q,
                        const RealVector<Real>& qdot) const = 0;
  virtual Real force_rate(int stop) const = 0;
  // What of a contact force may be an error where the last search ended because one of them was
  // told (Arrival::told), N in units of the modal mass.
  virtual Real force_error(int /*stop*/) const { return 0; }
  // Whether the motion is known ahead, with bounds; what follows is asked for only then.
  virtual bool sees_ahead() const { return false; }
  // At the start of the arc, a derivative of the gap of an open stop, which the structure is on, or
  // of the contact force of a closed one; its bounds hold for so many seconds.
  virtual CurvePoint<Real> outlook(int /*stop*/, int /*order*/, const Real& /*ahead*/) const {
    return {};
  }
  // Whether an open stop is not met in that time, a closed one not released.
  virtual bool stays_quiet(int /*stop*/, const Real& /*duration*/) const { return false; }
  // Of the right-hand side of the equations of motion, where they are integrated.
  virtual long long evaluations() const { return 0; }

  // The closed form of the arc; null where it has none.
  virtual const ExactPhase<Real>* exact() const { return nullptr; }
  // Of compressed springs, and of a structure on a hub; null where nothing of that is there.
  virtual const SpringArc* sprung() const { return nullptr; }
  // What follows it by power series; null where that is something else.
  virtual const SeriesPhase* series() const { return nullptr; }
  // What integrates it step by step; null where its closed form is the motion.
  virtual StepFlow* stepped() const { return nullptr; }

 protected:
  // Flights are to be cut to this, s; infinite but for matrix exponentials, and for a torque that
  // is smooth no longer.
  virtual Real longest_flight() const { return std::numeric_limits<Real>::infinity(); }

 private:
  PhaseKey key_;
};

}  // namespace graze
