// Work done on a structure, for the energy balance (arc_work.hpp).
#pragma once

namespace graze {

struct Work {
  double forcing = 0.0;      // of the harmonic forcing, J
  double load = 0.0;         // of the constant load, J
  double constraint = 0.0;   // of the closed stops; zero except with an oblique law, J
  double dissipation = 0.0;  // taken by damping, J, >= 0
  double contact = 0.0;      // of compliant stops, J: minus the energy that they took, kept or lost
  // The part of that energy which their damping took, J, >= 0: it may exceed all energy of the
  // structure, if springs were compressed at the start.
  double contact_lost = 0.0;
  double friction = 0.0;  // of dry friction, J
  double stops = 0.0;  // of stops that move, J; works are then those on the structure itself
};

}  // namespace graze
