// Every scene in data/scenes is read, and what is written of it reads back to the same values.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(GRAZE_SOURCE_DIR) / "data" / "scenes";

std::vector<std::filesystem::path> shipped_scenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    files.push_back(entry.path());
  }
  return files;
}

// The numbers of both scenes, bit by bit, and everything that is no number.
void expect_equal(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.structure.index(), b.structure.index());
  EXPECT_EQ(a.modes(), b.modes());
  if (a.beam() != nullptr && b.beam() != nullptr) {
    EXPECT_EQ(a.beam()->discretisation, b.beam()->discretisation);
  }
  EXPECT_EQ(parameter_names(a), parameter_names(b));
  for (const std::string& name : parameter_names(a)) {
    EXPECT_EQ(*find_parameter(a, name), *find_parameter(b, name)) << name;
  }
  ASSERT_EQ(a.forcing.has_value(), b.forcing.has_value());
  if (a.forcing) {
    EXPECT_EQ(a.forcing->kind, b.forcing->kind);
  }
  ASSERT_EQ(a.gravity.has_value(), b.gravity.has_value());
  ASSERT_EQ(a.stops.size(), b.stops.size());
  for (std::size_t k = 0; k < a.stops.size(); ++k) {
    EXPECT_EQ(a.stops[k].side, b.stops[k].side);
    EXPECT_EQ(a.stops[k].impulse, b.stops[k].impulse);
    EXPECT_EQ(a.stops[k].spring.has_value(), b.stops[k].spring.has_value());
  }
  ASSERT_EQ(a.probes.size(), b.probes.size());
  for (std::size_t k = 0; k < a.probes.size(); ++k) {
    EXPECT_EQ(a.probes[k].quantity, b.probes[k].quantity);
    EXPECT_EQ(a.probes[k].position, b.probes[k].position);
    EXPECT_EQ(a.probes[k].shape, b.probes[k].shape);
  }
  ASSERT_EQ(a.hub.has_value(), b.hub.has_value());
  ASSERT_EQ(a.initial.has_value(), b.initial.has_value());
  if (a.initial) {
    EXPECT_EQ(a.initial->q, b.initial->q);
    EXPECT_EQ(a.initial->qdot, b.initial->qdot);
  }
  EXPECT_EQ(a.solver.flow, b.solver.flow);
  EXPECT_EQ(a.solver.tolerance, b.solver.tolerance);
}

TEST(ShippedScene, ThereAreSome) { EXPECT_GE(shipped_scenes().size(), 16u); }

TEST(ShippedScene, IsReadAndHasATitle) {
  for (const auto& file : shipped_scenes()) {
    EXPECT_FALSE(read_scene(file).title.empty()) << file;
  }
}

TEST(ShippedScene, ReadsBackFromWhatIsWritten) {
  for (const auto& file : shipped_scenes()) {
    SCOPED_TRACE(file.string());
    const Scene scene = read_scene(file);
    const std::string text = write_scene(scene);
    const Scene again = parse_scene(text, "written");
    expect_equal(scene, again);
    EXPECT_EQ(write_scene(again), text);
  }
}

// Wagg, J. Sound Vib. 276 (2004) 1128-1134, section 3.
TEST(ShippedScene, WaggHasThePapersNumbers) {
  const Scene scene = read_scene(kFolder / "01_wagg_2004.toml");
  ASSERT_NE(scene.beam(), nullptr);
  EXPECT_EQ(scene.beam()->length, 0.3);
  EXPECT_EQ(scene.beam()->youngs_modulus, 205e9);
  EXPECT_EQ(scene.beam()->second_moment, 24.4e-14);
  EXPECT_EQ(scene.beam()->density, 8500.0);
  EXPECT_EQ(scene.beam()->area, 12.4e-6);
  EXPECT_EQ(scene.beam()->modes, 4);
  EXPECT_EQ(scene.beam()->discretisation, Projection::kCollocation);
  EXPECT_EQ(*find_parameter(scene, "damping.viscous"), 0.005);
  EXPECT_EQ(scene.forcing->kind, ForcingKind::kBase);
  EXPECT_EQ(scene.forcing->amplitude, 0.0006);
  EXPECT_EQ(scene.forcing->frequency, 28.3);
  ASSERT_EQ(scene.stops.size(), 1u);
  EXPECT_EQ(scene.stops[0].position, 0.3);
  EXPECT_EQ(scene.stops[0].gap, 1.05e-3);
  EXPECT_EQ(scene.stops[0].side, Side::kBelow);
  EXPECT_EQ(scene.stops[0].restitution, std::vector<double>{0.8});
  EXPECT_EQ(scene.stops[0].impulse, Impulse::kCollocation);
  EXPECT_EQ(read_scene(kFolder / "03_wagg_fig4.toml").stops[0].gap, 10.05e-3);
}

