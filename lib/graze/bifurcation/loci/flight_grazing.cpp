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
  const ShootingProblem& shooting = flights_.shooting();
  const Eigen::Index n = problem_.first, modes = system->modes();
  const Eigen::Index first = static_cast<Eigen::Index>(grazing_) * (2 * modes + 1) + 1 + modes;
  const auto stop = static_cast<std::size_t>(shooting.pattern().stops[grazing_]);
  const Vector units = shooting.scale().velocity / shooting.scale().speed;
  const Vector qdot = y.segment(first, modes).cwiseProduct(units);
  const Vector& row = system->stops[stop].row;
  Condition condition{row.dot(qdot), Vector::Zero(n + 1), tangents[1]->stops[stop].row.dot(qdot)};
  condition.slope.segment(first, modes) = row.cwiseProduct(units);
  condition.slope[n] = tangents[0]->stops[stop].row.dot(qdot) * unit_;
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
