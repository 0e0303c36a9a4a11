// A periodic orbit with everything that is said of it: where it impacts, whether it is stable, and
// whether it is an orbit of the system at all.
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

// What became of an impact at a compliant stop.
struct OrbitContact {
  double duration = 0.0;     // s; 0: a grazing contact, in which nothing happens
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
  double duration = 0.0;  // s; of the whole orbit where it is never released
  double force = 0.0;     // contact force that sets in, N
  // Smallest interior local minimum of the contact force, N; nothing when there is none.
  std::optional<double> smallest_force;
};

// Where motions begin that repeat an orbit: a state in each of its forcing periods, or one that
// leads through all of them.
struct OrbitSection {
  OrbitInstant at;  // of the first; the others follow a forcing period apart
  std::vector<MotionState<double>> states;
  double closure_speed = 0.0;  // m/s: the tails of chatters below it are summed
};

struct Orbit {
  int period = 1;  // p
  // In time order from the smallest (period_index, phase). Where a chatter completes, the impacts
  // that were resolved: their number depends on the closure speed.
  std::vector<OrbitImpact> impacts;
  std::vector<StickingPhase> sticking{};  // in time order; none: it does not stick
  std::vector<Eigenvalue> multipliers;    // of the map over p periods, largest modulus first
  // Nothing when a multiplier sits on the unit circle within its error.
  std::optional<bool> stable;
  // Clear of every stop between the impacts, every impact speed positive; what sticks is held by
  // its force.
  bool admissible = false;
  // Smallest interior local minimum of any stop's gap between the impacts, m; nothing when there is
  // none.
  std::optional<double> clearance;
  double residual = 0.0;  // of its equations, scaled, largest entry
  // Of an orbit that was followed; nothing where its impacts and the arcs between them tell it.
  std::optional<OrbitSection> section{};

  bool sticks() const { return !sticking.empty(); }
  // Else it is the response of the free structure.
  bool meets_stops() const { return sticks() || !impacts.empty(); }
  // For the shooting equations, which know of no sticking and no compliant stops.
  ImpactPattern pattern() const;
  std::vector<ImpactPoint> points() const;
  // Whether each impact comes after the one before it, and the first again after the last. The
  // equations also have solutions with flights that go backwards: motions through no impacts.
  bool in_order() const;
};

// The impact that stands for the orbit in a picture: the first; where the orbit sticks, and has
// stuck phases and tiny impacts come and go along its branch, the fastest. Requires an impact.
const OrbitImpact& leading_impact(const Orbit& orbit);

// The impacts of a solution of the shooting equations in time order, the one with the smallest
// phase first and in period 0.
std::vector<OrbitImpact> ordered_impacts(const System& system, const ImpactPattern& pattern,
                                         const std::vector<ImpactPoint>& points);

// How many multipliers lie outside the unit circle, and how many sit on it within their error.
struct MultiplierCount {
  int outside = 0;
  int undecided = 0;
};
MultiplierCount count_multipliers(const std::vector<Eigenvalue>& multipliers);
// Whether an orbit with these multipliers is stable; nothing where one sits on the unit circle
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
// taken in units in which the free flow only turns and shrinks, velocities by the faster of mode
// and forcing: otherwise the errors would be those of the fast modes' stiffness.
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

// Where the motion comes nearest to a stop that it does not hit there: between impacts, or at an
// impact on another stop that turns it back from this one as well.
struct NearestApproach {
  std::size_t flight = 0;  // after this impact of the pattern
  int stop = 0;            // index from 0
  double after = 0.0;      // s after that impact
  double gap = 0.0;        // m; negative: it penetrates
};

// What makes the orbit admissible or not, without its multipliers.
struct Admissibility {
  bool admissible = false;
  std::optional<NearestApproach> nearest;  // nothing where no gap has an interior minimum
  double smallest_speed = 0.0;             // m/s
  std::size_t slowest = 0;                 // the impact of the pattern that has it
  double shortest_flight = 0.0;            // from impact to impact, s; negative: out of order
  // The largest acceleration into its stop right after an impact that leaves it at rest (r = 0),
  // m/s^2: where it is positive the stop pushes back and the structure sticks, however small the
  // push is. Nothing where every impact rebounds.
  std::optional<double> push;

  std::optional<double> clearance() const {  // m
    return nearest ? std::optional(nearest->gap) : std::nullopt;
  }
};
Admissibility admissibility(const System& system, const ImpactPattern& pattern,
                            const std::vector<ImpactPoint>& points);

}  // namespace graze
