// The structure while it is held by closed stops (and by a joint that does not rotate).
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
// holds here; otherwise see couple(). Without closed stops damping may couple the modes all the
// same.
//
// Under several harmonics the system is followed with one more coordinate for each harmonic beside
// the first, z = unit cos(order theta), which nothing moves: z'' = -(order W)^2 z, and z and z'
// press on the structure. So these forces are part of the free motion, whatever holds the structure
// or damps it. So is a course over time, z'' = 0 along each of its lines.
//
// Dry friction that sticks holds b.q where it was, or with the speed of its belt: q = q_c + e s + U
// y with B^T e = those speeds. Then |e| s is one more coordinate that nothing moves, s the time
// since.
#pragma once

#include <vector>

#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/held/detail/coupled_flow.hpp"

namespace graze {

template <class Real>
struct ConstrainedStructure {
  // `constrained`: indices of stops and frictions with linearly independent rows; none: the
  // structure is free, and the members that may be empty are. `places`: of the frictions among
  // them, m.
  ConstrainedStructure(const System& system, std::vector<int> constrained,
                       const std::vector<double>& places = {});

  bool is_free() const { return constrained.empty() && whole.harmonics.empty(); }
  Eigen::Index size() const { return reduced.omega.size(); }  // of y, m
  // y and y' of a state at forcing phase theta, and back.
  RealVector<Real> coordinates(const RealVector<Real>& q, const Real& theta) const {
    if (is_free()) return q;
    RealVector<Real> y = basis.transpose() * (q - rest);
    for (std::size_t k = 0; k < whole.harmonics.size(); ++k)
      y[drive(k)] = units[k] * wave(k, theta);
    return y;
  }
  RealVector<Real> rates(const RealVector<Real>& qdot, const Real& theta) const {
    if (is_free()) return qdot;
    RealVector<Real> ydot = basis.transpose() * qdot;
    for (std::size_t k = 0; k < whole.harmonics.size(); ++k)
      ydot[drive(k)] = rate_unit(k) * swing(k, theta);
    return ydot;
  }
  // What the structure sees of a row or of a rate of its state: nothing of the harmonics.
  RealVector<Real> seen(const RealVector<Real>& row) const {
    return is_free() ? row : RealVector<Real>(basis.transpose() * row);
  }
  // The unit of its rate z' = -rate_unit sin(order theta), or of that of a course, kg^1/2 m/s.
  Real rate_unit(std::size_t k) const {
    return whole.harmonics[k].timed ? units[k] : Real(units[k] * reduced.omega[drive(k)]);
  }
  Real wave(std::size_t k, const Real& theta) const {
    using std::cos;
    const Harmonic& one = whole.harmonics[k];
    return one.timed ? Real(one.wave(static_cast<double>(theta))) : Real(cos(Real(one.order * theta)));
  }
  Real swing(std::size_t k, const Real& theta) const {
    using std::sin;
    const Harmonic& one = whole.harmonics[k];
    return one.timed ? Real(one.swing(static_cast<double>(theta)))
                     : Real(-sin(Real(one.order * theta)));
  }
  // The harmonic of this order, which there must be.
  std::size_t harmonic_of(double order) const {
    std::size_t k = 0;
    while (whole.harmonics[k].timed || whole.harmonics[k].order != order) ++k;
    return k;
  }
  // The place of harmonic k in y.
  Eigen::Index drive(std::size_t k) const {
    return size() - static_cast<Eigen::Index>(whole.harmonics.size() - k);
  }
  RealVector<Real> displacements(const RealVector<Real>& y) const {
    return is_free() ? y : RealVector<Real>(rest + basis * y);
  }
  RealVector<Real> velocities(const RealVector<Real>& ydot) const {
    return is_free() ? ydot : RealVector<Real>(basis * ydot);
  }
  // For every stop of the system that it was made from, on y: the gap, or the contact force where
  // the stop holds; then for every friction: the speed of sliding, or the force where it sticks.
  std::vector<Observable<Real>> observables(const System& system) const;
  // The column of a stop that holds.
  Eigen::Index column_of(int stop) const;
  bool holds(int stop) const {
    return column_of(stop) < static_cast<Eigen::Index>(constrained.size());
  }

  std::vector<int> constrained;
  LinearSystem<Real> whole;           // of all coordinates
  RealMatrix<Real> rows, directions;  // B, D: N x constrained stops
  RealMatrix<Real> shares;     // lambda_i = share_i.(free acceleration): N x constrained stops
  RealMatrix<Real> basis;      // U, N x m
  RealVector<Real> rest;       // q_c
  LinearSystem<Real> reduced;  // its real modes; where there are none, only their frequencies
  bool has_real_modes = true;  // not under several harmonics
  bool is_normal = true;       // impulses act along the rows
  RealMatrix<Real> stretched;  // w U, as it was decomposed
  RealVector<Real> drift;      // e, kg^1/2 m/s; empty where no belt drags what sticks to it
  Matrix left;                 // left inverse of U that is orthogonal to oblique directions
                               // (couple()); empty where there are none
  std::vector<Real> units;     // of the coordinates of harmonics, kg^1/2 m

 private:
  void reduce(const System& system, const std::vector<double>& places);
  RealVector<Real> held_at(const System& system, const std::vector<double>& places) const;
  Observable<Real> held_force(Eigen::Index column) const;
  RealVector<Real> balanced_load();
  friend CoupledSystem couple(ConstrainedStructure<double>& structure);
};

// Whether damping couples no modes and decay rates are alpha + beta w^2 to rounding: then a
// structure that stops hold along their rows has real modes.
bool proportional_damping(const System& system);

// The equations of y for a structure without real modes. Moves its q_c.
CoupledSystem couple(ConstrainedStructure<double>& structure);

}  // namespace graze
