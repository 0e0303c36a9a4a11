// Definitions of contact_phase.hpp; included by one translation unit per scalar.
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "graze/base/linear_equations.hpp"
#include "graze/flow/arc_curve_impl.hpp"
#include "graze/flow/contact_phase.hpp"
#include "graze/flow/contact_phase_steps_impl.hpp"
#include "graze/flow/contact_share.hpp"

namespace graze {
namespace contact_phase_detail {

// Roundings by which decay rates may miss alpha + beta w^2 and a direction b/(b.b).
inline constexpr int kRoundings = 16;

// Decay rates proportional to mass and stiffness: delta_j = alpha + beta w_j^2.
template <class Real>
struct ProportionalDamping {
  Real alpha = 0, beta = 0;
};

template <class Real>
std::optional<ProportionalDamping<Real>> proportional_damping(const LinearSystem<Real>& system) {
  using std::abs;
  const Eigen::Index n = system.omega.size();
  const RealVector<Real> stiffness = system.omega.cwiseAbs2();
  Eigen::Index low = 0, high = 0;
  for (Eigen::Index j = 1; j < n; ++j) {
    if (stiffness[j] < stiffness[low]) low = j;
    if (stiffness[j] > stiffness[high]) high = j;
  }
  ProportionalDamping<Real> law;
  if (system.delta[high] != system.delta[low] && stiffness[high] > stiffness[low])
    law.beta = (system.delta[high] - system.delta[low]) / (stiffness[high] - stiffness[low]);
  law.alpha = system.delta[low] - law.beta * stiffness[low];
  for (Eigen::Index j = 0; j < n; ++j) {
    const Real miss = abs(system.delta[j] - law.alpha - law.beta * stiffness[j]);
    // The decay rates come in double precision, whatever the scalar.
    if (miss > kRoundings * std::numeric_limits<double>::epsilon() * system.delta[j]) return {};
  }
  return law;
}

template <class Real>
bool is_normal(const RealVector<Real>& row, const RealVector<Real>& direction) {
  const RealVector<Real> normal = row / row.squaredNorm();
  return (direction - normal).norm() <=
         kRoundings * std::numeric_limits<double>::epsilon() * normal.norm();
}

}  // namespace contact_phase_detail

template <class Real>
ContactPhase<Real>::ContactPhase(const System& given, const std::vector<int>& closed,
                                 const std::optional<StepSetting>& steps,
                                 const PhaseSprings& springs, Joint joint, double angle)
    : closed_(closed), holds_(closed), springs_(springs), joint_(joint) {
  std::optional<System> with_joint;
  if (joint == Joint::kHeld) {
    holds_.push_back(static_cast<int>(given.stops.size()));
    with_joint = with_joint_held(given, angle);
  }
  const System& system = with_joint ? *with_joint : given;
  const LinearSystem<Real> full = linear_system<Real>(system);
  if (holds_.empty()) {
    reduced_ = full;
  } else {
    rows_ = rows_of(system, holds_).template cast<Real>();
    directions_ = directions_of(system, holds_).template cast<Real>();
    reduce(system, full);
  }
  if (!coupled_flow_) {
    flow_.emplace(reduced_);
    arc_.emplace(*flow_);
  }
  RealMatrix<Real> shares;  // columns: lambda_i = share_i.(free acceleration)
  if (!holds_.empty())
    shares = rows_ * (rows_.transpose() * directions_).transpose().fullPivLu().inverse();
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const Stop& stop = system.stops[i];
    const RealVector<Real> row = stop.row.template cast<Real>();
    const auto found = std::find(holds_.begin(), holds_.end(), static_cast<int>(i));
    const Observable<Real> observable =
        found == holds_.end() ? gap_observable<Real>(row, Real(stop.gap))
                              : force_observable(full, shares.col(found - holds_.begin()),
                                                 Real(1) / row.squaredNorm());
    observables_.push_back(holds_.empty() ? observable : reduced_observable(observable));
  }
  shares_ = shares;
  if constexpr (std::is_same_v<Real, double>) {
    if (!springs_.empty() || system.turns())
      spring_by(system, steps);
    else if (steps)
      step_by(*steps);
  } else if (!springs_.empty()) {
    refusal_ = "a compressed spring is followed in double precision only";
  } else if (system.turns()) {
    refusal_ = "a structure on a hub is followed in double precision only";
  }
}

