#include "graze/bifurcation/orbit_equations.hpp"

#include <algorithm>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/half_period.hpp"
#include "graze/bifurcation/locus_margins.hpp"
#include "graze/orbit/solve.hpp"

namespace graze {

OrbitEquations::OrbitEquations(const SystemFamily& family, ImpactPattern pattern,
                               const MotionScale& scale)
    : systems_(family), shooting_(std::move(pattern), scale) {
  problem_.evaluate = [this](const Vector& u, double value) { return evaluate(u, value); };
  problem_.multipliers = [this](const Vector& u, double value,
                                ErrorBounds errors) -> std::vector<Eigenvalue> {
    const System* system = system_at(value);
    if (!system) return {};
    return orbit_multipliers(*system, this->pattern(), shooting_.unpack(*system, u), errors);
  };
  problem_.poles = [this](const Vector& u, double value) -> Vector {
    const System* system = system_at(value);
    if (!system) return {};
    return approach_speeds(*system, this->pattern(), shooting_.unpack(*system, u));
  };
  problem_.wrap = shooting_.wrap();
}

const System* OrbitEquations::system_at(double value) const { return systems_.at(value); }

const System* OrbitEquations::tangent_at(double value) const { return systems_.tangent_at(value); }

std::optional<ZeroEvaluation> OrbitEquations::evaluate(const Vector& u, double value) const {
  const System* system = systems_.at(value);
  const System* tangent = systems_.tangent_at(value);
  if (system == nullptr || tangent == nullptr) return {};
  ZeroEvaluation at;
  at.residual = shooting_.residual(*system, u, &at.jacobian, tangent, &at.parameter_derivative);
  return at;
}

std::vector<ImpactPoint> OrbitEquations::points(const BranchPoint& solution) const {
  return shooting_.unpack(*system_at(solution.parameter), solution.u);
}

Admissibility OrbitEquations::admissibility_of(const BranchPoint& solution) const {
  return admissibility(*system_at(solution.parameter), pattern(), points(solution));
}

OrbitBranchPoint OrbitEquations::judge(const BranchPoint& solution) const {
  const System& system = *system_at(solution.parameter);
  return point_of_branch(solution.parameter,
                         solution.multipliers.empty()
                             ? make_orbit(system, shooting_, solution.u)
                             : make_orbit(system, shooting_, solution.u, solution.multipliers));
}

Vector OrbitEquations::halves_differ(const BranchPoint& solution) const {
  const ImpactPattern& whole = pattern();
  const int half = whole.impacts() / 2, half_period = whole.period / 2;
  if (whole.period % 2 != 0 || whole.impacts() % 2 != 0 ||
      !std::equal(whole.stops.begin(), whole.stops.begin() + half, whole.stops.begin() + half))
    return {};
  const Eigen::Index size = solution.u.size() / 2, block = size / half;
  Vector difference = solution.u.tail(size) - solution.u.head(size);
  for (Eigen::Index at = 0; at < size; at += block) difference[at] -= kTurn * half_period;
  return difference;
}

bool OrbitEquations::passes_half(const BranchPoint& a, const BranchPoint& b) const {
  // Where a branch was switched onto, its first point has half the period to rounding.
  return turns_round(halves_differ(a), halves_differ(b), kShootingTolerance);
}

}  // namespace graze
