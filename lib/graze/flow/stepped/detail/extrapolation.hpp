// Extrapolation (Bulirsch and Stoer) with Boost.Odeint.
#pragma once

#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <limits>
#include <vector>

namespace graze::step_walk {

using Extrapolation = boost::numeric::odeint::bulirsch_stoer<std::vector<double>>;

// A step that fails its error more often than this in a row will not succeed.
inline constexpr int kMostFailures = 500;

// Odeint begins a step by reading the size of the last one, which is uninitialised before the first
// step. It gets a value here, NaN, which no step has. That member is private: an explicit
// instantiation may name it, and has a friend that sets it.
void begin_steps(Extrapolation& method);
template <double Extrapolation::*kLastStep>
struct LastStep {
  friend void begin_steps(Extrapolation& method) {
    method.*kLastStep = std::numeric_limits<double>::quiet_NaN();
  }
};
template struct LastStep<&Extrapolation::m_dt_last>;

// `absolute`, `relative`: allowed errors of a step; `longest`: longest step, 0: no limit.
inline Extrapolation extrapolation(double absolute, double relative, double longest = 0.0) {
  Extrapolation method(absolute, relative, 1.0, 0.0, longest);
  begin_steps(method);
  return method;
}

}  // namespace graze::step_walk
