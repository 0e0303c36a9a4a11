// How small deviations of a motion grow along an arc, free or held, and pass its events.
//
// A deviation is carried as that of the state at its own instant: (dq, dq') is the difference of
// the states, dt the delay between the instants at which they are compared. At an event dt is such
// that the deviated motion is at that event too: at a contact on stop i, b_i.dq = 0 and
//
//   dt' = dt - (b_i.dq)/v,   (dq, dq') + f (dt' - dt),       f = (q', q'') before the impact,
//
// and the impact itself is just the derivative of its jump at fixed position. No difference of
// nearby numbers is divided by a small speed, however short the flights of a chatter become. With
// dt = 0 before and after this is the saltation matrix S = J + (f+ - J f-) c^T/(c^T f-).
#pragma once

#include <vector>

#include "graze/flow/held/detail/exact_phase.hpp"

namespace graze {

// One deviation a column.
struct Deviations {
  Matrix q, qdot;            // kg^1/2 m, kg^1/2 m/s; N x m
  Eigen::RowVectorXd delay;  // s, m

  Eigen::Index count() const { return q.cols(); }
};

// Growth of the deviations `start` over s seconds of the arc that `phase` was started on, at
// unchanged delay: (Phi - 1) x + (d end/d start instant) dt. Accurate relative to itself, however
// short the flight. Deviations of a held phase have to satisfy the constraints of its closed stops
// (see `hold`).
Deviations growth(const ExactPhase<double>& phase, double s, const Deviations& start);

// Deviations after the instant is moved by `shift` (s, one per column) along the motion, whose rate
// is (q', q'').
void move_instant(Deviations& deviations, const State& rate, const Eigen::RowVectorXd& shift);

// The same under everything that holds the structure, friction that sticks included, which keeps
// what it has of a deviation along its row: in all coordinates, as the phase of this key has it,
// from forcing phase theta.
Deviations held_growth(const System& system, const PhaseKey& key, double theta, double s,
                       const Deviations& start);

// The force of dry friction that slides, but at springs, on the modes; empty where there is none.
Vector friction_push(const System& system, const std::vector<Contact>& frictions);

// (q', q'') at forcing phase theta while the stops `closed` (with independent rows) hold. `push`: a
// further acceleration, as by springs; empty where there is none.
State held_rate(const System& system, const std::vector<int>& closed, const State& state,
                double theta, const Vector& push = {});

// The part of an acceleration that closed stops allow: P a = a - D (B^T D)^-1 B^T a.
Vector held(const System& system, const std::vector<int>& closed, const Vector& acceleration);

// How the force of a friction that sticks, N, changes with the state, with a delay of the forcing,
// and in time along a motion of this rate.
struct ForceChange {
  Vector by_q, by_qdot;
  double by_delay = 0.0, rate = 0.0;
};
ForceChange force_change(const System& system, const PhaseKey& key, int friction, double theta,
                         const State& rate);

// Removes the parts of deviations that closed stops do not allow: displacements along the rows,
// which are rounding (where friction sticks they are kept), and velocities along the directions of
// the contact forces, which the contact absorbs when it closes.
void hold(const System& system, const std::vector<int>& closed, Deviations& deviations);

}  // namespace graze
