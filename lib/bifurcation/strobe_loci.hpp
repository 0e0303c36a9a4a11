// Loci of folds, period doublings and tori of orbits on compliant stops: those of the stroboscopic
// map (strobe_map.hpp) over two parameters of the scene.
//
// The equations need first derivatives of the map, which are integrated. The slope of their last
// one, for a critical multiplier, would need second ones; it is told by differences of the first.
// Newton's method ends where the equations hold, so that a solution does not depend on that slope,
// only how quickly it is reached.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/orbit_locus.hpp"
#include "graze/continuation/locus.hpp"
#include "graze/continuation/plane_map.hpp"
#include "graze/orbit/strobe_map.hpp"

namespace graze {

// A critical orbit on compliant stops, at or near a locus; not of grazing.
struct StrobeLocusStart {
  OrbitLocusKind kind = OrbitLocusKind::kFold;
  std::vector<State> turns;  // at the starts of its forcing periods
  double first = 0.0, second = 0.0;
  Complex multiplier = 1.0;  // of NS: one of the pair
};

struct StrobeLocusAnswer {
  bool known = false;               // its locus had been traced before
  std::optional<OrbitLocus> locus;  // nothing where the start leads to none either
  long long evaluations = 0;
};

// All that have been traced so far. One thread at a time.
class StrobeLoci {
 public:
  // Requires that the scene allows its own values. Refers to the scene.
  StrobeLoci(const Scene& scene, const std::string& first, const std::string& second,
             const LocusOptions& options, const StrobeOptions& strobe);
  StrobeLoci(const StrobeLoci&) = delete;
  StrobeLoci& operator=(const StrobeLoci&) = delete;

  StrobeLocusAnswer trace(const StrobeLocusStart& start);

 private:
  std::optional<PlaneMapEvaluation> evaluate(const Vector& x, double p, double q) const;
  std::optional<double> product(const Vector& x, double p, double q, const Vector& left,
                                const Vector& right) const;
  std::optional<Vector> curvature(const Vector& x, double p, double q, const Vector& left,
                                  const Vector& right) const;
  const PlaneProblem& problem(int period);
  std::optional<OrbitLocusPoint> point_of(const LocusPoint& at) const;
  OrbitLocus as_orbits(OrbitLocusKind kind, int period, const Locus& locus) const;

  mutable SystemCursor systems_;
  LocusOptions options_;
  StrobeMap map_;
  std::map<int, PlaneProblem> problems_;  // by period
  std::map<std::pair<int, OrbitLocusKind>, std::vector<Locus>> traced_;
};

}  // namespace graze
