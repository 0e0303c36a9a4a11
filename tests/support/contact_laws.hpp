// Contact laws as parameters of tests.
#pragma once

#include <ostream>

#include "graze/contact/contact_force.hpp"

namespace graze {

// Under which a test is listed.
inline void PrintTo(const ContactForce& law, std::ostream* out) {
  *out << "k " << law.stiffness << " n " << law.exponent << " damping "
       << static_cast<int>(law.damping) << " " << law.coefficient
       << (law.separation == Separation::kAtZeroForce ? " force" : " position");
}

}  // namespace graze
