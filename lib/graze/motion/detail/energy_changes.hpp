// Changes of the mechanical energy of a structure at an instant, J: by impacts, and by closing
// chatters. Changes along an arc are in arc_work.hpp.
#pragma once

#include <vector>

#include "graze/flow/variation/arc_work.hpp"
#include "graze/flow/variation/detail/carried_work.hpp"
#include "graze/motion/detail/motion.hpp"

namespace graze {

double mechanical_energy(const System& system, const Vector& q, const Vector& qdot);
// That of the structure itself, where the system is in this state at forcing phase theta, rad.
double structure_energy(const System& system, const State& state, double theta);
// Change of the kinetic energy by a jump of the velocities at q, J.
double kinetic_change(const System& system, const Vector& q, const Vector& before,
                      const Vector& after);

// Change of the kinetic energy by an impact, in total and by the stops that were hit (ascending),
// J. The work of impulses at stops that are not hit themselves counts for the first one that is.
// The vectors are reused: a run calls this at every impact.
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

// Adds the work of stops that move, as an impact at forcing phase theta (rad) changes velocities.
void add_impact_work(const System& system, double theta, const Vector& before, const Vector& after,
                     Work& work);

// Change of the mechanical energy by a sudden change of the state, and the work of the forces at
// forcing phase theta (rad) along its displacement; J.
double energy_change(const System& system, const State& before, const State& after);
Work work_at_once(const System& system, double theta, const Vector& shift);

// Change of the kinetic energy by closing a chatter on these stops at forcing phase theta, J. With
// several stops the closure shifts the structure: the work of the forces meanwhile is added to
// `work`.
double closure_energy_change(const System& system, const std::vector<int>& closed, double theta,
                             const State& before, const State& after, Work& work);

Work operator+(const Work& a, const Work& b);

}  // namespace graze
