// The intervals of a parameter's range with (p, 1) solutions on a stop: their exact ends, which are
// folds or the ends of the range, and proof that there are no others.
//
// The proof is a bound: the range of F of one_impact_form.hpp is divided into cells over each of
// which F keeps its sign or is monotonic, in outward rounded intervals. It rests on the interpolant
// of the system's numbers (system_interpolant.hpp): exact over parameters of which these are
// polynomials up to the third degree, such as the forcing frequency, and an interpolation to 1e-12
// over others. It is no proof where cells are left undecided: two folds that agree to half of all
// digits, or more oscillations than the budget of cells resolves. Those are counted, and the width
// of the widest one bounds the intervals that may have been missed.
#pragma once

#include <optional>
#include <vector>

#include "graze/assembly/detail/system_interpolant.hpp"

namespace graze {

class SolutionRanges {
 public:
  struct Range {
    double from = 0.0, to = 0.0;
    bool folds_at_start = false, folds_at_end = false;
    bool folds() const { return folds_at_start || folds_at_end; }
  };

  // For impacts on a stop (index from 0) every `period` forcing periods. Requires lowest < highest,
  // forcing, and a constant restitution.
  SolutionRanges(const SystemFamily& family, int stop, int period, double lowest, double highest);

  const std::vector<Range>& ranges() const { return ranges_; }  // ascending
  long long evaluations() const { return evaluations_; }        // of F, over cells and at values
  int undecided() const { return undecided_; }                  // cells
  double widest_undecided() const { return widest_; }

  const SystemInterpolant& interpolant() const { return interpolant_; }
  int stop() const { return stop_; }
  int period() const { return period_; }
  double length() const { return length_; }  // of the range that was looked through

  // Index of the interval that contains a value, or that it exceeds by its rounding.
  std::optional<std::size_t> range_of(double value) const;
  // Which of the two solutions at a value has this impact phase: see family_of.
  int family(double value, double theta) const;
  // The system over a cell, or at a value; nullopt when the scene does not allow it throughout.
  std::optional<SystemForms> system_over(double low, double high) const;

  // A number for the connected set of the solution with this impact phase (rad): equal for
  // solutions that are connected within the range. Returns nullopt where there are no solutions.
  std::optional<int> component(double value, double phase) const;

 private:
  SystemInterpolant interpolant_;
  int stop_, period_;
  double length_;
  std::vector<Range> ranges_;
  long long evaluations_ = 0;
  int undecided_ = 0;
  double widest_ = 0.0;
};

}  // namespace graze
