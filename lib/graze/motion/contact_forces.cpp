#include "graze/motion/detail/contact_forces.hpp"

namespace graze {

void contact_forces(const System& system, const ContactPhase<double>& phase, double s,
                    const State& state, std::vector<double>& forces) {
  forces.assign(system.stops.size(), 0.0);
  for (const int i : phase.closed())
    if (!system.is_friction(i))
      forces[static_cast<std::size_t>(i)] = phase.force_at(i, s, state.q, state.qdot);
  for (const int i : phase.springs().loaded) {
    const Stop& stop = system.stops[static_cast<std::size_t>(i)];
    forces[static_cast<std::size_t>(i)] =
        stop.force().at(stop.row.dot(state.q) - stop.gap, stop.row.dot(state.qdot));
  }
}

void friction_forces(const System& system, const ContactPhase<double>& phase, double s,
                     const State& state, std::vector<double>& forces) {
  forces.assign(system.frictions.size(), 0.0);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const Contact contact = phase.key().frictions[k];
    const Friction& friction = system.frictions[k];
    double force = friction.sliding;
    if (friction.stop >= 0) {
      const Stop& stop = system.stops[static_cast<std::size_t>(friction.stop)];
      force *= stop.is_compliant()
                   ? stop.force().at(stop.row.dot(state.q) - stop.gap, stop.row.dot(state.qdot))
                   : 0.0;
    }
    if (contact == Contact::kForward) forces[k] = force;
    if (contact == Contact::kBackward) forces[k] = -force;
  }
  for (const int i : phase.closed())
    if (system.is_friction(i) && !system.follows(i))
      forces[static_cast<std::size_t>(i) - system.stops.size()] =
          phase.force_at(i, s, state.q, state.qdot);
}

}  // namespace graze
