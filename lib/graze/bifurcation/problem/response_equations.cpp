#include "graze/bifurcation/problem/detail/response_equations.hpp"

#include "graze/flow/held/detail/held_exactly.hpp"
#include "graze/flow/variation/detail/deviation.hpp"

namespace graze {
namespace {

// The free motion over a period less the identity, from each displacement and each velocity, in
// units of the scale.
Matrix free_growth(const System& free, double period, const MotionScale& scale) {
  const Eigen::Index n = free.modes();
  const Vector rest = Vector::Zero(n);
  Matrix map = Matrix::Zero(2 * n, 2 * n);
  if (free.coupling()) {
    const std::unique_ptr<ExactPhase<double>> phase = exact_phase(free, {});
    phase->start(0.0, rest, rest, 0.0);
    Deviations unit{Matrix::Zero(n, 2 * n), Matrix::Zero(n, 2 * n),
                    Eigen::RowVectorXd::Zero(2 * n)};
    unit.q.leftCols(n).diagonal().setConstant(scale.displacement);
    unit.qdot.rightCols(n).diagonal() = scale.velocity;
    const Deviations change = growth(*phase, period, unit);
    map << change.q / scale.displacement, scale.velocity.cwiseInverse().asDiagonal() * change.qdot;
    return map;
  }
  FreePhase<double> phase(free, {});
  Vector q(n), qdot(n);
  for (const bool of_velocity : {false, true}) {
    const Vector displaced = Vector::Constant(n, of_velocity ? 0.0 : scale.displacement);
    const Vector moving = of_velocity ? scale.velocity : rest;
    phase.start(0.0, displaced, moving, 0.0);
    phase.state(period, q, qdot);
    for (Eigen::Index j = 0; j < n; ++j) {
      const Eigen::Index from = of_velocity ? n + j : j;
      map(j, from) = q[j] / scale.displacement;
      map(n + j, from) = qdot[j] / scale.velocity[j];
    }
  }
  return map - Matrix::Identity(2 * n, 2 * n);
}

}  // namespace

ResponseEquations::ResponseEquations(const Scene& scene, const std::vector<std::string>& parameters,
                                     const MotionScale& scale)
    : OrbitProblem(scene, parameters), scene_(scene), parameters_(parameters), scale_(scale) {}

std::optional<Response> ResponseEquations::response(const SolutionPoint& solution) const {
  const System* system = system_at(solution.parameters());
  return system ? response_of(*system) : std::nullopt;
}

Vector ResponseEquations::packed(const Response& response, double frequency) const {
  const State at = response.at(0.0, frequency);
  Vector u(2 * at.q.size());
  u << at.q / scale_.displacement, at.qdot.cwiseQuotient(scale_.velocity);
  return u;
}

std::optional<Vector> ResponseEquations::unknowns_at(Parameters at) const {
  const System* system = system_at(at);
  const std::optional<Response> response = system ? response_of(*system) : std::nullopt;
  if (!response) return {};
  return packed(*response, system->forcing()->frequency);
}

std::optional<ShootingLinearisation> ResponseEquations::linearise(
    const System& system, const Vector& u, std::span<const System* const> tangents) const {
  const std::optional<Response> response = response_of(system);
  if (!response) return {};
  const Eigen::Index n = system.modes();
  const double frequency = system.forcing()->frequency;
  // The free motion over a period, of each mode from its displacement and from its velocity.
  System free = system;
  free.stops.clear();
  free.modal().forcing.reset();
  free.modal().load.reset();
  ShootingLinearisation sum;
  sum.jacobian = free_growth(free, system.period(), scale_);
  sum.residual = sum.jacobian * (u - packed(*response, frequency));
  sum.closing = -Matrix::Identity(2 * n, 2 * n);
  sum.by_parameters.resize(2 * n, static_cast<Eigen::Index>(tangents.size()));
  for (std::size_t k = 0; k < tangents.size(); ++k) {
    const Response rate = response_rate(system, *tangents[k], *response);
    Vector moved = packed(rate, frequency);
    if (const HarmonicForcing* forcing = tangents[k]->forcing())
      moved.tail(n) +=
          (forcing->frequency * response->at(0.0, 1.0).qdot).cwiseQuotient(scale_.velocity);
    sum.by_parameters.col(static_cast<Eigen::Index>(k)) = -sum.jacobian * moved;
  }
  return sum;
}

std::vector<Eigenvalue> ResponseEquations::multipliers(const System& system, const Vector& /*u*/,
                                                       ErrorBounds /*errors*/) const {
  return response_multipliers(system);
}

std::optional<OrbitBranchPoint> ResponseEquations::judge(const SolutionPoint& solution) const {
  const std::optional<Response> found = response(solution);
  if (!found) return {};
  return point_of_branch(solution.parameter,
                         response_orbit(*system_at(solution.parameters()), *found));
}

std::unique_ptr<OrbitProblem> ResponseEquations::doubled() const {
  return std::make_unique<ResponseEquations>(scene_, parameters_, scale_);
}

std::vector<SolutionPoint> ResponseEquations::rewritings(const OrbitProblem& of,
                                                         const ContinuationOptions& /*options*/,
                                                         const SolutionPoint& solution) const {
  if (dynamic_cast<const ResponseEquations*>(&of)) return {solution};
  return {};
}

}  // namespace graze
