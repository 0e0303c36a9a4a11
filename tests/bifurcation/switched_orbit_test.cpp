// Branches that have no closed form, confirmed by simulation; what special points part.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "branch_checks.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/base/angle.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/search/settled.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

using support::special_points;

OrbitBranches followed(const Scene& scene, const std::string& parameter, double from, double to,
                       int depth, int period = 1, int impacts = 1) {
  const SystemFamily family(scene, parameter);
  BranchOptions options;
  options.period = period;
  options.impacts = impacts;
  options.from = from;
  options.to = to;
  options.follow_depth = depth;
  return trace_orbits(family, options);
}

// The state at the start of a forcing period, on the orbit but for a relative push.
State pushed(const System& system, const Orbit& orbit, double push) {
  // From the last impact on to the end of its period the motion is one arc.
  const OrbitImpact& last = orbit.impacts.back();
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  State state = after_impact(system.stops.at(static_cast<std::size_t>(last.stop)), last.before);
  arc.start(last.phase, state.q, state.qdot);
  const double left = system.period() * (orbit.period - last.period_index - last.phase / kTurn);
  arc.state(left, state.q, state.qdot);
  return {(1.0 + push) * state.q, (1.0 + push) * state.qdot};
}

// Whether a motion that starts near the orbit, within a relative push, settles on it.
bool is_reached(const SystemFamily& family, const OrbitBranchPoint& point, double push,
                double accuracy) {
  const System system = *family.at(point.value);
  SettleOptions options;
  options.periods = 20000;
  // The clock of a run starts at phase `forcing.phase`; these scenes have none.
  const SettledMotion settled = settle(system, pushed(system, point.orbit, push), options);
  // Where deviations alternate in sign two periods may be seen to repeat before one does.
  if (!settled.pattern || settled.pattern->period % point.orbit.period != 0) return false;
  const std::size_t own = point.orbit.impacts.size(), met = settled.points.size();
  const auto rounds = static_cast<std::size_t>(settled.pattern->period / point.orbit.period);
  if (met != own * rounds) return false;
  double nearest = 1.0;
  for (std::size_t turn = 0; turn < met; ++turn) {
    double worst = 0.0;
    for (std::size_t i = 0; i < met; ++i)
      worst = std::max(worst, std::abs(std::remainder(settled.points[(i + turn) % met].theta -
                                                          point.orbit.impacts[i % own].phase,
                                                      kTurn)));
    nearest = std::min(nearest, worst);
  }
  return nearest <= accuracy;
}

// How far inside the circle the multipliers lie.
double contraction(const Orbit& orbit) { return std::abs(orbit.multipliers.front().value); }

int expect_stable_points_are_reached(const OrbitBranches& result, const SystemFamily& family) {
  int reached = 0;
  for (const OrbitBranch& branch : result.branches) {
    SCOPED_TRACE(testing::Message() << "branch " << branch.id << " (" << branch.pattern.period
                                    << ", " << branch.pattern.impacts() << ")");
    for (std::size_t i = 1; i + 1 < branch.points.size(); ++i) {
      const OrbitBranchPoint& point = branch.points[i];
      if (!point.orbit.stable.value_or(false) || contraction(point.orbit) > 0.95) continue;
      // Near a grazing the basin is as narrow as the way to it.
      if (point.smallest_speed < 1e-3 || point.orbit.clearance.value_or(1.0) < 1e-5) continue;
      EXPECT_TRUE(is_reached(family, point, 1e-6, 1e-5)) << "at " << point.value;
      ++reached;
    }
  }
  return reached;
}

TEST(SwitchedOrbits, OfTheOneModeBeamAreReachedBySimulation) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode");
  const SystemFamily family(scene, "forcing.frequency");
  const OrbitBranches result = followed(scene, "forcing.frequency", 15.0, 120.0, 2);
  EXPECT_GE(expect_stable_points_are_reached(result, family), 100);
  // The patterns that leave its grazings and doublings.
  for (const auto& [period, impacts] : {std::pair(1, 2), {2, 2}, {2, 1}, {2, 4}}) {
    const bool there =
        std::any_of(result.branches.begin(), result.branches.end(), [&](const OrbitBranch& b) {
          return b.pattern.period == period && b.pattern.impacts() == impacts;
        });
    EXPECT_TRUE(there) << period << " " << impacts;
  }
}

