// How large orbits are, against the balance of momentum over their period.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/orbit_amplitudes.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/search/settled.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// w^2 mean(q) = load - sum_i b_i J_i/T, mode by mode, of the orbit that the scene settles on.
void check_balance(const std::string& text) {
  const Scene scene = parse_scene(text, "scene");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SettleOptions settling;
  settling.closure_speed = default_closure_speed(system, start);
  const SettledMotion settled = settle(system, start, settling);
  ASSERT_GT(settled.period, 0);
  SegmentOptions segment;
  segment.closure_speed = *settling.closure_speed;
  const FollowedAnswer answer = followed_orbit(system, settled.at_start, settled.period, segment);
  ASSERT_TRUE(answer.orbit.has_value());
  std::vector<MeasuredRow> rows;
  for (int j = 0; j < system.modes(); ++j) rows.push_back({Vector::Unit(system.modes(), j), false});
  const Amplitudes found = orbit_amplitudes(system, *answer.orbit, rows);
  for (int j = 0; j < system.modes(); ++j) {
    double sum = system.omega[j] * system.omega[j] * found.rows[static_cast<std::size_t>(j)].mean;
    double size = std::abs(sum);
    for (std::size_t i = 0; i < system.stops.size(); ++i) {
      const double force = system.stops[i].row[j] * found.stops[i].impulse / found.duration;
      sum += force;
      size += std::abs(force);
    }
    // The state is known to the nearness of a settled motion, and better.
    EXPECT_NEAR(sum, 0.0, 1e-9 * size) << "mode " << j + 1;
  }
}

// The first stop holds the structure for ever; the second one is hit, and the impulse goes into
// both.
TEST(OrbitAmplitudes, CountWhatAHeldStopTakesOfAnImpact) {
  check_balance(
      "[modal]\nfrequencies = [1.0, 1.7]\ndamping_ratios = [0.1, 0.1]\n"
      "participation = [0.2, 1.0]\n[forcing]\namplitude = 1.0\nfrequency = 1.2\n"
      "[[stop]]\nshape = [1.0, 0.2]\ngap = -0.8\nrestitution = 0.3\n"
      "[[stop]]\nshape = [-0.5, 1.0]\ngap = 0.6\nrestitution = 0.5\n"
      "[initial]\nq = [-1.2, -0.5]\n");
}

// A chatter that completes, a stuck phase, a release.
TEST(OrbitAmplitudes, CountWhatAChatterLeaves) {
  check_balance(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.02]\nparticipation = [1.0]\n"
      "[forcing]\namplitude = 1.0\nfrequency = 0.25\n"
      "[[stop]]\nshape = [1.0]\ngap = 0.3\nrestitution = 0.4\n");
}

}  // namespace
}  // namespace graze
