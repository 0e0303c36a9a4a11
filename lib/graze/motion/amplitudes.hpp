// How large a motion is over a while: at a place of the structure, and at a stop. What response
// curves show.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "graze/system/measured_row.hpp"

namespace graze {

// A motion is measured at these rows and at all stops, from this time on, s.
struct MeasureOptions {
  std::vector<MeasuredRow> rows;
  double from = 0.0;
};

// Of one row, in its unit.
struct Amplitude {
  double highest = 0.0, lowest = 0.0;
  double mean = 0.0, rms = 0.0;       // over time; the root mean square about zero
  std::optional<double> speed{};      // largest |row.q'|; nothing of a velocity
  std::optional<Complex> harmonic{};  // a of its part Re(a e^{i theta}); nothing without forcing

  double largest() const { return std::fmax(std::abs(highest), std::abs(lowest)); }
  double half_range() const { return 0.5 * (highest - lowest); }
};

// Of one stop.
struct StopLoad {
  long long impacts = 0;  // and contacts begun
  double impulse = 0.0;   // N s
  // N; nothing where impacts on a rigid stop, which have no force, are among what acts.
  std::optional<double> peak_force{}, rms_force{};
};

struct Amplitudes {
  double duration = 0.0;        // s
  std::vector<Amplitude> rows;  // in the order of the rows
  std::vector<StopLoad> stops;  // of every stop
};

}  // namespace graze
