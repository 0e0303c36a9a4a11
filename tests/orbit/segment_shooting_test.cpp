// The equations of an orbit that sticks at its release: derivatives against central differences,
// multipliers against those of a section elsewhere in the stuck phase.
#include "graze/orbit/problem/detail/segment_shooting.hpp"

#include <gtest/gtest.h>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_family.hpp"
#include "graze/orbit/problem/detail/laid_orbit.hpp"
#include "graze/orbit/problem/detail/release.hpp"
#include "orbit/mixed_scenes.hpp"
#include "orbit/settled_sticking_orbit.hpp"

namespace graze {
namespace {

SegmentOptions options_of(const Found& found) {
  return {found.orbit.section->closure_speed, 10'000'000, {}};
}

// Chatters closed so late that the differences do not see it.
Found fine_orbit(const Scene& scene) {
  return settled_orbit(scene, 1e-8 * motion_scale(assemble(scene)).length);
}

// `step` of the differences and what they err by, where the motion itself is followed to 1e-13.
void expect_segment_derivatives(const Scene& scene, const std::string& parameter,
                                double step = 1e-7, double error = 1e-6) {
  SCOPED_TRACE(scene.title + ", " + parameter);
  const SystemFamily family(scene, parameter);
  const Found found = fine_orbit(scene);
  const std::vector<LaidOrbit> releases = layouts_of(found.system, found.orbit, options_of(found));
  ASSERT_FALSE(releases.empty());
  const SegmentShooting section(found.system, releases[0].layout, options_of(found));
  const Vector u = section.pack(found.system, releases[0].theta, releases[0].states);
  const double value = family.value();
  const System tangent = *family.tangent_at(value);
  const System* const tangents[] = {&tangent};
  const auto at = section.linearise(found.system, u, tangents);
  ASSERT_TRUE(at);
  EXPECT_EQ(at->residual.size(), section.size());
  EXPECT_LE(at->residual.cwiseAbs().maxCoeff(), 1e-11);
  const auto residual = [&](const System& system, const Vector& x) {
    return section.linearise(system, x, {})->residual;
  };
  // Either side of a solution the release comes before or after the section: second derivatives
  // jump there, so the steps are short.
  const Matrix jacobian =
      support::central_jacobian([&](const Vector& x) { return residual(found.system, x); }, u,
                                Vector::Constant(u.size(), step));
  EXPECT_LE((at->jacobian - jacobian).cwiseAbs().maxCoeff(), error * jacobian.cwiseAbs().maxCoeff())
      << at->jacobian << "\n\n"
      << jacobian;
  const Vector by_parameter = support::central_difference(
      [&](double p) { return residual(*family.at(p), u); }, value, step * value);
  EXPECT_LE((at->by_parameters.col(0) - by_parameter).cwiseAbs().maxCoeff(),
            error * by_parameter.cwiseAbs().maxCoeff())
      << at->by_parameters.transpose() << "\n"
      << by_parameter.transpose();
}

TEST(SegmentShooting, HasTheDerivativesOfItsEquations) {
  expect_segment_derivatives(sticking_case("Z2b"), "forcing.frequency");
  for (const char* parameter : {"forcing.frequency", "stop.gap", "stop.restitution"})
    expect_segment_derivatives(sticking_case("rayl3"), parameter);
  expect_segment_derivatives(sticking_case("gravity2"), "gravity.acceleration");
  // Rows that move: the coordinates must not.
  expect_segment_derivatives(sticking_case("beam2", {"forcing.frequency=24", "stop.restitution=0.2",
                                                     "damping.viscous=0.05", "stop.position=0.28"}),
                             "stop.position");
  expect_segment_derivatives(beam("collocation", 3, 44.0), "forcing.frequency");
  // Two stops closed, one of them let go.
  expect_segment_derivatives(sticking_case("two_stops3"), "stop.1.gap");
  expect_segment_derivatives(sticking_case("two_stops3"), "stop.2.gap");
}

// Whether the structure meets a compliant stop while another one holds it.
bool is_mixed(const Found& found) {
  const double turn = kTurn * found.orbit.period;
  const auto angle = [](const OrbitInstant& at) { return kTurn * at.period_index + at.phase; };
  for (const StickingPhase& sticking : found.orbit.sticking)
    for (const OrbitImpact& impact : found.orbit.impacts) {
      if (!impact.contact) continue;
      const double frequency = found.system.forcing()->frequency;
      const double begins = angle({impact.period_index, impact.phase}) - angle(sticking.from);
      const double since = begins - turn * std::floor(begins / turn);
      if (since < frequency * sticking.duration ||
          since + frequency * impact.contact->duration > turn)
        return true;
    }
  return false;
}

TEST(SegmentShooting, HasItsDerivativesWhereSpringsAreCompressedWhileAStopHolds) {
  const Scene dashpot = support::held_against_dashpot(), ball = support::held_against_ball(),
              beam = support::held_beam();
  for (const Scene& scene : {dashpot, ball, beam})
    EXPECT_TRUE(is_mixed(settled_orbit(scene))) << scene.title;
  for (const char* parameter : {"stop.1.gap", "stop.2.gap", "stop.2.spring.stiffness"})
    expect_segment_derivatives(dashpot, parameter, 1e-6, 1e-5);
  for (const char* parameter : {"forcing.frequency", "stop.1.restitution"})
    expect_segment_derivatives(ball, parameter, 1e-6, 1e-5);
  // Rows and directions that move, and what projects with them.
  expect_segment_derivatives(beam, "stop.2.position", 1e-6, 1e-5);
}

// The section of an orbit that sticks lies in the middle of the stuck phase, this one at its end.
TEST(SegmentShooting, HasTheMultipliersOfAnySection) {
  for (const Scene& scene :
       {sticking_case("Z2b"), sticking_case("rayl3"), sticking_case("gravity2"),
        sticking_case("two_stops3"), beam("momentum", 3, 24.0), beam("collocation", 3, 44.0)}) {
    SCOPED_TRACE(scene.title);
    const Found found = settled_orbit(scene);
    const LaidOrbit at = layouts_of(found.system, found.orbit, options_of(found)).at(0);
    const SegmentShooting section(found.system, at.layout, options_of(found));
    const Vector u = section.pack(found.system, at.theta, at.states);
    const std::vector<Eigenvalue> multipliers =
        section.multipliers(found.system, u, ErrorBounds::kGiven);
    ASSERT_EQ(multipliers.size(), found.orbit.multipliers.size());
    for (std::size_t i = 0; i < multipliers.size(); ++i)
      EXPECT_LE(std::abs(multipliers[i].value - found.orbit.multipliers[i].value), 1e-8);
    const auto back = return_of(found.system, section, u);
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->returns);
    EXPECT_EQ(back->sticking.size(), found.orbit.sticking.size());
    const auto orbit = orbit_of(found.system, section, u, {});
    ASSERT_TRUE(orbit);
    EXPECT_EQ(orbit->impacts.size(), found.orbit.impacts.size());
    EXPECT_EQ(exact_zeros(*orbit), exact_zeros(found.orbit));
  }
}

}  // namespace
}  // namespace graze
