// What of a motion is looked at.
#pragma once

#include "graze/base/vector.hpp"

namespace graze {

// row.q, or of a velocity row.q'.
struct MeasuredRow {
  Vector row;
  bool of_velocity = false;
};

}  // namespace graze
