#include "graze/scene/detail/spring_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "graze/scene/detail/schema.hpp"
#include "graze/scene/detail/suggestion.hpp"
#include "graze/scene/detail/value_checker.hpp"

namespace graze {
namespace {

using Keys = std::vector<std::string>;

// What a damping may be built from, and what it holds.
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
  if (allowed.linear_only && !damping.coefficient && (spring.geometry || spring.exponent != 1.0))
    checker.fail("damping",
                 fmt::format("the model \"{}\" knows its coefficient from {} only where the "
                             "exponent is 1, it must be given the coefficient",
                             name, joined(given.keys, "and")));
  const bool sets_in = damping.model == ContactModel::kLeeWang2;
  if (sets_in && !damping.onset)
    checker.fail("damping.onset",
                 "the key is missing, it must be the depth in m over which the damping "
                 "of the model \"lee-wang-2\" sets in");
  if (!sets_in && (damping.onset || damping.sharpness))
    checker.fail(damping.onset ? "damping.onset" : "damping.sharpness",
                 fmt::format("the model \"{}\" has none, it must be left out", name));
  if (damping.exact && (!damping.restitution || sets_in))
    checker.fail("damping.inversion",
                 "\"exact\" needs a restitution to be met, of any model but \"lee-wang-2\"");
}

}  // namespace

void check_spring(const Scene& scene, const Spring& spring, const std::string& path) {
  const ValueChecker checker(scene, path);
  if (spring.geometry) check_geometry(checker, *spring.geometry);
  if (spring.damping) check_damping(checker, scene, spring);
}

}  // namespace graze
