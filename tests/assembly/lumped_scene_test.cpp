// Masses and springs, matrices in the scene, points of loads, starts in coordinates: read, written,
// refused; parameters that move as one.
#include <gtest/gtest.h>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/base/errors.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "graze/scene/start_coordinate.hpp"

namespace graze {
namespace {

constexpr const char* kPair = R"(
[lumped]
masses = [1.0, 0.25]
names = ["frame", "ball"]

[[lumped.spring]]
between = ["ground", "frame"]
stiffness = 16.0
damping = 0.1

[forcing]
mass = "frame"
amplitude = 2.0
frequency = 3.0

[[stop]]
mass = "ball"
against = "frame"
gap = 0.2
restitution = 0.5

[[stop]]
mass = "ball"
against = "frame"
gap = 0.3
side = "below"
restitution = 0.5
)";

Scene pair(const std::vector<std::string>& settings = {}) {
  return parse_scene(kPair, "pair.toml", settings);
}

std::string why_refused(const std::string& text, const std::vector<std::string>& settings = {}) {
  try {
    parse_scene(text, "scene.toml", settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LumpedReader, NamesAndNumbersOfMasses) {
  const Scene scene = pair();
  EXPECT_EQ(scene.modes(), 2);
  EXPECT_STREQ(scene.structure_name(), "lumped");
  EXPECT_EQ(scene.forcing->kind, ForcingKind::kPoint);
  const Scene numbered = pair({"stop.mass=2", "stop.against=1", "forcing.mass=1"});
  const System a = assemble(scene), b = assemble(numbered);
  EXPECT_EQ(a.stops[0].row, b.stops[0].row);
  EXPECT_EQ(a.forcing()->amplitude, b.forcing()->amplitude);
  // Against the ground a displacement is that of the mass alone.
  EXPECT_EQ(assemble(pair({"stop.against=0"})).stops[0].row,
            assemble(parse_scene(kPair, "", {"stop.against=\"ground\""})).stops[0].row);
}

TEST(LumpedReader, WhatIsWrittenReadsBack) {
  const Scene scene =
      pair({"lumped.masses=[1.0, \"250 g\"]", "lumped.spring.damping=\"0.1 N s/m\""});
  const Scene again = parse_scene(write_scene(scene), "again.toml");
  EXPECT_EQ(write_scene(again), write_scene(scene));
  EXPECT_EQ(again.lumped()->masses, (std::vector<double>{1.0, 0.25}));
  EXPECT_EQ(again.lumped()->names, scene.lumped()->names);
  for (const std::string& name : parameter_names(scene))
    EXPECT_EQ(*find_parameter(again, name), *find_parameter(scene, name)) << name;
}

TEST(LumpedReader, RefusesWhatDoesNotFit) {
  const auto refused = [&](const std::string& setting) { return why_refused(kPair, {setting}); };
  EXPECT_NE(refused("lumped.spring.between=[0, 3]").find("a mass from 1 to 2 or the name of one"),
            std::string::npos);
  EXPECT_NE(refused("lumped.spring.between=[\"ground\", \"bal\"]").find("did you mean ball"),
            std::string::npos);
  EXPECT_NE(refused("lumped.spring.between=[1, 1]").find("they must be two"), std::string::npos);
  EXPECT_NE(refused("lumped.spring.between=[1]").find("it must have two"), std::string::npos);
  EXPECT_NE(refused("lumped.masses=[1.0, -1.0]").find("greater than 0"), std::string::npos);
  EXPECT_NE(refused("lumped.masses=[]").find("the list is empty"), std::string::npos);
  EXPECT_NE(refused("lumped.names=[\"a\"]").find("one for each mass"), std::string::npos);
  EXPECT_NE(refused("lumped.names=[\"a\", \"a\"]").find("names mass 1 already"), std::string::npos);
  EXPECT_NE(refused("stop.mass=\"bell\"").find("a mass from 1 to 2"), std::string::npos);
  EXPECT_NE(refused("stop.against=\"ball\"").find("moves with the other one"), std::string::npos);
  EXPECT_NE(refused("stop.node=\"2\"").find("nodes are those of [matrices]"), std::string::npos);
  EXPECT_NE(refused("stop.position=0.2").find("it must have a mass"), std::string::npos);
  EXPECT_NE(refused("lumped.modes=3").find("the matrices have 2"), std::string::npos);
  EXPECT_NE(refused("damping={ ratio = 0.1 }").find("only one of lumped.spring.damping"),
            std::string::npos);
  EXPECT_NE(refused("forcing.kind=base").find("forcing.kind must be \"point\""), std::string::npos);
}

TEST(LumpedReader, MatricesInTheScene) {
  const std::string text = R"(
[matrices]
mass = [[1.0, 0.0], [0.0, 2.0]]
stiffness = [[30.0, -10.0], [-10.0, 10.0]]

[[stop]]
node = 2
gap = 0.1
restitution = 0.5
)";
  const Scene scene = parse_scene(text, "rows.toml");
  EXPECT_EQ(scene.modes(), 2);
  EXPECT_EQ(write_scene(parse_scene(write_scene(scene), "again.toml")), write_scene(scene));
  // A parameter above the diagonal moves its mirror image, also in what is written.
  const Scene moved = with_parameter(scene, "matrices.stiffness.1.2", -9.0);
  EXPECT_NE(write_scene(moved).find("stiffness = [[30.0, -9.0], [-9.0, 10.0]]"), std::string::npos);
  EXPECT_NE(why_refused(text, {"matrices.mass=[[1.0, 0.5], [0.0, 2.0]]"}).find("not symmetric"),
            std::string::npos);
  EXPECT_NE(why_refused(text, {"matrices.mass=[[1.0, 0.5]]"}).find("it must have 1"),
            std::string::npos);
  EXPECT_NE(why_refused(text, {"matrices.mass=[[1.0]]"}).find("it must have 1 as the mass has"),
            std::string::npos);
  EXPECT_NE(why_refused(text, {"matrices.stiffness=\"k.mtx\""}).find("a list of rows as well"),
            std::string::npos);
  EXPECT_NE(why_refused(text, {"matrices.damping=[[0.1, 0.0], [0.0, -0.1]]"}).find("gives energy"),
            std::string::npos);
}

TEST(LumpedReader, StartsInCoordinates) {
  const Scene scene = pair(
      {"initial.displacement=[0.01, 0.05]", "initial.velocity=[0.3, -0.2]", "initial.speed=2.0"});
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  // The place of the ball relative to the frame, and their relative velocity.
  EXPECT_NEAR(system.stops[0].row.dot(start.q), 0.04, 1e-16);
  EXPECT_NEAR(system.stops[0].row.dot(start.qdot), -0.5, 1e-15);
  // A uniform speed moves none against the other.
  const Scene alone = pair({"initial.speed=2.0"});
  EXPECT_NEAR(system.stops[0].row.dot(initial_state(alone, system).qdot), 0.0, 1e-15);
  EXPECT_NEAR(initial_state(alone, system).qdot.squaredNorm(), 4.0 * 1.25, 1e-14);
  EXPECT_NE(why_refused(kPair, {"initial.velocity=[1.0]"}).find("one for each mass"),
            std::string::npos);
  EXPECT_NE(why_refused(kPair, {"initial={ velocity = [0.0, 1.0], qdot = [0.0, 1.0] }"})
                .find("the velocities are given already"),
            std::string::npos);
  const Scene moved = with_number(scene, "initial.velocity.2", 0.7);
  EXPECT_NEAR(system.stops[0].row.dot(initial_state(moved, system).qdot), 0.4, 1e-15);
  EXPECT_EQ(number_unit(scene, "initial.velocity.2"), "m/s");
  // Where the start stands in modal coordinates it is kept.
  const Scene from_modes =
      with_number(pair({"initial.q=[0.0, 0.02]"}), "initial.displacement.1", 0.0);
  EXPECT_EQ(from_modes.initial->displacement[0], 0.0);
}

TEST(LumpedReader, StartsInEquilibrium) {
  const Scene scene = parse_scene(R"(
[lumped]
masses = [2.0]
[[lumped.spring]]
between = [0, 1]
stiffness = 100.0
[gravity]
acceleration = -10.0
[[load]]
mass = 1
force = 5.0
[[stop]]
mass = 1
gap = 0.2
restitution = 0.5
[initial]
at = "equilibrium"
velocity = [1.0]
)",
                                  "hangs.toml");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  EXPECT_NEAR(system.stops[0].row.dot(start.q), (5.0 - 20.0) / 100.0, 1e-16);
  EXPECT_NEAR(system.stops[0].row.dot(start.qdot), 1.0, 1e-15);
}

TEST(LumpedReader, PointLoadsOfABeam) {
  // The static deflection of a cantilever under a force at its tip: F L^3/(3 E I).
  const std::string beam = R"(
[beam]
length = 1.0
youngs_modulus = 2e11
second_moment = 1e-10
density = 8000.0
area = 1e-4
modes = 40
[[load]]
position = 1.0
force = 3.0
[[stop]]
position = 1.0
gap = 1.0
restitution = 0.5
[initial]
at = "equilibrium"
)";
  const Scene scene = parse_scene(beam, "beam.toml");
  const System system = assemble(scene);
  EXPECT_NEAR(system.stops[0].row.dot(initial_state(scene, system).q), 3.0 / (3.0 * 20.0), 1e-6);
  const Scene forced = parse_scene(
      beam, "beam.toml", {"forcing={ position = 0.5, amplitude = 2.0, frequency = 10.0 }"});
  EXPECT_EQ(forced.forcing->kind, ForcingKind::kPoint);
  EXPECT_NE(why_refused(beam, {"load.position=1.5"}).find("at most the beam's length"),
            std::string::npos);
}

