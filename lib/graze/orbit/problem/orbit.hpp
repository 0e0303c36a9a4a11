// A periodic orbit with its properties: its impacts, its stability, and whether it is admissible.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/flow/exact/motion_state.hpp"
#include "graze/orbit/problem/impact_pattern.hpp"

namespace graze {

class ShootingProblem;

// A time within an orbit.
struct OrbitInstant {
  int period_index = 0;  // forcing period within the orbit, 0..p-1
  double phase = 0.0;    // (frequency t + phase) mod 2 pi, rad
};

// The contact of an impact at a compliant stop.
struct OrbitContact {
  double duration = 0.0;     // s; 0: a grazing contact, without any effect
  double speed_after = 0.0;  // away from the stop, m/s
  double peak_force = 0.0;   // N
  double taken = 0.0;        // of the structure's energy, J
};

struct OrbitImpact {
  int stop = 0;                           // index from 0
  int period_index = 0;                   // forcing period within the orbit, 0..p-1
  double phase = 0.0;                     // (frequency t + phase) mod 2 pi, rad
  double speed = 0.0;                     // approach speed, m/s; negative only on virtual orbits
  State before;                           // just before the impact
  std::optional<OrbitContact> contact{};  // at a compliant stop
};

// A stop closed from the end of its chatter (or an impact with r = 0) to its release.
struct StickingPhase {
  int stop = 0;
  OrbitInstant from, to;
  double duration = 0.0;  // s; of the whole orbit when the stop is never released
  double force = 0.0;     // contact force that sets in, N
  // Smallest interior local minimum of the contact force, N; nullopt when there is none.
  std::optional<double> smallest_force;
};

// Dry friction that slides one way, or sticks, from here on.
struct OrbitRubbing {
  int friction = 0;  // index from 0
  OrbitInstant at;
  Rubs what = Rubs::kSticks;
  double fall =
      0.0;  // of the speed of sliding where that ends, in parts of what friction alone does
};

// Starts of motions that repeat an orbit: a state in each of its forcing periods, or one state
// whose motion goes through all of them.
struct OrbitSection {
  OrbitInstant at;  // of the first; the others follow a forcing period apart
  std::vector<MotionState<double>> states;
  double closure_speed = 0.0;  // m/s: the tails of chatters below it are summed
};

struct Orbit {
  int period = 1;  // p
  std::optional<double> lasts{};  // s, of a self-excited one, whose period is its own
  // In time order from the smallest (period_index, phase). Of a chatter that completes, the
  // resolved impacts: their number depends on the closure speed.
  std::vector<OrbitImpact> impacts;
  std::vector<StickingPhase> sticking{};  // in time order; none: it does not stick
  std::vector<OrbitRubbing> rubbing{};    // in time order
  std::vector<Eigenvalue> multipliers;    // of the map over p periods, largest modulus first
  // nullopt when a multiplier lies on the unit circle within its error.
  std::optional<bool> stable;
  // Whether it is clear of every stop between the impacts, with positive impact speeds and contact
  // forces.
  bool admissible = false;
  // Smallest interior local minimum of any stop's gap between the impacts, m; nullopt when there is
  // none.
  std::optional<double> clearance;
  double residual = 0.0;  // of its equations, scaled, largest entry
  // Set for an orbit that was followed; nullopt when its impacts and the flights between them
  // define it.
  std::optional<OrbitSection> section{};

  bool sticks() const { return !sticking.empty(); }
  // False for the response of the free structure.
  bool meets_stops() const { return sticks() || !impacts.empty(); }
  // The system whose phase turns once in its period, where that is its own.
  System timed(const System& system) const;
  // For the shooting equations, which support neither sticking nor compliant stops.
  ImpactPattern pattern() const;
  std::vector<ImpactPoint> points() const;
  // Whether each impact comes after the previous one, and the first again after the last. The
  // equations also have solutions with flights that go backwards in time, which are no motions.
  bool in_order() const;
};

// The impact that represents the orbit in a picture: the first; for an orbit that sticks the
// fastest, as stuck phases and tiny impacts come and go along its branch. Requires an impact.
const OrbitImpact& leading_impact(const Orbit& orbit);

// The impacts of a solution of the shooting equations in time order, the one with the smallest
// phase first and in period 0.
std::vector<OrbitImpact> ordered_impacts(const System& system, const ImpactPattern& pattern,
                                         const std::vector<ImpactPoint>& points);

// Number of multipliers outside the unit circle, and on it within their error.
struct MultiplierCount {
  int outside = 0;
  int undecided = 0;
};
MultiplierCount count_multipliers(const std::vector<Eigenvalue>& multipliers);
// Whether an orbit with these multipliers is stable; nullopt when one lies on the unit circle
// within its error, or none is known.
std::optional<bool> stability(const std::vector<Eigenvalue>& multipliers);

// The linearised map from just before each impact to just before the next one, flow times
// saltation, 2N x 2N each, in time order from the first impact on.
std::vector<Matrix> impact_factors(const System& system, const ImpactPattern& pattern,
                                   const std::vector<ImpactPoint>& points);

// Their product: the linearised map over the orbit, from just before its first impact.
Matrix monodromy_matrix(const System& system, const ImpactPattern& pattern,
                        const std::vector<ImpactPoint>& points);

// Eigenvalues of the product of the impact factors, never formed for several impacts. They are
// computed in units in which the free flow only rotates and shrinks, velocities by the larger of
// the frequencies of mode and forcing: otherwise their errors would grow with the stiffness of fast
// modes.
//
// Next to grazing the impact factor grows like 1/v and one multiplier falls like v. A pair of sizes
// |A| and 1/|A| leaves the smaller one a relative error of eps |A|^2 in the product of flow and
// saltation; where that takes more than half of the digits, |A| > eps^(-1/4), the two stay separate
// factors. Empty when the iteration does not converge.
std::vector<Eigenvalue> orbit_multipliers(const System& system, const ImpactPattern& pattern,
                                          const std::vector<ImpactPoint>& points,
                                          ErrorBounds errors = ErrorBounds::kGiven);

// Assembles the orbit of a solution of the shooting equations, with its multipliers where they are
// known already.
Orbit make_orbit(const System& system, const ShootingProblem& problem, const Vector& solution);
Orbit make_orbit(const System& system, const ShootingProblem& problem, const Vector& solution,
                 std::vector<Eigenvalue> multipliers);

// The nearest approach of the motion to a stop that it does not hit there: between impacts, or at
// an impact on another stop that turns it back from this one as well.
struct NearestApproach {
  std::size_t flight = 0;  // after this impact of the pattern
  int stop = 0;            // index from 0
  double after = 0.0;      // s after that impact
  double gap = 0.0;        // m; negative: it penetrates
};

// Whether the orbit is admissible, and why, without its multipliers.
struct Admissibility {
  bool admissible = false;
  std::optional<NearestApproach> nearest;  // nullopt when no gap has an interior minimum
  double smallest_speed = 0.0;             // m/s
  std::size_t slowest = 0;                 // the impact of the pattern at that speed
  double shortest_flight = 0.0;            // from impact to impact, s; negative: out of order
  // The largest acceleration into its stop right after an impact that leaves it at rest (r = 0),
  // m/s^2: where it is positive the stop pushes back and the structure sticks, however small the
  // push is. nullopt when every impact rebounds.
  std::optional<double> push;

  std::optional<double> clearance() const {  // m
    return nearest ? std::optional(nearest->gap) : std::nullopt;
  }
};
Admissibility admissibility(const System& system, const ImpactPattern& pattern,
                            const std::vector<ImpactPoint>& points);

}  // namespace graze
