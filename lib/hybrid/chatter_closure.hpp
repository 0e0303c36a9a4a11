// When a chatter is to be summed: one rule for everyone who follows a motion.
#pragma once

#include <vector>

#include "graze/hybrid/motion.hpp"

namespace graze {

// The impact, among the shares of the one just applied, whose rebounds may all be summed now: it
// took an impulse alone, at an approach speed of at most `closure_speed` (m/s), on a stop that some
// speed is lost at. Null when there is none. Whether the chatter does complete is for
// Motion::close_chatter to say.
const ImpactShare<double>* closing_impact(const System& system,
                                          const std::vector<ImpactShare<double>>& shares,
                                          double closure_speed);

}  // namespace graze
