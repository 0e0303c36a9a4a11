// The requested and the actual restitution of a compliant stop.
#pragma once

#include <optional>

#include "graze/scene/scene.hpp"

namespace graze {

// Both are for one body that meets the stop alone.
struct RequestedRestitution {
  double requested = 0.0;       // e
  std::optional<double> speed;  // m/s, at which; absent where e is the same at all speeds
  std::optional<double> mass;   // kg, of the body; absent where e does not depend on it
  // e of that contact. For Lee and Wang's second model it holds for contacts much deeper than the
  // onset, which approach Kelvin-Voigt's; others have a larger restitution.
  double effective = 0.0;
  std::optional<double> exact_coefficient;  // C that gives `requested`; absent where none is known
};

// For a checked scene; nullopt when the spring's damping was not given by a restitution.
std::optional<RequestedRestitution> requested_restitution(const Spring& spring);

}  // namespace graze
