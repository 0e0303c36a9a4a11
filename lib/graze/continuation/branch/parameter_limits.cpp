#include "graze/continuation/branch/detail/parameter_limits.hpp"

#include <algorithm>

namespace graze {

ParameterLimits::ParameterLimits(const ContinuationOptions& options)
    : lowest_(std::min(options.from, options.to)), highest_(std::max(options.from, options.to)) {}

bool ParameterLimits::leaves_at(const SolutionPoint& here) const {
  return here.rate() != 0.0 && here.parameter == towards(here.rate());
}

std::optional<SolutionPoint> point_on_limit(Corrector& corrector, const SolutionPoint& near,
                                            double limit) {
  Vector x = corrector.pack(near);
  const Eigen::Index last = x.size() - 1;
  if (near.rate() != 0.0) x += (limit / corrector.range() - x[last]) / near.rate() * near.tangent;
  x[last] = limit / corrector.range();
  std::optional<SolutionPoint> point = corrector.at_parameter(x);
  if (!point) return {};
  point->parameter = limit;
  if (point->tangent.dot(near.tangent) < 0.0) point->turn_round();
  return point;
}

}  // namespace graze
