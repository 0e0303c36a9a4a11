#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "graze/scene/check.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

const std::string kHubBeam =
    "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\ndensity = 8500\n"
    "area = 12.4e-6\nmodes = 2\n";
const std::string kHub = "[hub]\nradius = 0.02\ninertia = 1e-3\n";
const std::string kPulse = "torque = { kind = \"pulse\", amplitude = 1, duration = 0.05 }\n";

template <typename F>
std::string refusal_of(F&& f) {
  try {
    f();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Hub, WhatItDoesNotNameIsAbsent) {
  EXPECT_FALSE(parse_scene(kHubBeam, "s").hub);
  const Scene scene = parse_scene(kHubBeam + kHub, "s");
  EXPECT_EQ(scene.hub->radius, 0.02);
  EXPECT_EQ(scene.hub->inertia, 1e-3);
  EXPECT_FALSE(scene.hub->torque || scene.hub->friction);
  EXPECT_EQ(scene.hub->equations, HubEquations::kConsistent);
  EXPECT_TRUE(scene.hub->centrifugal);
  EXPECT_EQ(scene.modes(), 2);
}

TEST(Hub, HasItsValues) {
  const Scene scene =
      parse_scene(kHubBeam + kHub + kPulse +
                      "equations = \"paper\"\ncentrifugal = false\nfriction = { coulomb = 0.01 }\n"
                      "[initial]\nangle = 0.5\nrate = -2\n",
                  "s");
  const auto& pulse = std::get<TorquePulse>(*scene.hub->torque);
  EXPECT_EQ(pulse.amplitude, 1.0);
  EXPECT_EQ(pulse.duration, 0.05);
  EXPECT_EQ(scene.hub->equations, HubEquations::kPaper);
  EXPECT_FALSE(scene.hub->centrifugal);
  EXPECT_EQ(scene.hub->friction, 0.01);
  EXPECT_EQ(scene.initial->angle, 0.5);
  EXPECT_EQ(scene.initial->rate, -2.0);
  EXPECT_EQ(scene.initial->q, std::vector<double>(2, 0.0));
}

TEST(Hub, TakesStopsAndFlowsWithSteps) {
  const Scene scene = parse_scene(
      kHubBeam + kHub + "[gravity]\nacceleration = 9.81\n" +
          "[[stop]]\nposition = 0.3\ngap = 0.01\nrestitution = 0.8\n[solver]\nflow = \"dopri5\"\n",
      "s");
  EXPECT_EQ(scene.stops.size(), 1u);
  EXPECT_EQ(scene.gravity->acceleration, 9.81);
}

TEST(Hub, RandomOnesReadBack) {
  std::mt19937 random(1990);
  const auto number = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
  const auto chance = [&] { return number() < 0.5; };
  for (int k = 0; k < 200; ++k) {
    Scene scene = parse_scene(kHubBeam, "s");
    auto& beam = std::get<Beam>(scene.structure);
    if (chance()) beam.thickness = 0.01 * number() + 1e-4;
    if (chance()) {
      Hub& hub = scene.hub.emplace();
      hub.radius = number();
      hub.inertia = number() * 1e-3;
      hub.equations = chance() ? HubEquations::kPaper : HubEquations::kConsistent;
      hub.centrifugal = chance();
      if (chance()) hub.friction = number();
      if (chance())
        hub.torque = TorquePulse{number() - 0.5, 0.1 + number()};
      else if (chance())
        hub.torque = TorqueTable{{0.0, number(), 1.0 + number()}, {number(), -number(), number()}};
      scene.initial = Initial{{number(), number()}, {number(), number()}};
      scene.initial->angle = number() - 0.5;
      scene.initial->rate = number() - 0.5;
    }
    for (int i = 0; i < 3 && chance(); ++i) {
      Probe& probe = scene.probes.emplace_back();
      probe.position = 0.3 * number();
      probe.quantity = static_cast<ProbeQuantity>(random() % (beam.thickness ? 4 : 3));
    }
    ASSERT_NO_THROW(check_scene(scene));
    const Scene back = parse_scene(write_scene(scene), "s");
    EXPECT_EQ(write_scene(back), write_scene(scene));
    EXPECT_EQ(back.beam()->thickness, beam.thickness);
    ASSERT_EQ(back.probes.size(), scene.probes.size());
    for (std::size_t i = 0; i < scene.probes.size(); ++i) {
      EXPECT_EQ(back.probes[i].position, scene.probes[i].position);
      EXPECT_EQ(back.probes[i].quantity, scene.probes[i].quantity);
    }
    ASSERT_EQ(back.hub.has_value(), scene.hub.has_value());
    if (!scene.hub) continue;
    EXPECT_EQ(back.hub->radius, scene.hub->radius);
    EXPECT_EQ(back.hub->inertia, scene.hub->inertia);
    EXPECT_EQ(back.hub->equations, scene.hub->equations);
    EXPECT_EQ(back.hub->centrifugal, scene.hub->centrifugal);
    EXPECT_EQ(back.hub->friction, scene.hub->friction);
    EXPECT_EQ(back.initial->angle, scene.initial->angle);
    EXPECT_EQ(back.initial->rate, scene.initial->rate);
    ASSERT_EQ(back.hub->torque.has_value(), scene.hub->torque.has_value());
    if (!scene.hub->torque) continue;
    if (const auto* pulse = std::get_if<TorquePulse>(&*scene.hub->torque)) {
      EXPECT_EQ(std::get<TorquePulse>(*back.hub->torque).amplitude, pulse->amplitude);
      EXPECT_EQ(std::get<TorquePulse>(*back.hub->torque).duration, pulse->duration);
    } else {
      const auto& table = std::get<TorqueTable>(*scene.hub->torque);
      EXPECT_EQ(std::get<TorqueTable>(*back.hub->torque).times, table.times);
      EXPECT_EQ(std::get<TorqueTable>(*back.hub->torque).values, table.values);
    }
  }
}

TEST(Hub, SettingsReachItsNumbers) {
  const auto with = [](const std::string& setting) {
    return parse_scene(kHubBeam + kHub + kPulse, "s", {setting});
  };
  EXPECT_EQ(std::get<TorquePulse>(*with("hub.torque.amplitude=2").hub->torque).amplitude, 2.0);
  EXPECT_EQ(with("hub.radius=0").hub->radius, 0.0);
  EXPECT_EQ(with("hub.friction.coulomb=0.2").hub->friction, 0.2);
  EXPECT_EQ(with("hub.equations=paper").hub->equations, HubEquations::kPaper);
  EXPECT_FALSE(with("hub.centrifugal=false").hub->centrifugal);
  EXPECT_EQ(with("initial.rate=3").initial->rate, 3.0);
  const Scene table = with("hub.torque={kind=\"table\", times=[0, 1], values=[2, 0]}");
  EXPECT_EQ(std::get<TorqueTable>(*table.hub->torque).values, (std::vector<double>{2.0, 0.0}));
  EXPECT_EQ(refusal_of([&] { with("hub.torque.duration=-1"); }),
            "--set hub.torque.duration=-1: hub.torque.duration: -1 is not allowed, it must be "
            "a finite number greater than 0");
  EXPECT_EQ(refusal_of([&] { with("hub.torque.amplitud=1"); }),
            "--set hub.torque.amplitud=1: hub.torque.amplitud: there is no such key, did you "
            "mean hub.torque.amplitude?");
}

TEST(Hub, ParametersAreItsNumbers) {
  const Scene scene = parse_scene(kHubBeam + "thickness = 2e-3\n" + kHub + kPulse +
                                      "friction = { coulomb = 0.01 }\n[initial]\nangle = 1\n",
                                  "s");
  const std::pair<const char*, const char*> names[] = {
      {"beam.thickness", "m"},      {"hub.radius", "m"},
      {"hub.inertia", "kg m^2"},    {"hub.torque.amplitude", "N m"},
      {"hub.torque.duration", "s"}, {"hub.friction.coulomb", "N m"}};
  for (const auto& [name, unit] : names) {
    ASSERT_NE(find_parameter(scene, name), nullptr) << name;
    EXPECT_EQ(parameter_unit(scene, name), unit) << name;
    EXPECT_EQ(*find_parameter(with_parameter(scene, name, 0.125), name), 0.125) << name;
    const Scene direction = parameter_direction(scene, name);
    for (const auto& [other, no_matter] : names)
      EXPECT_EQ(*find_parameter(direction, other), std::string(other) == name ? 1.0 : 0.0) << name;
    EXPECT_EQ(direction.initial->angle, 0.0);
  }
  EXPECT_EQ(refusal_of([&] { with_parameter(scene, "hub.torque.duration", 0.0); }),
            "hub.torque.duration: 0 is not allowed, it must be a finite number greater than 0");
  EXPECT_EQ(find_parameter(scene, "initial.angle"), nullptr);
}

TEST(Hub, RulesHoldForScenesMadeInCode) {
  Scene scene = parse_scene(kHubBeam + kHub + kPulse, "s");
  scene.origins = nullptr;
  const auto message = [](const Scene& changed) {
    return refusal_of([&] { check_scene(changed); });
  };
  Scene changed = scene;
  changed.hub->torque = TorqueTable{};
  EXPECT_EQ(message(changed), "hub.torque.times: the list has no entry, it must have at least two");
  changed.hub->torque = TorqueTable{{0.0, 1.0}, {1.0}};
  EXPECT_EQ(message(changed),
            "hub.torque.values: the list has 1 entry, it must have one per time, which is 2");
  changed = scene;
  changed.hub.reset();
  changed.initial = Initial{{0.0, 0.0}, {0.0, 0.0}};
  EXPECT_EQ(message(changed), "accepted");
  changed.initial->rate = 1.0;
  EXPECT_EQ(message(changed),
            "initial.rate: it is that of a [hub], without one it must be left out");
}

}  // namespace
}  // namespace graze
