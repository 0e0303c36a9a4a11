// The result of a fit with what made it.
#pragma once

#include <string>
#include <vector>

#include "graze/fit/fit.hpp"
#include "graze/record/records.hpp"

namespace graze {

struct FitRecord {
  RunInfo info;
  std::string data_file;    // as given
  std::string data_sha256;  // of its content
  std::vector<std::string> unused_columns;
  FitResult result;
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "fitted", "not_determined", "not_converged", "budget" or "interrupted".
Outcome fit_outcome(const FitResult& result);

// "restitution", "impact times" or "response".
std::string name_of(MeasurementKind kind);

// What stands beside the measured values: "speed" (m/s), "time" (s), "impact".
struct Abscissa {
  std::string name, unit;
};
Abscissa abscissa_of(MeasurementKind kind);

// The scene with the fitted values as TOML; empty where there is none.
std::string fitted_scene_text(const FitResult& result);

}  // namespace graze