// Coordinates in which the held structure has real modes: U = Q V, Q an orthonormal basis of what
// the rows leave free, V the right singular vectors of w Q. The singular values are the
// frequencies, with an error of eps times the largest one (of their squares it would be far worse).
template <class Real>
void ContactPhase<Real>::reduce(const System& system, const LinearSystem<Real>& full) {
  using namespace contact_phase_detail;
  const Eigen::Index n = rows_.rows(), k = rows_.cols(), m = n - k;
  const Eigen::HouseholderQR<RealMatrix<Real>> qr(rows_);
  const RealMatrix<Real> all = qr.householderQ() * RealMatrix<Real>::Identity(n, n);
  RealVector<Real> gaps(k);
  for (Eigen::Index i = 0; i < k; ++i)
    gaps[i] = Real(system.stops[static_cast<std::size_t>(holds_[static_cast<std::size_t>(i)])].gap);
  // The shortest q with B^T q = a.
  held_ = rows_ * (rows_.transpose() * rows_).fullPivLu().solve(gaps);
  basis_ = all.rightCols(m);
  reduced_.omega.resize(m);
  RealMatrix<Real> stretched(n, m);  // w U
  if (m > 0) {
    const RealMatrix<Real> root = full.omega.asDiagonal() * basis_;
    const Eigen::JacobiSVD<RealMatrix<Real>> svd(root, Eigen::ComputeThinU | Eigen::ComputeThinV);
    basis_ = (basis_ * svd.matrixV()).rowwise().reverse().eval();
    reduced_.omega = svd.singularValues().reverse();
    // Within the error of the singular values a mode is free.
    const Real smallest =
        Real(static_cast<int>(n)) * std::numeric_limits<Real>::epsilon() * reduced_.omega[m - 1];
    for (Real& w : reduced_.omega)
      if (w <= smallest) w = 0;
    stretched = svd.matrixU().rowwise().reverse() * reduced_.omega.asDiagonal();
  }
  reduced_.forced = full.forced;
  reduced_.frequency = full.frequency;
  reduced_.phase = full.phase;
  reduced_.reach = full.reach;

  bool normal = true;
  for (Eigen::Index i = 0; i < k; ++i)
    normal = normal && is_normal<Real>(rows_.col(i), directions_.col(i));
  const std::optional<ProportionalDamping<Real>> damping = proportional_damping(full);
  if (m > 0 && (!normal || (!damping && m > 1))) {
    couple(full, stretched, normal);
    return;
  }
  reduced_.delta.resize(m);
  for (Eigen::Index j = 0; j < m; ++j)
    reduced_.delta[j] =
        damping ? Real(damping->alpha + damping->beta * reduced_.omega[j] * reduced_.omega[j])
                : Real(full.delta.dot(basis_.col(j).cwiseAbs2()));
  if (full.forced) reduced_.amplitude = basis_.transpose() * full.amplitude;
  reduced_.load = balance(full, stretched);
}

// Moves what is held to where its stiffness balances the load, so that nothing large has to cancel;
// returns the load that is left to modes too soft for it.
template <class Real>
RealVector<Real> ContactPhase<Real>::balance(const LinearSystem<Real>& full,
                                             const RealMatrix<Real>& stretched) {
  RealVector<Real> load = -stretched.transpose() * full.omega.cwiseProduct(held_);
  if (full.load.size() > 0) load += basis_.transpose() * full.load;
  for (Eigen::Index j = 0; j < load.size(); ++j) {
    const Real w = reduced_.omega[j];
    if (!(w > 0 && exact_flow_detail::rests_within_reach(load[j], w, full.reach))) continue;
    held_ += basis_.col(j) * (load[j] / (w * w));
    load[j] = 0;
  }
  return load;
}

