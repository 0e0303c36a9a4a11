// The work that is done at most where a caller sets no bound of its own.
#pragma once

namespace graze {

// Impacts of one motion.
inline constexpr long long kDefaultImpactBudget = 10'000'000;

}  // namespace graze
