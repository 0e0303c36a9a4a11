#include "graze/hybrid/chatter_closure.hpp"

namespace graze {

const ImpactShare<double>* closing_impact(const System& system,
                                          const std::vector<ImpactShare<double>>& shares,
                                          double closure_speed) {
  const ImpactShare<double>* last = nullptr;
  int acting = 0;
  for (const ImpactShare<double>& share : shares) {
    acting += share.impulse > 0.0 ? 1 : 0;
    // Of several stops hit at once the one listed last.
    if (share.hit && (!last || share.stop > last->stop)) last = &share;
  }
  if (acting != 1 || !last || !(last->speed <= closure_speed)) return nullptr;
  const Restitution& restitution = system.stops[static_cast<std::size_t>(last->stop)].restitution;
  return restitution.at_rest() < 1.0 ? last : nullptr;
}

}  // namespace graze
