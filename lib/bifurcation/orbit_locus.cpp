#include "graze/bifurcation/orbit_locus.hpp"

namespace graze {

const char* label_of(OrbitLocusKind kind) {
  switch (kind) {
    case OrbitLocusKind::kFold:
      return "LP";
    case OrbitLocusKind::kPeriodDoubling:
      return "PD";
    case OrbitLocusKind::kTorus:
      return "NS";
    case OrbitLocusKind::kGrazing:
      break;
  }
  return "GR";
}

}  // namespace graze
