// Checks before a fit: the limits of the parameters, and whether the measurements can determine
// them.
#pragma once

#include <vector>

#include "graze/fit/detail/fit_model.hpp"
#include "graze/fit/fit_result.hpp"

namespace graze {

// The parameters with all their limits; default limits of restitutions: a0 from 0 to 1, the others
// none. Throws InputError for a limit that the scene does not allow.
std::vector<SoughtParameter> checked_parameters(const Scene& scene,
                                                const Measurements& measurements,
                                                const std::vector<SoughtParameter>& asked);

// Throws InputError, with the place in the file, where there are too few values.
void require_enough(const Measurements& measurements,
                    const std::vector<SoughtParameter>& parameters);

// Throws InputError, with the place in the file, when the values are far larger or smaller than the
// model's at `start` and where one parameter is at a limit: most likely they are in another unit.
// Does not throw when it is stopped on the way.
void require_comparable(const Measurements& measurements,
                        const std::vector<SoughtParameter>& parameters, const Vector& start,
                        FitModel& model, const StopSignal& stop);

}  // namespace graze
