#include "graze/scene/parameter.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "graze/scene/check.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

Scene beam_scene() {
  return parse_scene(
      "[beam]\nlength = 0.3\nyoungs_modulus = 2e11\nsecond_moment = 2e-13\ndensity = 8500\n"
      "area = 1e-5\nmodes = 2\npoints = [0.1, 0.3]\n[damping]\nviscous = 0.005\n"
      "[forcing]\namplitude = 6e-4\nfrequency = 28.3\n"
      "[[stop]]\nposition = 0.3\ngap = 1e-3\nrestitution = 0.8\n"
      "[initial]\nq = [1, 2]\nqdot = [3, 4]\n",
      "s");
}

Scene modal_scene() {
  return parse_scene(
      "[modal]\nfrequencies = [1, 6]\nparticipation = [1, 0.5]\ninertia = [1, 0.25]\n"
      "damping_ratios = [0.01, 0.02]\n[forcing]\namplitude = 1\nfrequency = 2\n"
      "[[stop]]\nshape = [1, -1]\ngap = 0\nrestitution = 0.8\n",
      "s");
}

// Gravity, r(v) and two stops.
Scene two_stop_scene() {
  return parse_scene(
      "[modal]\nfrequencies = [0, 6]\ninertia = [1, 0.25]\n[gravity]\nacceleration = 9.81\n"
      "[[stop]]\nshape = [1, -1]\ngap = 1\nrestitution = [0.9, 0.1, 0.02]\n"
      "[[stop]]\nshape = [1, 1]\ngap = 0.5\nside = \"below\"\nrestitution = 0.7\n",
      "s");
}

