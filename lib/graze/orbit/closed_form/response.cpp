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
Eigen::MatrixXcd impedance_matrix(const System& system, double frequency) {
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

Complex impedance(const System& system, double frequency, Eigen::Index j) {
  const double w = system.omega[j];
  return {(w - frequency) * (w + frequency), 2.0 * system.delta()[j] * frequency};
}

// The amplitudes at order k of a force; empty where there are none, or more than one.
ComplexVector amplitudes_of(const System& system, int order, const ComplexVector& force) {
  const double frequency = order * system.forcing()->frequency;
  if (system.coupling()) return solve(impedance_matrix(system, frequency), force);
  ComplexVector amplitudes(force.size());
  for (Eigen::Index j = 0; j < force.size(); ++j) {
    const Complex z = impedance(system, frequency, j);
    if (z == 0.0) return {};
    amplitudes[j] = force[j] / z;
  }
  return amplitudes;
}

// Their derivative by the parameter of a tangent.
ComplexVector amplitude_rates(const System& system, const System& tangent, int order,
                              const ComplexVector& amplitudes, const ComplexVector& force_rate) {
  const Eigen::Index n = system.modes();
  const double frequency = order * system.forcing()->frequency;
  const double turns = tangent.forcing() ? order * tangent.forcing()->frequency : 0.0;
  if (system.coupling() || tangent.coupling()) {
    const Matrix damping = system.damping(), damping_rate = tangent.damping();
    Eigen::MatrixXcd z_rate =
        Complex(0.0, 1.0) * (frequency * damping_rate + turns * damping).cast<Complex>();
    z_rate.diagonal() +=
        (2.0 * (system.omega.cwiseProduct(tangent.omega).array() - frequency * turns))
            .matrix()
            .cast<Complex>();
    return solve(impedance_matrix(system, frequency), force_rate - z_rate * amplitudes);
  }
  ComplexVector rates(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Complex dz(2.0 * (system.omega[j] * tangent.omega[j] - frequency * turns),
                     2.0 * (tangent.delta()[j] * frequency + system.delta()[j] * turns));
    rates[j] = (force_rate[j] - amplitudes[j] * dz) / impedance(system, frequency, j);
  }
  return rates;
}

}  // namespace

State Response::at(double theta, double frequency) const {
  const Complex turn = std::polar(1.0, theta);
  State state{offset + (turn * amplitude).real(), -frequency * (turn * amplitude).imag()};
  for (const Part& part : harmonics) {
    const Complex turned = std::polar(1.0, part.order * theta);
    state.q += (turned * part.amplitude).real();
    state.qdot -= part.order * frequency * (turned * part.amplitude).imag();
  }
  return state;
}

HarmonicSum Response::gap(const Stop& stop) const {
  const auto swing = [&](const ComplexVector& of) {
    Complex sum = 0.0;
    for (Eigen::Index j = 0; j < of.size(); ++j) sum += stop.row[j] * of[j];
    return -sum;
  };
  HarmonicSum gap{stop.gap - stop.row.dot(offset), {{1, swing(amplitude)}}};
  for (const Part& part : harmonics) gap.terms.push_back({part.order, swing(part.amplitude)});
  return gap;
}

double Response::nearest_phase(const Stop& stop) const { return gap(stop).phase_of_least(); }

double Response::clearance(const Stop& stop) const { return gap(stop).least(); }

std::optional<double> Response::clearance(const std::vector<Stop>& stops) const {
  std::optional<double> smallest;
  for (const Stop& stop : stops) {
    const double here = clearance(stop);
    smallest = std::min(smallest.value_or(here), here);
  }
  return smallest;
}

std::optional<Response> response_of(const System& system) {
  const auto rubs = [](const Friction& friction) { return friction.sticking > 0.0; };
  if (std::any_of(system.frictions.begin(), system.frictions.end(), rubs)) return {};
  const Eigen::Index n = system.modes();
  Response response{{}, Vector::Zero(n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    if (!(system.omega[j] > 0.0)) return {};
    if (system.load())
      response.offset[j] = (*system.load())[j] / (system.omega[j] * system.omega[j]);
  }
  response.amplitude = amplitudes_of(system, 1, system.forcing()->amplitude.cast<Complex>());
  bool found = response.amplitude.size() == n && response.amplitude.allFinite();
  for (const Harmonic& one : system.forcing()->harmonics) {
    if (one.timed) return {};
    const int order = static_cast<int>(one.order);
    response.harmonics.push_back({order, amplitudes_of(system, order, one.force())});
    const ComplexVector& part = response.harmonics.back().amplitude;
    found = found && part.size() == n && part.allFinite();
  }
  if (!found || !response.offset.allFinite()) return {};
  return response;
}

Response response_rate(const System& system, const System& tangent, const Response& response) {
  const Eigen::Index n = system.modes();
  const HarmonicForcing* forcing = tangent.forcing();
  const ComplexVector none = ComplexVector::Zero(n);
  Response rate{amplitude_rates(system, tangent, 1, response.amplitude,
                                forcing ? ComplexVector(forcing->amplitude.cast<Complex>()) : none),
                Vector::Zero(n)};
  for (std::size_t k = 0; k < response.harmonics.size(); ++k) {
    const auto& [order, amplitude] = response.harmonics[k];
    rate.harmonics.push_back(
        {order, amplitude_rates(system, tangent, order, amplitude,
                                forcing ? forcing->harmonics[k].force() : none)});
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    const double w = system.omega[j], load = tangent.load() ? (*tangent.load())[j] : 0.0;
    if (system.load() || tangent.load())
      rate.offset[j] = (load - 2.0 * w * tangent.omega[j] * response.offset[j]) / (w * w);
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
