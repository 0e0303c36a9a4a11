// The exact motion of the linear modal system between events.
//
// Each mode is a free part, written in the form that suits its damping, and a forced part p_j =
// Re(P_j e^{i theta}), P_j = f_j/(w_j^2 - W^2 + 2 i delta_j W):
//   - oscillatory:    Re(Z e^{(-delta + i wd) s}) + p
//   - overdamped:     A e^{-slow s} + B e^{-fast s} + p
//   - near critical:  the basis of free_basis.hpp + p (also a free mass, w = 0)
//   - from rest:      P_j is large against the motion and cancels it: at resonance, or where mode
//                     and forcing are slow against the motion between impacts. The free part is the
//                     motion's own start, and the response to the force from rest is added, in a
//                     form that holds down to zero detuning, damping, frequency (forced_response).
// A constant load c_j moves the rest position to c_j/w_j^2; where that is far beyond the stops (a
// free mass, w = 0, or nearly one), or no stops give a length to compare with, its response from
// rest is added. A template on the scalar: double, and an extended type for references.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "graze/flow/exact/detail/mode_flow.hpp"
#include "graze/flow/exact/instant.hpp"
#include "graze/system/system.hpp"

namespace graze {

// The smooth part of a system in the scalar of the flow.
template <class Real>
struct LinearSystem {
  RealVector<Real> omega, delta;  // rad/s, 1/s
  bool forced = false, repeats = true;
  Real frequency = 0, phase = 0;  // rad/s, rad; with forcing
  RealVector<Real> amplitude;     // f_j, with forcing
  RealVector<Real> load;          // c_j; empty: none
  // How far the modes move between stops, in their own coordinates: the largest |gap|/|row|, m
  // sqrt(kg); 0 where all gaps are 0, infinite without stops.
  Real reach = 0;
  RealMatrix<Real> coupling{};  // beside delta (NaturalModes), 1/s; empty: none
  std::vector<Harmonic> harmonics{};  // of the force, beside the first

  // The harmonic force on mode j where the first harmonic has this cosine, and a bound on its size.
  Real force(Eigen::Index j, const Real& cosine, const Real& theta) const {
    using std::cos, std::sin;
    if (!forced) return 0;
    Real sum = amplitude[j] * cosine;
    for (const Harmonic& one : harmonics) {
      if (one.timed) {
        sum += one.cosine[j] * one.wave(static_cast<double>(theta));
        continue;
      }
      const Real angle = one.order * theta;
      sum += one.cosine[j] * cos(angle) + one.sine[j] * sin(angle);
    }
    return sum;
  }
  Real force_size(Eigen::Index j) const {
    using std::abs;
    if (!forced) return 0;
    Real sum = abs(amplitude[j]);
    for (const Harmonic& one : harmonics)
      sum += one.largest_wave() * (std::abs(one.cosine[j]) + std::abs(one.sine[j]));
    return sum;
  }
  // The same of all modes, with its derivative by theta.
  RealVector<Real> forces(const Real& theta) const {
    using std::cos, std::sin;
    RealVector<Real> sum = amplitude * cos(theta);
    for (const Harmonic& one : harmonics)
      sum += one.timed ? RealVector<Real>(one.at(static_cast<double>(theta)).template cast<Real>())
                       : RealVector<Real>(
                             one.cosine.template cast<Real>() * cos(Real(one.order * theta)) +
                             one.sine.template cast<Real>() * sin(Real(one.order * theta)));
    return sum;
  }
  RealVector<Real> force_rates(const Real& theta) const {
    using std::cos, std::sin;
    RealVector<Real> sum = -amplitude * sin(theta);
    for (const Harmonic& one : harmonics)
      sum += one.timed
                 ? RealVector<Real>(one.rate_at(static_cast<double>(theta)).template cast<Real>())
                 : RealVector<Real>(
                       Real(one.order) *
                       (one.sine.template cast<Real>() * cos(Real(one.order * theta)) -
                        one.cosine.template cast<Real>() * sin(Real(one.order * theta))));
    return sum;
  }
  RealVector<Real> force_sizes() const {
    RealVector<Real> sum = amplitude.cwiseAbs();
    for (const Harmonic& one : harmonics)
      sum += one.largest_wave() *
             (one.cosine.cwiseAbs() + one.sine.cwiseAbs()).template cast<Real>();
    return sum;
  }
  // Of the quickest harmonic, rad/s; a course changes by that part of its size in a second.
  Real highest_frequency() const {
    Real highest = frequency;
    for (const Harmonic& one : harmonics)
      highest = std::max<Real>(
          highest, one.timed ? Real(one.timed->course->steepest / one.largest_wave())
                             : Real(one.order * frequency));
    return highest;
  }
};

template <class Real>
LinearSystem<Real> linear_system(const System& system) {
  LinearSystem<Real> linear{
      system.omega.template cast<Real>(), {}, system.forcing() != nullptr, true, 0, 0, {}, {}, 0, {},
      {}};
  // A hub couples the damping of its modes, and their flow is not this one.
  if (system.turns())
    linear.delta.setZero(system.modes());
  else
    linear.delta = system.delta().template cast<Real>();
  if (system.forcing()) {
    linear.repeats = system.repeats();
    linear.frequency = system.forcing()->frequency;
    linear.phase = near_zero(Real(system.forcing()->phase));
    linear.amplitude = system.forcing()->amplitude.template cast<Real>();
  }
  if (system.harmonics()) linear.harmonics = *system.harmonics();
  if (system.coupling()) linear.coupling = system.coupling()->template cast<Real>();
  if (system.load()) linear.load = system.load()->template cast<Real>();
  if (system.stops.empty()) linear.reach = std::numeric_limits<Real>::infinity();
  for (const Stop& stop : system.stops) {
    const double row = stop.row.norm();
    if (row > 0.0) linear.reach = std::max<Real>(linear.reach, std::abs(stop.gap) / row);
  }
  return linear;
}

template <class Real>
class ExactFlow {
 public:
  explicit ExactFlow(const System& system) : ExactFlow(linear_system<Real>(system)) {}
  explicit ExactFlow(const LinearSystem<Real>& system);

