// Starts for the branches of (p, 1) solutions over a parameter's range, one for each part that they
// may have, and a name for the connected set each solution belongs to.
//
// Where the restitution is constant the intervals with solutions are known (solution_ranges.hpp):
// none is too narrow to be given its starts. Where along them the solutions are orbits of the
// system is sought by bounds (admissible_runs.hpp) or, where these do not hold, sampled evenly over
// the range and over every interval: a run of orbits narrower than the distance of the samples may
// then be passed over.
#pragma once

#include <optional>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/bounds/detail/solution_ranges.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

class ClosedFormSurvey {
 public:
  struct Start {
    double value = 0.0;  // of the parameter
    ImpactPoint point;
  };

  // Surveys [lowest, highest] for impacts on a stop (index from 0) every `period` forcing periods,
  // whose restitution is constant.
  ClosedFormSurvey(const SystemFamily& family, int stop, int period, double lowest, double highest);

  // A solution of each family in every interval.
  void start_in_every_range();
  // One in every run of samples at which the solution is an orbit of the system; of those before it
  // was asked to stop (stop_scope.hpp).
  void start_in_every_run();

  const std::vector<Start>& starts() const { return starts_; }
  const SolutionRanges& ranges() const { return ranges_; }
  // Values at which solutions were judged, and the distance of those that are spread over the
  // range; none and 0 where nothing was sampled.
  int samples() const { return samples_; }
  double spacing() const { return spacing_; }

 private:
  std::vector<ImpactPoint> solutions_at(double value, std::optional<System>& system) const;

  const SystemFamily& family_;
  int stop_, period_;
  SolutionRanges ranges_;
  std::vector<Start> starts_;
  int samples_ = 0;
  double spacing_ = 0.0;
};

}  // namespace graze
