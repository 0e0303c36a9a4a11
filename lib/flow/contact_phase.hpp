// A contact phase: the smooth motion while a given set of stops is closed (none: free flight).
//
// Closed stops keep b_i.q = a_i by accelerations -d_i lambda_i along the directions of their
// impulses:
//
//   q'' = P (g - 2 delta q' - w^2 q),  P = I - D (B^T D)^-1 B^T,
//   lambda = (B^T D)^-1 B^T (g - 2 delta q' - w^2 q),   contact force = lambda_i/(b_i.b_i).
//
// This is again a linear system, on the reduced coordinates y of q = q_c + U y with B^T U = 0. For
// the momentum law and proportional damping (equal decay rates or Rayleigh's) it decouples into
// real modes, those of the structure held at its stops, and everything that holds in free flight
// holds here; otherwise see coupled_flow.hpp (double only).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graze/flow/arc_curve.hpp"
#include "graze/flow/coupled_flow.hpp"
#include "graze/flow/step_flow.hpp"
#include "graze/flow/step_setting.hpp"

namespace graze {

template <class Real>
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

// The springs that the structure compresses: those whose force acts, and those whose force is gone
// before the structure has left them. Indices of stops, ascending.
struct PhaseSprings {
  std::vector<int> loaded, parted;
  bool empty() const { return loaded.empty() && parted.empty(); }
  auto operator<=>(const PhaseSprings&) const = default;
};

// Of a step where the motion has no closed form, against the speed of the contact
// (sprung_rates.hpp), or of the structure that turns. A contact costs some thousand evaluations and
// gives the speed away to 3e-13; over some ten thousand steps the energy keeps ten digits.
inline constexpr double kStepTolerance = 1e-14;

template <class Real>
class ContactPhase {
 public:
  // `closed`: indices of stops with linearly independent rows. `steps`: the motion is integrated
  // step by step (double only); absent: it is exact.
  // `springs`: they are integrated step by step in any case (double only).
  // `joint`: of a hub with friction, and its angle where it is held, rad.
  ContactPhase(const System& system, const std::vector<int>& closed,
               const std::optional<StepSetting>& steps = {}, const PhaseSprings& springs = {},
               Joint joint = Joint::kFree, double angle = 0.0);
  ContactPhase(const ContactPhase&) = delete;  // the arc refers to the flow beside it
  ContactPhase& operator=(const ContactPhase&) = delete;

  // Why the phase cannot be followed, or empty: its constrained motion grows without bound (an
  // oblique law can do that), or has no real modes and the scalar is not double.
  const std::string& refusal() const { return refusal_; }
  const std::vector<int>& closed() const { return closed_; }
  const PhaseSprings& springs() const { return springs_; }
  // At the next start, m: of the loaded springs, then of the parted ones.
  void set_depths(const std::vector<double>& depths) { depths_ = depths; }
  // And, s, of a structure that turns.
  void set_time(double time) { time_ = time; }
  // Flights are to be cut to this, s; infinite but for matrix exponentials, and for a torque that
  // is smooth no longer.
  Real longest_flight() const;

  void start(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot);
  // Displacements and velocities s seconds after the start.
  void state(const Real& s, RealVector<Real>& q, RealVector<Real>& qdot) const;
  // The gap of an open stop along the arc, for `window` seconds; `from_zero`: it starts on the
  // stop.
  ArcCurve<Real> gap(int stop, const Real& window, bool from_zero) const;
  // The same, kept until the arc ends; its window is set anew.
  const ArcCurve<Real>& gap_along(int stop, const Real& window, bool from_zero);
  // The contact force of a closed stop, N (in units of the modal mass).
  ArcCurve<Real> force(int stop, const Real& window) const;
  // The flow that steps along, if one does, and what it watches for at a stop that is open or
  // closed: the curve is the exact one at the start of the arc.
  StepFlow* step_flow() const { return step_flow_.get(); }
  // On springs: the equations that it integrates, and the depths at the start of the arc, m.
  const SprungSystem& sprung() const { return *sprung_; }
  const std::vector<double>& depths() const { return depths_; }
  const Watch& watch(int stop, int multiplicity);
  // What it watches for at its springs, counted as set_depths() does: the depth, which starts from
  // this departure where that is a zero (watch()); the grip, or the lack of it, which may start
  // from a zero too.
  const Watch& depth_watch(std::size_t spring, int multiplicity, double departure);
  const Watch& grip_watch(std::size_t spring, int multiplicity);
  // And at a joint with friction that turns: its rate in the direction in which it does, until it
  // stands still; that is held: what is left of the friction against being turned forward and back.
  // Starting from rest, the joint leaves it as told: see watch().
  const std::vector<Watch>& joint_watches(int multiplicity, double departure);
  // The torque of a joint that is held, at the start, N m: what turns it is positive.
  double joint_torque_at_start() const;
  // Acceleration of the hub at the start, rad/s^2, its rounding, and its rate.
  CurvePoint<double> hub_acceleration_at_start() const;
  // The force of a closed stop at a state, s seconds after the start.
  Real force_at(int stop, const Real& s, const RealVector<Real>& q,
                const RealVector<Real>& qdot) const;
  // At the start of the arc, a derivative of the gap of an open stop with its rounding; order 1..3.
  CurvePoint<Real> gap_rate(int stop, int order);
  // Of a closed stop of a structure that turns, N/s.
  double force_rate_at_start(int stop) const;
  // Of a structure that turns: no curve is known of it ahead.
  bool turns() const { return sprung_ && sprung_->turning; }

