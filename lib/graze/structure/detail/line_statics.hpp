// Static displacements of a line under constant loads, without its rigid motions: a line that is
// free to move is held by its own inertia, its displacement orthogonal to the rigid motions in the
// mass (inertia relief). All modes of the line together give the same, sum of phi phi^T/w^2.
#pragma once

#include <vector>

#include "graze/structure/detail/line.hpp"

namespace graze {

// The loads are 1 N at each of P places, and last a uniform acceleration of 1 m/s^2. Entry (i, k)
// of these (P + 1) by (P + 1) matrices is the work of load i on the displacement under load k.
struct LineStatics {
  Matrix displacement, rate;  // the rate is empty where none is asked for
  bool is_torn = false;       // then there is no rate, as there is none of the modes
};

// Requires a line that has modes.
LineStatics line_statics(const Line& line, const std::vector<Rated>& places, bool rates);

}  // namespace graze
