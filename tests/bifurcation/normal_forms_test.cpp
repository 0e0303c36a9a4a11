// Normal forms of folds and doublings of orbits, against multipliers along the branches beside
// them; of tori, against simulated motions on them.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// The slope at zero of the polynomial without a constant through places and values, of degree 4.
double slope_at_zero(const std::vector<double>& at, const std::vector<double>& of) {
  constexpr Eigen::Index kDegree = 4;
  const double unit = std::abs(*std::max_element(
      at.begin(), at.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  Matrix squares = Matrix::Zero(kDegree, kDegree);
  Vector moments = Vector::Zero(kDegree);
  for (std::size_t i = 0; i < at.size(); ++i) {
    Vector powers(kDegree);
    for (Eigen::Index k = 0; k < kDegree; ++k)
      powers[k] = std::pow(at[i] / unit, static_cast<double>(k + 1));
    squares += powers * powers.transpose();
    moments += of[i] * powers;
  }
  return PivotedLu<double>(squares).solve(moments)[0] / unit;
}

// The real multiplier nearest to 1.
double critical_multiplier(const OrbitBranchPoint& point) {
  double nearest = 1e9;
  for (const Eigenvalue& one : point.orbit.multipliers)
    if (std::abs(one.value.imag()) == 0.0 &&
        std::abs(one.value.real() - 1.0) < std::abs(nearest - 1.0))
      nearest = one.value.real();
  return nearest;
}

BranchOptions around(double value, double reach) {
  BranchOptions options;
  options.from = value - reach;
  options.to = value + reach;
  options.max_step = reach / 30.0;
  options.start_values = 2;
  options.finder.from_random = false;
  return options;
}

// The phase's part of the critical vector of a (1, 1) orbit, |q| = 1 in its unknowns.
Complex part_of_phase(const SystemFamily& family, const MotionScale& scale,
                      const SpecialPoint& point) {
  const System system = *family.at(point.at.value);
  const ShootingLinearisation here =
      ShootingProblem({1, {0}}, scale).linearise(system, point.solution.u, {});
  const Eigen::MatrixXcd critical =
      here.jacobian.cast<Complex>() + (*point.multiplier - 1.0) * here.closing.cast<Complex>();
  const Eigen::JacobiSVD<Eigen::MatrixXcd> factors(critical, Eigen::ComputeFullV);
  return factors.matrixV().col(critical.cols() - 1)[0];
}

// On a doubled orbit at p a multiplier is 1 - 4 b (p - p0)/opening, and its two phases are 2 x q
// apart.
void expect_doubling(const SystemFamily& family, const MotionScale& scale,
                     const SpecialPoint& point) {
  const double expected = -4.0 * point.normal->coefficient / point.normal->opening;
  const double reach = 0.03 / std::abs(expected);  // within which the multiplier is near 1
  BranchOptions options = around(point.at.value, reach);
  options.follow_depth = 1;
  const OrbitBranches traced = trace_orbits(family, options);
  const auto doubled =
      std::find_if(traced.branches.begin(), traced.branches.end(),
                   [](const OrbitBranch& branch) { return branch.origin.starts_with("PD"); });
  ASSERT_NE(doubled, traced.branches.end());
  std::vector<double> at, of, squares;
  for (const OrbitBranchPoint& one : doubled->points)
    if (std::abs(one.value - point.at.value) > 1e-3 * reach) {
      at.push_back(one.value - point.at.value);
      of.push_back(critical_multiplier(one) - 1.0);
      EXPECT_EQ(at.back() > 0.0, point.normal->opening > 0.0);
      if (one.orbit.impacts.size() != 2 || one.orbit.section) continue;
      const double apart = std::remainder(one.orbit.impacts[1].phase - one.orbit.impacts[0].phase,
                                          2.0 * std::numbers::pi);
      squares.push_back(apart * apart);
    }
  ASSERT_GT(at.size(), 8u);
  EXPECT_NEAR(slope_at_zero(at, of), expected, 1e-4 * std::abs(expected));
  if (squares.size() != at.size()) return;
  const double part = std::abs(part_of_phase(family, scale, point));
  EXPECT_NEAR(slope_at_zero(at, squares) * point.normal->opening, 4.0 * part * part,
              1e-4 * 4.0 * part * part);
}

// Beside a fold the multiplier is 1 + 2 a x at p0 + opening x^2.
void expect_fold(const SystemFamily& family, const SpecialPoint& point) {
  const double expected =
      2.0 * std::abs(point.normal->coefficient) / std::sqrt(std::abs(point.normal->opening));
  const double reach = std::pow(0.007 / expected, 2);
  const OrbitBranches traced = trace_orbits(family, around(point.at.value, reach));
  for (const OrbitBranch& branch : traced.branches) {
    const auto fold = std::find_if(branch.special.begin(), branch.special.end(),
                                   [](const auto& one) { return one.kind == SpecialKind::kFold; });
    if (fold == branch.special.end()) continue;
    std::vector<double> at, of;
    bool behind = false;
    for (const OrbitBranchPoint& one : branch.points) {
      const double distance = one.value - point.at.value;
      if (std::abs(distance) < 1e-4 * reach) {
        behind = true;
        continue;
      }
      EXPECT_EQ(distance > 0.0, point.normal->opening > 0.0);
      at.push_back((behind ? 1.0 : -1.0) * std::sqrt(std::abs(distance)));
      of.push_back(critical_multiplier(one) - 1.0);
    }
    ASSERT_GT(at.size(), 8u);
    EXPECT_NEAR(std::abs(slope_at_zero(at, of)), expected, 1e-4 * expected);
    return;
  }
  ADD_FAILURE() << "no fold";
}

// The mean square deviation of the phase of the impacts that a motion beside a (1, 1) orbit settles
// on, which takes some periods.
double spread(const SystemFamily& family, double value, const OrbitImpact& impact, int settling) {
  const SystemFamily from_impact(with_parameter(family.scene(), "forcing.phase", impact.phase),
                                 family.parameter());
  const System system = *from_impact.at(value);
  SimulationOptions options;
  options.periods = 2 * settling;
  double sum = 0.0, squares = 0.0, count = 0.0;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (event.kind != EventKind::kImpact || event.period_index < settling) return;
    const double off = std::remainder(*event.phase - impact.phase, 2.0 * std::numbers::pi);
    sum += off;
    squares += off * off;
    ++count;
  };
  simulate(system, after_impact(system.stops[0], impact.before), options, listeners);
  return (squares - sum * sum / count) / count;
}

// On the torus the phase is z q + its conjugate, |z|^2 = (p - p0)/opening.
void expect_torus(const SystemFamily& family, const MotionScale& scale, const SpecialPoint& point) {
  const double share = 2.0 * std::norm(part_of_phase(family, scale, point));
  const auto at_growth = [&](double growth) {
    const double square = growth / -point.normal->coefficient;  // |z|^2
    return spread(family, point.at.value + point.normal->opening * square,
                  point.at.orbit.impacts[0], static_cast<int>(20.0 / growth)) /
           (square * share);
  };
  constexpr double kGrowth = 2e-4;
  EXPECT_NEAR(2.0 * at_growth(kGrowth) - at_growth(2.0 * kGrowth), 1.0, 2e-3);
}

struct FormCase {
  std::string scene, parameter;
  double from, to;
};

std::string impact_oscillator(double ratio, double gap, double restitution) {
  return fmt::format(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [{}]\nparticipation = [1.0]\n"
      "[forcing]\namplitude = 1.0\nfrequency = 2.8\n[[stop]]\nshape = [1.0]\ngap = {}\n"
      "restitution = {}\n",
      ratio, gap, restitution);
}

std::string two_modes(double gap) {
  return fmt::format(
      "[modal]\nfrequencies = [1.0, 2.6]\ndamping_ratios = [0.005, 0.005]\n"
      "participation = [1.0, 0.6]\n[forcing]\namplitude = 1.0\nfrequency = 2.8\n"
      "[[stop]]\nshape = [1.0, 0.8]\ngap = {}\nrestitution = 0.9\n",
      gap);
}

OrbitBranches with_normal_forms(const SystemFamily& family, double from, double to) {
  BranchOptions options;
  options.from = from;
  options.to = to;
  options.start_values = 4;
  options.finder.from_random = false;
  options.normal_forms = true;
  return trace_orbits(family, options);
}

TEST(NormalForms, OfToriAreTheirSizes) {
  int tori = 0;
  for (const double gap : {0.1, 0.12, 0.15}) {
    const SystemFamily family(parse_scene(two_modes(gap), "two modes"), "forcing.frequency");
    const OrbitBranches traced = with_normal_forms(family, 1.5, 2.5);
    for (const OrbitBranch& branch : traced.branches)
      for (const SpecialPoint& special : branch.special) {
        if (special.kind != SpecialKind::kTorus) continue;
        SCOPED_TRACE(fmt::format("{} {}", gap, special.id));
        ASSERT_TRUE(special.normal);
        // Weak ones are wide, beyond what the normal form says; subcritical ones are unstable.
        if (special.normal->coefficient > -0.05 || special.at.unstable_multipliers > 0) continue;
        expect_torus(family, traced.scale, special);
        ++tori;
      }
  }
  EXPECT_GE(tori, 3);
}

TEST(NormalForms, SayWhatBranchesBesideThemDo) {
  std::vector<FormCase> cases;
  for (const double restitution : {0.6, 0.7, 0.8, 0.9})
    for (const double gap : {-0.05, 0.0, 0.1})
      cases.push_back({impact_oscillator(0.05, gap, restitution), "forcing.frequency", 2.0, 3.3});
  for (const double gap : {0.35, 0.4, 0.45, 0.5})
    cases.push_back({impact_oscillator(0.05, gap, 0.8), "forcing.frequency", 1.7, 2.2});
  const std::string sprung =
      "[lumped]\nmasses = [1]\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 1\ndamping = 0.05\n"
      "[forcing]\nmass = 1\nfrequency = 1.2\namplitude = ";
  for (const double amplitude : {0.015, 0.018, 0.021, 0.024})
    cases.push_back({sprung + fmt::format("{}\n", amplitude) +
                         "[[stop]]\nmass = 1\ngap = 0.1\n[stop.spring]\nstiffness = 100\n",
                     "forcing.frequency", 1.2, 1.65});
  cases.push_back({two_modes(0.1), "forcing.frequency", 2.0, 4.0});  // one has slow impacts
  int folds = 0, doublings = 0;
  for (const FormCase& one : cases) {
    SCOPED_TRACE(one.scene);
    const SystemFamily family(parse_scene(one.scene, "oscillator"), one.parameter);
    const OrbitBranches traced = with_normal_forms(family, one.from, one.to);
    for (const OrbitBranch& branch : traced.branches)
      for (const SpecialPoint& special : branch.special) {
        if (special.kind != SpecialKind::kFold && special.kind != SpecialKind::kPeriodDoubling)
          continue;
        SCOPED_TRACE(special.id);
        ASSERT_TRUE(special.normal);
        const bool is_fold = special.kind == SpecialKind::kFold;
        if (is_fold)
          expect_fold(family, special);
        else
          expect_doubling(family, traced.scale, special);
        ++(is_fold ? folds : doublings);
      }
  }
  EXPECT_GE(folds, 6);
  EXPECT_GE(folds + doublings, 20);
}

// Beside a grazing of an elastic stop only short distances are within one motion. The doubled
// orbits lie below and are stable, at every gap.
TEST(NormalForms, AreSettledBesideShortContacts) {
  for (const double gap : {0.2, 0.21, 0.22}) {
    const SystemFamily family(
        parse_scene(fmt::format("[lumped]\nmasses = [1]\n[[lumped.spring]]\nbetween = [0, 1]\n"
                                "stiffness = 1\ndamping = 0.05\n[forcing]\nmass = 1\n"
                                "amplitude = 1\nfrequency = 1.5\n[[stop]]\nmass = 1\ngap = {}\n"
                                "[stop.spring]\nstiffness = 20\n",
                                gap),
                    "oscillator"),
        "forcing.frequency");
    const OrbitBranches traced = with_normal_forms(family, 2.3, 2.6);
    std::vector<const SpecialPoint*> doublings;
    for (const OrbitBranch& branch : traced.branches)
      for (const SpecialPoint& special : branch.special)
        if (special.kind == SpecialKind::kPeriodDoubling) doublings.push_back(&special);
    ASSERT_EQ(doublings.size(), 1u);
    ASSERT_TRUE(doublings[0]->normal);
    EXPECT_GT(doublings[0]->normal->coefficient, 1e6);
    EXPECT_LT(doublings[0]->normal->opening, 0.0);
    if (gap > 0.2) continue;
    BranchOptions options;
    options.from = 2.3;
    options.to = 2.6;
    options.max_step = 0.002;
    options.follow_depth = 1;
    options.finder.from_random = false;
    int below = 0;  // nearest to where the branch begins; it folds back soon
    for (const OrbitBranch& branch : trace_orbits(family, options).branches) {
      if (!branch.origin.starts_with("PD") || branch.points.size() < 3) continue;
      const auto is_there = [&](const OrbitBranchPoint& point) {
        return std::abs(point.value - doublings[0]->at.value) < 1e-13;
      };
      const bool at_front = is_there(branch.points.front());
      if (!at_front && !is_there(branch.points.back())) continue;
      const OrbitBranchPoint& next =
          at_front ? branch.points[1] : branch.points[branch.points.size() - 2];
      EXPECT_LT(next.value, doublings[0]->at.value);
      EXPECT_EQ(next.orbit.stable, true);
      ++below;
    }
    EXPECT_EQ(below, 1);
  }
}

// Where the normal form of the tori changes its sign on slices beside the point.
TEST(NormalForms, VanishOnLoci) {
  const Scene scene = parse_scene(two_modes(0.1), "two modes");
  LociOptions options;
  options.branches.from = 2.0;
  options.branches.to = 2.25;
  options.branches.finder.from_random = false;
  options.branches.normal_forms = true;
  options.second_from = 0.03;
  options.second_to = 0.14;
  options.kinds = {OrbitLocusKind::kPeriodDoubling, OrbitLocusKind::kTorus};
  options.slices = 3;
  std::vector<OrbitLocusSpecial> found;
  for (const OrbitLocus& locus : trace_loci(scene, "forcing.frequency", "stop.gap", options).loci)
    for (const OrbitLocusSpecial& special : locus.special)
      if (special.label == "GNS" || special.label == "GPD") found.push_back(special);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].label, "GNS");
  const auto coefficient_at = [&](double gap) {
    const SystemFamily family(with_parameter(scene, "stop.gap", gap), "forcing.frequency");
    const OrbitBranches traced =
        with_normal_forms(family, found[0].at.value - 0.01, found[0].at.value + 0.01);
    for (const OrbitBranch& branch : traced.branches)
      for (const SpecialPoint& special : branch.special)
        if (special.kind == SpecialKind::kTorus) return special.normal->coefficient;
    return std::nan("");
  };
  constexpr double kBeside = 1e-6;
  const double zero = found[0].at.second;
  const double below = coefficient_at(zero - kBeside), above = coefficient_at(zero + kBeside);
  EXPECT_LT(below * above, 0.0);
  EXPECT_NEAR(below / (below - above), 0.5, 1e-3);
}

}  // namespace
}  // namespace graze
