// The first contact of a free flight of many modes at many stops.
//
// Stops are followed side by side, so that none is searched beyond the first contact of another. A
// speed at the stop is at most |b| sqrt(2 E), and what that speed cannot bridge is not looked at.
// Near a stop the gap is a polynomial with a bound on what it leaves out (motion_series.hpp), over
// a step of a few radians of the quickest mode; on the last stretch before a zero the search of
// first_zero.hpp decides, as everywhere.
#pragma once

#include <functional>
#include <vector>

#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/flow/series/detail/motion_series.hpp"

namespace graze {

// Of more modes than this a step of a series takes less time than as far a search of single gaps.
inline constexpr int kFewModes = 64;

// The curve of the gap of a stop along the arc, its bounds holding up to the window (s), from its
// first zero at the start on where it has one there (ExactPhase::gap).
using GapCurves = std::function<const ArcCurve<double>&(int stop, double window, bool from_zero)>;

class FlightSearch {
 public:
  FlightSearch(const System& system, const LinearSystem<double>& modes);

  // Along the arc of a free flight, whose gaps are `curves`.
  Arrival<double> first_event(const GapCurves& curves, const Arc<double>& arc,
                              const MotionState<double>& now, const Flight<double>& flight);

 private:
  struct Watched {
    int stop = 0, multiplicity = 0;
    double clear = 0.0;  // s, up to where the gap is sure to be positive
  };

  double reached(double from, double gap, double norm, double speed) const;
  // Advances what is clear of one stop over the step.
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
