#include "graze/bifurcation/orbit_equations.hpp"

#include <algorithm>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/half_period.hpp"
#include "graze/bifurcation/locus_margins.hpp"
#include "graze/orbit/shooting_curvature.hpp"
#include "graze/orbit/solve.hpp"

namespace graze {
namespace {

bool is_real(const CriticalProduct& product) {
  return product.multiplier.imag() == 0.0 && product.left.imag().isZero(0.0) &&
         product.right.imag().isZero(0.0);
}

}  // namespace

OrbitEquations::OrbitEquations(const Scene& scene, const std::vector<std::string>& parameters,
                               ImpactPattern pattern, const MotionScale& scale)
    : systems_(scene, parameters), shooting_(std::move(pattern), scale) {
  problem_.evaluate = [this](const Vector& u, Parameters at) { return evaluate(u, at); };
  problem_.multipliers = [this](const Vector& u, Parameters at,
                                ErrorBounds errors) -> std::vector<Eigenvalue> {
    const System* system = system_at(at);
    if (!system) return {};
    return orbit_multipliers(*system, this->pattern(), shooting_.unpack(*system, u), errors);
  };
  problem_.poles = [this](const Vector& u, Parameters at) -> Vector {
    const System* system = system_at(at);
    if (!system) return {};
    return approach_speeds(*system, this->pattern(), shooting_.unpack(*system, u));
  };
  problem_.curvature = [this](const Vector& u, Parameters at,
                              const std::vector<CriticalProduct>& products) {
    return curvature(u, at, products);
  };
  problem_.wrap = shooting_.wrap();
}

std::vector<const System*> OrbitEquations::tangents_at(Parameters at) const {
  std::vector<const System*> tangents;
  for (std::size_t i = 0; i < at.size(); ++i) tangents.push_back(tangent_at(at, i));
  return tangents;
}

std::optional<ZeroEvaluation> OrbitEquations::evaluate(const Vector& u, Parameters at) const {
  const System* system = system_at(at);
  if (!system) return {};
  const std::vector<const System*> tangents = tangents_at(at);
  if (std::find(tangents.begin(), tangents.end(), nullptr) != tangents.end()) return {};
  ShootingLinearisation equations = shooting_.linearise(*system, u, tangents);
  return ZeroEvaluation{std::move(equations.residual), std::move(equations.jacobian),
                        std::move(equations.by_parameters), std::move(equations.closing)};
}

std::optional<Eigen::MatrixXcd> OrbitEquations::curvature(
    const Vector& u, Parameters at, const std::vector<CriticalProduct>& products) const {
  const System* system = system_at(at);
  if (!system) return {};
  const std::vector<const System*> tangents = tangents_at(at);
  Eigen::MatrixXcd rows(static_cast<Eigen::Index>(products.size()),
                        u.size() + static_cast<Eigen::Index>(at.size()));
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    const CriticalProduct& product = products[static_cast<std::size_t>(row)];
    if (is_real(product))
      rows.row(row) = shooting_curvature(shooting_, *system, u, tangents, product.left.real(),
                                         product.right.real(), product.multiplier.real())
                          .cast<Complex>();
    else
      rows.row(row) = shooting_curvature(shooting_, *system, u, tangents, product.left,
                                         product.right, product.multiplier);
  }
  return rows;
}

std::vector<ImpactPoint> OrbitEquations::points(const BranchPoint& solution) const {
  return shooting_.unpack(*system_at(solution.parameters()), solution.u);
}

Admissibility OrbitEquations::admissibility_of(const BranchPoint& solution) const {
  return admissibility(*system_at(solution.parameters()), pattern(), points(solution));
}

OrbitBranchPoint OrbitEquations::judge(const BranchPoint& solution) const {
  const System& system = *system_at(solution.parameters());
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
