// What is checked before parameters are sought: their limits, and whether the measurements can tell
// them anything.
#pragma once

#include <vector>

#include "graze/fit/detail/fit_model.hpp"
#include "graze/fit/fit_result.hpp"

namespace graze {

// The parameters with all their limits; those of restitutions where none were given: a0 from 0 to
// 1, the others without limits. Throws InputError where a limit is none that the scene allows.
std::vector<SoughtParameter> checked_parameters(const Scene& scene,
                                                const Measurements& measurements,
                                                const std::vector<SoughtParameter>& asked);

// Throws InputError, with the place in the file, where there are too few values.
void require_enough(const Measurements& measurements,
                    const std::vector<SoughtParameter>& parameters);

// Throws InputError, with the place in the file, where the values are far larger or smaller than
// what the model says at `start` and where one parameter is at a limit: another unit, most likely.
// Where it is stopped on the way nothing is said.
void require_comparable(const Measurements& measurements,
                        const std::vector<SoughtParameter>& parameters, const Vector& start,
                        FitModel& model, const StopSignal& stop);

}  // namespace graze