template <typename F>
std::string message_of(F&& f) {
  try {
    f();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Parameter, NamesAreThoseOfTheScene) {
  EXPECT_EQ(
      parameter_names(beam_scene()),
      (std::vector<std::string>{"beam.length", "beam.youngs_modulus", "beam.second_moment",
                                "beam.density", "beam.area", "beam.points.1", "beam.points.2",
                                "damping.viscous", "forcing.amplitude", "forcing.frequency",
                                "forcing.phase", "stop.position", "stop.gap", "stop.restitution"}));
  EXPECT_EQ(parameter_names(modal_scene()),
            (std::vector<std::string>{
                "modal.frequencies.1", "modal.frequencies.2", "modal.damping_ratios.1",
                "modal.damping_ratios.2", "modal.participation.1", "modal.participation.2",
                "modal.inertia.1", "modal.inertia.2", "forcing.amplitude", "forcing.frequency",
                "forcing.phase", "stop.shape.1", "stop.shape.2", "stop.gap", "stop.restitution"}));
  EXPECT_EQ(parameter_names(two_stop_scene()),
            (std::vector<std::string>{
                "modal.frequencies.1", "modal.frequencies.2", "modal.inertia.1", "modal.inertia.2",
                "gravity.acceleration", "stop.shape.1", "stop.shape.2", "stop.gap",
                "stop.restitution.1", "stop.restitution.2", "stop.restitution.3", "stop.2.shape.1",
                "stop.2.shape.2", "stop.2.gap", "stop.2.restitution"}));
}

TEST(Parameter, DampingHasTheNamesOfItsKind) {
  Scene scene = modal_scene();
  std::get<ModalStructure>(scene.structure).damping_ratios.clear();
  scene.damping = DampingRatios{{0.1, 0.2}};
  EXPECT_EQ(*find_parameter(scene, "damping.ratios.2"), 0.2);
  EXPECT_EQ(find_parameter(scene, "damping.viscous"), nullptr);
  scene.damping = RayleighDamping{0.3, 0.4};
  EXPECT_EQ(*find_parameter(scene, "damping.rayleigh.mass"), 0.3);
  EXPECT_EQ(*find_parameter(scene, "damping.rayleigh.stiffness"), 0.4);
}

TEST(Parameter, EveryNameIsFoundAndNoTwoMeanTheSameNumber) {
  for (Scene scene : {beam_scene(), modal_scene(), two_stop_scene()}) {
    double value = 100.0;
    for (const std::string& name : parameter_names(scene)) {
      ASSERT_NE(find_parameter(scene, name), nullptr) << name;
      *find_parameter(scene, name) = ++value;
    }
    value = 100.0;
    for (const std::string& name : parameter_names(scene)) {
      EXPECT_EQ(*find_parameter(scene, name), ++value) << name;
    }
  }
}

TEST(Parameter, NamesAreTheReadersKeys) {
  for (const Scene& scene : {beam_scene(), modal_scene(), two_stop_scene()}) {
    for (const std::string& name : parameter_names(scene)) {
      if (name != "forcing.phase") {  // not written in these scenes
        EXPECT_EQ(scene.origins->count(name), 1u) << name;
      }
    }
  }
}

TEST(Parameter, FirstStopMayHaveItsNumber) {
  Scene scene = beam_scene();
  EXPECT_EQ(find_parameter(scene, "stop.1.gap"), &scene.stops[0].gap);
  EXPECT_EQ(find_parameter(scene, "stop.2.gap"), nullptr);
  scene.stops.push_back(scene.stops[0]);
  EXPECT_EQ(find_parameter(scene, "stop.2.gap"), &scene.stops[1].gap);
}

TEST(Parameter, RestitutionOfTheSpeedIsNamedByItsCoefficients) {
  Scene scene = two_stop_scene();
  EXPECT_EQ(find_parameter(scene, "gravity.acceleration"), &scene.gravity->acceleration);
  EXPECT_EQ(find_parameter(scene, "stop.restitution"), nullptr);
  EXPECT_EQ(find_parameter(scene, "stop.restitution.2"), &scene.stops[0].restitution[1]);
  EXPECT_EQ(find_parameter(scene, "stop.1.restitution.3"), &scene.stops[0].restitution[2]);
  EXPECT_EQ(find_parameter(scene, "stop.restitution.4"), nullptr);
  EXPECT_EQ(find_parameter(scene, "stop.2.restitution"), &scene.stops[1].restitution[0]);
  EXPECT_EQ(find_parameter(scene, "stop.2.restitution.1"), nullptr);
  scene.stops[1].restitution = {0.5, 0.1};
  EXPECT_EQ(find_parameter(scene, "stop.2.restitution.2"), &scene.stops[1].restitution[1]);
  EXPECT_EQ(find_parameter(scene, "stop.2.restitution"), nullptr);
}

TEST(Parameter, WhatIsNotContinuousIsNone) {
  const Scene scene = beam_scene();
  for (const char* name :
       {"", ".", "beam", "beam.modes", "initial.q.1", "solver.tolerance", "stop.side",
        "beam.points.0", "beam.points.3", "stop.shape.1", "title"}) {
    EXPECT_EQ(find_parameter(scene, name), nullptr) << name;
  }
}

TEST(Parameter, ChangesOneNumberAndChecksTheScene) {
  const Scene scene = beam_scene();
  const Scene changed = with_parameter(scene, "stop.gap", 2e-3);
  EXPECT_EQ(changed.stops[0].gap, 2e-3);
  EXPECT_EQ(scene.stops[0].gap, 1e-3);
  EXPECT_EQ(changed.origins, scene.origins);
  EXPECT_EQ(message_of([&] { with_parameter(scene, "stop.restitution", 1.5); }),
            "stop.restitution: 1.5 is not allowed, it must be a number from 0 to 1");
  EXPECT_EQ(message_of([&] {
              with_parameter(scene, "forcing.frequency", std::numeric_limits<double>::quiet_NaN());
            }),
            "forcing.frequency: nan is not allowed, it must be a finite number greater than 0");
  EXPECT_EQ(message_of([&] { with_parameter(scene, "beam.length", 0.25); }),
            "beam.points.2: 0.3 is not allowed, it must be greater than 0.1 and at most the beam's "
            "length 0.25");
}

TEST(Parameter, ChangesGravityAndEveryStop) {
  const Scene scene = two_stop_scene();
  EXPECT_EQ(with_parameter(scene, "gravity.acceleration", -1.6).gravity->acceleration, -1.6);
  EXPECT_EQ(with_parameter(scene, "stop.2.gap", -2e-3).stops[1].gap, -2e-3);
  // Only a0 has bounds.
  EXPECT_EQ(with_parameter(scene, "stop.restitution.2", -50.0).stops[0].restitution,
            (std::vector<double>{0.9, -50.0, 0.02}));
  EXPECT_EQ(message_of([&] { with_parameter(scene, "stop.restitution.1", 1.01); }),
            "stop.restitution.1: 1.01 is not allowed, it must be a number from 0 to 1");
  EXPECT_EQ(message_of([&] { with_parameter(scene, "stop.2.restitution", -0.5); }),
            "stop.2.restitution: -0.5 is not allowed, it must be a number from 0 to 1");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message_of([&] { with_parameter(scene, "stop.restitution.3", infinity); }),
            "stop.restitution.3: inf is not allowed, it must be a finite number");
  EXPECT_EQ(message_of([&] { with_parameter(scene, "gravity.acceleration", infinity); }),
            "gravity.acceleration: inf is not allowed, it must be a finite number");
}

