// How large a motion is over some time: at a place of the structure, and at a stop, as response
// curves show it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "graze/system/measured_row.hpp"

namespace graze {

// Equal windows of time, one after the other, over each of which the force of a stop is averaged.
struct ForceWindows {
  double length = 0.0;  // s, > 0
  int count = 0;        // > 0
};

// What is measured: these rows and all stops, from the time `from` on, s.
struct MeasureOptions {
  std::vector<MeasuredRow> rows;
  double from = 0.0;
  std::optional<ForceWindows> windows{};  // of the forces over time; nullopt: not recorded
};

// The amplitude of one row, in its unit.
struct Amplitude {
  double highest = 0.0, lowest = 0.0;
  double mean = 0.0, rms = 0.0;       // over time; the root mean square about zero
  std::optional<double> speed{};      // largest |row.q'|; nullopt for a row of velocities
  std::optional<Complex> harmonic{};  // a of its part Re(a e^{i theta}); nullopt without forcing

  double largest() const { return std::fmax(std::abs(highest), std::abs(lowest)); }
  double half_range() const { return 0.5 * (highest - lowest); }
  // The root mean square about the mean. Below a millionth of that about zero it is the rounding of
  // the two, and told as zero.
  double standard_deviation() const {
    const double variance = rms * rms - mean * mean;
    return variance > 1e-12 * rms * rms ? std::sqrt(variance) : 0.0;
  }
};

// The load of one stop.
struct StopLoad {
  long long impacts = 0;  // and contacts begun
  double impulse = 0.0;   // N s
  double held = 0.0;      // time that a rigid stop holds the structure, s
  // N; nullopt where a rigid stop has impacts, whose force is not finite.
  std::optional<double> peak_force{}, rms_force{};
};

// The forces of stops over time, as means over windows, of impacts and of contact forces alike.
struct StopForces {
  double from = 0.0, length = 0.0;         // s, of the first window, of each
  std::vector<std::vector<double>> means;  // of every stop, N, window by window
};

struct Amplitudes {
  double duration = 0.0;               // s
  std::vector<Amplitude> rows;         // in the order of the rows
  std::vector<StopLoad> stops;         // of every stop
  std::optional<StopForces> forces{};  // where windows were asked for
};

}  // namespace graze
