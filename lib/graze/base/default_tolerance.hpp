// The accuracy where neither the scene nor the caller gives one.
#pragma once

namespace graze {

// Error of a displacement over one forcing period, relative to the size of the motion.
inline constexpr double kDefaultTolerance = 1e-10;

}  // namespace graze
