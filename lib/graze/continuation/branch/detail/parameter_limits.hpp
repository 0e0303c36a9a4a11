// The limits of the parameter's range, where a branch ends to the last bit of the parameter.
#pragma once

#include <optional>

#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

class ParameterLimits {
 public:
  explicit ParameterLimits(const ContinuationOptions& options);

  bool outside(double parameter) const { return parameter < lowest_ || parameter > highest_; }
  // The limit that the parameter approaches in this direction.
  double towards(double direction) const { return direction > 0.0 ? highest_ : lowest_; }
  // Whether the branch is at a limit there and leaves the range.
  bool leaves_at(const SolutionPoint& here) const;

 private:
  double lowest_, highest_;
};

// The solution at a limit, near a point of the branch at or before it. Returns nullopt when the
// corrector does not reach it.
std::optional<SolutionPoint> point_on_limit(Corrector& corrector, const SolutionPoint& near,
                                            double limit);

}  // namespace graze
