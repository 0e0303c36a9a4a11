// Traces loci of orbits in the plane of two parameters, of whatever layout, each once: folds,
// period doublings and tori by the equations of the orbits, grazings and CH by a condition of their
// own.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "graze/bifurcation/loci/detail/orbit_curve.hpp"
#include "graze/bifurcation/loci/locus_continuations.hpp"
#include "graze/bifurcation/trace/detail/orbit_problems.hpp"
#include "graze/continuation/branch/detail/known_branch.hpp"
#include "graze/continuation/locus/detail/known_loci.hpp"

namespace graze {

// In ranges of the parameters.
double distance(const OrbitLocusPoint& a, const OrbitLocusPoint& b, const LocusOptions& options);

// What came of a start.
struct LocusAnswer {
  bool known = false;               // its locus had been traced before
  std::optional<LocusTrace> trace;  // nothing where it leads to no locus either
  long long evaluations = 0;        // of the shooting equations
};

// One thread at a time.
class LocusTracer {
 public:
  // Requires that the scene allows its own values. Refers to the scene. `segment`: as of
  // OrbitProblems.
  LocusTracer(const Scene& scene, const std::string& first, const std::string& second,
              const LocusOptions& options, const SegmentOptions& segment);
  LocusTracer(const LocusTracer&) = delete;
  LocusTracer& operator=(const LocusTracer&) = delete;

  LocusAnswer trace(const OrbitLocusStart& start);
  double speed_unit() const { return scale_.speed; }  // m/s, of the forced motion

 private:
  using Written = OrbitProblems::Written;
  // LP, PD and NS of the orbits of one layout.
  struct Critical {
    std::unique_ptr<LocusOrbits> orbits;
    std::map<OrbitLocusKind, KnownLoci> traced;
  };
  // Curves of a kind of one layout, of grazing contacts at one stop.
  struct Curves {
    std::unique_ptr<OrbitCurve> curve;
    std::vector<KnownBranch> traced{};
  };
  // The unknown of a curve near a start.
  struct CurveStart {
    Curves* curves = nullptr;
    Vector unknown;
  };

  // Every way in which the equations have its orbit; the one to start from first.
  std::vector<Written> written(const OrbitLocusStart& start);
  Critical& critical_of(const LaidOrbits& orbits);
  LocusAnswer trace_critical(const OrbitLocusStart& start);
  LocusAnswer trace_along(const OrbitLocusStart& start);
  CurveStart curve_at(const OrbitLocusStart& start);
  CurveStart flight_grazing(const OrbitLocusStart& start);
  CurveStart segment_grazing(const OrbitLocusStart& start);
  CurveStart completion(const OrbitLocusStart& start);
  LocusTrace as_trace(OrbitLocusKind kind, const LocusOrbits& orbits, const Locus& locus) const;
  LocusTrace as_trace(OrbitLocusKind kind, const OrbitCurve& curve, const PlaneCurve& traced) const;
  // `sites`: of the points, those beyond its ends among them.
  struct Within;
  LocusTrace assembled(OrbitLocus frame, const LocusOrbits& orbits,
                       const std::vector<LocusSite>& sites, std::array<LocusEnd, 2> ends,
                       std::vector<Within> within) const;

  LocusOptions options_;
  MotionScale scale_;
  OrbitProblems problems_;
  std::optional<double> closure_speed_;  // m/s, that of the first orbit that is followed
  std::map<const OrbitProblem*, Critical> critical_;
  std::map<std::pair<const OrbitProblem*, int>, Curves> curves_;  // by stop; -1: of CH
};

}  // namespace graze
