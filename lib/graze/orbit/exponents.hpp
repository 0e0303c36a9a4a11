// Lyapunov exponents of a motion through its impacts: how fast neighbouring motions diverge or
// converge, from the derivative of the stroboscopic map, event by event (trajectory_segment.hpp).
//
// A forced structure of N modes has 2N of them and, for the forcing's own phase, one that is zero
// and is not listed. Where every impact has the constant restitution r and acts along its row,
//
//   sum = -2 sum_j delta_j + (k/t) ln r^2        for k impacts in t seconds,
//
// since the flow contracts volumes by the first term and every impact by the second. A motion that
// comes to rest on a stop, or meets one with r = 0, loses directions: exponents of minus infinity.
//
// P. Mueller, Chaos, Solitons and Fractals 5 (1995) 1671-1681 (exponents through discontinuities).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/defaults.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/system/system.hpp"

namespace graze {

struct ExponentOptions {
  long long periods = 1000;  // forcing periods averaged over
  // Periods before the average, in which the directions align.
  long long turning = 50;
  // The motion repeats after so many forcing periods: its exponents are those of its multipliers.
  // 0: it does not repeat.
  int repeats = 0;
  double closure_speed = 0.0;                    // m/s, of chatters
  long long max_impacts = kDefaultImpactBudget;  // of a period
  StopSignal stop{};
};

// Classification of a motion that does not repeat, by an average over K periods. Neighbours on a
// torus stay near each other, or diverge in proportion to the time where its frequencies vary; so
// their distance changes at most by a factor K. In chaos it grows exponentially. An exponent below
// ln K/(K T), T the forcing period, is not known to differ from zero.
enum class Wandering {
  kOpen,   // neither: it decays, or its error is too large
  kTorus,  // the largest exponent is zero: the growth stayed within the factor K throughout
  kChaos   // it is positive: growth beyond the factor K, and more than three standard errors
};

struct Exponents {
  Vector values;  // 2N, largest first, 1/s; minus infinity for directions that are lost
  // Standard errors by blocks of the average, 1/s; 0 where the exponents come from multipliers, not
  // finite where they are unknown.
  Vector errors;
  Wandering wandering = Wandering::kOpen;  // open where they come from multipliers
  int lost = 0;                            // how many are minus infinity
  long long periods = 0;                   // averaged over
  long long impacts = 0;                   // in them
  std::string failure;         // a sentence where the motion could not be followed; empty: it was
  std::optional<State> end{};  // at the start of a forcing period, where all was followed
};

// Exponents of the motion that starts from `start` at the start of a forcing period. Requires
// forcing. Motions on a hub are not supported.
Exponents lyapunov_exponents(const System& system, const State& start,
                             const ExponentOptions& options);

}  // namespace graze
