// Names of special points, as AUTO and MatCont users know them.
#pragma once

#include <map>
#include <string>

#include "graze/bifurcation/problem/orbit_branch.hpp"

namespace graze {

// "GR", or the label that any branch gives to such a point.
inline std::string label_of(SpecialKind kind) {
  switch (kind) {
    case SpecialKind::kFold:
      return label_of(CriticalKind::kFold);
    case SpecialKind::kPeriodDoubling:
      return label_of(CriticalKind::kPeriodDoubling);
    case SpecialKind::kTorus:
      return label_of(CriticalKind::kTorus);
    case SpecialKind::kBranchPoint:
      return label_of(CriticalKind::kBranchPoint);
    case SpecialKind::kLevel:
      return label_of(CriticalKind::kLevel);
    case SpecialKind::kExtreme:
      return label_of(CriticalKind::kExtreme);
    case SpecialKind::kGrazing:
      return "GR";
    case SpecialKind::kGrazingSliding:
      return "GS";
    case SpecialKind::kCrossingSliding:
      return "CS";
    case SpecialKind::kSwitchingSliding:
      return "SS";
    case SpecialKind::kAddingSliding:
      return "AS";
    case SpecialKind::kChatterCompletes:
      return "CH";
    case SpecialKind::kLiftOff:
      break;
  }
  return "LO";
}

// Numbers special points, each kind from 1.
class SpecialNames {
 public:
  std::string next(SpecialKind kind) { return label_of(kind) + std::to_string(++counts_[kind]); }

 private:
  std::map<SpecialKind, int> counts_;
};

}  // namespace graze
