// All loci of orbits on compliant stops that have been traced so far: of folds, period doublings
// and tori (passage_equations.hpp), and of grazing (strobe_grazing.hpp).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "graze/bifurcation/locus_leads.hpp"
#include "graze/bifurcation/orbit_locus.hpp"
#include "graze/bifurcation/passage_equations.hpp"
#include "graze/bifurcation/strobe_grazing.hpp"
#include "graze/continuation/locus.hpp"

namespace graze {

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
             const LocusOptions& options, const PassageOptions& strobe);
  StrobeLoci(const StrobeLoci&) = delete;
  StrobeLoci& operator=(const StrobeLoci&) = delete;

  // Requires a start on compliant stops.
  StrobeLocusAnswer trace(const OrbitLocusStart& start);

 private:
  // Of one period and stop.
  struct Grazing {
    std::unique_ptr<StrobeGrazing> curve;
    std::vector<Branch> traced{};
  };

  StrobeLocusAnswer trace_grazing(const OrbitLocusStart& start);
  // The touch that a start is at, and the shortest orbit that has it.
  struct Touching {
    Vector u;
    Touch touch;
  };
  std::optional<Touching> touching(const OrbitLocusStart& start);
  // Of orbits with this period.
  const PassageEquations& equations(int period);
  const PassageEquations& equations_of(const Vector& u);

  OrbitLocus frame_of(OrbitLocusKind kind, int period) const;
  OrbitLocusPoint as_point(double first, double second, double angle, const Orbit& orbit) const;
  std::optional<OrbitLocusPoint> point_of(const LocusPoint& at);
  std::optional<OrbitLocusPoint> point_of(const StrobeGrazing& curve, const BranchPoint& at);
  OrbitLocus as_orbits(OrbitLocusKind kind, int period, const Locus& locus);

  LocusOptions options_;
  const Scene& scene_;
  std::vector<std::string> parameters_;
  PassageOptions strobe_;
  std::map<int, PassageEquations> equations_;  // by period
  System own_;
  Eigen::Index state_size_;  // 2N
  std::map<std::pair<int, OrbitLocusKind>, std::vector<Locus>> traced_;
  std::map<std::pair<int, int>, Grazing> grazings_;
};

}  // namespace graze
