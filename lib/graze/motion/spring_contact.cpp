#include "graze/motion/spring_contact.hpp"

#include <algorithm>
#include <limits>

#include "graze/flow/sprung/detail/spring_arc.hpp"
#include "graze/flow/variation/detail/arc_integrals.hpp"
#include "graze/motion/detail/arc_extent.hpp"

namespace graze {
namespace {

double follow_steps(SpringContacts& contacts, const std::vector<int>& loaded, StepFlow& flow,
                    double flight) {
  double deepest = 0.0;
  const SprungWorks works = flow.works(flight);
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    SpringContact& contact = contacts[static_cast<std::size_t>(loaded[k])];
    contact.peak_force = std::max(contact.peak_force, flow.peak_force(k));
    contact.lost += works.springs[k].lost;
    deepest = std::max(deepest, flow.deepest(k));
  }
  return deepest;
}

}  // namespace

void end_contact(SpringContact& contact, double stored, Event& event) {
  event.duration = event.time - contact.since;
  event.peak_force = contact.peak_force;
  event.energy_change = contact.change(stored);
  contact.change_before += event.energy_change;
  if (contact.speed > 0.0) event.effective_restitution = event.speed / contact.speed;
}

double follow(SpringContacts& contacts, const ContactPhase<double>& phase, double flight) {
  const std::vector<int>& loaded = phase.springs().loaded;
  if (loaded.empty()) return 0.0;
  if (phase.stepped()) return follow_steps(contacts, loaded, *phase.stepped(), flight);
  const ExactPhase<double>& exact = *phase.exact();
  const SpringArc& arc = *phase.sprung();
  double deepest = 0.0;
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    SpringContact& contact = contacts[static_cast<std::size_t>(loaded[k])];
    const ContactForce& law = arc.equations.springs[k].law;
    const Observable<double>& depth = arc.depth_observables[k];
    const double force = highest_along(exact, linear_force(law, depth), 0.0, flight, 0.0);
    contact.peak_force = std::max(contact.peak_force, force);
    if (law.damping == ContactDamping::kNone) {
      deepest = std::max(deepest, force / law.stiffness);
      continue;
    }
    deepest = std::max(deepest, highest_along(exact, depth, 0.0, flight, 0.0));
    const Observable<double> rate{
        0.0, Vector::Zero(depth.displacement.size()), depth.displacement, {}};
    contact.lost += law.coefficient * square_along(exact, rate, flight);
  }
  return deepest;
}

}  // namespace graze
