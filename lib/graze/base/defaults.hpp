// The accuracy and the limit on the amount of work where neither the scene nor a caller sets one.
#pragma once

namespace graze {

// Number of impacts of one motion.
inline constexpr long long kDefaultImpactBudget = 10'000'000;

// Error of a displacement over one forcing period, relative to the size of the motion.
inline constexpr double kDefaultTolerance = 1e-10;

}  // namespace graze
