// Guesses at orbits that fulfil contact and little else, for Levenberg-Marquardt to bring in.
#pragma once

#include <cstdint>
#include <vector>

#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

// A guess at a (p, 1) orbit: at forcing phase theta the motion meets the stop at speed v, otherwise
// as near to the forced response as a static push and a matching velocity allow.
ImpactPoint rough_guess(const System& system, int stop, double theta, double speed);

// Such impacts for a pattern at quasi-random phases, with random speeds up to twice `speed`, m/s:
// as many guesses as asked for, the same for the same seed.
std::vector<std::vector<ImpactPoint>> rough_guesses(const System& system,
                                                    const ImpactPattern& pattern, int count,
                                                    double speed, std::uint64_t seed);

}  // namespace graze
