#include "graze/record/detail/fit_record.hpp"

#include "graze/scene/reader.hpp"

namespace graze {

Outcome fit_outcome(const FitResult& result) {
  switch (result.end) {
    case FitEnd::kFitted:
      return {"fitted", ""};
    case FitEnd::kNotDetermined:
      return {"not_determined", result.message};
    case FitEnd::kNotConverged:
      return {"not_converged", result.message};
    case FitEnd::kBudget:
      return {"budget", result.message};
    case FitEnd::kInterrupted:
      break;
  }
  return {"interrupted", result.message};
}

std::string name_of(MeasurementKind kind) {
  switch (kind) {
    case MeasurementKind::kRestitution:
      return "restitution";
    case MeasurementKind::kImpactTimes:
      return "impact times";
    case MeasurementKind::kResponse:
      break;
  }
  return "response";
}

Abscissa abscissa_of(MeasurementKind kind) {
  switch (kind) {
    case MeasurementKind::kRestitution:
      return {"speed", "m/s"};
    case MeasurementKind::kImpactTimes:
      return {"impact", ""};
    case MeasurementKind::kResponse:
      break;
  }
  return {"time", "s"};
}

std::string fitted_scene_text(const FitResult& result) {
  return result.fitted ? write_scene(*result.fitted) : "";
}

}  // namespace graze
