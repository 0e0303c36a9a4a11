// Random systems whose modes take every form that the exact flow knows.
#pragma once

#include "support/systems.hpp"

namespace graze::support {

enum class Damped { kUnder, kOver, kCritical, kNearCritical, kFreeMass, kResonant, kNearResonant };
inline constexpr int kDampedKinds = 7;

// Natural frequency and decay rate of a mode of the given kind under forcing at `frequency`.
inline void set_mode(System& system, int j, Damped kind, double frequency, Dice& dice) {
  double omega = dice.uniform(0.5, 8.0), zeta = dice.uniform(0.0, 0.4);
  switch (kind) {
    case Damped::kUnder:
      break;
    case Damped::kOver:
      zeta = dice.uniform(1.3, 3.0);
      break;
    case Damped::kCritical:
      zeta = 1.0;
      break;
    case Damped::kNearCritical:
      zeta = 1.0 + dice.uniform(-1.0, 1.0) * 1e-6;
      break;
    case Damped::kFreeMass:
      omega = 0.0;
      break;
    case Damped::kResonant:
      omega = frequency, zeta = 0.0;
      break;
    case Damped::kNearResonant:
      omega = frequency * (1.0 + 1e-4 * dice.uniform(-1.0, 1.0));
      zeta = 1e-4 * dice.uniform(0.0, 1.0);
      break;
  }
  system.omega[j] = omega;
  system.modal().delta[j] = zeta * omega;
}

// Forced, with one stop at the given gap and random rows of entries up to 1.
inline System random_system(Dice& dice, int modes, double gap) {
  System system{Vector(modes), NaturalModes{Vector(modes)}, {}};
  const double frequency = dice.uniform(0.5, 4.0);
  for (int j = 0; j < modes; ++j)
    set_mode(system, j, static_cast<Damped>(dice.pick(kDampedKinds)), frequency, dice);
  system.modal().forcing =
      HarmonicForcing{frequency, dice.uniform(0.0, 6.0), dice.vector(modes, -1.0, 1.0)};
  const Vector row = dice.vector(modes, -1.0, 1.0);
  system.stops.push_back({row, gap, ImpactLaw{momentum_direction(row), dice.uniform(0.3, 1.0)}});
  return system;
}

}  // namespace graze::support
