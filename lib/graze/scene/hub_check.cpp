#include "graze/scene/detail/hub_check.hpp"

#include <fmt/format.h>

#include <optional>

#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/torque_table.hpp"
#include "graze/scene/detail/value_checker.hpp"

namespace graze {
namespace {

// What turns with the hub has no closed form, is projected by its own mass matrix, and is driven at
// the hub alone.
void check_surroundings(const Scene& scene) {
  if (scene.beam() == nullptr)
    throw scene_error(scene, "hub", "a hub carries a [beam], with [modal] it must be left out");
  if (scene.forcing)
    throw scene_error(scene, "forcing",
                      "a structure on a hub is driven by hub.torque, [forcing] must be left out");
  if (scene.beam()->discretisation == Projection::kCollocation)
    throw scene_error(scene, "beam.discretisation",
                      "\"collocation\" is not allowed with a [hub], it must be \"galerkin\"");
  for (std::size_t k = 0; k < scene.stops.size(); ++k)
    if (!scene.stops[k].spring && scene.stops[k].impulse == Impulse::kCollocation)
      throw scene_error(scene, numbered_path("stop", k + 1) + ".impulse",
                        "\"collocation\" is not allowed with a [hub], it must be \"momentum\"");
  if (scene.solver.flow == FlowChoice::kExact)
    throw scene_error(scene, "solver.flow",
                      "the motion of a structure on a hub has no exact flow, it must be \"auto\", "
                      "\"bulirsch-stoer\", \"rk4\", \"dopri5\" or \"fehlberg78\"");
}

void check_table(const ValueChecker& checker, const TorqueTable& table) {
  if (table.times.size() < 2)
    checker.fail("times", fmt::format("the list has {}, it must have at least two",
                                      table.times.empty() ? "no entry" : "1 entry"));
  if (table.values.size() != table.times.size())
    checker.fail("values",
                 fmt::format("the list has {} entr{}, it must have one per time, which is {}",
                             table.values.size(), table.values.size() == 1 ? "y" : "ies",
                             table.times.size()));
  if (const std::optional<TorqueFault> fault = torque_fault(table))
    checker.fail(fmt::format("{}.{}", fault->of_times ? "times" : "values", fault->entry + 1),
                 fault->sentence);
}

}  // namespace

void check_hub(const Scene& scene) {
  if (!scene.hub) {
    if (scene.solver.flow == FlowChoice::kBulirschStoer)
      throw scene_error(scene, "solver.flow",
                        "\"bulirsch-stoer\" is the flow of a structure on a [hub], it must be "
                        "\"auto\", \"exact\", \"rk4\", \"dopri5\" or \"fehlberg78\"");
    return;
  }
  check_surroundings(scene);
  if (scene.hub->torque)
    if (const auto* table = std::get_if<TorqueTable>(&*scene.hub->torque))
      check_table(ValueChecker(scene, "hub.torque"), *table);
}

}  // namespace graze
