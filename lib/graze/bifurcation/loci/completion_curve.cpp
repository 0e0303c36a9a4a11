#include "graze/bifurcation/loci/detail/completion_curve.hpp"

#include "graze/bifurcation/cut/detail/segment_locus.hpp"
#include "graze/orbit/problem/detail/chatter_completion.hpp"

namespace graze {
namespace {

// Step of the differences, in units of the unknowns and the parameters' ranges: the distance has an
// error of some 1e-13, and is smooth over some 1e-5.
constexpr double kStep = 1e-8;

}  // namespace

CompletionCurve::CompletionCurve(const SegmentEquations& equations)
    : OrbitCurve(equations, equations.shooting().size(), 0, equations.unit(0),
                 std::make_unique<ReleaseLocus>(equations, true)),
      segments_(equations) {
  problem_.problem.evaluate = [this](const Vector& y, Parameters at) {
    return with(y, at[0], condition(y, at[0]));
  };
}

std::optional<double> CompletionCurve::distance(const Vector& y, double second) const {
  const System* system = segments_.system_at(parameters_of(y, second));
  return system ? completion_distance(*system, segments_.shooting(), y.head(problem_.first))
                : std::optional<double>();
}

std::optional<OrbitCurve::Condition> CompletionCurve::condition(const Vector& y,
                                                                double second) const {
  const auto here = distance(y, second);
  if (!here) return {};
  Condition condition{*here, Vector(y.size()), 0.0};
  const double by = kStep * segments_.unit(1);
  for (Eigen::Index j = 0; j <= y.size(); ++j) {
    const bool moves = j < y.size();
    const Vector step = moves ? Vector(kStep * Vector::Unit(y.size(), j)) : Vector::Zero(y.size());
    const auto ahead = distance(y + step, moves ? second : second + by),
               behind = distance(y - step, moves ? second : second - by);
    if (!ahead || !behind) return {};
    const double change = *ahead - *behind;
    (moves ? condition.slope[j] : condition.by_second) = change / (2.0 * (moves ? kStep : by));
  }
  return condition;
}

}  // namespace graze
