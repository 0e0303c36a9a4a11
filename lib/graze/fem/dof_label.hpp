// The name of a degree of freedom: its number, or a node of the mesh and a direction there (1, 2, 3
// displacements along x, y, z; 4, 5, 6 rotations about them), as finite-element programs count.
// CalculiX makes solids of shells and beams, so that a node of these has several rows with one
// name; a third number distinguishes them.
#pragma once

#include <compare>
#include <optional>
#include <string>

namespace graze {

struct DofLabel {
  long node = 0;
  int direction = 0;  // 0: a number without a direction, `node` from 1 on
  int row = 0;        // of several rows of this name, from 1; 0: there is but one

  auto operator<=>(const DofLabel&) const = default;
};

// "12.3", or "7" for one without a direction, or "12.3.2" for the second of several rows.
std::string label_text(const DofLabel& label);

// Reads such a text; nullopt when it is no label.
std::optional<DofLabel> label_from_text(const std::string& text);

}  // namespace graze
