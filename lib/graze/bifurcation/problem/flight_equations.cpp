#include "graze/bifurcation/problem/detail/flight_equations.hpp"

#include <algorithm>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/problem/detail/canonical_pattern.hpp"
#include "graze/bifurcation/problem/detail/locus_margins.hpp"
#include "graze/continuation/map.hpp"
#include "graze/orbit/problem/detail/shooting_curvature.hpp"
#include "graze/orbit/problem/detail/solve.hpp"

namespace graze {
namespace {

bool is_real(const CriticalProduct& product) {
  return product.multiplier.imag() == 0.0 && product.left.imag().isZero(0.0) &&
         product.right.imag().isZero(0.0);
}

}  // namespace

FlightEquations::FlightEquations(const Scene& scene, const std::vector<std::string>& parameters,
                                 ImpactPattern pattern, const MotionScale& scale)
    : OrbitProblem(scene, parameters),
      scene_(scene),
      parameters_(parameters),
      shooting_(std::move(pattern), scale) {
  problem_.poles = [this](const Vector& u, Parameters at) -> Vector {
    const System* system = system_at(at);
    if (!system) return {};
    return approach_speeds(*system, this->pattern(), shooting_.unpack(*system, u));
  };
  problem_.wrap = shooting_.wrap();
}

std::optional<ShootingLinearisation> FlightEquations::linearise(
    const System& system, const Vector& u, std::span<const System* const> tangents) const {
  return shooting_.linearise(system, u, tangents);
}

std::vector<Eigenvalue> FlightEquations::multipliers(const System& system, const Vector& u,
                                                     ErrorBounds errors) const {
  return orbit_multipliers(system, pattern(), shooting_.unpack(system, u), errors);
}

std::optional<Eigen::MatrixXcd> FlightEquations::curvature(
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

std::vector<ImpactPoint> FlightEquations::points(const SolutionPoint& solution) const {
  return shooting_.unpack(*system_at(solution.parameters()), solution.u);
}

Admissibility FlightEquations::admissibility_of(const SolutionPoint& solution) const {
  return admissibility(*system_at(solution.parameters()), pattern(), points(solution));
}

OrbitBranchPoint FlightEquations::orbit_at(const SolutionPoint& solution) const {
  const System& system = *system_at(solution.parameters());
  return point_of_branch(solution.parameter,
                         solution.multipliers.empty()
                             ? make_orbit(system, shooting_, solution.u)
                             : make_orbit(system, shooting_, solution.u, solution.multipliers));
}

std::optional<OrbitBranchPoint> FlightEquations::judge(const SolutionPoint& solution) const {
  return system_at(solution.parameters()) ? std::optional(orbit_at(solution)) : std::nullopt;
}

Vector FlightEquations::halves_differ(const SolutionPoint& solution) const {
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

std::unique_ptr<OrbitProblem> FlightEquations::doubled() const {
  ImpactPattern twice = pattern();
  twice.period *= 2;
  twice.stops.insert(twice.stops.end(), pattern().stops.begin(), pattern().stops.end());
  return std::make_unique<FlightEquations>(scene_, parameters_, std::move(twice),
                                           shooting_.scale());
}

SolutionPoint FlightEquations::twice_round(const SolutionPoint& solution) const {
  SolutionPoint twice = graze::twice_round(solution);
  const Eigen::Index n = solution.u.size(), block = n / pattern().impacts();
  for (Eigen::Index at = n; at < 2 * n; at += block) twice.u[at] += kTurn * pattern().period;
  return twice;
}

std::vector<SolutionPoint> FlightEquations::rewritings(const OrbitProblem& of,
                                                       const ContinuationOptions& /*options*/,
                                                       const SolutionPoint& solution) const {
  std::vector<SolutionPoint> list;
  if (&of != this || !system_at(solution.parameters())) return list;
  for (const std::vector<ImpactPoint>& impacts : graze::rewritings(pattern(), points(solution))) {
    list.push_back(solution);
    list.back().u = shooting_.pack(*system_at(solution.parameters()), impacts);
  }
  return list;
}

}  // namespace graze