  // Forcing phase at the start of the arc, rad.
  Real start_phase() const;
  // The reduced motion, for what integrates over it.
  bool has_real_modes() const { return !coupled_flow_; }
  const Arc<Real>& arc() const { return *arc_; }
  const CoupledArc& coupled_arc() const { return *coupled_arc_; }
  const RealMatrix<Real>& basis() const { return basis_; }  // U, N x m
  const LinearSystem<Real>& reduced() const { return reduced_; }
  // Gap of an open stop or contact force of a closed one, on the reduced coordinates.
  const Observable<Real>& observable(int stop) const {
    return observables_[static_cast<std::size_t>(stop)];
  }

 private:
  void reduce(const System& system, const LinearSystem<Real>& full);
  // `stretched`: w U.
  RealVector<Real> balance(const LinearSystem<Real>& full, const RealMatrix<Real>& stretched);
  // `normal`: impulses act along the rows.
  void couple(const LinearSystem<Real>& full, const RealMatrix<Real>& stretched, bool normal);
  Observable<Real> force_observable(const LinearSystem<Real>& full, const RealVector<Real>& share,
                                    const Real& unit) const;
  Observable<Real> reduced_observable(const Observable<Real>& full) const;
  ArcCurve<Real> curve(const Observable<Real>& observable, const Real& window,
                       bool from_zero) const;
  RealVector<Real> reduced_coordinates(const RealVector<Real>& q) const;
  void step_by(const StepSetting& setting);
  void spring_by(const System& system, const std::optional<StepSetting>& steps);
  SprungSystem sprung_system(const System& system) const;
  Turning turning(const System& system) const;
  // Where springs act or the structure turns: of a closed stop, N.
  double sprung_force_at(int stop, double s, const Vector& q, const Vector& qdot) const;
  // By loaded springs, on all coordinates, N, and at the start its rate, N/s.
  Vector spring_push(const Vector& q, const Vector& qdot) const;
  Vector spring_push_rate(const Vector& acceleration) const;
  CurvePoint<Real> turning_gap_rate(int stop, int order) const;
  void add_powers(const System& system, SprungSystem& sprung) const;
  void add_watches(const Vector& scale);
  void start_steps(double theta, const Vector& q, const Vector& qdot);
  void step_state(double s, Vector& q, Vector& qdot) const;

  System with_joint_held(const System& system, double angle) const;
  void watch_joint(double friction);
  struct AtStart {
    Vector force, acceleration, force_rate, jerk;
  };
  AtStart at_start() const;

  std::vector<int> closed_;
  std::vector<int> holds_;  // these and, after all stops, a joint that is held
  PhaseSprings springs_;
  std::vector<double> depths_;
  double time_ = 0.0;
  Vector start_q_, start_qdot_;     // of a structure that turns
  std::vector<Vector> whole_rows_;  // b of every stop where springs act or the structure turns
  std::vector<double> gaps_;        // beside them, m
  std::string refusal_;
  RealMatrix<Real> rows_, directions_;  // B, D: N x closed
  RealVector<Real> held_;               // q_c; empty in free flight
  RealMatrix<Real> basis_;              // U
  LinearSystem<Real> reduced_;
  std::vector<Observable<Real>> observables_;  // of every stop: gap, or contact force where closed
  std::optional<ExactFlow<Real>> flow_;
  std::optional<Arc<Real>> arc_;
  struct KeptCurve {
    bool known = false, from_zero = false;
    ArcCurve<Real> curve;
  };
  std::vector<KeptCurve> kept_;  // of every stop, on this arc
  std::unique_ptr<CoupledFlow> coupled_flow_;
  std::optional<CoupledArc> coupled_arc_;
  std::optional<SprungSystem> sprung_;
  std::unique_ptr<StepFlow> step_flow_;
  Vector step_scale_;                                // of the displacements, beside it
  std::vector<Watch> watches_;                       // of every stop, beside it
  std::vector<Watch> depth_watches_, grip_watches_;  // of every spring
  Joint joint_ = Joint::kFree;
  std::vector<Watch> joint_watches_;
  RealMatrix<Real> shares_;  // of the closed stops in a free acceleration, N x closed
  RealMatrix<Real> left_;    // left inverse of U that knows nothing of oblique directions; or empty
};

}  // namespace graze
