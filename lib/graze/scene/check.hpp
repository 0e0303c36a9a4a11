// The rules that a scene's values must keep, whichever way the scene came about.
#pragma once

#include <vector>

#include "graze/scene/scene.hpp"

namespace graze {

// Up to here the beam's mode shapes keep an error of about eps b_j in double precision.
inline constexpr int kMostModes = 2000;

// Throws InputError at the first broken rule. Which stop penetrates at the start is not among
// them: that needs mode shapes.
void check_scene(const Scene& scene);

// The collocation points in force: those given, or i L/N (the last is L itself, unrounded).
std::vector<double> collocation_points(const Beam& beam);

// Index of the collocation point at which the stop stands, or -1. A stop stands at a point when
// both agree to 4 eps of the beam's length: i L/N is computed with two roundings.
int collocation_index(const Beam& beam, double position);

}  // namespace graze
