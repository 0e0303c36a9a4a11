// Guesses at orbits that satisfy contact and little else, as starts for Levenberg-Marquardt.
#pragma once

#include <cstdint>
#include <vector>

#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

// A guess at a (p, 1) orbit: at forcing phase theta the motion meets the stop at speed v, otherwise
// as near to the forced response as a static push and a matching velocity allow.
ImpactPoint rough_guess(const System& system, int stop, double theta, double speed);

// `count` such guesses for a pattern at quasi-random phases, with random speeds up to twice
// `speed`, m/s; the same for the same seed.
std::vector<std::vector<ImpactPoint>> rough_guesses(const System& system,
                                                    const ImpactPattern& pattern, int count,
                                                    double speed, std::uint64_t seed);

}  // namespace graze
