#include "graze/scene/detail/table_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/schema.hpp"
#include "graze/scene/detail/torque_table.hpp"
#include "graze/scene/suggestion.hpp"
#include "graze/scene/value_checker.hpp"

namespace graze {
namespace {

// What turns with the hub has no closed form, is projected by its own mass matrix, and is driven at
// the hub alone.
void check_surroundings(const Scene& scene) {
  if (scene.beam() == nullptr)
    throw scene_error(scene, "hub",
                      fmt::format("a hub carries a [beam], with [{}] it must be left out",
                                  scene.structure_name()));
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
  if (const Span* span = scene.span()) {
    if (!(probe.position >= 0.0 && probe.position <= span->length))
      checker.fail("position",
                   fmt::format("{} is not allowed, it must be at least 0 and at most the {}'s "
                               "length {}",
                               probe.position, scene.structure_name(), span->length));
    return;
  }
  if (probe.quantity == ProbeQuantity::kStrain)
    checker.fail(
        "quantity",
        "only a [beam] or a [bar] has a strain, it must be \"displacement\", \"velocity\" or "
        "\"deflection\"");
}

}  // namespace

void check_probes(const Scene& scene) {
  for (std::size_t k = 0; k < scene.probes.size(); ++k) check_probe(scene, scene.probes[k], k + 1);
}

namespace {

using Keys = std::vector<std::string>;

// The numbers that a damping model may be built from, and those that it holds.
struct Ingredients {
  std::vector<Keys> ways;
  bool linear_only = false;  // the ways other than the coefficient
};

Ingredients ingredients(ContactModel model) {
  switch (model) {
    case ContactModel::kKelvinVoigt:
      return {{{"coefficient"}, {"ratio", "mass"}, {"restitution", "mass"}}, true};
    case ContactModel::kLeeWang1:
      return {{{"coefficient"}, {"alpha"}}};
    case ContactModel::kLeeWang2:
      return {{{"coefficient"}, {"restitution", "mass"}}, true};
    case ContactModel::kHuntCrossley:
      return {{{"coefficient"}, {"alpha"}, {"restitution", "speed"}}};
    case ContactModel::kLankaraniNikravesh:
    case ContactModel::kFlores:
      return {{{"coefficient"}, {"restitution", "speed"}}};
    case ContactModel::kAdams:
      return {{{"coefficient"}}};
    case ContactModel::kJankowski:
      return {{{"coefficient"}, {"ratio", "mass"}, {"restitution", "mass"}}};
    case ContactModel::kElastoGap:
      return {{{"coefficient"}, {"ratio", "mass"}}, true};
  }
  return {};
}

// The numbers that a damping is given; how it sets in is asked for separately.
struct GivenNumbers : SchemaVisitor {
  Keys keys;
  void number(const Key& key, const std::optional<double>& value) {
    const std::string name = key.name;
    if (value && name != "onset" && name != "sharpness") keys.push_back(name);
  }
};

void check_geometry(const ValueChecker& checker, const SpringGeometry& geometry) {
  for (const double radius : body_numbers(geometry, BodyNumbers::kRadii))
    if (radius == 0.0 || std::isnan(radius))
      checker.refuse("radii", radius, "a number other than 0 (inf: flat, negative: hollow)");
  if (!hertz_stiffness(geometry.bodies[0], geometry.bodies[1], geometry.angle))
    checker.fail("radii", "such bodies do not touch at a point, Hertz's law needs that");
}

void check_damping(const ValueChecker& checker, const Scene& scene, const Spring& spring) {
  const SpringDamping& damping = *spring.damping;
  const std::string name = contact_model_name(damping.model);
  const Ingredients allowed = ingredients(damping.model);
  GivenNumbers given;
  describe(given, damping, scene);
  if (std::find(allowed.ways.begin(), allowed.ways.end(), given.keys) == allowed.ways.end()) {
    Keys ways;
    for (const Keys& way : allowed.ways) ways.push_back(joined(way, "with"));
    checker.fail("damping", fmt::format("the model \"{}\" must be given exactly one of: {}", name,
                                        joined(ways, "or")));
  }
  if (allowed.linear_only && !damping.coefficient && !spring.is_residual &&
      (spring.geometry || spring.exponent != 1.0))
    checker.fail("damping",
                 fmt::format("the model \"{}\" knows its coefficient from {} only where the "
                             "exponent is 1, it must be given the coefficient",
                             name, joined(given.keys, "and")));
  const bool sharp = damping.model == ContactModel::kLeeWang2;
  const bool sets_in = sharp || damping.model == ContactModel::kAdams;
  if (sets_in && !damping.onset)
    checker.fail("damping.onset",
                 fmt::format("the key is missing, it must be the depth in m over which the damping "
                             "of the model \"{}\" sets in",
                             name));
  if ((!sets_in && damping.onset) || (!sharp && damping.sharpness))
    checker.fail(!sets_in && damping.onset ? "damping.onset" : "damping.sharpness",
                 fmt::format("the model \"{}\" has none, it must be left out", name));
  if (damping.exact &&
      (!damping.restitution || sets_in || damping.model == ContactModel::kJankowski))
    checker.fail("damping.inversion",
                 "\"exact\" needs a restitution to be met, of any model but \"lee-wang-2\" and "
                 "\"jankowski\"");
}

// The flexibility of the modes left out follows from the whole structure.
void check_residual(const ValueChecker& checker, const Scene& scene) {
  if (scene.hub)
    checker.fail("stiffness",
                 "\"residual\" is not known of a beam that turns with a hub, it must be a number");
  if (scene.modal() && !scene.discrete())
    checker.fail("stiffness",
                 "of a [modal] structure nothing but its modes is known, it must be a number and "
                 "not \"residual\"");
  if (!scene.loads.empty())
    checker.fail("stiffness",
                 "how the modes left out give way to a [[load]] is not known, it must be a number "
                 "and not \"residual\"");
  if (scene.string() && !scene.string()->frequencies.empty())
    checker.fail("stiffness",
                 "of a string with given frequencies nothing but its modes is known, it must be a "
                 "number and not \"residual\"");
}

}  // namespace

void check_spring(const Scene& scene, const Spring& spring, const std::string& path) {
  const ValueChecker checker(scene, path);
  if (spring.is_residual) check_residual(checker, scene);
  if (spring.geometry) check_geometry(checker, *spring.geometry);
  if (spring.damping) check_damping(checker, scene, spring);
}

}  // namespace graze
