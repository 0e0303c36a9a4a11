// Multipliers of orbits whose impact speed v at a stop has all but vanished: their limit v -> 0.
//
// The saltation matrix there is S0 + x0 c^T/v, c the row on displacements. Once the singular part
// is beyond 1/eps of the rest, products lose the rest in its rounding. But the limit is regular:
// with F and x the products of the rest of the orbit with S0 and x0, an eigenvalue of F + x c^T/v
// that stays finite has its vector in the plane c^T z = 0 and leaves it along x only, and the last
// eigenvalue goes as c^T x/v.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

// `unit`: of each mode's velocity per displacement, 1/s. Returns nullopt when no impact is that
// slow, when several are, or when c^T x vanishes too. The eigenvalue that grows without bound is
// given at
// v|.
std::optional<std::vector<Eigenvalue>> multipliers_at_grazing(
    const System& system, const ImpactPattern& pattern, const std::vector<ImpactPoint>& points,
    const Vector& unit, ErrorBounds errors);

}  // namespace graze
