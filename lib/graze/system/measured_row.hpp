// A measured quantity of a motion.
#pragma once

#include <vector>

#include "graze/base/vector.hpp"
#include "graze/system/system.hpp"

namespace graze {

// row.q, or row.q' for a velocity, of the structure: what stops that move carry it along by comes to
// the coordinates of the system.
struct MeasuredRow {
  struct Harmonic {
    double order = 1.0;
    double cosine = 0.0, sine = 0.0;
  };
  Vector row;
  bool of_velocity = false;
  std::vector<Harmonic> carried{};  // row.c
  double frequency = 0.0;           // of the forcing, rad/s, where something is carried

  // row.c and row.c' at forcing phase theta, rad.
  double carried_at(double theta) const;
  double carried_rate(double theta) const;
  // The quantity, of a state of the system.
  double value(const State& state, double theta) const {
    return of_velocity ? row.dot(state.qdot) + carried_rate(theta)
                       : row.dot(state.q) + carried_at(theta);
  }
};

MeasuredRow measured_row(const System& system, const Vector& row, bool of_velocity = false);

}  // namespace graze