// A doubled branch starts at the doubling it came from, its speeds parting as a square root.
TEST(SwitchedOrbits, DoubledBranchStartsAtItsDoubling) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode");
  const OrbitBranches result = followed(scene, "forcing.frequency", 15.0, 120.0, 1);
  const auto doublings = special_points(result, SpecialKind::kPeriodDoubling);
  int doubled = 0;
  for (const OrbitBranch& branch : result.branches) {
    if (branch.origin.rfind("PD", 0) != 0) continue;
    ++doubled;
    EXPECT_EQ(branch.ends[0], OrbitBranchEnd::kPeriodDoubling);
    const auto origin =
        std::find_if(doublings.begin(), doublings.end(),
                     [&](const SpecialPoint* special) { return special->id == branch.origin; });
    ASSERT_NE(origin, doublings.end());
    EXPECT_EQ(branch.points.front().value, (*origin)->at.value);
  }
  EXPECT_EQ(doubled, 2);
}

// Doubled orbits that were found by themselves end at the doubling, a branch point that they meet
// from the side of the pitchfork: at the value that the orbits of half the period have for it.
TEST(SwitchedOrbits, DoubledBranchesEndWhereTheOrbitsOfHalfThePeriodDouble) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode");
  const OrbitBranches single = followed(scene, "forcing.frequency", 15.0, 120.0, 0);
  const OrbitBranches twice = followed(scene, "forcing.frequency", 15.0, 120.0, 0, 2, 2);
  int met = 0;
  for (const OrbitBranch& branch : twice.branches)
    for (const std::size_t end : {0, 1}) {
      if (branch.ends[end] != OrbitBranchEnd::kPeriodDoubling) continue;
      ++met;
      const double value = (end == 0 ? branch.points.front() : branch.points.back()).value;
      double nearest = 1.0;
      for (const SpecialPoint* doubling : special_points(single, SpecialKind::kPeriodDoubling))
        nearest = std::min(nearest, std::abs(value / doubling->at.value - 1.0));
      EXPECT_LE(nearest, 1e-12) << value;
    }
  EXPECT_EQ(met, 2);
}

// Across a grazing the impact sequence is rewritten: the new branch starts where the old one ends,
// its new impact at speed zero, and on both the grazing contact is one and the same instant.
TEST(SwitchedOrbits, GrazingJoinsTheSequencesWithAndWithoutTheImpact) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode");
  const OrbitBranches result = followed(scene, "forcing.frequency", 15.0, 120.0, 2);
  int joined = 0;
  for (const OrbitBranch& branch : result.branches) {
    if (branch.origin.rfind("GR", 0) != 0) continue;
    for (const OrbitBranch& from : result.branches)
      for (const SpecialPoint& grazing : from.special) {
        if (grazing.id != branch.origin) continue;
        ++joined;
        EXPECT_EQ(std::abs(branch.pattern.impacts() - from.pattern.impacts()), 1);
        EXPECT_EQ(grazing.by_speed, branch.pattern.impacts() < from.pattern.impacts());
        const auto twin = std::find_if(
            branch.special.begin(), branch.special.end(), [&](const SpecialPoint& special) {
              return special.kind == SpecialKind::kGrazing &&
                     std::abs(special.at.value / grazing.at.value - 1.0) <= 1e-10;
            });
        ASSERT_NE(twin, branch.special.end()) << grazing.id;
        EXPECT_EQ(twin->by_speed, !grazing.by_speed) << grazing.id;
      }
  }
  EXPECT_GE(joined, 3);
}

// Every doubling parts orbits that a perturbed motion returns to from orbits that it leaves.
TEST(SwitchedOrbits, DoublingsPartWhatSimulationReachesFromWhatItLeaves) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode");
  const SystemFamily family(scene, "forcing.frequency");
  const OrbitBranches result = followed(scene, "forcing.frequency", 15.0, 120.0, 0);
  int parted = 0;
  for (const OrbitBranch& branch : result.branches)
    for (std::size_t i = 0; i < branch.points.size(); ++i)
      for (const SpecialPoint& special : branch.special) {
        if (special.kind != SpecialKind::kPeriodDoubling ||
            branch.points[i].value != special.at.value)
          continue;
        ASSERT_GT(i, 0u);
        ASSERT_LT(i + 1, branch.points.size());
        for (const OrbitBranchPoint* side : {&branch.points[i - 1], &branch.points[i + 1]}) {
          ASSERT_TRUE(side->orbit.stable);
          EXPECT_EQ(is_reached(family, *side, 1e-6, 1e-4), *side->orbit.stable) << side->value;
        }
        EXPECT_NE(*branch.points[i - 1].orbit.stable, *branch.points[i + 1].orbit.stable);
        ++parted;
      }
  EXPECT_EQ(parted, 2);
  // All other special points of these branches are grazings, which the next test confirms.
  for (const OrbitBranch& branch : result.branches)
    for (const SpecialPoint& special : branch.special)
      EXPECT_TRUE(special.kind == SpecialKind::kPeriodDoubling ||
                  special.kind == SpecialKind::kGrazing)
          << special.id;
}

