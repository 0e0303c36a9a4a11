// The shape of a beam, a string or a bar over its length, from modal coordinates.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

struct BeamStop {
  double x = 0.0, u = 0.0;  // where it stands, m
  bool is_above = true;
};

// Places along it, and the rows that give the displacement there: u = rows * q, m.
struct BeamPlaces {
  std::string structure;  // "beam", "string" or "bar"
  std::vector<double> x;  // m from the left end, both ends among them
  Matrix rows;            // places by modes, kg^-1/2
  std::vector<BeamStop> stops;
};

// Returns nullopt when the modes are given, or when the beam's clamp rotates with a hub.
std::optional<BeamPlaces> beam_places(const Scene& scene, int places);

}  // namespace graze
