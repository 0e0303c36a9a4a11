// Solutions with other events between two orbits that stick with the same events: an impact is born
// and lost again, an approach touches and is clear again, or the two orbits are on two branches.
//
// The speeds of the impacts and the gaps of the approaches outside the chatters are known with
// their rates at both ends; the cubic through them shows where to search (margin_interpolant.hpp).
// The events there are decided by the motion itself.
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "graze/bifurcation/problem/detail/remembered.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/special/detail/margin_interpolant.hpp"

namespace graze {

class HiddenEvents {
 public:
  // Refers to both, which must outlive it.
  HiddenEvents(const SegmentEquations& equations, Corrector& corrector)
      : equations_(equations), corrector_(corrector) {}

  // Searches between a and b, which both have the events of `at_a`, for a solution with other
  // events; returns it, or a prediction without a tangent where none can be solved for. Returns
  // nullopt when all have the same events, or after `looks` solutions, which are counted down.
  std::optional<SolutionPoint> between(const SolutionPoint& a, const SolutionPoint& b,
                                       const ReleaseReturn& at_a, int& looks);

 private:
  std::optional<std::vector<SegmentMargin>> margins(const SolutionPoint& solution);
  std::vector<MarginInterpolant> interpolants(const SolutionPoint& a, const SolutionPoint& b);

  const SegmentEquations& equations_;
  Corrector& corrector_;
  // Cached by unknowns, parameter and tangent.
  Remembered<std::tuple<Vector, double, Vector>, std::optional<std::vector<SegmentMargin>>>
      margins_;
};

}  // namespace graze
