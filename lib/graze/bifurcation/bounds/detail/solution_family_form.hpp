// One of the two (p, 1) solutions at a stop, bounded over a cell of a parameter: its impact speed
// and the gaps at chosen instants between its impacts. With the quantities of one_impact_form.hpp,
// K = (1 + r) Omega g and M = D^2 + K^2,
//
//   A e^{i theta} = (a D + i s sqrt(F)) (D + i K)/M,      s = +1 or -1,
//   v = -Omega (a K + s sqrt(F))/M,      u = (1 + r) v,
//
// and a part tau of the way to the next impact the gap at stop k is
//
//   a_k - Re(A_k e^{i (theta + 2 pi p tau)}) + u sum_j b_kj d_j G_j(tau P),
//
// G_j the repeated impulse. Where at one instant the gap is negative all over a cell, the solution
// is virtual all over it; likewise where its impact speed is.
#pragma once

#include <optional>

#include "graze/bifurcation/bounds/detail/one_impact_form.hpp"

namespace graze {

class SolutionFamilyForm {
 public:
  // `family`: as returned by family_of. Returns nullopt when a cell is too wide, reaches a fold, or
  // holds a pole of an undamped mode; and where the free motion between impacts repeats by itself
  // or never does (free masses, undamped with r = 1).
  static std::optional<SolutionFamilyForm> over(const SystemForms& system, int stop, int period,
                                                int family);

  const MeanValueForm& speed() const { return speed_; }  // m/s
  // m, at a stop, `part` in (0, 1) of the way to the next impact. Refers to the system.
  std::optional<MeanValueForm> gap(const SystemForms& system, int stop, double part) const;

 private:
  int stop_ = 0, period_ = 1;
  MeanValueForm speed_, impulse_;
  MeanValueForm turned_real_, turned_imaginary_;  // e^{i theta}
};

}  // namespace graze
