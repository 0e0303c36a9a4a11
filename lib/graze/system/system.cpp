#include "graze/system/system.hpp"

#include <cmath>

namespace graze {

ComplexVector Harmonic::force() const {
  return cosine.cast<Complex>() - Complex(0.0, 1.0) * sine.cast<Complex>();
}

Vector Harmonic::at(double theta) const {
  if (timed) return cosine * timed->course->at(timed->time(theta));
  return cosine * std::cos(order * theta) + sine * std::sin(order * theta);
}

double Harmonic::wave(double theta) const {
  return timed ? timed->course->at(timed->time(theta)) : std::cos(order * theta);
}

double Harmonic::swing(double theta) const {
  return timed ? timed->course->slope(timed->time(theta)) : -std::sin(order * theta);
}

double Harmonic::largest_wave() const { return timed ? timed->course->largest : 1.0; }

Vector Harmonic::rate_at(double theta) const {
  if (timed) return cosine * timed->course->slope(timed->time(theta)) / timed->frequency;
  return order * (sine * std::cos(order * theta) - cosine * std::sin(order * theta));
}

Vector HarmonicForcing::at(double theta) const {
  Vector sum = amplitude * std::cos(theta);
  for (const Harmonic& one : harmonics) sum += one.at(theta);
  return sum;
}

Vector HarmonicForcing::rate_at(double theta) const {
  Vector sum = -amplitude * std::sin(theta);
  for (const Harmonic& one : harmonics) sum += one.rate_at(theta);
  return sum;
}

Vector HarmonicForcing::size() const {
  Vector sum = amplitude.cwiseAbs();
  for (const Harmonic& one : harmonics) sum += one.largest_wave() * one.force().cwiseAbs();
  return sum;
}

namespace {

State moved(const System& system, const State& state, double theta, double sign) {
  State there = state;
  if (!system.carried()) return there;
  for (const Harmonic& one : *system.carried()) {
    there.q += sign * one.at(theta);
    there.qdot += sign * system.forcing()->frequency * one.rate_at(theta);
  }
  return there;
}

}  // namespace

State structure_state(const System& system, const State& state, double theta) {
  return moved(system, state, theta, 1.0);
}

State system_state(const System& system, const State& structure, double theta) {
  return moved(system, structure, theta, -1.0);
}

std::optional<Vector> modal_forces(const System& system) {
  const HarmonicForcing* forcing = system.forcing();
  if (!forcing) return {};
  return forcing->harmonics.empty() ? forcing->amplitude : forcing->size();
}

}  // namespace graze