  int modes() const { return static_cast<int>(modes_.size()); }
  const ModeFlow<Real>& mode(int j) const { return modes_[static_cast<std::size_t>(j)]; }
  bool forced() const { return forced_; }
  Real frequency() const { return frequency_; }
  // Forcing period, s; infinity without forcing, or where it does not repeat.
  Real period() const { return period_; }
  // The flow in which an arc from this state is written: usually this one. Where all gaps are 0 and
  // the state is small against the harmonic responses, it is one with all responses taken from
  // rest.
  const ExactFlow& for_start(const RealVector<Real>& q, const RealVector<Real>& qdot) const;
  // Frequencies and decay rates of the exponentials of forcing (first) and modes; zero for a mode
  // in another form. In columns for turn_terms.
  struct Turns {
    std::vector<Real> decay, half_frequency;  // 1/s, rad/s
    Real quickest = 0;                        // largest half frequency
  };
  const Turns& turns() const { return turns_; }
  // Forcing phase at an instant, rad: frequency * local + phase.
  Real phase(const Instant<Real>& instant) const {
    return forced_ ? Real(frequency_ * instant.local + phase_) : Real(0);
  }

 private:
  void add_from_rest(const LinearSystem<Real>& system);
  void note_turns();

  std::vector<ModeFlow<Real>> modes_;
  Turns turns_;
  bool forced_ = false;
  Real frequency_ = 0, phase_ = 0, period_ = 0;
  std::shared_ptr<const ExactFlow> from_rest_;  // null where the reach of the stops decides
  Real farthest_response_ = 0;                  // largest |P_j|, beside from_rest_
  Real push_ = 0;                               // of forcing and load, beside from_rest_
};

// One smooth piece of motion, from a state at forcing phase theta; s counts from its start.
// Refers to its flow, which must outlive it; can be restarted without allocating.
template <class Real>
class Arc {
 public:
  explicit Arc(const ExactFlow<Real>& flow);

  void start(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot);
  // Whether the arc starts there, to the last bit.
  bool starts_at(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot) const {
    return theta_ == theta && start_.size() == q.size() && start_ == q && start_rate_ == qdot;
  }
  // Displacements and velocities at s >= 0.
  void state(const Real& s, RealVector<Real>& q, RealVector<Real>& qdot) const;

  // Velocity of one mode at s >= 0.
  Real mode_velocity(int j, const Real& s) const;

  const ExactFlow<Real>& flow() const { return *flow_; }
  const Real& start_phase() const { return theta_; }
  // e^{i theta} there; 1 without forcing.
  const PlanarNumber<Real>& start_turn() const { return turn_; }
  // Displacements and velocities at the start, as they were given.
  const RealVector<Real>& start_displacements() const { return start_; }
  const RealVector<Real>& start_velocities() const { return start_rate_; }
  // The two numbers of mode j: oscillatory Z = first + i second; overdamped A, B; otherwise the
  // free part's displacement and velocity at the start.
  const PlanarNumber<Real>& amplitude(int j) const {
    return amplitudes_[static_cast<std::size_t>(j)];
  }

 private:
  // Mode j at s, where the forcing has cosine c and sine n.
  void mode_state(int j, const Real& s, const Real& c, const Real& n, Real& q, Real& qdot) const;

  const ExactFlow<Real>*whole_flow_, *flow_;  // as given; the one in which the arc is written
  Real theta_ = 0;
  PlanarNumber<Real> turn_{1, 0};
  RealVector<Real> start_, start_rate_;
  std::vector<PlanarNumber<Real>> amplitudes_;
};

}  // namespace graze
