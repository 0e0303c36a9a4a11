// Chains of bodies with compliant contacts between them, and an independent integration of them:
// the contact force as a function of the state, x^n and its damping where x > 0 and nothing
// elsewhere (nor a pull, where the contact ends with the force), by the pair of Dormand and Prince.
//   J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6 (1980) 19-26, RK5(4)7M.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/systems.hpp"

namespace graze::support {

struct Chain {
  System system;
  State start;
  double duration = 0.0;  // s
};

// What acts on the structure at a state, less what its modes do by themselves.
inline Vector chain_acceleration(const System& system, double t, const Vector& q,
                                 const Vector& qdot) {
  Vector sum = -system.omega.cwiseAbs2().cwiseProduct(q) - 2.0 * system.delta().cwiseProduct(qdot);
  if (system.load()) sum += *system.load();
  if (system.forcing())
    sum += system.forcing()->amplitude *
           std::cos(system.forcing()->frequency * t + system.forcing()->phase);
  for (const Stop& stop : system.stops) {
    if (!stop.is_compliant()) continue;
    const double x = stop.row.dot(q) - stop.gap;
    if (!(x > 0.0)) continue;
    const ContactForce& law = stop.force();
    const double v = stop.row.dot(qdot);
    double force = law.stiffness * std::pow(x, law.exponent);
    if (law.damping == ContactDamping::kConstant) force += law.coefficient * v;
    if (law.damping == ContactDamping::kDepth) force += law.coefficient * x * v;
    if (law.damping == ContactDamping::kPower)
      force += law.coefficient * std::pow(x, law.exponent) * v;
    if (law.separation == Separation::kAtZeroForce) force = std::max(force, 0.0);
    sum -= force * stop.row;
  }
  return sum;
}

// The coefficients of their pair.
struct DormandPrince {
  static constexpr double kA[7][6] = {
      {},
      {1.0 / 5},
      {3.0 / 40, 9.0 / 40},
      {44.0 / 45, -56.0 / 15, 32.0 / 9},
      {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
      {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
      {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
  static constexpr double kC[7] = {0.0, 0.2, 0.3, 0.8, 8.0 / 9, 1.0, 1.0};
  static constexpr double kError[7] = {71.0 / 57600,      0.0,        -71.0 / 16695, 71.0 / 1920,
                                       -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
};

// The state after the duration; `tolerance` of a step.
inline State integrated_chain(const Chain& chain, double tolerance = 1e-13) {
  const Eigen::Index n = chain.start.q.size();
  Vector z(2 * n);
  z << chain.start.q, chain.start.qdot;
  const auto slope = [&](double t, const Vector& at) {
    Vector rate(2 * n);
    rate << at.tail(n), chain_acceleration(chain.system, t, at.head(n), at.tail(n));
    return rate;
  };
  double t = 0.0, step = 1e-3 * chain.duration;
  std::array<Vector, 7> k;
  k[0] = slope(t, z);
  while (t < chain.duration) {
    const bool last = t + step >= chain.duration;
    if (last) step = chain.duration - t;
    Vector next;
    for (std::size_t i = 1; i < 7; ++i) {
      next = z;
      for (std::size_t j = 0; j < i; ++j) next += step * DormandPrince::kA[i][j] * k[j];
      k[i] = slope(t + DormandPrince::kC[i] * step, next);
    }
    Vector error = Vector::Zero(2 * n);
    for (std::size_t i = 0; i < 7; ++i) error += step * DormandPrince::kError[i] * k[i];
    const double part = error.cwiseAbs().maxCoeff() / tolerance;
    if (part <= 1.0 || step < 1e-14 * chain.duration) {
      t = last ? chain.duration : t + step;
      z = next;
      k[0] = k[6];
    }
    step *= std::clamp(0.9 * std::pow(std::max(part, 1e-10), -0.2), 0.2, 5.0);
  }
  return {z.head(n), z.tail(n)};
}

// From 2 to so many bodies in a row that touch, at a wall or not, on springs of their own or free,
// one of them struck.
inline Chain touching_chain(Dice& dice, int most) {
  const auto bodies = static_cast<Eigen::Index>(2 + dice.pick(most - 1));
  const bool bound = dice.uniform(0.0, 1.0) < 0.3, wall = dice.uniform(0.0, 1.0) < 0.5;
  Chain chain{{Vector::Zero(bodies), NaturalModes{Vector::Zero(bodies)}, {}},
              {Vector::Zero(bodies), Vector::Zero(bodies)},
              0.0};
  Vector root(bodies);  // of the masses
  for (double& m : root) m = std::sqrt(std::exp(dice.uniform(-1.0, 1.0)));
  if (bound)
    for (double& w : chain.system.omega) w = dice.uniform(0.1, 1.0);
  const double exponents[] = {1.0, 1.5, 2.0, 1.0 + dice.uniform(0.05, 1.5)};
  const ContactDamping dampings[] = {ContactDamping::kNone, ContactDamping::kConstant,
                                     ContactDamping::kDepth, ContactDamping::kPower};
  ContactForce law;
  law.exponent = exponents[static_cast<int>(dice.uniform(0.0, 4.0))];
  law.damping = dampings[static_cast<int>(dice.uniform(0.0, 4.0))];
  law.separation =
      dice.uniform(0.0, 1.0) < 0.5 ? Separation::kAtZeroForce : Separation::kAtZeroDepth;
  for (Eigen::Index i = 0; i + 1 < bodies || (wall && i < bodies); ++i) {
    law.stiffness = std::exp(dice.uniform(-1.0, 1.0));
    if (law.damping != ContactDamping::kNone) law.coefficient = dice.uniform(0.02, 0.5);
    Vector row = Vector::Zero(bodies);
    row[i] = 1.0 / root[i];
    if (i + 1 < bodies) row[i + 1] = -1.0 / root[i + 1];
    chain.system.stops.push_back({row, 0.0, law});
  }
  const auto struck = static_cast<Eigen::Index>(
      dice.uniform(0.0, 1.0) < 0.7 ? 0.0 : dice.uniform(0.0, static_cast<double>(bodies)));
  chain.start.qdot[struck] = root[struck];
  chain.duration = dice.uniform(2.0, 4.0) + 2.0 * static_cast<double>(bodies);
  return chain;
}

}  // namespace graze::support
