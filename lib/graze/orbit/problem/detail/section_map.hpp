// The motion from one section to the next: the state at a forcing phase where some stops C are
// closed (or none), after a number of forcing periods, with its derivatives.
//
// While the stops C hold, the motion has N - m degrees of freedom. A state on the section is given
// by x = (y, y') in coordinates that do not move with a parameter, y = U^T T q and y' = U^T T q',
// with U an orthonormal basis of what the closed stops of one system of a family leave free; q
// follows from B^T q = a, U^T T q = y, likewise q'. Where no stop is closed, U = 1 and x is the
// whole state. T = 1, but for masses and springs, whose modes may change their sign or their order
// with a parameter, u = T q are the displacements of the masses.
//
// The map is the simulated motion, certified as in a run, and so are its fixed points. It is smooth
// through every contact on a compliant stop whose force sets in without a jump; at other grazing
// contacts it has a corner.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graze/flow/variation/detail/sprung_deviation.hpp"
#include "graze/orbit/problem/detail/trajectory_segment.hpp"

namespace graze {

// Error of the map's slopes through contacts on springs, in its units: ten times that of a step of
// the deviations. On rigid stops alone they are closed forms, to rounding.
inline constexpr double kMapAccuracy = 10.0 * kDeviationTolerance;

class SectionMap {
 public:
  // `reference`: the system whose rows and units make the coordinates. Requires forcing. `closed`:
  // C in rising order, with independent rows.
  SectionMap(const System& reference, std::vector<int> closed, const SegmentOptions& options);

  const SegmentOptions& options() const { return options_; }
  const std::vector<int>& closed() const { return closed_; }
  Eigen::Index size() const { return unit_.size(); }  // 2(N - m)
  const Vector& unit() const { return unit_; }        // of x
  Vector pack(const System& system, const State& state) const;
  // Its derivative by a parameter along which the state moves at the rate `moved`.
  Vector pack_rate(const System& system, const System& tangent, const State& at,
                   const State& moved) const;

  // The state of x, and its derivative by y, which is also that of q' by y'.
  struct Chart {
    State state;
    Matrix slope;  // V with B^T V = 0, U^T V = 1; N x (N - m)
  };
  // Returns nullopt when the rows have turned so far that the coordinates no longer determine the
  // state.
  std::optional<Chart> chart_at(const System& system, const Vector& x) const;
  // Derivative of the state by a parameter at a fixed x, and of the motion that starts from there.
  State chart_rate(const System& system, const System& tangent, const State& at) const;
  ParameterDeviation moved_start(const System& system, const System& tangent, const State& at,
                                 const MotionState<double>& start) const;
  // Derivative of x by the state at its instant.
  Matrix seen(const System& system, const Matrix& q, const Matrix& qdot) const;

  // The start of the motion from x at phase theta, rad, within the forcing period 0. Returns
  // nullopt where chart_at does, when a rigid stop is penetrated, or a compliant one so deep that
  // its damping would keep the structure for longer than can be followed.
  std::optional<MotionState<double>> start_of(const System& system, const Vector& x,
                                              double theta) const;

  struct Image {
    MotionState<double> end;
    Vector image;          // 2(N - m)
    Matrix jacobian;       // by x
    Vector by_start;       // by the phase at which it starts, per rad, where that moves
    Vector by_end;         // by the one at which it ends
    Matrix by_parameters;  // a column for each tangent
    std::vector<SegmentContact> contacts;
  };
  // The image after whole periods; `moves`: the section's phase is an unknown. Returns nullopt when
  // the motion cannot be followed.
  std::optional<Image> image(const System& system, const Vector& x, double theta, int periods,
                             bool moves, std::span<const System* const> tangents) const;
  // Why image() is nullopt; empty where it is not.
  std::string why_no_image(const System& system, const Vector& x, double theta, int periods) const;
  // The motion over as many periods; nullopt likewise. `minima`: as in SegmentOptions.
  std::optional<TrajectorySegment> follow(const System& system, const Vector& x, double theta,
                                          int periods, bool minima = false) const;
  // The same along a direction of (theta where it moves, x) and of the parameter.
  std::optional<TrajectorySegment> follow_along(const System& system, const Vector& x, double theta,
                                                int periods, bool moves, const System& tangent,
                                                const Vector& direction,
                                                double parameter_rate) const;

  // The motion at a forcing angle after the section, angle >= 0.
  struct Within {
    State state;
    MotionState<double> at;  // that motion goes on from
    Deviations by_state;     // by x
    State by_start;          // by the phase at which it starts, per rad, where that moves
    State by_angle;          // per rad
    std::vector<State> by_parameters;
  };
  std::optional<Within> within(const System& system, const Vector& x, double theta, double angle,
                               bool moves, std::span<const System* const> tangents) const;
  // The same section for motions in which a stop is ignored for some time.
  SectionMap leaving_out(const LeftOut& one) const;

 private:
  Deviations start_deviations(const System& system, const MotionState<double>& start,
                              const Chart& chart, bool moves) const;

  Matrix seen_by(const System& system) const;      // U^T T
  // [B^T; U^T T], which determines q.
  Matrix determining(const System& system) const;

  SegmentOptions options_;
  std::vector<int> closed_;
  Matrix basis_;  // U, N x (N - m)
  Vector unit_;   // of (y, y')
};

// Seconds from one instant of a system to another.
double seconds_between(const System& system, const Instant<double>& from,
                       const Instant<double>& to);

// (q', q'') of a motion at its state, with closed stops and springs.
State rate_of(const System& system, const MotionState<double>& at);

// The stops that are closed there, in rising order.
std::vector<int> closed_stops(const MotionState<double>& at);

}  // namespace graze