// 07 is 02 between two stops.
TEST(ShippedScene, TwoStopsHoldTheSameBeam) {
  Scene one = read_scene(kFolder / "02_wagg_momentum.toml");
  Scene two = read_scene(kFolder / "07_two_stops.toml");
  ASSERT_EQ(two.stops.size(), 2u);
  for (const SceneStop& stop : two.stops) {
    EXPECT_EQ(stop.position, 0.3);
    EXPECT_EQ(stop.gap, 1.05e-3);
    EXPECT_EQ(stop.impulse, Impulse::kMomentum);
  }
  EXPECT_NE(two.stops[0].side, two.stops[1].side);
  for (Scene* scene : {&one, &two}) {
    scene->title.clear();
    scene->stops.clear();
  }
  expect_equal(one, two);
}

// 09 is 02 with fewer modes, a softer stop and another frequency.
TEST(ShippedScene, SoftStopHoldsTheSameBeam) {
  Scene hard = read_scene(kFolder / "02_wagg_momentum.toml",
                          {"beam.modes=2", "stop.restitution=0.3", "forcing.frequency=37.6"});
  Scene soft = read_scene(kFolder / "09_soft_stop_two_modes.toml");
  for (Scene* scene : {&hard, &soft}) scene->title.clear();
  expect_equal(hard, soft);
}

// Falls from rest, then a flight of 2 v/g after every impact, v shrinking by r each time:
// sqrt(2 h/g) (1 + r)/(1 - r) is the time that the scene's words name.
TEST(ShippedScene, BouncingBallRestsAfterTheTimeItNames) {
  const Scene scene = read_scene(kFolder / "06_bouncing_ball.toml");
  EXPECT_EQ(scene.modal()->frequencies, std::vector<double>{0.0});
  EXPECT_FALSE(scene.damping || scene.forcing || scene.initial);
  ASSERT_EQ(scene.stops.size(), 1u);
  const double r = scene.stops[0].restitution[0];
  const double fall = std::sqrt(2.0 * scene.stops[0].gap / scene.gravity->acceleration);
  EXPECT_NEAR(fall * (1.0 + r) / (1.0 - r), 4.0637127688715781, 1e-14);
}

// At its stop the spring pushes with 0.2, the load pulls with up to 0.3 away from it.
TEST(ShippedScene, PreloadedOscillatorLiftsOff) {
  const Scene scene = read_scene(kFolder / "08_preloaded_oscillator.toml");
  ASSERT_EQ(scene.stops.size(), 1u);
  EXPECT_FALSE(scene.initial.has_value());
  EXPECT_EQ(scene.modal()->frequencies, std::vector<double>{1.0});
  EXPECT_LT(scene.stops[0].gap, 0.0);
  EXPECT_GT(scene.forcing->amplitude, -scene.stops[0].gap);
}

// 10 is the beam of 02 with fewer modes and no forcing, above two supports.
TEST(ShippedScene, SupportsCarryTheSameBeam) {
  const Scene one = read_scene(kFolder / "02_wagg_momentum.toml", {"beam.modes=2"});
  const Scene two = read_scene(kFolder / "10_two_supports.toml");
  ASSERT_NE(two.beam(), nullptr);
  EXPECT_FALSE(two.forcing);
  Scene beam = one, supported = two;
  for (Scene* scene : {&beam, &supported}) {
    scene->title.clear();
    scene->stops.clear();
    scene->forcing.reset();
    scene->gravity.reset();
  }
  expect_equal(beam, supported);
}

// 12 is 04, and 13 and 14 are 02, at a stop that gives way.
TEST(ShippedScene, CompliantStopsHoldTheSameStructures) {
  const auto expect = [](const char* rigid_name, const char* compliant_name, double exponent) {
    Scene rigid = read_scene(kFolder / rigid_name),
          compliant = read_scene(kFolder / compliant_name);
    ASSERT_EQ(compliant.stops.size(), 1u);
    ASSERT_TRUE(compliant.stops[0].spring);
    EXPECT_TRUE(compliant.stops[0].spring->damping);
    EXPECT_EQ(compliant.stops[0].spring->exponent, exponent);
    EXPECT_EQ(compliant.stops[0].gap, rigid.stops[0].gap);
    EXPECT_EQ(compliant.stops[0].side, rigid.stops[0].side);
    EXPECT_EQ(compliant.stops[0].position, rigid.stops[0].position);
    EXPECT_EQ(compliant.stops[0].spring->damping->restitution, rigid.stops[0].restitution[0]);
    for (Scene* scene : {&rigid, &compliant}) {
      scene->title.clear();
      scene->stops.clear();
    }
    expect_equal(rigid, compliant);
  };
  expect("04_impact_oscillator.toml", "12_spring_dashpot_oscillator.toml", 1.0);
  expect("02_wagg_momentum.toml", "13_beam_on_a_spring.toml", 1.0);
  expect("02_wagg_momentum.toml", "14_beam_against_a_ball.toml", 1.5);
}