// How long after an impact of the orbit a motion without closing of chatters hits the next,
// periods.
double flight_from(const System& system, const Orbit& orbit) {
  const OrbitImpact& impact = orbit.impacts.front();
  const State after = after_impact(system.stops[0], impact.before);
  Motion<double> motion(system, {0, impact.phase / system.forcing()->frequency}, after.q,
                        after.qdot);
  const double period = system.period();
  for (int k = 0; k < 4; ++k) {
    const Arrival<double> arrival = motion.fly(period);
    if (arrival.kind == ArrivalKind::kContact)
      return static_cast<double>(motion.instant().period) +
             (motion.instant().local - impact.phase / system.forcing()->frequency) / period;
  }
  return std::numeric_limits<double>::infinity();
}

// Impacts of the motion that is not to touch the stop, over some periods from on it.
int impacts_of_free_response(const System& system) {
  const double w = system.forcing()->frequency;
  const Complex response =
      system.forcing()->amplitude[0] /
      Complex(system.omega[0] * system.omega[0] - w * w, 2.0 * system.delta()[0] * w);
  Motion<double> motion(system, {}, Vector::Constant(1, response.real()),
                        Vector::Constant(1, (Complex(0.0, w) * response).real()));
  int impacts = 0;
  while (motion.instant().period < 20) {
    if (motion.fly(system.period()).kind != ArrivalKind::kContact) continue;
    motion.impact();
    ++impacts;
  }
  return impacts;
}

// Every grazing parts runs by their impacts: those without any, where the speed of an impact
// vanishes, and those from impact to impact of the orbit, where an approach between them touches.
TEST(SwitchedOrbits, GrazingsPartRunsByTheirImpacts) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode");
  const SystemFamily family(scene, "forcing.frequency");
  BranchOptions options;
  options.from = 15.0;
  options.to = 120.0;
  options.keep_virtual = true;
  const OrbitBranches result = trace_orbits(family, options);
  int by_speed = 0, between = 0;
  for (const OrbitBranch& branch : result.branches)
    for (const SpecialPoint& special : branch.special) {
      if (special.kind != SpecialKind::kGrazing) continue;
      const double value = special.at.value;
      SCOPED_TRACE(testing::Message() << special.id << " at " << value);
      if (special.by_speed) {
        // The resonance lies between the two: more is less below it, and the other way round.
        const int below = impacts_of_free_response(*family.at(value * (1.0 - 1e-9)));
        const int above = impacts_of_free_response(*family.at(value * (1.0 + 1e-9)));
        EXPECT_NE(below == 0, above == 0) << below << " and " << above << " impacts";
        ++by_speed;
        continue;
      }
      const auto here = std::find_if(branch.points.begin(), branch.points.end(),
                                     [&](const auto& point) { return point.value == value; });
      ASSERT_TRUE(here != branch.points.begin() && here + 1 < branch.points.end());
      for (const auto& side : {here - 1, here + 1}) {
        const double flight = flight_from(*family.at(side->value), side->orbit);
        if (side->orbit.admissible)
          EXPECT_NEAR(flight, 1.0, 1e-9);
        else
          EXPECT_LT(flight, 0.999);
      }
      EXPECT_NE((here - 1)->orbit.admissible, (here + 1)->orbit.admissible);
      ++between;
    }
  EXPECT_EQ(by_speed, 2);
  EXPECT_EQ(between, 1);
}

// Where an approach touches and a speed vanishes within one step, the branch ends at the first: no
// point of it penetrates, however long its steps.
TEST(SwitchedOrbits, EndAtTheFirstOfTwoGrazingsWithinOneStep) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode");
  const OrbitBranches result = followed(scene, "forcing.frequency", 15.0, 120.0, 4);
  const double length = motion_scale(assemble(scene)).length;
  int triples = 0;
  for (const OrbitBranch& branch : result.branches) {
    triples += branch.pattern.period == 2 && branch.pattern.impacts() == 3;
    for (const OrbitBranchPoint& point : branch.points)
      EXPECT_GE(point.orbit.clearance.value_or(0.0), -1e-12 * length)
          << "branch " << branch.id << " at " << point.value;
  }
  EXPECT_GE(triples, 1);
}

