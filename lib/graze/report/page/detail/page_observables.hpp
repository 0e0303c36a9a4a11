// What a page can show over the parameter: of the dots of a sweep and of
// branches, one at a time.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/record/detail/diagram_record.hpp"

namespace graze {

// What can be shown over the parameter.
struct PageObservable {
  std::string key, name, unit;
  bool from_zero = false, has_dots = true;
  std::vector<DiagramCurve> curves;                             // one a branch, or none
  std::function<std::vector<double>(const SweepRow&)> heights;  // of a row's dots
  std::optional<double> reference = std::nullopt;               // a line across
  double most = 1e300;                                          // of the axis
};

// Speed and phase of the impacts; of branches the largest multiplier too.
std::vector<PageObservable> impact_observables(const OrbitBranches& traced);

// What is shown of the amplitudes, and the largest multiplier; requires both. Refers to the record.
std::vector<PageObservable> amplitude_observables(const BranchRecord& record);

// Displacements and velocities at the stops, of a stroboscopic diagram.
std::vector<PageObservable> stroboscopic_observables(const DiagramRecord& record);

// Whether a row's motion is shown.
bool has_dots(const SweepRow& row);

}  // namespace graze