// A body of 0.1 kg at 0.1 m/s.
TEST(ShippedScene, BodyMeetsAHertzContact) {
  const Scene scene = read_scene(kFolder / "11_body_meets_stop.toml");
  const double shape = scene.stops.at(0).shape.at(0);
  EXPECT_NEAR(1.0 / (shape * shape), 0.1, 1e-16);
  EXPECT_NEAR(shape * scene.initial->qdot.at(0), 0.1, 1e-16);
  EXPECT_EQ(scene.stops[0].spring->exponent, 1.5);
}

// The formulas that the scene's words name.
TEST(ShippedScene, SphereOnABeamHasItsModes) {
  const Scene scene = read_scene(kFolder / "15_sphere_on_a_beam.toml");
  const double length = 0.1535, line = 7850.0 * 1e-4, pi = std::acos(-1.0);
  const double rigidity = 206e9 * 1e-8 / 12.0, mass = 4.0 / 3.0 * pi * 1e-6 * 7850.0;
  ASSERT_EQ(scene.modes(), 26);
  const std::vector<double>& shape = scene.stops.at(0).shape;
  EXPECT_EQ(scene.modal()->frequencies[0], 0.0);
  EXPECT_NEAR(shape[0] * shape[0] * mass, 1.0, 1e-14);
  EXPECT_NEAR(shape[0] * scene.initial->qdot[0], 0.01, 1e-16);
  for (std::size_t j = 1; j < 26; ++j) {
    const double n = 2.0 * static_cast<double>(j) - 1.0, wave = n * pi / length;
    EXPECT_NEAR(scene.modal()->frequencies[j] / (wave * wave * std::sqrt(rigidity / line)), 1.0,
                1e-14);
    EXPECT_NEAR(shape[j] / (-std::sqrt(2.0 / (line * length)) * std::sin(0.5 * n * pi)), 1.0,
                1e-14);
    EXPECT_EQ(scene.initial->qdot[j], 0.0);
  }
  // Two thirds of the modulus in plane strain, times the root of the radius.
  EXPECT_NEAR(scene.stops[0].spring->stiffness / (2.0 / 3.0 * 206e9 / 0.91 * 0.1), 1.0, 1e-13);
}

// Every table and choice, with numbers that need all 17 digits.
TEST(ShippedScene, WritingKeepsEveryKindOfScene) {
  const std::string beam =
      "title = \"a \\\"quoted\\\" \\\\ title\\n\\u0001 \\u00e9\"\n"
      "[beam]\nlength = 0.30000000000000004\nyoungs_modulus = 205000000001\n"
      "second_moment = 2.2250738585072014e-30\ndensity = 6.703903964971299e153\n"
      "area = 4.9e-324\nmodes = 2\npoints = [0.1, 0.2]\ndiscretisation = \"collocation\"\n";
  const std::string modal = "[modal]\nfrequencies = [0.0, 0.1]\ninertia = [1, 2]\n";
  const std::vector<std::string> texts = {
      beam +
          "[damping]\nrayleigh = { mass = 0.1, stiffness = 1e-6 }\n"
          "[forcing]\nkind = \"distributed\"\namplitude = -1\nfrequency = 2\nphase = 0.7\n"
          "[[stop]]\nposition = 0.2\ngap = -1e-3\nrestitution = 1\nimpulse = \"collocation\"\n"
          "[initial]\nq = [1, 2]\nqdot = [3, 4]\n[solver]\nflow = \"exact\"\ntolerance = 1e-7\n",
      beam,
      modal +
          "damping_ratios = [0.0, 2.0]\nparticipation = [-0.0, 1e23]\n"
          "[forcing]\namplitude = 1\nfrequency = 2\n",
      modal +
          "[damping]\nratios = [0.1, 0.2]\n"
          "[forcing]\nkind = \"base\"\namplitude = 1\nfrequency = 2\n"
          "[[stop]]\nshape = [0.5, -0.5]\ngap = 0\nrestitution = 0\nside = \"below\"\n",
      modal +
          "[gravity]\nacceleration = -9.8066500000000012\n"
          "[[stop]]\nshape = [0.5, 0.5]\ngap = 0.1\nrestitution = [1, 0.1, -4.9e-324, 1e300]\n"
          "[[stop]]\nshape = [1, 0]\ngap = 0.2\nrestitution = [0.3]\nside = \"below\"\n"
          "[[stop]]\nshape = [0, 1]\ngap = 0.2\nrestitution = 0.7\n",
      beam +
          "[gravity]\nacceleration = 1\n"
          "[[stop]]\nposition = 0.1\ngap = 1\nrestitution = 1\nimpulse = \"collocation\"\n"
          "[[stop]]\nposition = 0.2\ngap = 1\nrestitution = 1\nimpulse = \"collocation\"\n"};
  for (const std::string& text : texts) {
    SCOPED_TRACE(text);
    const Scene scene = parse_scene(text, "text");
    expect_equal(scene, parse_scene(write_scene(scene), "written"));
  }
}

}  // namespace
}  // namespace graze
