// The energy book of a run, J:
//
//   start + forcing + load + constraint + impacts + contact - dissipation = now,
//
// where energy is (|q'|^2 + |w q|^2)/2, relative to the clamp, without that of compressed stops; of
// a structure on a hub (q'.M q' + |w q|^2)/2, forcing being its torque and load its weight. Every
// entry is computed on its own, so the book closes only if all of them are right.
#pragma once

#include <cmath>
#include <vector>

#include "graze/flow/arc_work.hpp"
#include "graze/hybrid/motion.hpp"

namespace graze {

double mechanical_energy(const System& system, const Vector& q, const Vector& qdot);
// Change of its kinetic part by a jump of the velocities at q, J.
double kinetic_change(const System& system, const Vector& q, const Vector& before,
                      const Vector& after);

struct EnergyBook {
  double start = 0.0, now = 0.0;
  Work work;
  double impacts = 0.0;  // change at impacts and closed chatters

  // What is missing, and the size of the largest entry to compare it with.
  double defect() const {
    return start + work.forcing + work.load + work.constraint + impacts + work.contact -
           work.dissipation - now;
  }
  double size() const {
    return std::fmax(
        std::fmax(std::fmax(start, now), std::fmax(std::abs(work.forcing), std::abs(work.load))),
        std::fmax(std::fmax(std::abs(work.constraint), std::abs(impacts)),
                  std::fmax(std::abs(work.contact), work.dissipation)));
  }
};

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