TEST(Parameter, UnknownNamesGetASuggestionAndTheList) {
  const Scene scene = beam_scene();
  const std::string list =
      "Allowed are beam.length, beam.youngs_modulus, beam.second_moment, beam.density, beam.area, "
      "beam.points.1..2, damping.viscous, forcing.amplitude, forcing.frequency, forcing.phase, "
      "stop.position, stop.gap and stop.restitution.";
  const std::string none = ": the scene has no such continuous parameter. ";
  EXPECT_EQ(message_of([&] { with_parameter(scene, "forcing.freqency", 1.0); }),
            "forcing.freqency" + none + "Did you mean forcing.frequency? " + list);
  EXPECT_EQ(message_of([&] { parameter_direction(scene, "gap"); }),
            "gap" + none + "Did you mean stop.gap? " + list);
  EXPECT_EQ(message_of([&] { parameter_direction(scene, "forcing.freq"); }),
            "forcing.freq" + none + "Did you mean forcing.frequency? " + list);
  EXPECT_EQ(message_of([&] { parameter_direction(scene, "colour"); }), "colour" + none + list);
  EXPECT_EQ(message_of([&] { parameter_direction(two_stop_scene(), "stop.restitution"); }),
            "stop.restitution" + none +
                "Did you mean stop.restitution.1? Allowed are modal.frequencies.1..2, "
                "modal.inertia.1..2, gravity.acceleration, stop.shape.1..2, stop.gap, "
                "stop.restitution.1..3, stop.2.shape.1..2, stop.2.gap and stop.2.restitution.");
}

TEST(Parameter, DirectionIsOneNumberInTheShapeOfTheScene) {
  for (const Scene& scene : {beam_scene(), modal_scene(), two_stop_scene()}) {
    for (const std::string& name : parameter_names(scene)) {
      const Scene direction = parameter_direction(scene, name);
      EXPECT_EQ(parameter_names(direction), parameter_names(scene));
      EXPECT_EQ(direction.modes(), scene.modes());
      for (const std::string& other : parameter_names(scene)) {
        EXPECT_EQ(*find_parameter(direction, other), other == name ? 1.0 : 0.0) << name;
      }
      EXPECT_EQ(direction.solver.tolerance, 0.0);
      EXPECT_EQ(direction.initial.has_value(), scene.initial.has_value());
      if (direction.initial) {
        EXPECT_EQ(direction.initial->q, std::vector<double>(2, 0.0));
        EXPECT_EQ(direction.initial->qdot, std::vector<double>(2, 0.0));
      }
    }
  }
}

// d(i L/N)/dL = i/N: the direction's points are the derivatives of the scene's.
TEST(Parameter, DirectionMovesTheDefaultPoints) {
  Scene scene = beam_scene();
  std::get<Beam>(scene.structure).points.clear();
  const Scene direction = parameter_direction(scene, "beam.length");
  EXPECT_EQ(collocation_points(*direction.beam()), (std::vector<double>{0.5, 1.0}));
}

TEST(Parameter, HasItsUnit) {
  const Scene beam = beam_scene();
  EXPECT_EQ(parameter_unit(beam, "beam.length"), "m");
  EXPECT_EQ(parameter_unit(beam, "beam.points.2"), "m");
  EXPECT_EQ(parameter_unit(beam, "damping.viscous"), "N s/m^2");
  EXPECT_EQ(parameter_unit(beam, "forcing.amplitude"), "m");
  EXPECT_EQ(parameter_unit(beam, "stop.gap"), "m");
  EXPECT_EQ(parameter_unit(beam, "stop.2.gap"), "m");
  EXPECT_EQ(parameter_unit(beam, "stop.restitution"), "");
  const Scene modal = modal_scene();
  EXPECT_EQ(parameter_unit(modal, "forcing.amplitude"), "");
  EXPECT_EQ(parameter_unit(modal, "modal.frequencies.1"), "rad/s");
  EXPECT_EQ(parameter_unit(modal, "stop.shape.1"), "kg^-1/2");
  EXPECT_EQ(parameter_unit(modal, "stop.2.shape.1"), "kg^-1/2");
  const Scene stops = two_stop_scene();
  EXPECT_EQ(parameter_unit(stops, "gravity.acceleration"), "m/s^2");
  // a_k v^k is a pure number.
  EXPECT_EQ(parameter_unit(stops, "stop.restitution.1"), "");
  EXPECT_EQ(parameter_unit(stops, "stop.restitution.2"), "s/m");
  EXPECT_EQ(parameter_unit(stops, "stop.1.restitution.3"), "s^2/m^2");
  EXPECT_EQ(parameter_unit(stops, "stop.2.restitution"), "");
  EXPECT_EQ(parameter_unit(stops, "stop.2.restitution.2"), "s/m");
}

}  // namespace
}  // namespace graze
