// One value of a sweep, or one cell of a map: what the motion from a start settles on.
#pragma once

#include <vector>

#include "graze/orbit/shooting.hpp"
#include "graze/scene/scene.hpp"
#include "graze/study/sweep.hpp"

namespace graze {

struct RowOptions {
  long long periods = 1000, samples = 100;
  long long max_impacts = kDefaultImpactBudget;
  std::optional<double> closure_speed;  // m/s; nothing: by the scene alone, whatever the start
  double nearness = 1e-8;
  long long exponent_periods = 0;
  StopSignal stop;
};

// Fills motion, status, message and, where they are wanted, exponents. `row.start` says where the
// start comes from. False where it was stopped before that was done.
bool settle_row(const Scene& scene, const System& system, const State& start,
                const RowOptions& options, SweepRow& row);

// Whether two motions that repeat are the same orbit, seen in whichever of its periods: states at
// the starts of their periods no further apart than this part of the scale.
bool are_same_strobes(const ShootingScale& scale, const std::vector<State>& left,
                      const std::vector<State>& right, double apart);

}  // namespace graze