template <class Real>
void ContactPhase<Real>::couple(const LinearSystem<Real>& full, const RealMatrix<Real>& stretched,
                                bool normal) {
  if constexpr (!std::is_same_v<Real, double>) {
    refusal_ = "the constrained motion has no real modes; it is followed in double precision only";
    // Something to hold on to; a refused phase is never flown.
    reduced_ = LinearSystem<Real>{reduced_.omega, reduced_.omega, false, 0, 0, {}, {}, 0};
  } else {
    const Eigen::Index n = rows_.rows(), m = basis_.cols();
    // Left inverse of the basis that knows nothing of the directions: Z^T U = I, Z^T D = 0.
    Matrix whole(n, n);
    whole << basis_, directions_;
    const Matrix left = LuFactors(whole).inverse().topRows(m);
    if (!normal) left_ = left;
    CoupledSystem reduced;
    // From w U, that soft and free directions see nothing of the rounding of stiff ones.
    reduced.stiffness = normal ? Matrix(reduced_.omega.cwiseAbs2().asDiagonal())
                               : Matrix(left * full.omega.asDiagonal() * stretched);
    reduced.damping = left * (2.0 * full.delta).asDiagonal() * basis_;
    if (normal) {
      reduced.load = balance(full, stretched);
    } else {
      reduced.load = -left * full.omega.cwiseAbs2().cwiseProduct(held_);
      if (full.load.size() > 0) reduced.load += left * full.load;
      const auto stiffness = reduced.stiffness.fullPivLu();
      if (reduced_.omega.minCoeff() > 0.0 && stiffness.isInvertible()) {
        const Vector rest = stiffness.solve(reduced.load);
        if (rest.norm() <= kLargestAmplification * full.reach) {
          held_ += basis_ * rest;
          reduced.load.setZero();
        }
      }
    }
    reduced.force = full.forced ? Vector(left * full.amplitude) : Vector(Vector::Zero(m));
    reduced.frequency = full.forced ? full.frequency : 0.0;
    const double slowest = std::max(full.frequency, 1e-3 * reduced_.omega.maxCoeff());
    reduced.scale = reduced_.omega.cwiseMax(slowest > 0.0 ? slowest : 1.0);
    coupled_flow_ = std::make_unique<CoupledFlow>(reduced);
    coupled_arc_.emplace(*coupled_flow_);
    reduced_.delta = Vector::Zero(m);
    refusal_ = coupled_flow_->instability();
  }
}

template <class Real>
Observable<Real> ContactPhase<Real>::force_observable(const LinearSystem<Real>& full,
                                                      const RealVector<Real>& share,
                                                      const Real& unit) const {
  Observable<Real> force;
  force.displacement = -unit * full.omega.cwiseAbs2().cwiseProduct(share);
  force.velocity = -2 * unit * full.delta.cwiseProduct(share);
  if (full.load.size() > 0) force.constant = unit * share.dot(full.load);
  if (full.forced) force.harmonic.re = unit * share.dot(full.amplitude);
  return force;
}

template <class Real>
Observable<Real> ContactPhase<Real>::reduced_observable(const Observable<Real>& full) const {
  Observable<Real> reduced;
  reduced.constant = full.constant + full.displacement.dot(held_);
  reduced.displacement = basis_.transpose() * full.displacement;
  if (full.velocity.size() > 0) reduced.velocity = basis_.transpose() * full.velocity;
  reduced.harmonic = full.harmonic;
  return reduced;
}

template <class Real>
Real ContactPhase<Real>::longest_flight() const {
  if (turns()) return Real(sprung_->turning->structure.smooth_for());
  return coupled_flow_ ? Real(coupled_flow_->longest_flight())
                       : std::numeric_limits<Real>::infinity();
}

template <class Real>
RealVector<Real> ContactPhase<Real>::reduced_coordinates(const RealVector<Real>& q) const {
  return basis_.transpose() * (q - held_);
}

