// The limits of the ranges of unknowns, where a branch ends to the last bit of the unknown.
#pragma once

#include <optional>
#include <vector>

#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

struct UnknownLimit {
  Eigen::Index unknown = 0;  // its place in u
  double value = 0.0;
};

class UnknownLimits {
 public:
  explicit UnknownLimits(const ContinuationOptions& options);

  // The first limit that a step of length h along the tangent would pass; nullopt when it passes
  // none.
  std::optional<UnknownLimit> ahead(const SolutionPoint& here, double h) const;
  // The largest step along the tangent that the ranges allow; infinity where they set no limit.
  double longest(const SolutionPoint& here) const;
  // Where the branch first leaves the ranges between neighbours a and b, on the limit; a itself,
  // with `reached` false, when the corrector does not reach it. Returns nullopt when it stays
  // within.
  struct Exit {
    SolutionPoint point;
    bool reached = true;
  };
  std::optional<Exit> exit_between(Corrector& corrector, const SolutionPoint& a,
                                   const SolutionPoint& b) const;
  // Whether the branch is at a limit there and leaves the range.
  bool leaves_at(const SolutionPoint& here) const;

 private:
  std::vector<UnknownRange> ranges_;  // in rising order
};

// The solution at a limit, near a point of the branch at or before it. Returns nullopt when the
// corrector does not reach it.
std::optional<SolutionPoint> point_on_limit(Corrector& corrector, const SolutionPoint& near,
                                            const UnknownLimit& limit);

}  // namespace graze
