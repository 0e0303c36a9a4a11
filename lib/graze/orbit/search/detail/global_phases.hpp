// The lowest point of the phase problem on its whole torus, where local solves found none.
//
// Minimised is the squared residual, deflated and in units of a length, plus the squares of what is
// negative of the approach speeds, in units of a speed: of all the points where contact holds the
// orbits are those that approach. DIRECT (NLopt's locally biased version; Gablonsky & Kelley,
// J. Global Optim. 21, 2001) divides the torus into boxes and needs neither derivatives nor random
// numbers, so that it is the same everywhere; its answer is a start for a local solve, no more.
#pragma once

#include <optional>

#include "graze/orbit/closed_form/detail/phase_problem.hpp"
#include "graze/orbit/search/detail/phase_deflation.hpp"
#include "graze/orbit/search/detail/phase_search_options.hpp"

namespace graze {

// The phases, rad, of the lowest of options.global_evaluations values; nothing where none could be
// evaluated or NLopt refuses.
std::optional<Vector> lowest_phases(const PhaseProblem& problem, const PhaseDeflation& deflation,
                                    const PhaseSearchOptions& options);

}  // namespace graze
