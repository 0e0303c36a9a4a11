// Pseudo-arclength continuation of F(u, parameter) = 0, F: R^n x R -> R^n. Generic: it does not
// depend on what the equations stand for.
//
//   #include "graze/continuation/branch.hpp"
//
// is all that a program needs: the problem (zero_problem.hpp), the options and the branch that
// comes out (branch_values.hpp), and the functions below.
//
// A point is x = (u, parameter/range); the predictor follows the unit tangent, the corrector is
// Newton's method on F bordered by the hyperplane through the prediction. It passes folds and
// branch points. The metric is Euclidean: scale the unknowns so that a change of one is large.
//
// Special points, named as AUTO and MatCont name them: folds (LP) and branch points (BP) of any
// equations; period doublings (PD) and tori (NS) where the problem gives the multipliers of its
// solutions (map.hpp makes such a problem of a map). They are located to the last digits that
// arclength carries. See switching.hpp for continuing across them.
#pragma once

#include <functional>
#include <optional>

#include "graze/continuation/branch/branch_values.hpp"
#include "graze/continuation/branch/zero_problem.hpp"

namespace graze {

// The solution near u at a fixed parameter, with a tangent that points to growing parameter (or
// along growing arclength at a fold). Returns nullopt when Newton's method does not reach the
// tolerance.
std::optional<SolutionPoint> solve_at(const ZeroProblem& problem,
                                      const ContinuationOptions& options, const Vector& u,
                                      double parameter);

// The same near (u, parameter) where the branch may turn back there: on the hyperplane normal to
// the branch, whose direction in (u, parameter/range) is `along` or, where that is empty, the
// kernel of dF/dx. Returns nullopt likewise, and at a branch point.
std::optional<SolutionPoint> solve_near(const ZeroProblem& problem,
                                        const ContinuationOptions& options, const Vector& u,
                                        double parameter, const Vector& along = {});

enum class Directions { kBoth, kForward };  // forward: along the tangent of the start

// The branch through a solution, to its ends, its special points located.
Branch trace_branch(const ZeroProblem& problem, const ContinuationOptions& options,
                    const SolutionPoint& start, Directions directions = Directions::kBoth);

// The point of the branch between neighbours a and b where `test` changes sign, to the last digits
// that arclength carries and on the side where `test` is not negative. Returns nullopt when the
// corrector fails on the way or the signs agree.
std::optional<SolutionPoint> locate(const ZeroProblem& problem, const ContinuationOptions& options,
                                    const SolutionPoint& a, const SolutionPoint& b,
                                    const std::function<double(const SolutionPoint&)>& test);

// Whether a solution lies on a traced branch.
bool lies_on(const ZeroProblem& problem, const ContinuationOptions& options, const Branch& branch,
             const SolutionPoint& point);

}  // namespace graze
