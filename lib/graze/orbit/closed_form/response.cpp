#include "graze/orbit/closed_form/response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/flow/held/detail/generator_parts.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Z = w^2 - W^2 + i W D, by which Z amplitude = force.
Eigen::MatrixXcd impedance_matrix(const System& system) {
  const double frequency = system.forcing()->frequency;
  Eigen::MatrixXcd all = Complex(0.0, frequency) * system.damping().cast<Complex>();
  for (Eigen::Index j = 0; j < all.cols(); ++j)
    all(j, j) += (system.omega[j] - frequency) * (system.omega[j] + frequency);
  return all;
}

// The first-order form of the free motion, on (w q, q').
Matrix free_generator(const System& system) {
  const Eigen::Index n = system.modes();
  Matrix generator = Matrix::Zero(2 * n, 2 * n);
  generator.topRightCorner(n, n) = system.omega.asDiagonal();
  generator.bottomLeftCorner(n, n) = -Matrix(system.omega.asDiagonal());
  generator.bottomRightCorner(n, n) = -system.damping();
  return generator;
}

Complex impedance(const System& system, Eigen::Index j) {
  const double w = system.omega[j], frequency = system.forcing()->frequency;
  return {(w - frequency) * (w + frequency), 2.0 * system.delta()[j] * frequency};
}

}  // namespace

State Response::at(double theta, double frequency) const {
  const Complex turn = std::polar(1.0, theta);
  return {offset + (turn * amplitude).real(), -frequency * (turn * amplitude).imag()};
}

double Response::clearance(const Stop& stop) const {
  Complex swing = 0.0;
  for (Eigen::Index j = 0; j < amplitude.size(); ++j) swing += stop.row[j] * amplitude[j];
  return stop.gap - stop.row.dot(offset) - std::abs(swing);
}

std::optional<double> Response::clearance(const std::vector<Stop>& stops) const {
  std::optional<double> smallest;
  for (const Stop& stop : stops) {
    const double here = clearance(stop);
    smallest = std::min(smallest.value_or(here), here);
  }
  return smallest;
}

std::optional<Response> response_of(const System& system) {
  const Eigen::Index n = system.modes();
  Response response{ComplexVector(n), Vector::Zero(n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    const Complex z = impedance(system, j);
    if ((z == 0.0 && !system.coupling()) || !(system.omega[j] > 0.0)) return {};
    response.amplitude[j] = system.forcing()->amplitude[j] / z;
    if (system.load())
      response.offset[j] = (*system.load())[j] / (system.omega[j] * system.omega[j]);
  }
  if (system.coupling())
    response.amplitude =
        solve(impedance_matrix(system), system.forcing()->amplitude.cast<Complex>());
  if (!response.amplitude.allFinite() || !response.offset.allFinite()) return {};
  return response;
}

Response response_rate(const System& system, const System& tangent, const Response& response) {
  const Eigen::Index n = system.modes();
  const double frequency = system.forcing()->frequency;
  const double turns = tangent.forcing() ? tangent.forcing()->frequency : 0.0;
  Response rate{ComplexVector(n), Vector::Zero(n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    const double w = system.omega[j], delta = system.delta()[j];
    const Complex dz(2.0 * (w * tangent.omega[j] - frequency * turns),
                     2.0 * (tangent.delta()[j] * frequency + delta * turns));
    const double force = tangent.forcing() ? tangent.forcing()->amplitude[j] : 0.0;
    rate.amplitude[j] = (force - response.amplitude[j] * dz) / impedance(system, j);
    const double load = tangent.load() ? (*tangent.load())[j] : 0.0;
    if (system.load() || tangent.load())
      rate.offset[j] = (load - 2.0 * w * tangent.omega[j] * response.offset[j]) / (w * w);
  }
  if (system.coupling() || tangent.coupling()) {
    const Matrix damping = system.damping(), damping_rate = tangent.damping();
    Eigen::MatrixXcd z_rate =
        Complex(0.0, 1.0) * (frequency * damping_rate + turns * damping).cast<Complex>();
    z_rate.diagonal() +=
        (2.0 * (system.omega.cwiseProduct(tangent.omega).array() - frequency * turns))
            .matrix()
            .cast<Complex>();
    const Vector force = tangent.forcing() ? tangent.forcing()->amplitude : Vector(Vector::Zero(n));
    rate.amplitude =
        solve(impedance_matrix(system), force.cast<Complex>() - z_rate * response.amplitude);
  }
  return rate;
}

std::vector<Eigenvalue> response_multipliers(const System& system) {
  // Roundings of argument and exponential, which grow with the period.
  constexpr double kRoundings = 4.0 * std::numeric_limits<double>::epsilon();
  const double period = system.period();
  std::vector<Eigenvalue> list;
  if (system.coupling()) {
    for (const GeneratorPart& part : generator_parts(free_generator(system))->parts)
      for (const Complex& rate : part.modes.values) {
        const Complex value = std::exp(rate * period);
        list.push_back({value, kRoundings * std::abs(rate) * period * std::abs(value)});
      }
    sort_eigenvalues(list);
    return list;
  }
  for (Eigen::Index j = 0; j < system.modes(); ++j) {
    const double w = system.omega[j], delta = system.delta()[j];
    const Complex root = std::sqrt(Complex((w - delta) * (w + delta)));
    for (const Complex rate :
         {Complex(-delta) + Complex(0.0, 1.0) * root, Complex(-delta) - Complex(0.0, 1.0) * root}) {
      const Complex value = std::exp(rate * period);
      const double rounding = delta == 0.0 ? kRoundings : kRoundings * std::abs(rate) * period;
      list.push_back({value, rounding * std::abs(value)});
    }
  }
  sort_eigenvalues(list);
  return list;
}

Orbit response_orbit(const System& system, const Response& response) {
  const HarmonicForcing& forcing = *system.forcing();
  const State start = response.at(0.0, forcing.frequency);
  const double local = wrapped(-forcing.phase) / forcing.frequency;
  MotionState<double> state;
  state.instant = {0, local < system.period() ? local : 0.0};
  state.q = start.q;
  state.qdot = start.qdot;
  state.contacts.assign(system.stops.size(), Contact::kClear);
  state.multiplicities.assign(system.stops.size(), 0);
  Orbit orbit;
  orbit.section = OrbitSection{{}, {state}, 0.0};
  orbit.multipliers = response_multipliers(system);
  orbit.stable = stability(orbit.multipliers);
  orbit.clearance = response.clearance(system.stops);
  orbit.admissible = orbit.clearance.value_or(0.0) >= 0.0;
  return orbit;
}

}  // namespace graze
