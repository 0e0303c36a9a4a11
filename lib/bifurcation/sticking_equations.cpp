#include "graze/bifurcation/sticking_equations.hpp"

#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/half_period.hpp"

namespace graze {

StickingEquations::StickingEquations(const SystemFamily& family, ReleaseSection section)
    : family_(family), systems_(family), section_(std::move(section)) {
  const int period = section_.release().period;
  if (period % 2 == 0) half_ = section_.over(period / 2);
  problem_.evaluate = [this](const Vector& u, Parameters at) { return evaluate(u, at[0]); };
  // The errors of the eigenvalues come with them, whether or not they are asked for.
  problem_.multipliers = [this](const Vector& u, Parameters at,
                                auto&&...) -> std::vector<Eigenvalue> {
    const System* system = system_at(at[0]);
    return system ? section_.multipliers(*system, u) : std::vector<Eigenvalue>();
  };
  problem_.wrap = Vector::Zero(section_.size());
  problem_.wrap[0] = kTurn;
}

std::optional<ZeroEvaluation> StickingEquations::evaluate(const Vector& u, double value) const {
  const System* system = systems_.at(value);
  const System* tangent = systems_.tangent_at(value);
  if (!system || !tangent) return {};
  const auto at = section_.evaluate(*system, u, tangent);
  if (!at) return {};
  return ZeroEvaluation{at->residual, at->jacobian, at->parameter_derivative};
}

std::optional<ReleaseReturn> StickingEquations::follow(const BranchPoint& solution,
                                                       bool minima) const {
  return followed_.answer({solution.u, solution.parameter, minima}, [&] {
    const System* system = system_at(solution.parameter);
    return system ? section_.follow(*system, solution.u, minima) : std::optional<ReleaseReturn>();
  });
}

std::optional<std::vector<PassageMargin>> StickingEquations::margins(const BranchPoint& solution,
                                                                     double range) const {
  const System* system = systems_.at(solution.parameter);
  const System* tangent = systems_.tangent_at(solution.parameter);
  if (!system || !tangent) return {};
  const Eigen::Index n = solution.u.size();
  return section_.margins(*system, solution.u, *tangent, solution.tangent.head(n),
                          solution.rate() * range);
}

std::optional<OrbitBranchPoint> StickingEquations::judge(const BranchPoint& solution) const {
  const System* system = system_at(solution.parameter);
  if (!system) return {};
  std::optional<Orbit> orbit = section_.orbit(*system, solution.u);
  if (!orbit) return {};
  return point_of_branch(solution.parameter, std::move(*orbit));
}

Vector StickingEquations::halves_differ(const BranchPoint& solution) const {
  if (!half_) return {};
  return halves_.answer({solution.u, solution.parameter}, [&] {
    const System* system = system_at(solution.parameter);
    const auto at = system ? half_->evaluate(*system, solution.u) : std::nullopt;
    return at ? at->residual : Vector();
  });
}

bool StickingEquations::passes_half(const BranchPoint& a, const BranchPoint& b) const {
  return turns_round(halves_differ(a), halves_differ(b), 0.0);
}

bool has_same_events(const ReleaseReturn& back, const ReleaseReturn& other, bool impacts) {
  return back.returns && back.holds == other.holds &&
         (!impacts || back.itinerary == other.itinerary);
}

}  // namespace graze
