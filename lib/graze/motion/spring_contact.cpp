#include "graze/motion/spring_contact.hpp"

#include <algorithm>

#include "graze/flow/sprung/detail/sprung_phase.hpp"

#include "graze/flow/exact/detail/contact_phase.hpp"

namespace graze {

double follow(SpringContacts& contacts, const ContactPhase<double>& phase, double flight) {
  const std::vector<int>& loaded = phase.springs().loaded;
  if (loaded.empty()) return 0.0;
  double deepest = 0.0;
  StepFlow& flow = phase.sprung()->steps();
  const SprungWorks works = flow.works(flight);
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    SpringContact& contact = contacts[static_cast<std::size_t>(loaded[k])];
    contact.peak_force = std::max(contact.peak_force, flow.peak_force(k));
    contact.lost += works.springs[k].lost;
    deepest = std::max(deepest, flow.deepest(k));
  }
  return deepest;
}

}  // namespace graze
