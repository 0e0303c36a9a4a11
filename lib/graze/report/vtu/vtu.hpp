// Mode shapes for ParaView: a .vtu file (VTK XML unstructured grid) for each mode and a .pvd file
// that lists them with their frequencies as times.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "graze/scene/scene.hpp"

namespace graze {

// Names and contents: modes.pvd, mode_1.vtu, .. Points are the nodes that have coordinates, cells
// the elements of the mesh; without a file of elements the pairs that the stiffness couples, if
// these are few as for a frame, else the points. `displacement` is that of a mode, m per unit of
// its coordinate. Empty where no coordinates are known.
std::vector<std::pair<std::string, std::string>> mode_shape_files(const Scene& scene);

}  // namespace graze
