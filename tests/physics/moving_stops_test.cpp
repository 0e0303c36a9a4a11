// Motions against stops that move, against tests/reference/moving_stops.py (50 digits, in inertial
// coordinates with the stop's motion explicit): a mass that is shaken beside a stop fixed in space
// (the case of Code_Aster's SDND102), a ball on a table, a chain against a stop of two orders with
// rigid stops and a spring, and an oscillator that only its stop drives.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/reader.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::number;
using support::TableRow;


const std::string kBall = R"(
[lumped]
masses = [1]
[forcing]
kind = "none"
frequency = 60
[gravity]
acceleration = -9.81
[[stop]]
mass = 1
gap = 0
side = "below"
restitution = 0.5
[stop.motion]
amplitude = 0.0035425
phase = -1.5707963267948966
[initial]
displacement = [0.01]
)";

std::string shaken() {
  const double w = 20.0 * std::numbers::pi;
  return fmt::format(R"(
[lumped]
masses = [25]
[[lumped.spring]]
between = [0, 1]
stiffness = 98696
damping = {}
[forcing]
kind = "base"
amplitude = {}
frequency = {}
phase = 1.5707963267948966
[[stop]]
mass = 1
gap = 5e-4
frame = "space"
[stop.spring]
stiffness = 5.76e7
)",
                     2.0 * 0.07 * std::sqrt(98696.0 * 25.0), 1.0 / (w * w), w);
}

std::string chain(const std::string& law) {
  return R"(
[lumped]
masses = [2, 1]
[[lumped.spring]]
between = [0, 1]
stiffness = 8000
damping = 1.5
[[lumped.spring]]
between = [1, 2]
stiffness = 5000
damping = 0.8
[forcing]
mass = 1
amplitude = 20
frequency = 30
phase = 0.4
[[stop]]
mass = 2
gap = 0.004
)" + law + R"(
[[stop.motion]]
amplitude = 0.001
phase = 1.1
[[stop.motion]]
amplitude = 0.0006
order = 1.5
phase = -0.3
)";
}

const std::string kDriven = R"(
[lumped]
masses = [1]
[[lumped.spring]]
between = [0, 1]
stiffness = 400
damping = 0.8
[forcing]
kind = "none"
frequency = 18
[[stop]]
mass = 1
gap = 0.002
restitution = 0.6
[stop.motion]
amplitude = 0.003
)";

std::string scene_of(const std::string& name) {
  static const std::map<std::string, std::string> scenes = {
      {"A in_space", shaken()},
      {"B chatter_r0.5", kBall},
      {"C r0", chain("restitution = 0")},
      {"C r0.5", chain("restitution = 0.5")},
      {"C r1", chain("restitution = 1")},
      {"C k4e4", chain("[stop.spring]\nstiffness = 4e4")},
      {"D r0.6", kDriven}};
  const auto found = scenes.find(name);
  return found == scenes.end() ? "" : found->second;
}

std::map<std::string, std::vector<TableRow>> cases() {
  std::map<std::string, std::vector<TableRow>> list;
  for (const TableRow& row : support::read_table("moving_stops.csv"))
    list[row.at("case") + " " + row.at("variant")].push_back(row);
  return list;
}

const char* kind_of(const Event& event) {
  switch (event.kind) {
    case EventKind::kImpact:
      return "impact";
    case EventKind::kContact:
      return "contact";
    case EventKind::kSeparation:
      return "separation";
    case EventKind::kStick:
      return "stick";
    case EventKind::kRelease:
      return "release";
    default:
      return "chatter";
  }
}

