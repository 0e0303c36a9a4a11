// The shape of a beam over its length, from modal coordinates.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

struct BeamStop {
  double x = 0.0, u = 0.0;  // where it stands, m
  bool is_above = true;
};

// Places along a beam that is clamped, and the rows that give the displacement there, one row a
// place: u = rows * q, m.
struct BeamPlaces {
  std::vector<double> x;  // m from the clamp, the clamp and the tip among them
  Matrix rows;            // places by modes, kg^-1/2
  std::vector<BeamStop> stops;
};

// Nothing where the structure is no beam, or where its clamp turns with a hub.
std::optional<BeamPlaces> beam_places(const Scene& scene, int places);

}  // namespace graze
