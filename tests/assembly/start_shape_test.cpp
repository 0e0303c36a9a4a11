// Starts of beams, strings and bars in a shape through points, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/scene/reader.hpp"
#include "graze/scene/start_coordinate.hpp"
#include "graze/structure/modal_model.hpp"

namespace graze {
namespace {

State start_of(const std::string& text) {
  const Scene scene = parse_scene(text, "start");
  return initial_state(scene, assemble(scene));
}

// A string of length L plucked by h at a: u is the sum of
// 2 h L^2/(j^2 pi^2 a (L - a)) sin(j pi a/L) sin(j pi x/L), and q_j its part times sqrt(mu L/2).
TEST(StartShape, OfAPluckedStringIsItsFourierSeries) {
  const double length = 0.8, mu = 0.006, a = 0.3, h = 2e-3;
  const State start = start_of(
      "[string]\nlength = 0.8\ntension = 40.0\nmass_per_length = 0.006\nmodes = 40\n"
      "[initial]\npositions = [0.0, 0.3, 0.8]\ndisplacement = [0.0, \"2 mm\", 0.0]\n");
  for (int j = 1; j <= 40; ++j) {
    const double part = 2.0 * h * length * length / (j * j * M_PI * M_PI * a * (length - a)) *
                        std::sin(j * M_PI * a / length);
    EXPECT_NEAR(start.q[j - 1], part * std::sqrt(0.5 * mu * length), 1e-15 * h) << "mode " << j;
  }
  EXPECT_EQ(start.qdot, Vector::Zero(40));
}

// integral of x phi = phi''(0)/beta^4 of a clamped-free beam, phi''(0) = 2 beta^2/sqrt(rho A L).
TEST(StartShape, OfACantileverThatTurnsAtItsClampHasAClosedForm) {
  const State start = start_of(
      "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\n"
      "density = 8500.0\narea = 12.4e-6\nmodes = 20\n"
      "[initial]\npositions = [0.0, 0.3]\nvelocity = [0.0, 1.5]\n");
  const Scene scene = parse_scene(
      "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\n"
      "density = 8500.0\narea = 12.4e-6\nmodes = 20\n",
      "beam");
  const double mass = 8500.0 * 12.4e-6, stiffness = 205e9 * 24.4e-14;
  const Vector omega = modal_model(scene).omega;
  for (int j = 0; j < 20; ++j) {
    const double beta = std::sqrt(omega[j] * std::sqrt(mass / stiffness));
    const double closed = 1.5 / 0.3 * std::sqrt(mass / 0.3) * 2.0 / (beta * beta);
    EXPECT_NEAR(start.qdot[j], closed, 1e-14 * start.qdot[0]) << "mode " << j + 1;
  }
}

// A shape that is a rigid motion is that mode alone, of a stepped beam with a point mass that has a
// rotary inertia of its own, and of a tapered one: it is M-orthogonal to all others.
TEST(StartShape, OfARigidTurnIsTheRigidModeAlone) {
  const std::string beam =
      "[beam]\nlength = 1.0\nyoungs_modulus = 70e9\ndensity = 2700.0\n"
      "ends = [\"pinned\", \"free\"]\nmodes = 12\n";
  const std::string start = "[initial]\npositions = [0.0, 1.0]\ndisplacement = [0.0, 0.01]\n";
  for (const std::string more :
       {"[[beam.piece]]\nto = 0.4\nsecond_moment = 2e-10\narea = 8e-5\n[[beam.piece]]\n"
        "second_moment = 1e-10\narea = 4e-5\n[[beam.mass]]\nposition = 0.7\nmass = 0.2\n"
        "inertia = 1e-3\n",
        "section = { shape = \"rectangle\", width = 0.02, height = [0.002, 0.001] }\n"}) {
    SCOPED_TRACE(more);
    const State state = start_of(beam + more + start);
    EXPECT_GT(state.q[0], 1e-4);
    for (int j = 1; j < 12; ++j)
      EXPECT_NEAR(state.q[j], 0.0, 1e-11 * state.q[0]) << "mode " << j + 1;
  }
}

TEST(StartShape, OfOneSpeedIsThatOfTheWholeStructure) {
  const std::string bar =
      "[bar]\nlength = 2.0\nyoungs_modulus = 200e9\ndensity = 7800.0\narea = 1e-4\n"
      "ends = [\"free\", \"free\"]\nmodes = 10\n";
  const State places = start_of(bar + "[initial]\npositions = [1.0]\nvelocity = [3.0]\n");
  const State whole = start_of(bar + "[initial]\nspeed = 3.0\n");
  EXPECT_LE((places.qdot - whole.qdot).lpNorm<Eigen::Infinity>(), 1e-14 * whole.qdot[0]);
}

TEST(StartShape, ItsValuesAreParameters) {
  const Scene scene = parse_scene(
      "[string]\nlength = 1.0\ntension = 1.0\nmass_per_length = 1.0\nmodes = 3\n"
      "[initial]\npositions = [0.0, 0.5, 1.0]\ndisplacement = [0.0, 1e-3, 0.0]\n",
      "string");
  const Scene twice = with_number(scene, "initial.displacement.2", 2e-3);
  const Vector once = initial_state(scene, assemble(scene)).q;
  EXPECT_LE((initial_state(twice, assemble(twice)).q - 2.0 * once).norm(), 1e-18);
}

// Without a stop or a probe the places where forces act are looked at.
TEST(Probes, StandAtTheLoadsOfASceneWithoutStops) {
  const std::string bar =
      "[bar]\nlength = 2.0\nyoungs_modulus = 200e9\ndensity = 7800.0\narea = 1e-4\nmodes = 4\n"
      "[forcing]\nposition = 2.0\namplitude = 1.0\nfrequency = 10.0\n"
      "[[load]]\nposition = 1.5\nforce = 3.0\n";
  const Scene scene = parse_scene(bar, "bar");
  ASSERT_EQ(scene.probes.size(), 2u);
  EXPECT_EQ(scene.probes[0].position, 2.0);
  EXPECT_EQ(scene.probes[1].position, 1.5);
  EXPECT_TRUE(parse_scene(bar + "[[stop]]\nposition = 2.0\ngap = 1.0\nrestitution = 0.5\n", "bar")
                  .probes.empty());
  EXPECT_EQ(parse_scene(bar + "[[probe]]\nposition = 1.0\n", "bar").probes.size(), 1u);
}

}  // namespace
}  // namespace graze
