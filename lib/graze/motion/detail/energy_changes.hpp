// What changes the mechanical energy of a structure at an instant, J: impacts, and chatters that
// are closed. What changes it along an arc is arc_work.hpp's.
#pragma once

#include <vector>

#include "graze/flow/variation/arc_work.hpp"
#include "graze/motion/detail/motion.hpp"

namespace graze {

double mechanical_energy(const System& system, const Vector& q, const Vector& qdot);
// Change of its kinetic part by a jump of the velocities at q, J.
double kinetic_change(const System& system, const Vector& q, const Vector& before,
                      const Vector& after);

// Change of the kinetic energy by an impact, whole and by the stops that were hit (ascending), J.
// What goes through stops that are not hit themselves counts to the first one that is. Written to
// where the last one was: a run asks at every impact.
struct ImpactEnergy {
  struct Hit {
    ImpactShare<double> share;
    double change = 0.0;
  };
  double total = 0.0;
  std::vector<Hit> hits;
};
void impact_energy(const System& system, const std::vector<ImpactShare<double>>& shares,
                   const Vector& q, const Vector& before, const Vector& after,
                   ImpactEnergy& energy);

// Change of the mechanical energy by a sudden one of the state, and what the forces at forcing
// phase theta (rad) do along its displacement; J.
double energy_change(const System& system, const State& before, const State& after);
Work work_at_once(const System& system, double theta, const Vector& shift);

// Change of the kinetic energy by closing a chatter on these stops at forcing phase theta, J. Of
// several the closure shifts the structure: what the forces do meanwhile joins `work`.
double closure_energy_change(const System& system, const std::vector<int>& closed, double theta,
                             const State& before, const State& after, Work& work);

Work operator+(const Work& a, const Work& b);

}  // namespace graze
