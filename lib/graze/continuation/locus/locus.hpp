// Loci of folds (LP), period doublings (PD) and tori (NS) in the plane of two parameters: curves
// along which an orbit stays critical, traced from one critical orbit.
//
//   #include "graze/continuation/locus/locus.hpp"
//
// is all that a program needs: the problem (zero_problem.hpp over two parameters; map.hpp makes one
// of a map), the options and the locus that comes out (locus_values.hpp), and the functions below.
//
// A locus is traced as a branch over the second parameter, by the equations of locus_equations.hpp:
// minimally augmented systems, W. Govaerts, Numerical Methods for Bifurcations of Dynamical
// Equilibria (SIAM 2000). It passes its own turning points, cusps and resonances; NS ends where its
// pair becomes real. No derivative is taken by differences.
//
// Special points are named as MatCont names them (Govaerts, Khoshsiar Ghaziani, Kuznetsov, Meijer,
// SIAM J. Sci. Comput. 29 (2007) 2644). Two of one kind between neighbouring points are missed,
// except those made by further multipliers that pass -1 or leave the circle as a pair. Those at
// which a normal form degenerates (GPD, GNS) are searched for where its coefficient is given.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "graze/continuation/branch/zero_problem.hpp"
#include "graze/continuation/locus/locus_values.hpp"

namespace graze {

// The point of the locus near a start: at its second parameter, or at its first where the second is
// constant along the locus. Returns nullopt when Newton's method reaches none in the ranges of the
// options and within a fifth of them.
std::optional<LocusPoint> solve_locus(const ZeroProblem& problem, const LocusOptions& options,
                                      const LocusStart& start);

// The locus through that point, to its ends, its special points located; nullopt likewise.
std::optional<Locus> trace_locus(const ZeroProblem& problem, const LocusOptions& options,
                                 const LocusStart& start);

// The index of the traced locus that contains the point that a start leads to.
std::optional<std::size_t> find_locus(const ZeroProblem& problem, const LocusOptions& options,
                                      const std::vector<Locus>& loci, const LocusStart& start);

}  // namespace graze
