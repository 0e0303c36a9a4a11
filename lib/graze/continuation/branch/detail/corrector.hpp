// Newton's method on F bordered by a hyperplane, and the geometry of the points it works on, x =
// (u, parameter/range). All of continuation uses it.
#pragma once

#include <optional>

#include "graze/continuation/branch/branch_values.hpp"
#include "graze/continuation/branch/zero_problem.hpp"

namespace graze {

class Corrector {
 public:
  // Refers to both, which must outlive it.
  Corrector(const ZeroProblem& problem, const ContinuationOptions& options);

  // x of a point.
  Vector pack(const SolutionPoint& point) const;
  // Length of the parameter's range; 1 where that is empty.
  double range() const { return range_; }
  // Evaluations of F so far.
  long long evaluations() const { return evaluations_; }

  // The solution on the hyperplane through `guess` normal to `normal`, its tangent on the side of
  // `normal`. Returns nullopt when Newton's steps do not shrink by `contraction` from one to the
  // next, or miss the tolerance. The smaller the required contraction, the nearer the guess has to
  // be, and the less it can slide to another branch.
  std::optional<SolutionPoint> on_hyperplane(const Vector& guess, const Vector& normal,
                                             double contraction = kConvergent);
  // The result of one step of Newton's method from `guess` on the hyperplane normal to `normal`.
  // Returns nullopt when the equations cannot be evaluated or the step is not finite.
  std::optional<Vector> newton_step(const Vector& guess, const Vector& normal);
  // The solution at the parameter of `guess`, with its tangent towards growing parameter. Returns
  // nullopt as on_hyperplane does.
  std::optional<SolutionPoint> at_parameter(const Vector& guess);

  struct Linearised {
    Vector residual;
    Matrix bordered;  // [dF/du, dF/dparameter * range], below it the normal, (n + 1) x (n + 1)
  };
  // The equations at x; nullopt when they cannot be evaluated.
  std::optional<Linearised> linearise(const Vector& x, const Vector& normal);
  // [dF/du, dF/dparameter * range] at x, n x (n + 1); nullopt likewise.
  std::optional<Matrix> slope_at(const Vector& x);
  // Largest entry of F at x; nullopt likewise.
  std::optional<double> residual_at(const Vector& x);
  // |det [slope; tangent]| at b over that at a; not a number where either cannot be evaluated.
  double determinant_ratio(const SolutionPoint& a, const SolutionPoint& b);

  // x - y with angles taken the short way round.
  Vector difference(const Vector& x, const Vector& y) const;
  // The vector from a to b.
  Vector chord(const SolutionPoint& a, const SolutionPoint& b) const {
    return difference(pack(b), pack(a));
  }
  // How far b lies ahead of a, along the tangent there.
  double ahead(const SolutionPoint& a, const SolutionPoint& b) const {
    return chord(a, b).dot(a.tangent);
  }

 private:
  // Contraction with which Newton's method still converges; used where no other branch is near.
  static constexpr double kConvergent = 0.8;

  std::optional<SolutionPoint> solve(Vector x, const Vector& normal, double contraction);
  // `sign` of det [slope; tangent]
  SolutionPoint unpack(const Vector& x, const Vector& tangent, double residual, int sign) const;

  const ZeroProblem& problem_;
  const ContinuationOptions& options_;
  double range_;
  long long evaluations_ = 0;
};

}  // namespace graze
