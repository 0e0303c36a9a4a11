#include "graze/continuation/locus/locus_values.hpp"

#include <algorithm>
#include <iterator>

namespace graze {

const char* label_of(LocusKind kind) {
  switch (kind) {
    case LocusKind::kFold:
      return "LP";
    case LocusKind::kPeriodDoubling:
      return "PD";
    case LocusKind::kTorus:
      return "NS";
  }
  return "";
}

const char* label_of(LocusPointKind kind) {
  switch (kind) {
    case LocusPointKind::kCusp:
      return "CP";
    case LocusPointKind::kResonance1:
      return "R1";
    case LocusPointKind::kResonance2:
      return "R2";
    case LocusPointKind::kResonance3:
      return "R3";
    case LocusPointKind::kResonance4:
      return "R4";
    case LocusPointKind::kFoldDoubling:
      return "LPPD";
    case LocusPointKind::kFoldTorus:
      return "LPNS";
    case LocusPointKind::kTwoDoublings:
      return "PDPD";
    case LocusPointKind::kDoublingTorus:
      return "PDNS";
    case LocusPointKind::kTwoTori:
      return "NSNS";
    case LocusPointKind::kDegenerateDoubling:
      return "GPD";
    case LocusPointKind::kDegenerateTorus:
      return "GNS";
    case LocusPointKind::kCrossing:
      return "BP";
  }
  return "";
}

std::vector<LocusSpecialPoint> Locus::special_of(LocusPointKind which) const {
  std::vector<LocusSpecialPoint> list;
  std::copy_if(special.begin(), special.end(), std::back_inserter(list),
               [which](const LocusSpecialPoint& point) { return point.kind == which; });
  return list;
}

LocusEnd as_locus_end(BranchEnd end, bool first) {
  switch (end) {
    case BranchEnd::kParameterLimit:
      return LocusEnd::kSecondLimit;
    case BranchEnd::kUnknownLimit:
      return first ? LocusEnd::kFirstLimit : LocusEnd::kResonance;
    case BranchEnd::kClosed:
      return LocusEnd::kClosed;
    case BranchEnd::kStepLimit:
      return LocusEnd::kStepLimit;
    case BranchEnd::kOutOfTime:
      return LocusEnd::kOutOfTime;
    case BranchEnd::kStopped:
      return LocusEnd::kStopped;
    case BranchEnd::kHalted:
      return LocusEnd::kHalted;
    case BranchEnd::kStart:
    case BranchEnd::kNotConverged:
      break;
  }
  return LocusEnd::kNotConverged;
}

}  // namespace graze
