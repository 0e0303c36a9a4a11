// How sensitive a motion is to a parameter, by the measures of A. S. Yigit, A. G. Ulsoy, R. A.
// Scott, J. Sound Vib. 137 (1990) 183-203, equations 24 and 25, for every probe w of the scene:
//
//   s1 = [max |w| - mean]/mean, the mean over all values of the parameter,
//   s2 = [w_ref(t) - w(t)]/w_ref(t), at the end t of the run, against the run at a reference value.
#pragma once

#include <string>
#include <vector>

#include "graze/study/sweep/run_series.hpp"

namespace graze {

struct SensitivityOptions {
  RunSeriesOptions series;
  double reference = 0.0;       // value of the parameter that s2 compares with
  std::string second;           // another parameter; empty: none
  std::vector<double> seconds;  // its values
};

struct SensitivityCurve {
  double second = 0.0;  // value of the other parameter, where there is one
  std::vector<ValueRun> runs;
  ValueRun reference;
  // Values of probe i at value k: s1(k, i); not finite where a mean or a reference is zero or a run
  // did not reach its end.
  Matrix s1, s2;
};

// Finished curves, in the order of `seconds`. Throws InputError as run_series does.
std::vector<SensitivityCurve> sensitivities(const Scene& scene, const SensitivityOptions& options);

}  // namespace graze
