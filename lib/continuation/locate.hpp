// Finding points on a branch that is known at two neighbours, with a corrector at hand.
#pragma once

#include <functional>
#include <optional>

#include "graze/continuation/corrector.hpp"

namespace graze {

// Solutions nearer than this are one: next to a fold they are known to about sqrt(eps).
inline constexpr double kOnePoint = 1e-7;

// As `locate` of branch.hpp.
std::optional<BranchPoint> locate(Corrector& corrector, const BranchPoint& a, const BranchPoint& b,
                                  const std::function<double(const BranchPoint&)>& test);

// Whether `point` lies on the branch between neighbours a and b. `max_turn`: that of the branch.
bool lies_between(Corrector& corrector, const BranchPoint& a, const BranchPoint& b,
                  const BranchPoint& point, double max_turn);

}  // namespace graze
