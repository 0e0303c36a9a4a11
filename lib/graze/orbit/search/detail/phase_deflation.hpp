// Keeps a search for impact phases away from what it has found (deflation).
//
// The residual is multiplied by
//
//   M(theta) = 1 + sum over known points eta^2/d(theta, point)^2 + sum over pairs of impacts of one
//              stop eta^2/d(theta_i, theta_j)^2,
//
// which is at least one, so that no solution is made or lost, and so large near the known points
// that the product does not vanish there: the residual falls like d, the factor grows like 1/d^2. A
// known point counts with all its images: with its impacts numbered from another one, and as the
// whole orbit shifted by forcing periods, to which the distance is invariant. The distance consists
// of the first phase modulo 2 pi and of the others' distances from the first modulo 2 pi p,
//
//   d^2 = (2 sin(D_0/2))^2 + sum_i>0 (2 p sin((D_i - D_0)/(2 p)))^2,     D = theta - point,
//
// the Euclidean distance between the images of the phases under `place`. The pairs are the points
// where two impacts become one, which solve the equations but are no orbits (phase_problem.hpp);
// their distance is the chord of an angle modulo 2 pi p.
#pragma once

#include <vector>

#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

class PhaseDeflation {
 public:
  // For impacts of the pattern, each with a phase of its own.
  explicit PhaseDeflation(ImpactPattern pattern) : pattern_(std::move(pattern)) {}

  const ImpactPattern& pattern() const { return pattern_; }
  // Adds a point: its impacts in time order.
  void add(const std::vector<int>& stops, const Vector& phases);
  // M at the phases and, on request, its gradient.
  double factor(const Vector& phases, Vector* gradient = nullptr) const;
  // Whether the phases are those of a known point, each to within `distance`, rad.
  bool knows(const Vector& phases, double distance) const;
  // Smallest distance between two impacts of one stop, rad; infinite without such a pair.
  double nearest_pair(const Vector& phases) const;

 private:
  // (cos theta_0, sin theta_0, .. p cos((theta_i - theta_0)/p), p sin(..) ..)
  Vector place(const Vector& phases) const;
  // The derivative by the phases of a function of the place whose gradient is `along`.
  Vector pull_back(const Vector& where, const Vector& along) const;

  ImpactPattern pattern_;
  std::vector<Vector> points_;  // places, numbered from each impact that fits the pattern
};

}  // namespace graze
