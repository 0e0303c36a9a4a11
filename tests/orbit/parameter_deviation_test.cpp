// The derivative of a segment by a parameter of the scene, through chatter, sticking and release,
// against central differences of the motion.
#include "graze/orbit/problem/detail/parameter_deviation.hpp"
#include "graze/assembly/initial_state.hpp"

#include <gtest/gtest.h>

#include "graze/assembly/system_family.hpp"
#include "graze/orbit/problem/detail/trajectory_segment.hpp"
#include "graze/system/scale.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

// Chatters followed so far that closing them moves nothing by more than the differences see.
SegmentOptions segment_options(const System& system) {
  SegmentOptions options;
  options.closure_speed =
      1e-7 * speed_scale(system, {Vector::Zero(system.modes()), Vector::Zero(system.modes())});
  return options;
}

Vector state_vector(const State& state) {
  Vector x(2 * state.q.size());
  x << state.q, state.qdot;
  return x;
}

MotionState<double> started(const System& system, const State& start) {
  return Motion<double>(system, {}, start.q, start.qdot).state();
}

Vector end_of(const System& system, const State& start, int periods) {
  const TrajectorySegment segment =
      pass(system, started(system, start), {periods, 0.0}, segment_options(system));
  EXPECT_EQ(segment.failure, "");
  return state_vector({segment.end.q, segment.end.qdot});
}

// At least one stuck phase ends within the segment, so that its release is passed too.
void expect_derivative(const Scene& scene, const std::string& parameter, int periods,
                       double relative_step = 1e-5) {
  SCOPED_TRACE(scene.title + ", " + parameter);
  const SystemFamily family(scene, parameter);
  const double value = family.value();
  const System system = *family.at(value), tangent = *family.tangent_at(value);
  const State start = initial_state(scene, system);
  const State rest{Vector::Zero(system.modes()), Vector::Zero(system.modes())};
  ParameterDeviation deviation(system, tangent, rest);
  const TrajectorySegment segment = pass(system, started(system, start), {periods, 0.0},
                                         segment_options(system), nullptr, &deviation);
  ASSERT_EQ(segment.failure, "");
  ASSERT_FALSE(segment.sticking.empty());
  EXPECT_FALSE(segment.sticking.front().to_end);
  EXPECT_GE(segment.impacts.size(), 3u);
  const double step = relative_step * (value == 0.0 ? 1.0 : value);
  const Vector expected = support::central_difference(
      [&](double p) { return end_of(*family.at(p), start, periods); }, value, step);
  const Vector found = state_vector(deviation.value());
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 2e-7 * expected.cwiseAbs().maxCoeff())
      << "found    " << found.transpose() << "\nexpected " << expected.transpose();
}

Scene sticking(const std::string& name, const std::vector<std::string>& settings = {}) {
  return support::reference_scene("sticking/" + name, settings);
}

TEST(ParameterDeviation, OfForcingGapAndRestitution) {
  for (const char* name : {"rayl3", "gravity2", "ratio2"})
    for (const char* parameter :
         {"forcing.frequency", "forcing.amplitude", "stop.gap", "stop.restitution"})
      expect_derivative(sticking(name), parameter, 2);
}

TEST(ParameterDeviation, OfTheStructure) {
  // Frequencies, damping and load move the held motion's matrices.
  expect_derivative(sticking("rayl3"), "damping.rayleigh.mass", 2);
  expect_derivative(sticking("rayl3"), "damping.rayleigh.stiffness", 2);
  expect_derivative(sticking("gravity2"), "gravity.acceleration", 2);
}

// Contact rows and directions move too.
TEST(ParameterDeviation, OfABeamUnderBothLaws) {
  for (const char* law : {"momentum", "collocation"}) {
    const Scene scene =
        sticking("beam2", {"forcing.frequency=24", "stop.restitution=0.2", "damping.viscous=0.05",
                           "stop.impulse=\"" + std::string(law) + "\""});
    for (const char* parameter : {"beam.area", "forcing.frequency"})
      expect_derivative(scene, parameter, 4);
  }
  const Scene scene = sticking("beam2", {"forcing.frequency=24", "stop.restitution=0.2",
                                         "damping.viscous=0.05", "stop.position=0.28"});
  for (const char* parameter : {"beam.length", "stop.position"})
    expect_derivative(scene, parameter, 4);
}

// Impacts on one stop while another is closed, both closed, unequal damping.
TEST(ParameterDeviation, OfTwoStops) {
  for (const char* parameter : {"stop.1.gap", "stop.2.gap", "stop.1.restitution",
                                "stop.2.restitution", "forcing.frequency"})
    expect_derivative(sticking("two_stops3"), parameter, 2);
}

}  // namespace
}  // namespace graze
