// The bordered Newton corrector behind branch.hpp; points are x = (u, parameter/range).
#pragma once

#include <optional>

#include "graze/continuation/branch.hpp"

namespace graze {

class Corrector {
 public:
  Corrector(const ZeroProblem& problem, const ContinuationOptions& options);

  Vector pack(const BranchPoint& point) const;
  double range() const { return range_; }
  long long evaluations() const { return evaluations_; }

  // The solution on the hyperplane through `guess` normal to `normal`, its tangent turned along
  // `normal`. Nothing when Newton's method contracts too slowly or misses the tolerance.
  std::optional<BranchPoint> on_hyperplane(const Vector& guess, const Vector& normal);
  // The solution at the parameter of `guess`, with its tangent towards growing parameter.
  std::optional<BranchPoint> at_parameter(const Vector& guess);

  // x - y with angles taken the short way round.
  Vector difference(const Vector& x, const Vector& y) const;

 private:
  struct Linearised {
    Vector residual;
    Matrix slope;  // [dF/du, dF/dparameter * range], n x (n + 1)
  };
  std::optional<Linearised> linearise(const Vector& x);
  std::optional<BranchPoint> solve(Vector x, const Vector& normal);
  BranchPoint unpack(const Vector& x, const Vector& tangent, double residual) const;

  const ZeroProblem& problem_;
  const ContinuationOptions& options_;
  double range_;
  long long evaluations_ = 0;
};

}  // namespace graze
