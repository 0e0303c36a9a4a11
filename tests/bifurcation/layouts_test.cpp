// What every layout of a periodic orbit has to keep, one battery over all of them: flights from
// impact to impact, segments from one fixed phase to the next and from release to release, with all
// directions held and with some, and on springs meanwhile.
#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "branch_checks.hpp"
#include "graze/bifurcation/cut/detail/branch_boundaries.hpp"
#include "graze/bifurcation/trace/detail/orbit_problems.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/search/finder.hpp"
#include "orbit/mixed_scenes.hpp"
#include "orbit/settled_sticking_orbit.hpp"

namespace graze {
namespace {

struct LayoutCase {
  const char* name;
  Scene scene;
  const char* parameter;
  int period = 0, impacts = 0;       // to be found; 0: the motion settles on it, and sticks
  double step = 1e-6, error = 1e-6;  // of differences, and what they miss by
};

// Names tests.
void PrintTo(const LayoutCase& one, std::ostream* out) { *out << one.name; }

class Layouts : public ::testing::TestWithParam<LayoutCase> {
 protected:
  void SetUp() override {
    const LayoutCase& one = GetParam();
    const SystemFamily family(one.scene, one.parameter);
    value_ = family.value();
    system_ = *family.at(value_);
    SegmentOptions segment;
    if (one.period == 0) {
      // Chatters closed so late that differences do not see it.
      orbit_ = settled_orbit(one.scene, 1e-8 * motion_scale(system_).length).orbit;
    } else {
      FinderOptions finder;
      finder.period = one.period;
      finder.impacts = one.impacts;
      const FoundOrbits found = find_orbits(system_, initial_state(one.scene, system_), finder);
      ASSERT_FALSE(found.orbits.empty());
      orbit_ = found.orbits.front();
    }
    problems_.emplace(GetParam().scene, std::vector<std::string>{one.parameter},
                      std::vector<double>{std::abs(value_)}, motion_scale(system_), segment);
    written_ = problems_->written(orbit_, std::array{value_});
    ASSERT_FALSE(written_.empty());
  }

  const OrbitProblem& problem() const { return *written_.front().orbits->problem; }
  const Vector& u() const { return written_.front().u; }
  SolutionPoint solution() const {
    SolutionPoint point;
    point.u = u();
    point.parameter = value_;
    point.tangent = Vector::Unit(u().size() + 1, u().size());
    return point;
  }
  static double residual(const OrbitProblem& problem, const Vector& u, double value) {
    const auto at = problem.problem().evaluate(u, std::span(&value, 1));
    return at ? at->residual.cwiseAbs().maxCoeff() : std::numeric_limits<double>::infinity();
  }

