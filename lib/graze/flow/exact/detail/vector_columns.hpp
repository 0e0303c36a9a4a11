// Columns of numbers as the vector unit reads them: of a length that it divides.
#pragma once

#include <cstddef>

namespace graze {

// The longest vector in use, in doubles.
inline constexpr std::size_t kColumnStep = 8;

inline constexpr std::size_t column_length(std::size_t count) {
  return (count + kColumnStep - 1) / kColumnStep * kColumnStep;
}

}  // namespace graze
