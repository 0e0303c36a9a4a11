// The name of a degree of freedom: its number, or a node of the mesh and a direction there (1, 2, 3
// displacements along x, y, z; 4, 5, 6 rotations about them), as finite-element programs count.
#pragma once

#include <compare>
#include <optional>
#include <string>

namespace graze {

struct DofLabel {
  long node = 0;
  int direction = 0;  // 0: a number without a direction, `node` from 1 on

  auto operator<=>(const DofLabel&) const = default;
};

// "12.3", or "7" of one without a direction.
std::string label_text(const DofLabel& label);

// Of a text written so; nothing where it is none.
std::optional<DofLabel> label_from_text(const std::string& text);

}  // namespace graze
