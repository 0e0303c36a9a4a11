// The order of the classical Runge-Kutta method across one contact. A body of mass m meets an
// elastic spring F = k x^n at speed v; its motion is known in closed form,
//
//   x_max^(n+1) = (n+1) m v^2/(2 k),   duration = c x_max/v,
//   c = 2 sqrt(pi)/(n+1) G(1/(n+1))/G(1/(n+1) + 1/2)     (G: the gamma function; pi for n = 1),
//
// and it leaves at the speed at which it came. Two ways to integrate it:
//   - located: steps begin where the contact begins, and the last one ends where it ends (simulate
//     with StepMethod::kRk4);
//   - not located: steps are not adapted, and the force sets in and ceases within one.
// A step across a place where a derivative of the force jumps has an error of the power of its
// length that this jump has, however high the order of the method: h^2 for the linear spring, whose
// slope jumps at x = 0. Locating the ends removes this error, but not for Hertz's spring: x^(3/2)
// has no second derivative at x = 0, and steps that begin or end there have errors of h^(5/2).
//   E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, section II.6;
//   K. L. Johnson, Contact Mechanics, section 11.4 (the duration).
#pragma once

#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/system/system.hpp"

namespace graze {

struct ElasticContact {
  double mass = 0.0;       // kg
  double speed = 0.0;      // of approach, m/s
  double stiffness = 0.0;  // k, N/m^n
  double exponent = 1.0;   // n

  double depth() const;     // x_max, m
  double duration() const;  // s
};

// The result of integrating one contact.
struct ContactCrossing {
  bool ended = false;         // the body got away
  double duration = 0.0;      // s
  double speed = 0.0;         // away, m/s
  long long evaluations = 0;  // of the right-hand side; with the exact flow of gaps too
};

// For comparison: Runge-Kutta steps of one length, s, straight across the contact, which begins
// `lead` s after the first step. The ends are found afterwards, from the straight flight before and
// after.
ContactCrossing cross_without_location(const ElasticContact& contact, double step, double lead);
// By a simulation; `step` 0: with the exact flow.
ContactCrossing cross_with_location(const ElasticContact& contact, double step);

// The larger of the relative errors of speed and duration.
double crossing_error(const ElasticContact& contact, const ContactCrossing& crossing);

struct ContactOrderRow {
  int steps = 0;         // in the contact; 0: the exact flow
  double step = 0.0;     // s
  double error = 0.0;    // the largest for kContactPlaces places of the contact within the steps
  double seconds = 0.0;  // of computing time, a contact
  double evaluations = 0.0;  // a contact
};
inline constexpr int kContactPlaces = 16;

struct ContactOrder {
  ElasticContact contact;
  std::string spring;  // "linear", "Hertz" or "n = 2"
  std::string method;  // "rk4, located", "rk4, not located" or "exact"
  double order = 0.0;  // slope of error over step where both are small; 0 for the exact flow
  std::vector<ContactOrderRow> rows;
};

// Orders for a linear spring, for Hertz's, and for the given one if it is neither; with the same
// depth.
std::vector<ContactOrder> contact_orders(const ElasticContact& contact,
                                         const StopSignal& stop = {});

// The first contact of the motion with a compliant stop, for a body with the effective mass of the
// structure there, 1/|row|^2, without the damping of the stop; or why there is none.
struct FirstContact {
  int stop = -1;  // index from 0
  ElasticContact contact;
  std::string message;
};
FirstContact first_contact(const System& system, const State& start, double longest,
                           const StopSignal& stop = {});

}  // namespace graze
