// Traces loci of orbits of any layout in the plane of two parameters, each once: folds, period
// doublings and tori by the equations of the orbits, grazings and CH by equations of their own.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "graze/bifurcation/loci/detail/orbit_curve.hpp"
#include "graze/bifurcation/loci/locus_continuations.hpp"
#include "graze/bifurcation/problem/branch_options.hpp"
#include "graze/bifurcation/problem/orbit_level.hpp"
#include "graze/bifurcation/trace/detail/orbit_problems.hpp"
#include "graze/continuation/branch/detail/known_branch.hpp"
#include "graze/continuation/locus/detail/known_loci.hpp"
#include "graze/continuation/locus/locus.hpp"

namespace graze {

// The locus of a start.
struct LocusAnswer {
  std::optional<LocusTrace> trace;   // nullopt when the start leads to no locus
  std::optional<Locus> critical;     // the same as it was traced, of LP, PD and NS,
  std::vector<SolutionPoint> curve;  // or of GR and CH
  long long evaluations = 0;         // of the shooting equations
};

// For one thread at a time.
class LocusTracer {
 public:
  // Requires that the scene allows its own values. Refers to the scene and to the options of the
  // orbits: their levels, and whether zeros of normal forms are marked, GPD and GNS. `segment`: as
  // of OrbitProblems.
  LocusTracer(const Scene& scene, const std::string& first, const std::string& second,
              const LocusOptions& options, const SegmentOptions& segment,
              const BranchOptions& orbits);
  LocusTracer(const LocusTracer&) = delete;
  LocusTracer& operator=(const LocusTracer&) = delete;

  // Whether the start leads to a known locus.
  bool knows(const OrbitLocusStart& start);
  // Its locus, known or not: depends only on the start and on the closure speed.
  LocusAnswer trace(const OrbitLocusStart& start);
  // Adds the locus of a start to the known ones.
  void know(const OrbitLocusStart& start, LocusAnswer answer);

  // m/s, that of the first orbit that has one; nullopt before.
  std::optional<double> closure_speed() const { return closure_speed_; }
  void set_closure_speed(std::optional<double> speed) { closure_speed_ = speed; }
  double speed_unit() const { return scale_.speed; }  // m/s, of the forced motion

 private:
  using Written = OrbitProblems::Written;
  // LP, PD and NS of the orbits of one layout.
  struct Critical {
    std::unique_ptr<LocusOrbits> orbits;
    std::map<OrbitLocusKind, KnownLoci> traced;
  };
  // Curves of a kind of one layout, of grazing contacts at one stop or of one level.
  struct Curves {
    std::unique_ptr<OrbitCurve> curve;
    std::vector<KnownBranch> traced{};
  };
  // The unknown of a curve near a start.
  struct CurveStart {
    Curves* curves = nullptr;
    Vector unknown;
  };

  // Every form of its orbit as a solution of the equations; the preferred one first.
  std::vector<Written> written(const OrbitLocusStart& start);
  Critical& critical_of(const LaidOrbits& orbits);
  static bool is_along(OrbitLocusKind kind);  // a curve with a condition of its own
  LocusOptions options_for(const LocusOrbits& orbits) const;
  void mark_zeros(LocusOptions& options, const LaidOrbits& orbits);  // of normal forms
  LocusOptions options_along(const OrbitCurve& curve) const;
  bool knows_critical(const OrbitLocusStart& start);
  bool knows_along(const OrbitLocusStart& start);
  LocusAnswer trace_critical(const OrbitLocusStart& start);
  LocusAnswer trace_along(const OrbitLocusStart& start);
  CurveStart curve_at(const OrbitLocusStart& start);
  CurveStart flight_grazing(const OrbitLocusStart& start);
  CurveStart segment_grazing(const OrbitLocusStart& start);
  CurveStart completion(const OrbitLocusStart& start);
  CurveStart level(const OrbitLocusStart& start);
  CurveStart level_from(const OrbitLocusStart& start, const Written& one);
  std::vector<CurveStart> forms_of(const OrbitLocusStart& start);
  bool is_known(const CurveStart& at, double second) const;
  LocusTrace as_trace(OrbitLocusKind kind, const LocusOrbits& orbits, const Locus& locus) const;
  LocusTrace as_trace(const OrbitLocusStart& start, const OrbitCurve& curve,
                      const PlaneCurve& traced) const;
  // `sites`: of the points, including those beyond its ends.
  struct Within;
  LocusTrace assembled(OrbitLocus frame, const LocusOrbits& orbits,
                       const std::vector<LocusSite>& sites, std::array<LocusEnd, 2> ends,
                       std::vector<Within> within) const;

  LocusOptions options_;
  const BranchOptions& orbits_;
  MotionScale scale_;
  OrbitProblems problems_;
  std::optional<double> closure_speed_;  // m/s, that of the first orbit that is followed
  std::map<const OrbitProblem*, Critical> critical_;
  std::map<std::pair<const OrbitProblem*, int>, Curves>
      curves_;  // by stop; -1: of CH, -2, ..: of levels
};

}  // namespace graze
