// Mode shapes for ParaView: a .vtu file (VTK XML unstructured grid) for each mode and a .pvd file
// that lists them with their frequencies as times.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "graze/scene/scene.hpp"

namespace graze {

// Names and contents: modes.pvd, mode_1.vtu, .. Points are the nodes that have coordinates, cells
// the elements of the mesh; where no file tells them the pairs that the stiffness couples if these
// are few, as of a frame, else the points.
// `displacement` is that of a mode, m per unit of its coordinate. Empty where nothing is known of
// coordinates.
std::vector<std::pair<std::string, std::string>> mode_shape_files(const Scene& scene);

}  // namespace graze
