// Limits on the amount of work where a caller sets none.
#pragma once

namespace graze {

// Number of impacts of one motion.
inline constexpr long long kDefaultImpactBudget = 10'000'000;

}  // namespace graze
