// A measured quantity of a motion.
#pragma once

#include "graze/base/vector.hpp"

namespace graze {

// row.q, or row.q' for a velocity.
struct MeasuredRow {
  Vector row;
  bool of_velocity = false;
};

}  // namespace graze