template <class Real>
void ContactPhase<Real>::start(const Real& theta, const RealVector<Real>& q,
                               const RealVector<Real>& qdot) {
  if constexpr (std::is_same_v<Real, double>) {
    if (step_flow_) start_steps(theta, q, qdot);
  }
  if (turns()) return;
  if (holds_.empty()) {
    // What an instant is asked for and the flight from there are one arc.
    if (arc_->starts_at(theta, q, qdot)) return;
    for (KeptCurve& kept : kept_) kept.known = false;
    arc_->start(theta, q, qdot);
    return;
  }
  for (KeptCurve& kept : kept_) kept.known = false;
  const RealVector<Real> y = reduced_coordinates(q), ydot = basis_.transpose() * qdot;
  if constexpr (std::is_same_v<Real, double>) {
    if (coupled_arc_) {
      coupled_arc_->start(theta, y, ydot);
      return;
    }
  }
  arc_->start(theta, y, ydot);
}

template <class Real>
void ContactPhase<Real>::state(const Real& s, RealVector<Real>& q, RealVector<Real>& qdot) const {
  if constexpr (std::is_same_v<Real, double>) {
    if (step_flow_) {
      step_state(s, q, qdot);
      return;
    }
  }
  if (holds_.empty()) {
    arc_->state(s, q, qdot);
    return;
  }
  RealVector<Real> y(basis_.cols()), ydot(basis_.cols());
  if constexpr (std::is_same_v<Real, double>) {
    if (coupled_arc_)
      coupled_arc_->state(s, y, ydot);
    else
      arc_->state(s, y, ydot);
  } else {
    arc_->state(s, y, ydot);
  }
  q = held_ + basis_ * y;
  qdot = basis_ * ydot;
}

template <class Real>
ArcCurve<Real> ContactPhase<Real>::curve(const Observable<Real>& observable, const Real& window,
                                         bool from_zero) const {
  if constexpr (std::is_same_v<Real, double>) {
    if (coupled_arc_) return coupled_arc_->curve(observable, window, from_zero);
  }
  return ArcCurve<Real>(*arc_, observable, window, from_zero);
}

template <class Real>
Real ContactPhase<Real>::start_phase() const {
  if (turns()) return Real(0);
  if constexpr (std::is_same_v<Real, double>) {
    if (coupled_arc_) return coupled_arc_->start_phase();
  }
  return arc_->start_phase();
}

template <class Real>
ArcCurve<Real> ContactPhase<Real>::gap(int stop, const Real& window, bool from_zero) const {
  return curve(observables_[static_cast<std::size_t>(stop)], window, from_zero);
}

template <class Real>
const ArcCurve<Real>& ContactPhase<Real>::gap_along(int stop, const Real& window, bool from_zero) {
  kept_.resize(observables_.size());
  KeptCurve& kept = kept_[static_cast<std::size_t>(stop)];
  if (kept.known && kept.from_zero == from_zero) {
    kept.curve.set_window(window);
    return kept.curve;
  }
  if (arc_)
    kept.curve.restart(*arc_, observables_[static_cast<std::size_t>(stop)], window, from_zero);
  else
    kept.curve = gap(stop, window, from_zero);
  // What depends on the window otherwise cannot be kept.
  kept.known = arc_.has_value();
  kept.from_zero = from_zero;
  return kept.curve;
}

template <class Real>
ArcCurve<Real> ContactPhase<Real>::force(int stop, const Real& window) const {
  return curve(observables_[static_cast<std::size_t>(stop)], window, false);
}

template <class Real>
Real ContactPhase<Real>::force_at(int stop, const Real& s, const RealVector<Real>& q,
                                  const RealVector<Real>& qdot) const {
  if constexpr (std::is_same_v<Real, double>) {
    if (sprung_) return sprung_force_at(stop, s, q, qdot);
  }
  const RealVector<Real> y = reduced_coordinates(q), ydot = basis_.transpose() * qdot;
  const Real theta = start_phase() + reduced_.frequency * s;
  return observed<Real>(observables_[static_cast<std::size_t>(stop)], theta, y, ydot).value;
}

}  // namespace graze
