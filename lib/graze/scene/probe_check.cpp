#include "graze/scene/detail/probe_check.hpp"

#include <fmt/format.h>

#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/value_checker.hpp"

namespace graze {
namespace {

// Unlike a stop a probe may sit at the clamp, where strains are largest, and on a node of every
// mode.
void check_probe(const Scene& scene, const Probe& probe, std::size_t number) {
  const ValueChecker checker(scene, numbered_path("probe", number));
  if (is_of_hub(probe.quantity)) {
    if (!scene.hub)
      checker.fail("quantity",
                   fmt::format("the {} is that of a [hub], which the scene does not have",
                               probe_quantity_name(probe.quantity)));
    return;
  }
  if (const Beam* beam = scene.beam()) {
    if (!(probe.position >= 0.0 && probe.position <= beam->length))
      checker.fail("position",
                   fmt::format("{} is not allowed, it must be at least 0 and at most the beam's "
                               "length {}",
                               probe.position, beam->length));
    if (probe.quantity == ProbeQuantity::kStrain && !beam->thickness)
      throw scene_error(scene, "beam.thickness",
                        "the key is missing, a probe of the strain needs a number greater than 0, "
                        "in m");
    return;
  }
  if (probe.quantity == ProbeQuantity::kStrain)
    checker.fail("quantity",
                 "only a [beam] has a strain, it must be \"displacement\", \"velocity\" or "
                 "\"deflection\"");
}

}  // namespace

void check_probes(const Scene& scene) {
  for (std::size_t k = 0; k < scene.probes.size(); ++k) check_probe(scene, scene.probes[k], k + 1);
}

}  // namespace graze
