#include "graze/bifurcation/loci/detail/flight_grazing.hpp"

#include <utility>

#include "graze/bifurcation/cut/detail/flight_locus.hpp"
#include "graze/bifurcation/problem/grazing_orbit.hpp"

namespace graze {

FlightGrazing::FlightGrazing(const FlightEquations& equations, std::size_t grazing, double unit)
    : OrbitCurve(equations, equations.problem().wrap.size(), 0, unit,
                 std::make_unique<FlightLocus>(equations, grazing)),
      flights_(equations),
      grazing_(grazing) {
  ZeroProblem& zero = problem_.problem;
  zero.evaluate = [this](const Vector& y, Parameters at) {
    return with(y, at[0], speed(y, at[0]));
  };
  if (equations.pattern().impacts() > 1)
    zero.multipliers = [this](const Vector& y, Parameters at, ErrorBounds errors) {
      return multipliers(y, at[0], errors);
    };
}

// The speed of the impact that touches.
std::optional<OrbitCurve::Condition> FlightGrazing::speed(const Vector& y, double second) const {
  const std::array<double, 2> values = parameters_of(y, second);
  const System* system = flights_.system_at(values);
  if (!system) return {};
  const std::vector<const System*> tangents = flights_.tangents_at(values);
  if (tangents.size() < 2) return {};
  const Eigen::Index n = problem_.first;
  const ShootingProblem::ImpactSpeed speed =
      flights_.shooting().speed_of(*system, y.head(n), grazing_, tangents);
  Condition condition{speed.value, Vector(n + 1), speed.by_parameters[1]};
  condition.slope << speed.by_x, speed.by_parameters[0] * unit_;
  return condition;
}

std::vector<Eigenvalue> FlightGrazing::multipliers(const Vector& y, double second,
                                                   ErrorBounds errors) const {
  const System* system = flights_.system_at(parameters_of(y, second));
  if (!system) return {};
  const GrazingOrbit orbit = without_grazing(
      {flights_.pattern(), flights_.shooting().unpack(*system, y.head(problem_.first)), grazing_});
  return orbit_multipliers(*system, orbit.pattern, orbit.impacts, errors);
}

}  // namespace graze