TEST(TiedParameters, MoveAsOne) {
  const Scene scene = pair();
  const Scene both = with_parameter(scene, "stop.*.gap", 0.15);
  EXPECT_EQ(both.stops[0].gap, 0.15);
  EXPECT_EQ(both.stops[1].gap, 0.15);
  EXPECT_EQ(parameter_value(scene, "stop.*.gap"), 0.2);
  EXPECT_EQ(parameter_unit(scene, "stop.*.gap"), "m");
  const std::string ratio = "forcing.frequency, lumped.spring.stiffness = 2.5*forcing.frequency";
  const Scene tied = with_parameter(scene, ratio, 4.0);
  EXPECT_EQ(static_cast<double>(tied.forcing->frequency), 4.0);
  EXPECT_EQ(tied.lumped()->springs[0].stiffness, 10.0);
  EXPECT_NEAR(assemble(tied).omega[1], std::sqrt(10.0), 1e-15);
  const Scene direction = parameter_direction(scene, ratio);
  EXPECT_EQ(direction.lumped()->springs[0].stiffness, 2.5);
  EXPECT_EQ(direction.forcing->frequency.written, 1.0);
  EXPECT_TRUE(are_same_parameter("stop.2.gap", "gravity.acceleration,stop.2.gap"));
  for (const char* wrong : {"stop.*.gape", "forcing.frequency,stop.gap=2*gravity.acceleration",
                            "stop.gap=2*forcing.frequency",
                            "forcing.frequency,stop.gap=x*forcing.frequency", "forcing.frequency,"})
    EXPECT_THROW(with_parameter(scene, wrong, 1.0), InputError) << wrong;
}

