// An orbit that sticks as a fixed point at the instant of a release: the equations that are
// continued over a parameter.
//
// The stops C are closed up to the forcing phase theta, where the contact force of one of them
// falls to zero. Unknown are theta and the state of the held motion there, in coordinates that do
// not move with the parameter, y = U^T q and y' = U^T q' with U at right angles to the rows of one
// system of the family; q follows from B^T q = a, U^T q = y, likewise q'. Equations:
//
//   force(theta, y, y') = 0,     P(theta, y, y') - (y, y') = 0,      2(N - m) + 1 in all,
//
// P the motion over p forcing periods from phase theta, seen in the same coordinates. With N = m
// held directions only theta is left, and the first equation alone.
//
// P is the simulator's own motion, and it goes on being continuous where a chatter no longer
// completes: the motion then comes near the stop instead of to rest on it. Such a solution is no
// orbit (`ReleaseReturn::returns`); it lets the end of a branch be bracketed from both sides.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/itinerary.hpp"
#include "graze/orbit/sticking_orbit.hpp"

namespace graze {

// A release of a periodic motion: which stops are closed just before, and which one lets go.
struct Release {
  int period = 1;           // p
  std::vector<int> closed;  // C in rising order, the released one among them
  int released = 0;
};

// What became of the motion over p periods.
struct ReleaseReturn {
  Passage passage;
  // The stops that were closed by a chatter (or an impact with r = 0), in time order.
  std::vector<int> holds;
  bool returns = false;  // to the same stops, released at the section
  // The shortest of these stuck phases, s; infinite where there is none.
  double shortest_hold = 0.0;
  // What happens in time order: the stops of impacts that are not of a chatter, and -1 - stop for a
  // stuck phase that begins. Changes where such an impact is born or lost, but also where two
  // impacts at the head of a chatter come to be equally fast.
  std::vector<int> itinerary;
  // The slowest impact that is not of a chatter, a run of ever slower impacts on a stop that leads
  // to a stuck phase on it, m/s; infinite where there is none.
  double slowest = 0.0;
};

class ReleaseSection {
 public:
  struct Equations {
    Vector residual;              // scaled
    Matrix jacobian;              // by the unknowns
    Vector parameter_derivative;  // where a tangent was given
    Matrix map;                   // DP at fixed theta, scaled, 2(N - m)
  };

  // `reference`: the system whose rows and units make the coordinates. Requires forcing.
  ReleaseSection(const System& reference, Release release, const PassageOptions& options);

  const Release& release() const { return release_; }
  // The same section, in the same coordinates, of orbits of another period.
  ReleaseSection over(int period) const {
    ReleaseSection other = *this;
    other.release_.period = period;
    return other;
  }
  Eigen::Index size() const { return 1 + 2 * freedoms(); }

  // Unknowns of a state at forcing phase theta, rad.
  Vector pack(double theta, const State& state) const;
  // The state that they stand for, its stops closed; nothing where the rows have turned into the
  // coordinates.
  std::optional<MotionState<double>> state_of(const System& system, const Vector& u) const;

  // Nothing where the motion cannot be followed.
  std::optional<Equations> evaluate(const System& system, const Vector& u,
                                    const System* tangent = nullptr) const;
  // The multipliers of the solution: those of P, and 2m exact zeros.
  std::vector<Eigenvalue> multipliers(const System& system, const Vector& u) const;

  // `minima`: as in PassageOptions.
  std::optional<ReleaseReturn> follow(const System& system, const Vector& u,
                                      bool minima = false) const;
  // In time order; `direction`: rates of the unknowns and of the parameter that moves the system
  // along `tangent`.
  std::optional<std::vector<PassageMargin>> margins(const System& system, const Vector& u,
                                                    const System& tangent, const Vector& direction,
                                                    double parameter_rate) const;
  // The orbit of a solution that returns.
  std::optional<Orbit> orbit(const System& system, const Vector& u) const;

 private:
  Eigen::Index freedoms() const { return basis_.cols(); }
  double theta_of(const Vector& u) const { return u[0]; }
  struct Chart;
  std::optional<Chart> chart_at(const System& system, const Vector& u) const;
  void add_force(const System& system, const Vector& u, const Chart& chart, const System* tangent,
                 const State& chart_rate, Equations& equations) const;
  State chart_rate(const System& tangent, const Chart& chart) const;
  Deviations start_deviations(const System& system, const Chart& chart) const;
  bool add_return(const System& system, const Vector& u, const Chart& chart, const System* tangent,
                  const State& chart_rate, Equations& equations) const;
  Instant<double> end_of(const MotionState<double>& start) const;

  Release release_;
  PassageOptions options_;
  Matrix basis_;     // U, N x (N - m)
  Vector unit_;      // of (y, y')
  double push_ = 1;  // unit of the force equation, m/s^2
};

// The releases of an orbit that sticks, that of the most closed stops first, and of these the one
// after the longest stuck phase; with the unknowns they are at in sections of their own. Empty
// where its stops are never let go.
struct OrbitRelease {
  Release release;
  double theta = 0.0;  // rad
  State state;
};
std::vector<OrbitRelease> releases_of(const System& system, const Orbit& orbit,
                                      const PassageOptions& options);

}  // namespace graze
