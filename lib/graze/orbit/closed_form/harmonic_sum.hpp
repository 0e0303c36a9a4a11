// A sum of harmonics and its lowest value, certified: the gap of a motion without impacts, the
// force on a stop that is never left.
#pragma once

#include <vector>

#include "graze/base/vector.hpp"

namespace graze {

// mean + sum of Re(swing e^{i order theta}).
struct HarmonicSum {
  struct Term {
    int order = 1;
    Complex swing;
  };
  double mean = 0.0;
  std::vector<Term> terms{};

  double at(double theta) const;
  // Phase of the lowest value, rad; the closed form where there is one term, of order 1.
  double phase_of_least() const;
  double least() const;

 private:
  bool is_single() const { return terms.size() == 1 && terms.front().order == 1; }
};

}  // namespace graze
