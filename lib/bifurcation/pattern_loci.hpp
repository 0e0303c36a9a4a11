// All loci of one impact pattern that have been traced so far: what lies on them need not be traced
// again. Those of folds, period doublings and tori are solutions of the equations of locus.hpp,
// those of grazing of grazing_curve.hpp.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "graze/bifurcation/canonical_pattern.hpp"
#include "graze/bifurcation/flight_equations.hpp"
#include "graze/bifurcation/grazing_curve.hpp"
#include "graze/bifurcation/locus_leads.hpp"
#include "graze/bifurcation/locus_parts.hpp"
#include "graze/continuation/locus.hpp"

namespace graze {

// The plane that loci are sought in.
struct LocusPlane {
  const Scene* scene = nullptr;
  std::string first, second;
  MotionScale scale;
  LocusOptions options;

  double speed_unit() const { return scale.speed; }  // m/s
};

// In ranges of the parameters.
double distance(const OrbitLocusPoint& a, const OrbitLocusPoint& b, const LocusOptions& options);

// What came of a start.
struct LocusAnswer {
  bool known = false;               // its locus had been traced before
  std::optional<LocusTrace> trace;  // nothing where it leads to no locus either
  long long evaluations = 0;        // of the shooting equations
};

// Of folds, period doublings or tori of one pattern in its canonical order.
class CriticalLoci {
 public:
  CriticalLoci(const LocusPlane& plane, OrbitLocusKind kind, const ImpactPattern& pattern);
  CriticalLoci(const CriticalLoci&) = delete;
  CriticalLoci& operator=(const CriticalLoci&) = delete;
  LocusAnswer trace(const OrbitLocusStart& start);

 private:
  bool knows(const OrbitLocusStart& start) const;
  // `zero`: the margin that vanishes there, where one does.
  LocusPlace place(const LocusPoint& at, std::optional<LocusMargin> zero = {}) const;
  std::optional<Vector> margins(const LocusPoint& at) const;
  Vector speeds(const LocusPoint& at) const;

  OrbitLocusKind kind_;
  FlightEquations orbits_;
  LocusOptions options_;
  double speed_unit_;  // m/s
  std::vector<Locus> traced_;
};

// Of grazing orbits of one pattern that begins with the touch.
class GrazingLoci {
 public:
  GrazingLoci(const LocusPlane& plane, const ImpactPattern& pattern);
  GrazingLoci(const GrazingLoci&) = delete;
  GrazingLoci& operator=(const GrazingLoci&) = delete;
  LocusAnswer trace(const OrbitLocusStart& start);

 private:
  LocusPlace place(const BranchPoint& at, std::optional<LocusMargin> zero = {}) const;
  std::optional<Vector> tests(const BranchPoint& at) const;
  Vector speeds(const BranchPoint& at) const;

  LocusOptions options_;
  GrazingCurve curve_;
  PlaneCurveProblem problem_;
  double speed_unit_;  // m/s
  std::vector<Branch> traced_;
};

}  // namespace graze
