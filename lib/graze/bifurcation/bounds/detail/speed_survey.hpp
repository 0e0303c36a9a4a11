// The (p, 1) solutions at one value of a parameter on a stop whose restitution depends on the
// speed.
//
// With the quantities of one_impact_form.hpp the approach speed v of a solution is a zero of
//
//   (a + g u)^2 + (v + H u)^2/Omega^2 - |A|^2,      u = (1 + r(v)) v,
//
// one equation in one unknown, for any number of modes: all of its zeros are isolated by bounds
// (isolated_zeros.hpp), and the phase follows from either square. A component that lies between two
// values is missed.
#pragma once

#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

struct SpeedSurvey {
  struct Start {
    double value = 0.0;  // of the parameter
    ImpactPoint point;
  };
  std::vector<Start> starts;
  int values = 0;        // that were looked at, spread evenly
  double spacing = 0.0;  // of them
  int unsolved = 0;      // values at which not all speeds can be isolated
};

// Over [lowest, highest], for impacts on a stop (index from 0) every `period` forcing periods.
// Requires forcing. `with_virtual`: solutions of negative speed too.
SpeedSurvey survey_speeds(const SystemFamily& family, int stop, int period, double lowest,
                          double highest, bool with_virtual);

}  // namespace graze
