// What a compliant stop was asked to give back, and what it gives.
#pragma once

#include <optional>

#include "graze/scene/scene.hpp"

namespace graze {

// Of one body that meets the stop alone.
struct RequestedRestitution {
  double requested = 0.0;       // e
  std::optional<double> speed;  // m/s, at which; absent where e is the same at all speeds
  std::optional<double> mass;   // kg, of the body; absent where e does not depend on it
  // e of that contact. Of Lee and Wang's second model: of contacts much deeper than its onset,
  // which approach Kelvin-Voigt's; others give back more.
  double effective = 0.0;
  std::optional<double> exact_coefficient;  // C that gives `requested`; absent where none is known
};

// Of a checked scene; absent where the spring's damping was not given by a restitution.
std::optional<RequestedRestitution> requested_restitution(const Spring& spring);

}  // namespace graze
