// Starts for the branches of (p, 1) solutions over a parameter's range, one for each part that they
// may have, and a number for the connected set that each solution belongs to.
//
// Where the restitution is constant the intervals with solutions are known (solution_ranges.hpp),
// so that even the narrowest gets its starts. Orbits among the solutions are searched for by bounds
// (admissible_runs.hpp) or, where these do not hold, by even samples over the range and over every
// interval: a run of orbits narrower than the distance of the samples may then be missed.
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

  // Adds one solution of each family in every interval as a start.
  void start_in_every_range();
  // Adds a start in every run of samples at which the solution is an orbit; only of those before it
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
