// Keeps a search for impact phases away from what it has found (deflation).
//
// The residual is multiplied by
//
//   M(theta) = 1 + sum over known points eta^2/d(theta, point)^2 + sum over pairs of impacts of one
//              stop eta^2/d(theta_i, theta_j)^2,
//
// which is at least one, so that no solution is made or lost, and so large near the known points
// that the product does not vanish there: the residual falls like d, the factor grows like 1/d^2.
// Known points count with all their images on the torus: impacts numbered from another one, the
// whole orbit later by some forcing periods. The pairs are the points where two impacts become one,
// which solve the equations but are no orbits (phase_problem.hpp). Distances are chords of the
// circle of p turns, 2 p sin(difference/(2 p)), the same length as the difference where it is
// small.
#pragma once

#include <vector>

#include "graze/orbit/shooting.hpp"

namespace graze {

class PhaseDeflation {
 public:
  // For impacts of the pattern, each with a phase of its own.
  explicit PhaseDeflation(ImpactPattern pattern) : pattern_(std::move(pattern)) {}

  const ImpactPattern& pattern() const { return pattern_; }
  // Adds a point: its impacts in time order.
  void add(const std::vector<int>& stops, const Vector& phases);
  // M at the phases and, where asked for, its gradient.
  double factor(const Vector& phases, Vector* gradient = nullptr) const;
  // Whether the phases are those of a known point, each to within `distance`, rad.
  bool knows(const Vector& phases, double distance) const;
  // Smallest distance between two impacts of one stop, rad; infinite without such a pair.
  double nearest_pair(const Vector& phases) const;

 private:
  double chord(double difference) const;

  ImpactPattern pattern_;
  std::vector<Vector> points_;  // all images
};

}  // namespace graze
