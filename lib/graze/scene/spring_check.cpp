#include "graze/scene/detail/spring_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "graze/scene/detail/suggestion.hpp"

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

Keys given(const SpringDamping& damping) {
  Keys keys;
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) keys.emplace_back(key);
  };
  add("coefficient", damping.coefficient);
  add("ratio", damping.ratio);
  add("alpha", damping.alpha);
  add("restitution", damping.restitution);
  add("speed", damping.speed);
  add("mass", damping.mass);
  return keys;
}

class SpringChecker {
 public:
  SpringChecker(const Scene& scene, std::string path) : scene_(scene), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& key, const std::string& sentence) const {
    throw scene_error(scene_, key.empty() ? path_ : path_ + "." + key, sentence);
  }
  void require(bool kept, const std::string& key, double value, const char* what) const {
    if (!kept) fail(key, fmt::format("{} is not allowed, it must be {}", value, what));
  }
  void positive(const std::string& key, const std::optional<double>& value) const {
    if (value)
      require(std::isfinite(*value) && *value > 0.0, key, *value, "a finite number greater than 0");
  }
  void not_negative(const std::string& key, const std::optional<double>& value) const {
    if (value)
      require(std::isfinite(*value) && *value >= 0.0, key, *value, "a finite number of at least 0");
  }

  void check(const SpringGeometry& geometry) const {
    for (std::size_t body = 0; body < 2; ++body) {
      const ElasticBody& own = geometry.bodies[body];
      const std::string number = std::to_string(body + 1);
      for (const double radius : own.radii)
        require(radius != 0.0 && !std::isnan(radius), "radii", radius,
                "a number other than 0 (inf: flat, negative: hollow)");
      positive("moduli." + number, own.modulus);
      require(own.poisson_ratio > -1.0 && own.poisson_ratio <= 0.5, "poisson." + number,
              own.poisson_ratio, "a number greater than -1 and at most 0.5");
    }
    require(std::isfinite(geometry.angle), "angle", geometry.angle, "a finite number");
    if (!hertz_stiffness(geometry.bodies[0], geometry.bodies[1], geometry.angle))
      fail("radii", "such bodies do not touch at a point, Hertz's law needs that");
  }

  void check(const SpringDamping& damping, double exponent) const {
    not_negative("damping.coefficient", damping.coefficient);
    not_negative("damping.ratio", damping.ratio);
    not_negative("damping.alpha", damping.alpha);
    if (damping.restitution)
      require(*damping.restitution > 0.0 && *damping.restitution <= 1.0, "damping.restitution",
              *damping.restitution, "a number greater than 0 and at most 1");
    positive("damping.speed", damping.speed);
    positive("damping.mass", damping.mass);
    positive("damping.onset", damping.onset);
    not_negative("damping.sharpness", damping.sharpness);
    check_ways(damping, exponent);
  }

 private:
  void check_ways(const SpringDamping& damping, double exponent) const {
    const std::string name = contact_model_name(damping.model);
    const Ingredients allowed = ingredients(damping.model);
    const Keys keys = given(damping);
    if (std::find(allowed.ways.begin(), allowed.ways.end(), keys) == allowed.ways.end()) {
      Keys ways;
      for (const Keys& way : allowed.ways) ways.push_back(joined(way, "with"));
      fail("damping", fmt::format("the model \"{}\" must be given exactly one of: {}", name,
                                  joined(ways, "or")));
    }
    if (allowed.linear_only && !damping.coefficient && exponent != 1.0)
      fail("damping", fmt::format("the model \"{}\" knows its coefficient from {} only where the "
                                  "exponent is 1, it must be given the coefficient",
                                  name, joined(keys, "and")));
    const bool sets_in = damping.model == ContactModel::kLeeWang2;
    if (sets_in && !damping.onset)
      fail("damping.onset",
           "the key is missing, it must be the depth in m over which the damping "
           "of the model \"lee-wang-2\" sets in");
    if (!sets_in && (damping.onset || damping.sharpness))
      fail(damping.onset ? "damping.onset" : "damping.sharpness",
           fmt::format("the model \"{}\" has none, it must be left out", name));
    if (damping.exact && (!damping.restitution || sets_in))
      fail("damping.inversion",
           "\"exact\" needs a restitution to be met, of any model but \"lee-wang-2\"");
  }

  const Scene& scene_;
  std::string path_;
};

}  // namespace

void check_spring(const Scene& scene, const Spring& spring, const std::string& path) {
  const SpringChecker checker(scene, path);
  if (spring.geometry) {
    checker.check(*spring.geometry);
  } else {
    checker.positive("stiffness", spring.stiffness);
    checker.require(std::isfinite(spring.exponent) && spring.exponent >= 1.0, "exponent",
                    spring.exponent, "a finite number of at least 1");
  }
  if (spring.damping) checker.check(*spring.damping, spring.geometry ? 1.5 : spring.exponent);
}

}  // namespace graze
