// The problems of all layouts of orbits met so far, over the same parameters.
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
  // of flights. `segment`: all but the closure speed, which is that of the orbits.
  OrbitProblems(const Scene& scene, std::vector<std::string> parameters, std::vector<double> units,
                const MotionScale& scale, const SegmentOptions& segment);
  OrbitProblems(const OrbitProblems&) = delete;
  OrbitProblems& operator=(const OrbitProblems&) = delete;

  // Makes the boundaries for a problem; none are made before this is set.
  using MakeBoundaries = std::function<std::unique_ptr<BranchBoundaries>(const OrbitProblem&)>;
  void set_boundaries(MakeBoundaries make) { make_boundaries_ = std::move(make); }

  // An orbit in the unknowns of its problem.
  struct Written {
    LaidOrbits* orbits = nullptr;
    Vector u;
    double held = 0.0;  // duration for which the stop that is released there was closed, s
  };
  // The problem of one pattern, with its impacts in this order.
  LaidOrbits& flights(const ImpactPattern& pattern);
  // The problem without impacts: the response that meets no stop (ResponseEquations).
  LaidOrbits& response();
  // An orbit in the pattern's canonical order, and in all cyclic relabellings that keep the
  // pattern; none where the scene does not allow the values.
  std::vector<Written> written(const ImpactPattern& pattern,
                               const std::vector<ImpactPoint>& impacts, Parameters at);
  std::vector<Written> rewritings(const ImpactPattern& pattern,
                                  const std::vector<ImpactPoint>& impacts, Parameters at);
  // Every form in which an orbit can be continued, the preferred one first; none where its stops
  // are never released.
  std::vector<Written> written(const Orbit& orbit, Parameters at);
  LaidOrbits& doubled(const LaidOrbits& orbits);
  // The problem of period 1 on the same stroboscopic section.
  LaidOrbits& fixed_phase_once(const LaidOrbits& orbits);
  // An orbit on stroboscopic sections, solved on sections clear of its contacts
  // (SegmentEquations::clear_of_contacts), and on all sections for which problems exist.
  Written clear_of_contacts(const Written& one, Parameters at);
  std::vector<Written> on_every_section(const Written& one, Parameters at);
  // As OrbitProblem::clearer; null where that returns null.
  LaidOrbits* clearer(const LaidOrbits& orbits, const SolutionPoint& solution);

 private:
  // The existing problem of the layout, or else a new one.
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
