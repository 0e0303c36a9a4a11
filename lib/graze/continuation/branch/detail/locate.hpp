// Points of a branch between two neighbours on it: at a given arclength, at the zero of a function,
// at a fold; and whether a solution lies between them.
#pragma once

#include <functional>
#include <optional>

#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

// Solutions nearer than this are the same: next to a fold they are known to about sqrt(eps).
inline constexpr double kOnePoint = 1e-7;

// A step, relative to 1 + |x|, over which the orientation may change: branch points are passed with
// steps this short.
inline constexpr double kShortest = 1e-6;
// Special points nearer to a branch point than this, relative to 1 + |x|, belong to it: some steps
// of that length.
inline constexpr double kOneCrossing = 10.0 * kShortest;

// Arclength from a to its neighbour b, to fourth order of their distance.
double arclength(const Corrector& corrector, const SolutionPoint& a, const SolutionPoint& b);

// The point where the cubic through neighbours a and b and their tangents meets the hyperplane
// normal to the tangent of `from`, s ahead of it. Its error is of the fourth power of their
// distance.
Vector cubic_between(const Corrector& corrector, const SolutionPoint& from, double s,
                     const SolutionPoint& a, const SolutionPoint& b);

// The point of the branch there; nullopt when the corrector does not reach it.
std::optional<SolutionPoint> point_between(Corrector& corrector, const SolutionPoint& from,
                                           double s, const SolutionPoint& a,
                                           const SolutionPoint& b);

// As `locate` of branch.hpp: where `test` changes sign between neighbours a and b. Returns nullopt
// when it does not, or the corrector fails on the way.
std::optional<SolutionPoint> locate(Corrector& corrector, const SolutionPoint& a,
                                    const SolutionPoint& b,
                                    const std::function<double(const SolutionPoint&)>& test);

// The fold between neighbours a and b; nullopt when the branch does not turn back between them.
std::optional<SolutionPoint> fold_between(Corrector& corrector, const SolutionPoint& a,
                                          const SolutionPoint& b);

// Whether `point` lies on the branch between neighbours a and b. `max_turn`: that of the branch.
bool lies_between(Corrector& corrector, const SolutionPoint& a, const SolutionPoint& b,
                  const SolutionPoint& point, double max_turn);

}  // namespace graze