  double value_ = 0.0;
  System system_;
  Orbit orbit_;
  std::optional<OrbitProblems> problems_;
  std::vector<OrbitProblems::Written> written_;
};

// However an orbit is written, it is a solution there, and the orbit of that is the orbit.
TEST_P(Layouts, WriteAnOrbitAndTellItAgain) {
  for (const OrbitProblems::Written& one : written_) {
    const OrbitProblem& problem = *one.orbits->problem;
    EXPECT_LE(residual(problem, one.u, value_), 1e-9);
    SolutionPoint there = solution();
    there.u = one.u;
    const std::optional<OrbitBranchPoint> at = problem.judge(there);
    ASSERT_TRUE(at);
    EXPECT_EQ(at->orbit.period, orbit_.period);
    EXPECT_EQ(at->orbit.sticking.size(), orbit_.sticking.size());
    EXPECT_EQ(at->orbit.stable, orbit_.stable);
    // In which order does not matter, nor how much of a chatter is told.
    const double fast = 1e-3 * motion_scale(system_).speed;
    for (const OrbitImpact& impact : orbit_.impacts) {
      if (impact.speed < fast) continue;
      const bool is_there = std::ranges::any_of(at->orbit.impacts, [&](const OrbitImpact& same) {
        return same.stop == impact.stop && turned(same.phase, impact.phase) <= 1e-6 &&
               std::abs(same.speed - impact.speed) <= 1e-6 * fast * 1e3;
      });
      EXPECT_TRUE(is_there) << impact.phase << ", " << impact.speed;
    }
  }
}

TEST_P(Layouts, HaveTheDerivativesOfTheirEquations) {
  const LayoutCase& one = GetParam();
  const ZeroProblem& zero = problem().problem();
  const auto at = zero.evaluate(u(), std::array{value_});
  ASSERT_TRUE(at);
  const auto equations = [&](const Vector& x, double value) {
    return zero.evaluate(x, std::span(&value, 1))->residual;
  };
  const Matrix jacobian =
      support::central_jacobian([&](const Vector& x) { return equations(x, value_); }, u(),
                                Vector::Constant(u().size(), one.step));
  EXPECT_LE((at->jacobian - jacobian).cwiseAbs().maxCoeff(),
            one.error * jacobian.cwiseAbs().maxCoeff());
  const Vector by_parameter = support::central_difference(
      [&](double value) { return equations(u(), value); }, value_, one.step * value_);
  EXPECT_LE((at->by_parameters.col(0) - by_parameter).cwiseAbs().maxCoeff(),
            one.error * by_parameter.cwiseAbs().maxCoeff());
}

// The equations of a motion that comes back multiplied by mu, A(mu) = dF/du + (mu - 1) closing,
// have a solution where mu is a multiplier and nowhere else.
TEST_P(Layouts, HaveTheMultipliersThatCloseTheirEquations) {
  if (!problem().has_multipliers()) return;  // all of them are zero
  const auto at = problem().problem().evaluate(u(), std::array{value_});
  ASSERT_TRUE(at);
  const std::vector<Eigenvalue> multipliers =
      problem().problem().multipliers(u(), std::array{value_}, ErrorBounds::kGiven);
  ASSERT_EQ(multipliers.size(), 2 * static_cast<std::size_t>(system_.modes()));
  const auto least = [&](Complex mu) {
    const Eigen::MatrixXcd closed = at->jacobian.cast<Complex>() + (mu - 1.0) * at->closing;
    return Eigen::JacobiSVD<Eigen::MatrixXcd>(closed).singularValues().tail(1)[0];
  };
  const double anywhere = least(Complex(0.3, 1.7));
  for (const Eigenvalue& multiplier : multipliers) {
    if (!(std::abs(multiplier.value) > 1e-3)) continue;
    EXPECT_LE(least(multiplier.value), 1e-7 * anywhere) << multiplier.value;
  }
}

// An orbit may be written from wherever its period begins.
TEST_P(Layouts, KnowTheirOrbitsAgain) {
  const std::vector<SolutionPoint> same = problem().rewritings(problem(), {}, solution());
  ASSERT_FALSE(same.empty());
  EXPECT_TRUE(std::ranges::any_of(
      same, [&](const SolutionPoint& one) { return (one.u - u()).norm() <= 1e-9; }));
  for (const SolutionPoint& one : same) EXPECT_LE(residual(problem(), one.u, value_), 1e-9);
}

// Twice round it is an orbit of twice the period with two halves that are one.
TEST_P(Layouts, SeeAnOrbitTwiceRound) {
  const LaidOrbits& twice = problems_->doubled(*written_.front().orbits);
  EXPECT_EQ(twice.problem->period(), 2 * orbit_.period);
  const SolutionPoint doubled = problem().twice_round(solution());
  EXPECT_LE(residual(*twice.problem, doubled.u, value_), 1e-9);
  EXPECT_TRUE(twice.problem->is_half(doubled));
}

INSTANTIATE_TEST_SUITE_P(
    Of, Layouts,
    ::testing::Values(
        LayoutCase{"one impact", support::shipped_scene("05_wagg_one_mode"), "forcing.frequency", 1,
                   1},
        LayoutCase{
            "four modes",
            support::shipped_scene("02_wagg_momentum", {"beam.modes=4", "forcing.frequency=60"}),
            "stop.gap", 1, 1},
        LayoutCase{"two impacts", support::shipped_scene("04_impact_oscillator"),
                   "forcing.frequency", 2, 2},
        LayoutCase{"a spring and a dashpot", support::shipped_scene("12_spring_dashpot_oscillator"),
                   "forcing.frequency", 1, 1},
        LayoutCase{"three contacts", support::shipped_scene("12_spring_dashpot_oscillator"),
                   "forcing.amplitude", 3, 3},
        LayoutCase{"one direction held", support::shipped_scene("08_preloaded_oscillator"),
                   "forcing.frequency"},
        LayoutCase{"one of two held", support::shipped_scene("09_soft_stop_two_modes"),
                   "forcing.frequency"},
        LayoutCase{"two stops closed", sticking_case("two_stops3"), "stop.1.gap"},
        LayoutCase{"held against a dashpot", support::held_against_dashpot(), "stop.2.gap", 0, 0,
                   1e-6, 1e-5}));

}  // namespace
}  // namespace graze
