#include <cmath>

#include "graze/motion/simulation.hpp"
#include "graze/system/scale.hpp"

namespace graze {

double default_closure_speed(const System& system, const State& start, double tolerance) {
  return speed_scale(system, start) * std::sqrt(tolerance / 100.0);
}

}  // namespace graze
