// The accuracy that is aimed at where a scene or a caller names none.
#pragma once

namespace graze {

// Of a displacement over one forcing period, relative to the motion's.
inline constexpr double kDefaultTolerance = 1e-10;

}  // namespace graze
