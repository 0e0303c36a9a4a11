#include "graze/record/names/detail/kind_names.hpp"

namespace graze {

std::string name_of(EventKind kind) {
  switch (kind) {
    case EventKind::kImpact:
      return "impact";
    case EventKind::kChatter:
      return "chatter";
    case EventKind::kStick:
      return "stick";
    case EventKind::kContact:
      return "contact";
    case EventKind::kSeparation:
      return "separation";
    case EventKind::kRelease:
      break;
  }
  return "release";
}

std::string name_of(OrbitBranchEnd end) {
  switch (end) {
    case OrbitBranchEnd::kParameterLimit:
      return "parameter limit";
    case OrbitBranchEnd::kClosed:
      return "closed";
    case OrbitBranchEnd::kGrazing:
      return "GR";
    case OrbitBranchEnd::kChatterCompletes:
      return "CH";
    case OrbitBranchEnd::kAtRest:
      return "at rest";
    case OrbitBranchEnd::kPeriodDoubling:
      return "PD";
    case OrbitBranchEnd::kImpactsMeet:
      return "impacts meet";
    case OrbitBranchEnd::kStepLimit:
      return "step limit";
    case OrbitBranchEnd::kOutOfTime:
      return "time limit";
    case OrbitBranchEnd::kStopped:
      return "interrupted";
    case OrbitBranchEnd::kNotConverged:
      break;
  }
  return "not converged";
}

std::string name_of(OrbitLocusEnd end) {
  switch (end) {
    case OrbitLocusEnd::kFirstLimit:
      return "parameter limit";
    case OrbitLocusEnd::kSecondLimit:
      return "second limit";
    case OrbitLocusEnd::kClosed:
      return "closed";
    case OrbitLocusEnd::kGrazing:
      return "GR";
    case OrbitLocusEnd::kChatterCompletes:
      return "CH";
    case OrbitLocusEnd::kImpactsMeet:
      return "impacts meet";
    case OrbitLocusEnd::kResonance:
      return "resonance";
    case OrbitLocusEnd::kStepLimit:
      return "step limit";
    case OrbitLocusEnd::kOutOfTime:
      return "time limit";
    case OrbitLocusEnd::kStopped:
      return "interrupted";
    case OrbitLocusEnd::kNotConverged:
      break;
  }
  return "not converged";
}

std::string stability_word(const std::optional<bool>& stable) {
  if (!stable) return "on the circle";
  return *stable ? "yes" : "no";
}

}  // namespace graze