TEST(Defaults, AreWhatOneExpects) {
  const Scene scene = parse_scene(R"(
[beam]
length = 1.0
youngs_modulus = 2e11
second_moment = 1e-10
density = 8000.0
area = 1e-4
modes = 3
[damping]
ratio = 0.01
[[stop]]
position = 1.0
gap = 0.01
[stop.spring]
stiffness = 1e5
[initial]
q = [0.1]
)",
                                  "beam.toml");
  EXPECT_EQ(scene.stops[0].spring->exponent, 1.0);
  const System system = assemble(scene);
  EXPECT_EQ(system.delta(), 0.01 * system.omega);
  EXPECT_EQ(initial_state(scene, system).q.size(), 3);
  EXPECT_EQ(parameter_value(scene, "damping.ratio"), 0.01);
}

TEST(TiedParameters, NameANumberOnce) {
  const Scene scene = pair();
  EXPECT_EQ(with_parameter(scene, "stop.*.gap", 0.1).stops[1].gap, 0.1);
  for (const char* name :
       {"stop.1.gap,stop.1.gap=2*stop.1.gap", "stop.1.gap,stop.*.gap=2*stop.1.gap",
        "stop.gap,stop.1.gap", "forcing.frequency,forcing.frequency_hz=2*forcing.frequency"})
    EXPECT_THROW(with_parameter(scene, name, 0.1), InputError) << name;
  EXPECT_THROW(with_parameter(scene, "stop.1.gap,", 0.1), InputError);
}

TEST(LumpedReader, AnEntryBesideTheDiagonalIsSetOnBothSides) {
  const std::string text =
      "[matrices]\nmass = [[1.0, 0.0], [0.0, 2.0]]\nstiffness = [[9.0, -2.0], [-2.0, 5.0]]\n";
  for (const char* setting : {"matrices.stiffness.1.2=-3.0", "matrices.stiffness.2.1=-3.0"}) {
    const Scene scene = parse_scene(text, "scene", {setting});
    EXPECT_EQ(scene.modal()->frequencies,
              with_parameter(parse_scene(text, "scene"), "matrices.stiffness.1.2", -3.0)
                  .modal()
                  ->frequencies);
  }
}

// A body that only dashpots hold: no mode is missing, and what is pushed elsewhere comes to move it.
TEST(LumpedReader, ABodyThatOnlyADashpotHoldsIsSeen) {
  const Scene scene = parse_scene(
      "[lumped]\nmasses = [1.0, 3.0, 0.5]\n"
      "[[lumped.spring]]\nbetween = [1, 2]\nstiffness = 100\n"
      "[[lumped.spring]]\nbetween = [2, 3]\ndamping = 7\n"
      "[forcing]\nmass = 2\namplitude = 50\nfrequency = 9\n"
      "[[stop]]\nmass = 3\ngap = 0.1\nrestitution = 0.6\n",
      "scene");
  const System system = assemble(scene);
  EXPECT_TRUE(system_warnings(scene, system).empty());
  EXPECT_GT(default_closure_speed(system, initial_state(scene, system), 1e-10), 0.0);
}

}  // namespace
}  // namespace graze
