// The course of an orbit between its impacts, for pictures and series.
#pragma once

#include <vector>

#include "graze/orbit/problem/orbit.hpp"

namespace graze {

struct CurveSample {
  double theta = 0.0;         // forcing phase counted from the orbit's first period, rad
  double displacement = 0.0;  // row.q at the stop, into the stop, m
  double velocity = 0.0;      // row.q', m/s
};

// One list per flight from impact to impact, ends included, at least `per_period` samples in a
// forcing period; seen at stop `stop` (index from 0).
std::vector<std::vector<CurveSample>> orbit_curve(const System& system, const Orbit& orbit,
                                                  int stop, int per_period);

}  // namespace graze
