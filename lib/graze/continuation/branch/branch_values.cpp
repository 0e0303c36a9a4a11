#include "graze/continuation/branch/branch_values.hpp"

#include <algorithm>

namespace graze {

Bracket bracket_around(std::initializer_list<double> values, bool converged) {
  return {std::min(values), std::max(values), converged};
}

const char* label_of(CriticalKind kind) {
  switch (kind) {
    case CriticalKind::kFold:
      return "LP";
    case CriticalKind::kPeriodDoubling:
      return "PD";
    case CriticalKind::kTorus:
      return "NS";
    case CriticalKind::kLevel:
      return "UZ";
    case CriticalKind::kExtreme:
      return "EX";
    case CriticalKind::kBranchPoint:
      break;
  }
  return "BP";
}

std::vector<CriticalPoint> Branch::critical_of(CriticalKind kind) const {
  std::vector<CriticalPoint> list;
  for (const CriticalPoint& point : critical)
    if (point.kind == kind) list.push_back(point);
  return list;
}

}  // namespace graze
