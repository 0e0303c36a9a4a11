// One segment of the hybrid motion between two instants, with its impacts, closed chatters, stuck
// phases and releases, certified as in a run; and the growth of small deviations from it.
//
// The derivative of the map from start to end, event by event (docs/theory.md, Orbits that stick):
//   impact   the derivative of the jump at fixed position, shared with the stops that are touched;
//   closure  as an impact with r = 0 on that stop: deviations (b.q, b.q') along the closed stops
//            vanish. State and derivative have an error of O(v_c^3);
//   release  the identity: the contact force vanishes there and (q', q'') is continuous;
//   contact with a compliant stop: as in sprung_deviation.hpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/defaults.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/orbit/problem/detail/carried_deviations.hpp"

namespace graze {

// A stop that is ignored for some time, s after the start, around an approach that just touches it.
// So a segment that grazes is followed on either side of the grazing, where the approach stays away
// or would be an impact, by one motion that is smooth. The gap must be open when that time begins
// and ends.
struct LeftOut {
  int stop = 0;
  double from = 0.0, to = 0.0;
};

struct SegmentOptions {
  double closure_speed = 0.0;  // m/s: below it the tail of a chatter is summed
  long long max_impacts = kDefaultImpactBudget;
  StopSignal stop{};
  bool minima = false;  // look for the minima of gaps and contact forces
  // Direction along which rates of speeds and approaches are computed; only with deviations and a
  // parameter's deviation.
  std::optional<SegmentDirection> along{};
  std::optional<LeftOut> left_out{};
  // Called for every flight: the phase as it was flown, the instant of its start, its duration, s.
  std::function<void(const ContactPhase<double>&, const Instant<double>&, double)> flight{};
  // Called for every impact, with the shares of all stops that are touched, held ones too.
  std::function<void(const std::vector<ImpactShare<double>>&)> impact{};
  // Called where a chatter is summed: the stops that hold the structure from then on, and the
  // velocities that this takes away, kg^1/2 m/s.
  std::function<void(const std::vector<int>&, const Vector&)> closure{};
};

struct SegmentImpact {
  int stop = 0;
  Instant<double> at;
  double speed = 0.0;  // m/s, before
  State before;
  double rate = 0.0;  // of the speed, with `along`
};

// An interior local minimum of a gap.
struct SegmentApproach {
  int stop = 0;
  std::size_t impacts = 0;       // passed before it
  double after = 0.0;            // s since the event before it
  double gap = 0.0, rate = 0.0;  // m, and along the direction
};

// A stop that is closed: from the end of its chatter, or from the start of the segment.
struct SegmentSticking {
  int stop = 0;
  Instant<double> from, to;
  bool from_start = false, to_end = false;  // cut by the ends of the segment
  double force = 0.0;                       // contact force at `from`, N
  std::optional<double> smallest_force;     // interior local minimum, N; with `minima`
};

// A contact at a compliant stop, from its entry until its force is finally gone: a spring that
// grips again below the surface continues it. A contact cut by the start of the segment has no
// speed.
struct SegmentContact {
  int stop = 0;
  Instant<double> from, to;
  bool from_start = false, to_end = false;  // cut by the ends of the segment
  double speed = 0.0, speed_after = 0.0;    // towards the stop and away from it, m/s
  double peak_force = 0.0;                  // N
  double taken = 0.0;                       // of the structure's energy, J
  State before;
  bool parted = false;  // its force is gone, below the surface
};

// Dry friction that slips, reverses or sticks from here on.
struct SegmentRubbing {
  int friction = 0;
  Instant<double> at;
  Rubs what = Rubs::kSticks;
  double fall = 0.0;  // as of OrbitRubbing
};

// Where a gap is least between the impacts.
struct SegmentMinimum {
  int stop = 0;
  Instant<double> at;
  double gap = 0.0;  // m
};

struct TrajectorySegment {
  std::string failure;  // a sentence where the end was not reached; empty: it was
  MotionState<double> end;
  std::vector<SegmentImpact> impacts;
  std::vector<SegmentSticking> sticking;  // by the instant at which they end
  std::vector<SegmentContact> contacts;   // likewise
  std::vector<SegmentRubbing> rubbing;    // in time order
  // The smallest interior local minimum of a gap; with `minima`.
  std::optional<SegmentMinimum> lowest{};
  std::optional<double> clearance() const {  // m
    return lowest ? std::optional(lowest->gap) : std::nullopt;
  }
  std::vector<SegmentApproach> approaches;  // with `along`
};

// Follows the motion from `start` to `end`. `deviations` of the start become those of the end (both
// at fixed instants); fails where two stops are hit at one instant, where the map has no
// derivative. `parameter` likewise, at fixed forcing phases.
TrajectorySegment pass(const System& system, const MotionState<double>& start,
                       const Instant<double>& end, const SegmentOptions& options,
                       Deviations* deviations = nullptr, ParameterDeviation* parameter = nullptr);
// The same from the present state of a motion, whose cached phases are used.
TrajectorySegment pass(const System& system, Motion<double>& motion, const Instant<double>& end,
                       const SegmentOptions& options, Deviations* deviations = nullptr,
                       ParameterDeviation* parameter = nullptr);

}  // namespace graze