// A fold parts values with a stable and an unstable orbit from values with neither: on the one side
// runs return to the one and leave the other, beyond it they go elsewhere.
TEST(SwitchedOrbits, FoldsPartWhatSimulationReachesFromNothing) {
  int folds = 0;
  for (const char* restitution : {"0.5", "0.7", "0.8", "0.9"}) {
    const SystemFamily family(
        support::shipped_scene("08_preloaded_oscillator",
                               {std::string("stop.restitution=") + restitution}),
        "forcing.frequency");
    BranchOptions options;
    options.from = 2.0;
    options.to = 5.0;
    for (const OrbitBranch& branch : trace_orbits(family, options).branches)
      for (const SpecialPoint& special : branch.special) {
        const auto here =
            std::find_if(branch.points.begin(), branch.points.end(),
                         [&](const auto& point) { return point.value == special.at.value; });
        // Next to it runs settle too slowly to tell.
        constexpr std::ptrdiff_t kApart = 3;
        if (special.kind != SpecialKind::kFold || here - branch.points.begin() < kApart ||
            branch.points.end() - here <= kApart)
          continue;
        SCOPED_TRACE(testing::Message() << "r = " << restitution << " at " << special.at.value);
        const OrbitBranchPoint &one = *(here - kApart), &other = *(here + kApart);
        EXPECT_EQ(one.value < special.at.value, other.value < special.at.value);
        for (const OrbitBranchPoint* side : {&one, &other})
          EXPECT_EQ(is_reached(family, *side, 1e-5, 1e-4), *side->orbit.stable) << side->value;
        // As far beyond it as the nearer of the two is before it: no orbit is left there to settle
        // on, and the run ends somewhere else.
        const double aside = std::min(std::abs(one.value - special.at.value),
                                      std::abs(other.value - special.at.value));
        OrbitBranchPoint beyond = special.at;
        beyond.value += one.value < special.at.value ? aside : -aside;
        EXPECT_FALSE(is_reached(family, beyond, 0.0, 1e-2));
        ++folds;
      }
  }
  EXPECT_EQ(folds, 4);
}

// r(v): no closed form.
TEST(SwitchedOrbits, WithSpeedDependentRestitutionAreReachedBySimulation) {
  const Scene scene =
      support::shipped_scene("04_impact_oscillator", {"stop.restitution=[0.9, 0.15]"});
  const SystemFamily family(scene, "forcing.frequency");
  const OrbitBranches result = followed(scene, "forcing.frequency", 2.0, 4.0, 1);
  EXPECT_GE(expect_stable_points_are_reached(result, family), 10);
}

// Sequences asked for by their number of impacts.
TEST(SwitchedOrbits, SequencesOfTwoImpactsAreFoundWithoutFollowing) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode", {"forcing.frequency=16"});
  const SystemFamily family(scene, "forcing.frequency");
  const OrbitBranches result = followed(scene, "forcing.frequency", 15.5, 17.5, 0, 1, 2);
  ASSERT_FALSE(result.branches.empty());
  for (const OrbitBranch& branch : result.branches) EXPECT_EQ(branch.pattern.impacts(), 2);
  EXPECT_GE(expect_stable_points_are_reached(result, family), 3);
}

// Doubled orbits between two doublings of one branch are met from both, half a period apart.
TEST(SwitchedOrbits, DoubledOrbitsBetweenTwoDoublingsAreTracedOnce) {
  const OrbitBranches result =
      followed(support::shipped_scene("04_impact_oscillator"), "forcing.frequency", 0.2, 6.0, 3);
  int between_doublings = 0;
  std::vector<std::pair<double, double>> ends;
  for (const OrbitBranch& branch : result.branches) {
    if (branch.ends[0] != OrbitBranchEnd::kPeriodDoubling ||
        branch.ends[1] != OrbitBranchEnd::kPeriodDoubling)
      continue;
    ++between_doublings;
    const auto [low, high] = std::minmax(branch.points.front().value, branch.points.back().value);
    for (const auto& [other_low, other_high] : ends)
      EXPECT_FALSE(std::abs(low - other_low) < 1e-9 && std::abs(high - other_high) < 1e-9)
          << "twice between " << low << " and " << high;
    ends.emplace_back(low, high);
  }
  EXPECT_GE(between_doublings, 2);
}

// A branch of orbits that are their own mirror images passes two branch points. A step that lands
// next to one of them leads on all the same, and a step that lands elsewhere finds the same points.
TEST(SwitchedOrbits, BranchPointsArePassedWhereverAStepLands) {
  const Scene scene = support::shipped_scene("07_two_stops", {"forcing.frequency=26.7"});
  const SystemFamily family(scene, "forcing.frequency");
  BranchOptions options;
  options.impacts = 2;
  options.from = 26.45;
  options.to = 27.5;
  options.start_values = 0;
  options.sticking = options.finder.from_simulation = false;
  std::vector<double> first;
  for (const double max_step : {0.14, 0.09, 0.07}) {
    options.max_step = max_step;
    const OrbitBranches result = trace_orbits(family, options);
    std::vector<double> found;
    for (const SpecialPoint* at : special_points(result, SpecialKind::kBranchPoint)) {
      EXPECT_LE(std::abs(*at->multiplier - 1.0), 1e-6);
      found.push_back(at->at.value);
    }
    EXPECT_EQ(result.cut_short, 0);
    ASSERT_EQ(found.size(), 2u) << max_step;
    if (first.empty()) first = found;
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], first[i], 1e-11);
  }
}

}  // namespace
}  // namespace graze
