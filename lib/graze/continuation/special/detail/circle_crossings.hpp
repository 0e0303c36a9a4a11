// Where multipliers pass the unit circle within a step of a branch: period doublings and tori.
//
// Test functions are the moduli of the multipliers, sorted: rho_1 >= rho_2 >= .., each continuous
// along the branch even where multipliers meet, so that the crossing rho_j = 1 between two points
// is a root of one function; no product of all multipliers is ever formed. Multipliers outside the
// circle are counted by kind (real below -1, real above 1, complex), and a piece whose counts
// change by more than one crossing is halved. The multiplier that crosses gives the kind: real and
// negative a period doubling, complex a torus, real and positive a fold or branch point (found
// otherwise). Two that meet at -1 and go on along the circle are a period doubling, too.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

class CircleCrossings {
 public:
  // Adds the crossings of one step to `found`. Refers to all arguments, which must outlive it.
  // `step`: see CriticalPoint::after.
  CircleCrossings(const ZeroProblem& problem, Corrector& corrector, const StopSignal& stop,
                  std::size_t step, std::vector<CriticalPoint>& found)
      : problem_(problem), corrector_(corrector), stop_(stop), step_(step), found_(found) {}

  // Adds those between neighbours a and b within the step, whose multipliers are known; in no
  // order.
  void add(const SolutionPoint& a, const SolutionPoint& b);
  // Adds those that the ends of the piece show, where they differ by one crossing.
  void add_undivided(const SolutionPoint& a, const SolutionPoint& b);

 private:
  std::vector<Eigenvalue> multipliers_of(const SolutionPoint& point,
                                         ErrorBounds errors = ErrorBounds::kGiven) const;
  void divide(const SolutionPoint& a, const SolutionPoint& b, int halvings);
  bool is_off_circle(const SolutionPoint& point, std::size_t j) const;
  std::optional<SolutionPoint> add_crossing(const SolutionPoint& a, const SolutionPoint& b,
                                            std::size_t j);
  std::optional<SolutionPoint> add_meeting(const SolutionPoint& a, const SolutionPoint& b);
  std::optional<SolutionPoint> known_between(const SolutionPoint& from, double s,
                                             const SolutionPoint& a, const SolutionPoint& b);

  const ZeroProblem& problem_;
  Corrector& corrector_;
  const StopSignal& stop_;
  std::size_t step_;
  std::vector<CriticalPoint>& found_;
  int divisions_ = 0;
};

}  // namespace graze
