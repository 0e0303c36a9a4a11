// Values at degrees of freedom, and places of nodes, from files.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/fem/dof_label.hpp"

namespace graze {

// Lines of a degree of freedom and a value, "12.3 1.5"; or one value a row in the order of `labels`
// (a text of single numbers, or a .npy vector). Degrees of freedom that are not named are zero.
// `others` may be named too and are skipped. Throws FileError, and InputError with file:line.
Vector read_dof_values(const std::filesystem::path& file, const std::vector<DofLabel>& labels,
                       const std::vector<DofLabel>& others = {});

}  // namespace graze
