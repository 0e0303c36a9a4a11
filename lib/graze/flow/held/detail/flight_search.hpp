// The first contact of a free flight of many modes at many stops.
//
// Stops are followed side by side, so that none is searched beyond the first contact of another.
// The speed at a stop is at most |b| sqrt(2 E), and gaps that cannot be crossed at that speed are
// skipped. Near a stop the gap is a polynomial with a bound on its remainder (motion_series.hpp),
// over a step of a few radians of the fastest mode; on the last stretch before a zero the search of
// first_zero.hpp decides, as everywhere.
#pragma once

#include <functional>
#include <vector>

#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/flow/series/detail/motion_series.hpp"

namespace graze {

// With more modes than this a step of a series is faster than searching single gaps as far.
inline constexpr int kFewModes = 64;

// The curve of the gap of a stop along the arc, its bounds valid up to the window (s); `from_zero`:
// it starts at a zero (ExactPhase::gap).
using GapCurves = std::function<const ArcCurve<double>&(int stop, double window, bool from_zero)>;

class FlightSearch {
 public:
  FlightSearch(const System& system, const LinearSystem<double>& modes);

  // The first event along the arc of a free flight with the gaps `curves`.
  Arrival<double> first_event(const GapCurves& curves, const Arc<double>& arc,
                              const MotionState<double>& now, const Flight<double>& flight);

 private:
  struct Watched {
    int stop = 0, multiplicity = 0;
    double clear = 0.0;  // s, up to where the gap is sure to be positive
  };

  double reached(double from, double gap, double norm, double speed) const;
  // Advances `clear` of one stop over the step.
  void look(Watched& watched, double from, double step);
  double bridged(double from);
  void step(const GapCurves& curves, const Arc<double>& arc, double& from,
            const Flight<double>& flight, Arrival<double>& arrival);
  double gap(int stop) const;
  // Its first contact in (clear, until], by its own curve.
  void decide(const GapCurves& curves, Watched& watched, double until, const Flight<double>& flight,
              Arrival<double>& arrival) const;

  MotionSeries series_;
  Vector omega_;            // rad/s, N
  double frequency_ = 0.0;  // of the forcing, rad/s
  Matrix rows_;             // b of every stop, N x stops
  Vector gaps_, norms_;     // and its gap, |b|
  double push_ = 0.0;       // |forcing| + |load|
  std::vector<Watched> watched_;
  std::vector<double> coefficients_;
  Vector q_, qdot_;
};

}  // namespace graze
