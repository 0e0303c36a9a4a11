// A periodic orbit with everything that is said of it: where it impacts, whether it is stable, and
// whether it is an orbit of the system at all.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/decompositions.hpp"
#include "graze/orbit/shooting.hpp"

namespace graze {

struct OrbitImpact {
  int stop = 0;          // index from 0
  int period_index = 0;  // forcing period within the orbit, 0..p-1
  double phase = 0.0;    // (frequency t + phase) mod 2 pi, rad
  double speed = 0.0;    // approach speed, m/s; negative only on virtual orbits
  State before;          // just before the impact
};

struct Orbit {
  int period = 1;                       // p
  std::vector<OrbitImpact> impacts;     // in time order from the smallest (period_index, phase)
  std::vector<Eigenvalue> multipliers;  // of the map over p periods, largest modulus first
  // Nothing when a multiplier sits on the unit circle within its error.
  std::optional<bool> stable;
  // Clear of every stop between the impacts, every impact speed positive.
  bool admissible = false;
  // Smallest interior local minimum of any stop's gap between the impacts, m; nothing when there is
  // none.
  std::optional<double> clearance;
  double residual = 0.0;  // of the shooting equations, scaled, largest entry

  ImpactPattern pattern() const;
  std::vector<ImpactPoint> points() const;
};

// How many multipliers lie outside the unit circle, and how many sit on it within their error.
struct MultiplierCount {
  int outside = 0;
  int undecided = 0;
};
MultiplierCount count_multipliers(const std::vector<Eigenvalue>& multipliers);

// The saltation matrix of an impact: how a deviation just before it, at a fixed time, becomes one
// just after: S = J + (f+ - J f-) c^T/(c^T f-), with c the contact row and f the vector field.
Matrix saltation_matrix(const System& system, const RigidStop& stop, const State& before,
                        double theta);

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
                                          const std::vector<ImpactPoint>& points);

// Assembles the orbit of a solution of the shooting equations, with its multipliers where they are
// known already.
Orbit make_orbit(const System& system, const ShootingProblem& problem, const Vector& solution);
Orbit make_orbit(const System& system, const ShootingProblem& problem, const Vector& solution,
                 std::vector<Eigenvalue> multipliers);

// Where the motion comes nearest to a stop between impacts.
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

  std::optional<double> clearance() const {  // m
    return nearest ? std::optional(nearest->gap) : std::nullopt;
  }
};
Admissibility admissibility(const System& system, const ImpactPattern& pattern,
                            const std::vector<ImpactPoint>& points);

}  // namespace graze
