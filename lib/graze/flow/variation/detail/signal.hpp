// Integrals over a flight: of sums of exponentials, of products of these, and of any function.
#pragma once

#include <functional>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/flow/held/detail/coupled_flow.hpp"

namespace graze {

// Re(size e^{rate s})
struct SignalTerm {
  Complex size, rate;
};
using Signal = std::vector<SignalTerm>;

// Whether two of its terms nearly cancel: near critical damping rates are nearly equal and sizes
// nearly opposite, with a small difference d, and the integral of the square cancels by d^2; a loss
// of four bits is accepted.
bool nearly_cancels(const Signal& signal);

// integral of e^{l s} over [0, s], without cancellation for small l s.
Complex exponential_integral(Complex l, double s);

// integral of a b over [0, s].
double product_integral(const Signal& a, const Signal& b, double s);
// integral of a^2 over [0, s].
double square_integral(const Signal& a, double s);

// Visits the nodes of Gauss' rule with their weights, s, over [0, s] in panels of at most one
// radian of `quickest`, rad/s, the largest rate of oscillation or decay: there 15 nodes integrate
// to rounding (the error is of order (1/2)^30/30!).
void visit_nodes(double s, double quickest, const std::function<void(double, double)>& visit);
// The integral of f over [0, s] by these panels.
double panel_integral(const std::function<double(double)>& f, double s, double quickest);

// The states of a coupled motion and its inputs, z = (x, u cos theta, u sin theta, u) with z' = E z
// and u as large as x, so that inputs cost no digits. Everything linear in the motion is a form in
// z, so that the moments of a flight give all integrals at once.
struct Moments {
  Matrix integral;    // of z z^T over the flight
  double unit = 1.0;  // u
};
Moments moments_along(const CoupledArc& arc, double s);
// An observable as a form in z.
Vector weights_of(const Observable<double>& observable, const CoupledArc& arc,
                  const Moments& moments);

}  // namespace graze
