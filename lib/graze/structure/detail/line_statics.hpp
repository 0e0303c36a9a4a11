// What a line gives way under constant loads, next to its rigid motions: a line that is free to
// move is held by its own inertia, its displacement orthogonal to the rigid motions in the mass
// (inertia relief). All modes of the line together make as much of it, sum of phi phi^T/w^2.
#pragma once

#include <vector>

#include "graze/structure/detail/line.hpp"

namespace graze {

// With P places, the loads are 1 N at each, and last a uniform acceleration of 1 m/s^2; P + 1 by
// P + 1: what load k moves place i, and what it does work on under the last one.
struct LineStatics {
  Matrix displacement, rate;  // the rate is empty where none is asked for
  bool is_torn = false;       // then there is no rate, as there is none of the modes
};

// Of a line that has modes.
LineStatics line_statics(const Line& line, const std::vector<Rated>& places, bool rates);

}  // namespace graze
