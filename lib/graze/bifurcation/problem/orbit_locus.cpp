#include "graze/bifurcation/problem/orbit_locus.hpp"

namespace graze {

const char* label_of(OrbitLocusKind kind) {
  switch (kind) {
    case OrbitLocusKind::kFold:
      return "LP";
    case OrbitLocusKind::kPeriodDoubling:
      return "PD";
    case OrbitLocusKind::kTorus:
      return "NS";
    case OrbitLocusKind::kChatterCompletes:
      return "CH";
    case OrbitLocusKind::kLevel:
      return "UZ";
    case OrbitLocusKind::kExtreme:
      return "EX";
    case OrbitLocusKind::kGrazing:
      break;
  }
  return "GR";
}

LocusKind as_locus_kind(OrbitLocusKind kind) {
  if (kind == OrbitLocusKind::kPeriodDoubling) return LocusKind::kPeriodDoubling;
  return kind == OrbitLocusKind::kTorus ? LocusKind::kTorus : LocusKind::kFold;
}

OrbitLocusEnd as_orbit_end(LocusEnd end) {
  switch (end) {
    case LocusEnd::kFirstLimit:
      return OrbitLocusEnd::kFirstLimit;
    case LocusEnd::kSecondLimit:
      return OrbitLocusEnd::kSecondLimit;
    case LocusEnd::kClosed:
      return OrbitLocusEnd::kClosed;
    case LocusEnd::kResonance:
      return OrbitLocusEnd::kResonance;
    case LocusEnd::kStepLimit:
      return OrbitLocusEnd::kStepLimit;
    case LocusEnd::kOutOfTime:
      return OrbitLocusEnd::kOutOfTime;
    case LocusEnd::kStopped:
      return OrbitLocusEnd::kStopped;
    case LocusEnd::kHalted:
      return OrbitLocusEnd::kGrazing;
    case LocusEnd::kNotConverged:
      break;
  }
  return OrbitLocusEnd::kNotConverged;
}

}  // namespace graze
