#include "graze/flow/stepped/detail/extrapolated_walk.hpp"

namespace graze {

std::unique_ptr<StepFlow> bulirsch_stoer_flow(const SprungSystem& system,
                                              const StepSetting& setting) {
  using Walk = step_walk::ExtrapolatedWalk;
  return std::make_unique<step_walk::WalkingFlow<Walk>>(
      Walk(step_walk::Sprung(system, setting.tolerance), setting));
}

}  // namespace graze
