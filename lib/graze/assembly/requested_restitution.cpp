#include "graze/assembly/detail/requested_restitution.hpp"

#include <cmath>

#include "graze/assembly/detail/spring_law.hpp"
#include "graze/contact/detail/restitution_damping.hpp"

namespace graze {
namespace {

double effective_restitution(const ContactForce& law, const SpringDamping& damping) {
  if (law.damping == ContactDamping::kPower)
    return restitution_of_power_damping(law.coefficient / law.stiffness * *damping.speed);
  const double zeta = 0.5 * law.coefficient / std::sqrt(law.stiffness * *damping.mass);
  return law.separation == Separation::kAtZeroForce ? restitution_at_zero_force(zeta)
                                                    : restitution_at_zero_depth(zeta);
}

}  // namespace

std::optional<RequestedRestitution> requested_restitution(const Spring& spring) {
  // What Jankowski's comes to depends on the motion.
  if (!spring.damping || !spring.damping->restitution ||
      spring.damping->model == ContactModel::kJankowski)
    return {};
  const SpringDamping& damping = *spring.damping;
  RequestedRestitution asked{*damping.restitution,
                             damping.speed,
                             damping.mass,
                             effective_restitution(spring_law(spring), damping),
                             {}};
  if (damping.model == ContactModel::kLeeWang2) return asked;
  Spring exact = spring;
  exact.damping->exact = true;
  asked.exact_coefficient = spring_law(exact).coefficient;
  return asked;
}

}  // namespace graze