// The motions listed have errors that grow from impact to impact by 1 + r at most, up to 1e5 over
// twenty of them.
TEST(MovingStops, EventsAgreeWithTheReference) {
  int compared = 0;
  for (const auto& [name, rows] : cases()) {
    const std::string text = scene_of(name);
    if (text.empty()) continue;
    SCOPED_TRACE(name);
    const Scene scene = parse_scene(text, name);
    const System system = assemble(scene);
    SimulationOptions options = support::for_seconds(12.0);
    options.energy = true;
    const support::RecordedRun run =
        support::record_run(system, initial_state(scene, system), options);
    EXPECT_LE(std::abs(run.result.energy->defect()), 1e-10 * run.result.energy->size());
    std::map<std::string, std::size_t> next;
    for (const TableRow& row : rows) {
      const std::string& kind = row.at("event");
      if (kind.size() < 3) continue;
      std::size_t& k = next[kind];
      while (k < run.events.size() && kind_of(run.events[k]) != kind) ++k;
      // Those that the sum of a chatter takes in.
      ASSERT_LT(k, run.events.size()) << kind;
      const Event& event = run.events[k++];
      EXPECT_NEAR(event.time, number(row, "time"), 1e-11) << kind << " " << k;
      if (!row.at("speed").empty()) {
        EXPECT_NEAR(event.speed, number(row, "speed"), 1e-10 * (1.0 + number(row, "speed")));
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 140);
}

// Displacements and velocities are those of the structure itself; beside a stop fixed in space they
// count from the ground, which is shaken.
TEST(MovingStops, StatesAgreeWithTheReference) {
  const double w = 20.0 * std::numbers::pi;
  int compared = 0;
  for (const auto& [name, rows] : cases()) {
    const std::string text = scene_of(name);
    if (text.empty()) continue;
    const Scene scene = parse_scene(text, name);
    const System system = assemble(scene);
    for (const TableRow& row : rows) {
      const std::string& what = row.at("event");
      if (what.size() > 2) continue;
      SCOPED_TRACE(name + " " + what + " at " + row.at("time"));
      const double time = number(row, "time");
      const Simulation run = simulate(system, initial_state(scene, system), support::for_seconds(time));
      const State own = structure_state(system, run.final, run.phase);
      const Matrix& shapes = scene.discrete()->solved->modes.shapes;
      const Eigen::Index mass = what[1] - '1';
      double value = shapes.row(mass).dot(what[0] == 'u' ? own.q : own.qdot);
      if (name[0] == 'A') value -= what[0] == 'u' ? std::sin(w * time) / (w * w) : std::cos(w * time) / w;
      EXPECT_NEAR(value, number(row, "value"), 1e-11);
      ++compared;
    }
  }
  EXPECT_GT(compared, 60);
}

// The ball leaves with g T/2 and comes back with it: A w^2 cos p = pi g (1 - r)/(1 + r), speed
// g T/(1 + r); its multipliers have the product r^2 and the sum 1 + r^2 - (1 + r)^2 A w^2 sin p/g.
TEST(MovingStops, ABallOnATableHasItsClosedFormOrbits) {
  constexpr double g = 9.81;
  for (const double r : {0.3, 0.5, 0.8})
    for (const double beyond : {1.05, 1.2}) {
      const double least = std::numbers::pi * g * (1.0 - r) / (1.0 + r) / 3600.0, amplitude = beyond * least;
      SCOPED_TRACE(fmt::format("r {} A {}", r, amplitude));
      const Scene scene = parse_scene(kBall, "ball.toml",
                                      {fmt::format("stop.restitution={}", r),
                                       fmt::format("stop.motion.amplitude={}", amplitude)});
      const System system = assemble(scene);
      FinderOptions options;
      options.impacts = 1;
      const FoundOrbits found = find_orbits(system, initial_state(scene, system), options);
      ASSERT_EQ(found.orbits.size(), 2u);
      for (const Orbit& orbit : found.orbits) {
        const double phase = orbit.impacts[0].phase;
        EXPECT_NEAR(std::cos(phase), 1.0 / beyond, 1e-12);
        EXPECT_NEAR(orbit.impacts[0].speed, g * 2.0 * std::numbers::pi / 60.0 / (1.0 + r), 1e-12);
        const Complex sum = orbit.multipliers[0].value + orbit.multipliers[1].value;
        const Complex product = orbit.multipliers[0].value * orbit.multipliers[1].value;
        EXPECT_NEAR(product.real(), r * r, 1e-11);
        EXPECT_NEAR(sum.real(),
                    1.0 + r * r -
                        (1.0 + r) * (1.0 + r) * amplitude * 3600.0 * std::sin(phase) / g,
                    1e-10);
      }
    }
}

// A stop that moves as the structure does by itself is never met.
TEST(MovingStops, AStopThatFollowsTheStructureIsNotMet) {
  // x'' + .4 x' + 9 x = 2 cos 2t: at rest in its response.
  const Complex response = 2.0 / Complex(9.0 - 4.0, 0.4 * 2.0);
  const std::string text = fmt::format(
      "[lumped]\nmasses = [1]\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 9\ndamping = 0.4\n"
      "[forcing]\nmass = 1\namplitude = 2\nfrequency = 2\n[[stop]]\nmass = 1\ngap = 0.01\n"
      "restitution = 0.5\n[stop.motion]\namplitude = {}\nphase = {}\n[initial]\ndisplacement = "
      "[{}]\nvelocity = [{}]\n",
      std::abs(response), std::arg(response), response.real(), -2.0 * response.imag());
  const Scene scene = parse_scene(text, "follows.toml");
  const System system = assemble(scene);
  const support::RecordedRun run =
      support::record_run(system, initial_state(scene, system), support::for_seconds(40.0));
  EXPECT_TRUE(run.events.empty());
  EXPECT_NEAR(*run.result.totals.smallest_gap, 0.01, 1e-14);
}

// One mass cannot follow a wall that moves and one that does not.
TEST(MovingStops, ThatContradictEachOtherAreRefused) {
  const Scene scene = parse_scene(
      "[lumped]\nmasses = [1]\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 9\n"
      "[forcing]\nkind = \"none\"\nfrequency = 2\n"
      "[[stop]]\nmass = 1\ngap = 0.5\nrestitution = 0.5\n"
      "[[stop]]\nmass = 1\ngap = 0.5\nside = \"below\"\nrestitution = 0.5\n"
      "[stop.motion]\namplitude = 0.1\n",
      "walls.toml");
  try {
    assemble(scene);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("stop 2 moves otherwise than the 1 mode can"),
              std::string::npos)
        << error.what();
  }
}

// In the frame of a stop a shaken wall and a shaken mass are one: the same relative motion.
TEST(MovingStops, AMovingStopIsAMovingBaseSeenFromTheStop) {
  const char* structure =
      "[lumped]\nmasses = [2]\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 50\ndamping = 0.3\n";
  // In space the mass u + y meets a wall at the gap; seen from the base, the wall moves by -y.
  const Scene in_space = parse_scene(
      std::string(structure) + "[forcing]\nkind = \"base\"\namplitude = 0.1\nfrequency = 4\n"
                               "phase = 0.7\n[[stop]]\nmass = 1\ngap = 0.2\nrestitution = 0.7\n"
                               "frame = \"space\"\n",
      "space.toml");
  const Scene moving = parse_scene(
      std::string(structure) + "[forcing]\nkind = \"base\"\namplitude = 0.1\nfrequency = 4\n"
                               "phase = 0.7\n[[stop]]\nmass = 1\ngap = 0.2\nrestitution = 0.7\n"
                               "[stop.motion]\namplitude = -0.1\nphase = 0.7\n",
      "moving.toml");
  const System first = assemble(in_space), second = assemble(moving);
  const support::RecordedRun a =
      support::record_run(first, initial_state(in_space, first), support::for_seconds(30.0));
  const support::RecordedRun b =
      support::record_run(second, initial_state(moving, second), support::for_seconds(30.0));
  ASSERT_GT(a.events.size(), 10u);
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < a.events.size(); ++i)
    EXPECT_EQ(a.events[i].time, b.events[i].time);
}

}  // namespace
}  // namespace graze
