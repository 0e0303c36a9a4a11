// All loci of orbits that are followed, those that stick and those on compliant stops, that have
// been traced so far: of folds, period doublings and tori (passage_equations.hpp), and of grazing
// on compliant stops (strobe_grazing.hpp), and of CH (completion_curve.hpp).
//
// Orbits that stick stay on their locus as long as their stuck phases, and the impacts that lead to
// none, are the same: it ends at CH or GR, which is bracketed.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "graze/bifurcation/completion_curve.hpp"
#include "graze/bifurcation/locus_leads.hpp"
#include "graze/bifurcation/orbit_locus.hpp"
#include "graze/bifurcation/passage_equations.hpp"
#include "graze/bifurcation/strobe_grazing.hpp"
#include "graze/continuation/locus.hpp"
#include "graze/orbit/laid_orbit.hpp"

namespace graze {

struct PassageLocusAnswer {
  bool known = false;               // its locus had been traced before
  std::optional<OrbitLocus> locus;  // nothing where the start leads to none either
  long long evaluations = 0;
};

// One thread at a time.
class PassageLoci {
 public:
  // Requires that the scene allows its own values. Refers to the scene. `passage`: but for the
  // closure speed, which is that of the orbits.
  PassageLoci(const Scene& scene, const std::string& first, const std::string& second,
              const LocusOptions& options, const PassageOptions& passage);
  PassageLoci(const PassageLoci&) = delete;
  PassageLoci& operator=(const PassageLoci&) = delete;

  // Requires a start that is followed.
  PassageLocusAnswer trace(const OrbitLocusStart& start);

 private:
  // Traced curves of one kind of equations, which are not moved.
  template <class Curve>
  struct Curves {
    std::unique_ptr<Curve> curve;
    std::vector<Branch> traced{};
  };
  // The orbits of one layout, chatters closed as in the first of them, and what has been traced.
  struct Orbits {
    std::unique_ptr<PassageEquations> equations;
    std::map<OrbitLocusKind, std::vector<Locus>> traced{};
    std::map<int, Curves<StrobeGrazing>> grazings{};  // by stop
    Curves<CompletionCurve> completions{};
  };
  // An orbit in its unknowns.
  struct Written {
    Orbits* orbits = nullptr;
    Vector u;
  };

  Orbits& orbits_of(const PassageLayout& layout, double closure_speed);
  // Every way in which the equations have it; the one to start from first.
  std::vector<Written> written(const OrbitLocusStart& start);
  std::vector<LaidOrbit> layouts(const OrbitLocusStart& start);
  Written written_in(const LaidOrbit& laid, double closure_speed);
  LocusOptions options_for(const Orbits& orbits) const;
  PassageLocusAnswer trace_grazing(const OrbitLocusStart& start);
  PassageLocusAnswer trace_completion(const OrbitLocusStart& start);
  // The curve through the point near this unknown. `same`: all that are one orbit.
  template <class Curve>
  PassageLocusAnswer trace_curve_near(
      const Orbits& orbits, Curves<Curve>& curves, const OrbitLocusStart& start,
      const Vector& unknown,
      const std::function<std::vector<BranchPoint>(const BranchPoint&)>& same) const;
  // The touch that a start is at, and the shortest orbit that has it.
  struct Touching {
    Written at;
    Touch touch;
  };
  std::optional<Touching> touching(const OrbitLocusStart& start);

  std::optional<OrbitLocusPoint> point_of(const Orbits& orbits, const LocusPoint& at) const;
  OrbitLocus as_orbits(const Orbits& orbits, OrbitLocusKind kind, const Locus& locus) const;

  const Scene& scene_;
  std::vector<std::string> parameters_;
  LocusOptions options_;
  PassageOptions passage_;
  SystemCursor systems_;
  System own_;
  std::deque<Orbits> orbits_;
};

}  // namespace graze
