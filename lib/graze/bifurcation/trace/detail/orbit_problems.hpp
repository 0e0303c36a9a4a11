// The problems of all layouts that orbits were met in, over the same parameters.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graze/bifurcation/trace/detail/branch_pieces.hpp"

namespace graze {

class OrbitProblems {
 public:
  // Refers to the scene. `units`: the lengths of the parameters' ranges. `scale`: of the unknowns
  // of flights. `segment`: but for the closure speed, which is that of the orbits.
  OrbitProblems(const Scene& scene, std::vector<std::string> parameters, std::vector<double> units,
                const MotionScale& scale, const SegmentOptions& segment);
  OrbitProblems(const OrbitProblems&) = delete;
  OrbitProblems& operator=(const OrbitProblems&) = delete;

  // What a problem is traced with, of its boundaries; none are made before this is set.
  using MakeBoundaries = std::function<std::unique_ptr<BranchBoundaries>(const OrbitProblem&)>;
  void set_boundaries(MakeBoundaries make) { make_boundaries_ = std::move(make); }

  // An orbit in the unknowns of its problem.
  struct Written {
    LaidOrbits* orbits = nullptr;
    Vector u;
    double held = 0.0;  // how long the stop that is released there was closed, s
  };
  // Of one pattern, its impacts in this order.
  LaidOrbits& flights(const ImpactPattern& pattern);
  // Without impacts: the response that meets no stop (ResponseEquations).
  LaidOrbits& response();
  // In the pattern's canonical order, and from every impact that it may begin with.
  Written written(const ImpactPattern& pattern, const std::vector<ImpactPoint>& impacts);
  std::vector<Written> rewritings(const ImpactPattern& pattern,
                                  const std::vector<ImpactPoint>& impacts);
  // Every way in which it can be continued, the one to choose first; none where its stops are never
  // let go.
  std::vector<Written> written(const Orbit& orbit, Parameters at);
  LaidOrbits& doubled(const LaidOrbits& orbits);
  // Those of period 1 on the same stroboscopic section.
  LaidOrbits& fixed_phase_once(const LaidOrbits& orbits);
  // An orbit that is written on stroboscopic sections, on sections clear of its contacts
  // (SegmentEquations::clear_of_contacts) and on all those that any were kept for.
  Written clear_of_contacts(const Written& one, Parameters at);
  std::vector<Written> on_every_section(const Written& one, Parameters at);
  // As OrbitProblem::clearer; null where that is.
  LaidOrbits* clearer(const LaidOrbits& orbits, const SolutionPoint& solution);

 private:
  // What there is of the layout, or else this.
  LaidOrbits& keep(const OrbitLayout& layout, double closure_speed,
                   const std::function<std::unique_ptr<OrbitProblem>()>& make);

  const Scene& scene_;
  std::vector<std::string> parameters_;
  std::vector<double> units_;
  MotionScale scale_;
  SegmentOptions segment_;
  SystemCursor systems_;
  MakeBoundaries make_boundaries_;
  std::deque<LaidOrbits> orbits_;  // references to them stay valid
};

}  // namespace graze
