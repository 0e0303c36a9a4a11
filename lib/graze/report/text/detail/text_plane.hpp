// A plane in words.
#pragma once

#include <string>

#include "graze/study/plane/plane.hpp"

namespace graze {

// "100 by 50 cells, stop.gap from 0 to 0.002 m, .." and a new line.
std::string plane_text(const Plane& plane, const std::string& x_unit, const std::string& y_unit);

}  // namespace graze
