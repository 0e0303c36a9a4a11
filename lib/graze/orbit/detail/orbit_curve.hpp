// The motion of an orbit between its impacts, for pictures and series.
#pragma once

#include <vector>

#include "graze/orbit/problem/orbit.hpp"

namespace graze {

struct CurveSample {
  double theta = 0.0;         // forcing phase counted from the orbit's first period, rad
  double displacement = 0.0;  // row.q, of a stop's into the stop, m
  double velocity = 0.0;      // row.q', m/s
};

// One list for each flight from impact to impact, ends included, with at least `per_period` samples
// in a forcing period; values along `row`.
std::vector<std::vector<CurveSample>> orbit_curve(const System& system, const Orbit& orbit,
                                                  const Vector& row, int per_period);

}  // namespace graze
