// Phases in closed form: the first events lie at zeros of curves with bounds (first_zero.hpp).
#pragma once

#include <memory>
#include <vector>

#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/flow/exact/detail/first_zero.hpp"
#include "graze/flow/held/detail/constrained_structure.hpp"
#include "graze/flow/held/detail/coupled_flow.hpp"
#include "graze/flow/held/detail/flight_search.hpp"

namespace graze {

template <class Real>
class ExactPhase : public ContactPhase<Real> {
 public:
  using ContactPhase<Real>::start;
  // `structure` is that of the closed stops of the key.
  ExactPhase(const System& system, PhaseKey key, ConstrainedStructure<Real> structure);
  // With given observables of every stop and friction, instead of the structure's own.
  ExactPhase(const System& system, PhaseKey key, ConstrainedStructure<Real> structure,
             std::vector<Observable<Real>> observables);

  const ConstrainedStructure<Real>& structure() const { return structure_; }
  const std::vector<Observable<Real>>& observables() const { return observables_; }
  // The gap of an open stop along the arc, or how fast dry friction slides, for `window` seconds;
  // `from_zero`: it starts on the stop, or at rest. The reference is valid until the arc ends, or
  // the gap is asked for with another window.
  const ArcCurve<Real>& gap(int stop, const Real& window, bool from_zero) const;
  // The contact force of a closed stop, N (in units of the modal mass); any observable of the
  // structure's coordinates y and y'.
  ArcCurve<Real> force(int stop, const Real& window) const {
    return curve(observables_[static_cast<std::size_t>(stop)], window);
  }
  ArcCurve<Real> curve(const Observable<Real>& observable, const Real& window) const;
  // The reduced motion as one of two: in real modes, or in modes that do not decouple.
  virtual const Arc<Real>* arc() const { return nullptr; }
  virtual const CoupledArc* coupled_arc() const { return nullptr; }

  Arrival<Real> first_event(const MotionState<Real>& now, const Flight<Real>& flight) override;
  CurvePoint<Real> gap_rate(int stop, int order) const override;
  Real force_at(int stop, const Real& s, const RealVector<Real>& q,
                const RealVector<Real>& qdot) const override;
  Real force_rate(int stop) const override;
  bool sees_ahead() const override { return true; }
  CurvePoint<Real> outlook(int stop, int order, const Real& ahead) const override;
  bool stays_quiet(int stop, const Real& duration) const override;
  const ExactPhase* exact() const override { return this; }

 protected:
  void forget_curves();
  // Up to which a friction sticks, N, where that depends on the motion.
  void limit_friction(std::size_t friction, Observable<Real> limit) {
    limits_[friction] = std::move(limit);
  }

 private:
  struct Slip {
    FirstZero<Real> zero;
    bool forward = false;
  };
  // The first slip of a friction that sticks. `came`: kCameForward or kCameBackward where it exerts
  // all that it can at the start, and less from then on.
  Slip first_slip(int friction, const Real& window, int came, const Flight<Real>* flight) const;
  // Sets the curve to that of this observable; returns whether its terms do not depend on the
  // window.
  virtual bool set_curve(ArcCurve<Real>& curve, const Observable<Real>& observable,
                         const Real& window, bool from_zero) const = 0;
  virtual Real start_phase() const = 0;

  ConstrainedStructure<Real> structure_;
  // Of every stop, the gap, or the contact force where closed; of every friction how fast it
  // slides, or the force where it sticks, and its limit, N.
  std::vector<Observable<Real>> observables_, limits_;
  struct KeptCurve {
    bool known = false, from_zero = false;
    ArcCurve<Real> curve;
  };
  mutable std::vector<KeptCurve> kept_;  // the gaps of this arc
};

template <class Real>
class FreePhase final : public ExactPhase<Real> {
 public:
  FreePhase(const System& system, PhaseKey key);

  void start(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot,
             const Real& time) override;
  void state(const Real& s, RealVector<Real>& q, RealVector<Real>& qdot) const override;
  const Arc<Real>* arc() const override { return &arc_; }
  Arrival<Real> first_event(const MotionState<Real>& now, const Flight<Real>& flight) override;

 private:
  bool set_curve(ArcCurve<Real>& curve, const Observable<Real>& observable, const Real& window,
                 bool from_zero) const override;
  Real start_phase() const override { return arc_.start_phase(); }

  ExactFlow<Real> flow_;
  Arc<Real> arc_;
  std::unique_ptr<FlightSearch> search_;  // of many modes; else null
};

template <class Real>
class ConstrainedPhase final : public ExactPhase<Real> {
 public:
  ConstrainedPhase(const System& system, PhaseKey key, ConstrainedStructure<Real> structure);

  // Not empty where the held structure has no real modes.
  std::string refusal() const override;
  void start(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot,
             const Real& time) override;
  void state(const Real& s, RealVector<Real>& q, RealVector<Real>& qdot) const override;
  const Arc<Real>* arc() const override { return &arc_; }

 private:
  bool set_curve(ArcCurve<Real>& curve, const Observable<Real>& observable, const Real& window,
                 bool from_zero) const override;
  Real start_phase() const override { return arc_.start_phase(); }

  ExactFlow<Real> flow_;
  Arc<Real> arc_;
};

}  // namespace graze
