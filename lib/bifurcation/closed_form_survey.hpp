// Where along a parameter's range the closed form has (p, 1) solutions: starts for branches that
// are narrower than the distance of other start values, and a name for the connected set each
// solution belongs to. Sampling the closed form is cheap beside tracing, so it can be fine; what is
// narrower than its spacing may still be passed over.
#pragma once

#include <optional>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/orbit/shooting.hpp"

namespace graze {

class ClosedFormSurvey {
 public:
  struct Start {
    double value = 0.0;  // of the parameter
    ImpactPoint point;
  };

  // Samples [lowest, highest] for impacts on a stop (index from 0) every `period` forcing periods.
  // With `admissible_only` starts are offered where the solution is an orbit of the system.
  ClosedFormSurvey(const SystemFamily& family, int stop, int period, double lowest, double highest,
                   bool admissible_only);

  // One in the middle of every run of samples that have the solution in question.
  const std::vector<Start>& starts() const { return starts_; }
  int samples() const { return samples_; }

  // Names the connected set of the solution with this impact phase (rad): equal numbers for
  // solutions that are connected within the range. Both solutions over an interval belong together
  // where a fold joins them at either end. Nothing where no sample saw the solution.
  std::optional<int> component(double value, double phase) const;

 private:
  struct Interval {  // of samples on which both solutions exist
    int first = 0, last = 0;
  };

  const SystemFamily& family_;
  int stop_, period_, samples_;
  double lowest_, spacing_;
  std::vector<Start> starts_;
  std::vector<Interval> intervals_;
};

}  // namespace graze
