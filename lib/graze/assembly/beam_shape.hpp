// The shape of a beam over its length, from modal coordinates.
#pragma once

#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// Places along the beam and the rows that give the displacement there, one row a place:
// deflections = rows * q, m. Requires a scene with a beam and no hub.
struct BeamRows {
  std::vector<double> x;  // m from the clamp, the clamp and the tip among them
  Matrix rows;            // places by modes, kg^-1/2
};
BeamRows beam_rows(const Scene& scene, int places);

}  // namespace graze
