// u'' + p e^u = 0, u(0) = u(1) = 0 on 80 intervals, fourth order (Numerov): fold at 3.5138307191.
#include <cstdio>

#include "graze/continuation/branch.hpp"

using namespace graze;

int main() {
  ZeroProblem bratu;
  bratu.evaluate = [](const Vector& u, Parameters parameters) -> std::optional<ZeroEvaluation> {
    const double p = parameters[0];
    const Eigen::Index n = u.size();
    const double h2 = 1.0 / double((n + 1) * (n + 1));
    const Vector growth = u.array().exp();
    Matrix second = Matrix::Identity(n, n) * -2.0, mean = Matrix::Identity(n, n) * (10.0 / 12.0);
    second.diagonal(1).setOnes(), second.diagonal(-1).setOnes();
    mean.diagonal(1).setConstant(1.0 / 12.0), mean.diagonal(-1).setConstant(1.0 / 12.0);
    Vector source = h2 * mean * growth;
    source[0] += h2 / 12.0, source[n - 1] += h2 / 12.0;  // e^0 at both ends
    return ZeroEvaluation{second * u + p * source, second + p * h2 * mean * growth.asDiagonal(),
                          source};
  };
  ContinuationOptions options{.from = 0.0, .to = 4.0, .max_distance = 1.0};
  const auto start = solve_at(bratu, options, Vector::Zero(79), 0.5);
  if (!start) return 3;
  for (const CriticalPoint& special : trace_branch(bratu, options, *start).critical)
    std::printf("%s p = %.12f\n", label_of(special.kind), special.point.parameter);
}
