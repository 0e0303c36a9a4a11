// The map from section to section of structures on compliant stops: its derivatives, and its
// orbits.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_family.hpp"
#include "graze/orbit/problem/detail/section_map.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/orbit/search/settled.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "support/contact_laws.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

ContactForce law_of(double exponent, ContactDamping damping, double coefficient,
                    Separation separation = Separation::kAtZeroForce) {
  return {exponent == 1.0 ? 4e3 : 4e4, exponent, damping, coefficient, 2e-4, 3.0, separation};
}

// Three modes that a force and a load move against a compliant stop; two contacts and more a
// period.
System three_modes(const ContactForce& law) {
  System system;
  system.omega = Vector{{10.0, 27.0, 61.0}};
  system.modal().delta = Vector{{0.6, 0.8, 1.1}};
  system.modal().forcing = HarmonicForcing{8.0, 0.7, Vector{{2.3, 1.7, 0.9}}};
  system.modal().load = Vector{{0.2, -0.1, 0.05}};
  const Vector row{{1.0, -0.9, 0.8}};
  system.stops.push_back({row, 0.01, law});
  return system;
}

// The derivative of a vector function at 0, by central differences extrapolated to step zero.
Vector slope_of(const std::function<Vector(double)>& f, double step) {
  const auto difference = [&](double h) { return Vector((f(h) - f(-h)) / (2.0 * h)); };
  const Vector a = difference(step), b = difference(0.5 * step), c = difference(0.25 * step);
  const Vector ab = (4.0 * b - a) / 3.0, bc = (4.0 * c - b) / 3.0;
  return (16.0 * bc - ab) / 15.0;
}

State some_state() { return support::state_of({0.013, -0.004, 0.002}, {0.11, 0.05, -0.07}); }

// Over a forcing period.
std::optional<SectionMap::Image> image_of(const SectionMap& map, const System& system,
                                          const Vector& x, const System* tangent = nullptr) {
  return map.image(system, x, 0.0, 1, false, std::span(&tangent, tangent ? 1 : 0));
}

System under_harmonics(System system, double size = 1.0) {
  system.modal().forcing->harmonics = {
      {2, size * Vector{{0.8, -0.5, 0.3}}, size * Vector{{0.4, 0.2, -0.6}}},
      {3, size * Vector{{0.0, 0.9, 0.5}}, size * Vector{{-0.7, 0.0, 0.4}}}};
  return system;
}

class SectionMapOf : public ::testing::TestWithParam<ContactForce> {};

// From a state before a contact to one after several, for every entry of it.
void expect_slopes(const System& system) {
  const SectionMap map(system, {}, {});
  const Vector x = map.pack(system, some_state());
  const std::optional<TrajectorySegment> segment = map.follow(system, x, 0.0, 1);
  ASSERT_TRUE(segment);
  ASSERT_GE(segment->contacts.size(), 2u);
  const auto image = image_of(map, system, x);
  ASSERT_TRUE(image);
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const Vector slope = slope_of(
        [&](double h) { return image_of(map, system, x + h * Vector::Unit(x.size(), j))->image; },
        1e-4);
    EXPECT_LT((slope - image->jacobian.col(j)).norm(), 2e-6 * image->jacobian.norm()) << j;
  }
}

TEST_P(SectionMapOf, SlopesAreThoseOfDifferences) {
  expect_slopes(three_modes(GetParam()));
  expect_slopes(under_harmonics(three_modes(GetParam())));
}

// And for what a scene may move: gap, row, load, frequencies, decay, forcing, and the spring.
void expect_parameter_rates(const System& system) {
  const ContactForce& law = system.stops[0].force();
  const SectionMap map(system, {}, {});
  const Vector x = map.pack(system, some_state());
  struct Case {
    const char* name;
    std::function<void(System&, double)> move;
    double size;
  };
  std::vector<Case> cases = {
      {"gap", [](System& s, double h) { s.stops[0].gap += h; }, 1e-2},
      {"row", [](System& s, double h) { s.stops[0].row[1] += h; }, 1.0},
      {"load", [](System& s, double h) { (*s.modal().load)[0] += h; }, 0.2},
      {"omega", [](System& s, double h) { s.omega[1] += h; }, 10.0},
      {"delta", [](System& s, double h) { s.modal().delta[0] += h; }, 1.0},
      {"amplitude", [](System& s, double h) { s.modal().forcing->amplitude[2] += h; }, 20.0},
      {"frequency", [](System& s, double h) { s.modal().forcing->frequency += h; }, 8.0},
      {"stiffness", [](System& s, double h) { s.stops[0].force().stiffness += h; }, law.stiffness},
      {"exponent", [](System& s, double h) { s.stops[0].force().exponent += h; }, 1.0},
      {"coefficient", [](System& s, double h) { s.stops[0].force().coefficient += h; },
       std::max(law.coefficient, 1.0)}};
  if (system.harmonics()) {
    cases.push_back({"second harmonic",
                     [](System& s, double h) { s.modal().forcing->harmonics[0].sine[0] += h; }, 10.0});
    cases.push_back({"third harmonic",
                     [](System& s, double h) { s.modal().forcing->harmonics[1].cosine[1] += h; }, 10.0});
  }
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    // The exponent of a law without one below 1 moves to one side only.
    if (std::string(one.name) == "exponent" && law.exponent == 1.0) continue;
    if (std::string(one.name) == "coefficient" && law.damping == ContactDamping::kNone) continue;
    System tangent = system;
    tangent.omega.setZero();
    tangent.modal().delta.setZero();
    tangent.modal().forcing = HarmonicForcing{0.0, 0.0, Vector::Zero(3)};
    if (system.harmonics()) tangent = under_harmonics(tangent, 0.0);
    tangent.modal().load = Vector::Zero(3);
    tangent.stops[0].row.setZero();
    tangent.stops[0].gap = 0.0;
    tangent.stops[0].law = ContactForce{0.0, 0.0, law.damping, 0.0, 0.0, 0.0, law.separation};
    one.move(tangent, 1.0);
    const auto image = image_of(map, system, x, &tangent);
    ASSERT_TRUE(image);
    const Vector slope = slope_of(
        [&](double h) {
          System moved = system;
          one.move(moved, h);
          return image_of(map, moved, x)->image;
        },
        1e-4 * one.size);
    EXPECT_GT(slope.norm(), 0.0);
    EXPECT_LT((slope - image->by_parameters.col(0)).norm(), 2e-6 * slope.norm());
  }
}

TEST_P(SectionMapOf, ParametersMoveItAsDifferencesSay) {
  expect_parameter_rates(three_modes(GetParam()));
  expect_parameter_rates(under_harmonics(three_modes(GetParam())));
}

// Every number of a scene with two loads, the phases of both and their common frequency among them,
// through impacts and sticking.
TEST(SectionMap, MovesWithEveryNumberOfSeveralLoads) {
  for (const char* name : {"orders13", "half_order", "orders_plastic", "higher_first"}) {
    const Scene scene = support::reference_scene(std::string("sticking/") + name);
    const System system = assemble(scene);
    const SectionMap map(system, {}, {});
    const Vector x = map.pack(system, {0.05 * Vector::Ones(system.modes()), 0.1 * Vector::Ones(system.modes())});
    for (const std::string& parameter : parameter_names(scene)) {
      SCOPED_TRACE(std::string(name) + " " + parameter);
      const SystemFamily family(scene, parameter);
      const double value = family.value();
      const System tangent = *family.tangent_at(value);
      const auto image = image_of(map, system, x, &tangent);
      ASSERT_TRUE(image);
      const double step = 1e-5 * std::max(std::abs(value), 0.1);
      if (!family.at(value - step)) continue;
      const Vector slope =
          slope_of([&](double h) { return image_of(map, *family.at(value + h), x)->image; }, step);
      EXPECT_LT((slope - image->by_parameters.col(0)).norm(), 1e-6 * (slope.norm() + x.norm()));
    }
  }
}

class SectionMapOfConstantDamping : public ::testing::TestWithParam<ContactForce> {};

// Liouville: volumes shrink by the trace of the damping, the spring's own while it is loaded; what
// jumps at the surface has determinant one.
TEST_P(SectionMapOfConstantDamping, VolumesShrinkByTheDampingAlone) {
  const ContactForce law = GetParam();
  const System system = three_modes(law);
  const SectionMap map(system, {}, {});
  const Vector x = map.pack(system, some_state());
  const std::optional<TrajectorySegment> segment = map.follow(system, x, 0.0, 1);
  ASSERT_TRUE(segment);
  double loaded = 0.0;
  for (const SegmentContact& contact : segment->contacts) {
    const auto periods = static_cast<double>(contact.to.period - contact.from.period);
    loaded += periods * system.period() + contact.to.local - contact.from.local;
  }
  const double shrinks = 2.0 * system.delta().sum() * system.period() +
                         law.coefficient * system.stops[0].row.squaredNorm() * loaded;
  EXPECT_NEAR(std::log(std::abs(image_of(map, system, x)->jacobian.determinant())), -shrinks,
              1e-9 * shrinks);
}

INSTANTIATE_TEST_SUITE_P(
    Laws, SectionMapOf,
    ::testing::Values(
        law_of(1.0, ContactDamping::kNone, 0.0), law_of(1.0, ContactDamping::kConstant, 10.0),
        law_of(1.0, ContactDamping::kConstant, 10.0, Separation::kAtZeroDepth),
        law_of(1.5, ContactDamping::kNone, 0.0), law_of(1.5, ContactDamping::kPower, 2e4),
        law_of(1.5, ContactDamping::kOnset, 5.0, Separation::kAtZeroDepth),
        law_of(2.2, ContactDamping::kPower, 1e4),
        law_of(1.0, ContactDamping::kStep, 10.0, Separation::kAtZeroDepth),
        law_of(1.5, ContactDamping::kApproach, 50.0), law_of(1.0, ContactDamping::kApproach, 10.0),
        law_of(1.0, ContactDamping::kCapped, 10.0)));

INSTANTIATE_TEST_SUITE_P(Laws, SectionMapOfConstantDamping,
                         ::testing::Values(law_of(1.0, ContactDamping::kNone, 0.0),
                                           law_of(1.0, ContactDamping::kConstant, 10.0),
                                           law_of(1.0, ContactDamping::kConstant, 10.0,
                                                  Separation::kAtZeroDepth),
                                           law_of(1.5, ContactDamping::kNone, 0.0)));

// A forced oscillator whose orbit is known piece by piece: a free one, and one on the spring.
TEST(OrbitOnASpring, SolvesThePiecewiseLinearOscillator) {
  System system = support::forced_oscillator(1.0, 0.05, 0.5, 0.0, 1.3, 1.0);
  const double k = 30.0;
  system.stops[0].law = ContactForce{k};
  const FoundOrbits found = find_orbits(system, support::rest(system), {});
  ASSERT_FALSE(found.orbits.empty());
  for (const Orbit& orbit : found.orbits) {
    ASSERT_TRUE(orbit.section);
    double product = 1.0;
    for (const Eigenvalue& multiplier : orbit.multipliers) product *= std::abs(multiplier.value);
    EXPECT_NEAR(product, std::exp(-2.0 * 0.05 * orbit.period * system.period()), 1e-9);
    EXPECT_LE(orbit.residual, 1e-11);
    // What the spring takes it gives back.
    for (const OrbitImpact& impact : orbit.impacts) EXPECT_NEAR(impact.contact->taken, 0.0, 1e-11);
  }
  // The motion settles on the stable one.
  const SettledMotion settled = settle(system, support::rest(system));
  ASSERT_EQ(settled.kind, SettledKind::kImpacts) << settled.classification;
  const auto stable = std::find_if(found.orbits.begin(), found.orbits.end(),
                                   [](const Orbit& orbit) { return orbit.stable == true; });
  ASSERT_NE(stable, found.orbits.end());
  EXPECT_EQ(settled.impacts.size(), stable->impacts.size());
}

// A body pressed into a stop whose dashpot lets it go below the surface and grips it again, every
// period: it never leaves, so there is no impact, least of all one of negative speed.
TEST(OrbitOnASpring, CountsNoImpactsWhereASpringGripsAgain) {
  System system = support::forced_oscillator(1.0, 0.05, -0.8, 0.0, 0.7, 0.65);
  system.stops[0].law = ContactForce{2.0, 1.0, ContactDamping::kConstant, 8.0};
  const auto run = support::record_run(system, support::rest(system), support::for_seconds(400.0));
  const auto grips = std::count_if(run.events.begin(), run.events.end(), [](const Event& event) {
    return event.kind == EventKind::kContact && event.speed < 0.0;
  });
  EXPECT_GT(grips, 20);
  EXPECT_LE(run.result.totals.impacts, 1);
  const SettledMotion settled = settle(system, support::rest(system));
  EXPECT_EQ(settled.kind, SettledKind::kAtRest) << settled.classification;
  EXPECT_LE(settled.impacts_met, 1);
  EXPECT_TRUE(find_orbits(system, support::rest(system), {}).orbits.empty());
}

// A spring whose resistance is C x^n lets a mass m out of the depth x at no more than k/C, which
// takes C^2 x^(n+1)/(m k) times as long as its velocity takes to settle: 1e4 is the most that is
// followed.
TEST(SectionMap, StartsInNoDentThatDampingKeepsItIn) {
  const double k = 4e4, c = 4e6, n = 1.5;
  const System damped = three_modes(law_of(n, ContactDamping::kPower, c));
  const System free = three_modes(law_of(n, ContactDamping::kNone, 0.0));
  const Stop& stop = damped.stops.front();
  const auto starts = [&](const System& system, double depth) {
    const Vector q = stop.row * ((stop.gap + depth) / stop.row.squaredNorm());
    const SectionMap map(system, {}, {});
    return map.start_of(system, map.pack(system, {q, Vector::Zero(3)}), 0.0).has_value();
  };
  const double mass = 1.0 / stop.row.squaredNorm();
  const double deepest = std::pow(1e4 * mass * k / (c * c), 1.0 / (n + 1.0));
  EXPECT_TRUE(starts(damped, 0.99 * deepest));
  EXPECT_FALSE(starts(damped, 1.01 * deepest));
  EXPECT_TRUE(starts(free, 1e3 * deepest));
}

// Near its resonance an oscillator hits its spring much harder than forcing and gap let expect.
TEST(SectionMap, FollowsDeepContactsOfAResonance) {
  const System system = assemble(
      support::shipped_scene("12_spring_dashpot_oscillator",
                             {"modal.damping_ratios=[0.005]",
                              "stop.spring.damping.restitution=0.98", "forcing.frequency=1.76"}));
  FinderOptions options;
  options.impacts = 1;
  const FoundOrbits found = find_orbits(system, support::state_of({0.0}, {0.0}), options);
  EXPECT_TRUE(std::any_of(found.orbits.begin(), found.orbits.end(),
                          [](const Orbit& orbit) { return orbit.stable == true; }));
}

// What meets its stop at speeds of 1e-230 m/s does not move.
TEST(OrbitOnASpring, NothingMovesWithoutForcing) {
  const System system =
      assemble(support::shipped_scene("12_spring_dashpot_oscillator", {"forcing.amplitude=0.0"}));
  const FoundOrbits found = find_orbits(system, support::state_of({0.0}, {0.0}), {});
  EXPECT_TRUE(found.orbits.empty());
}

// A hub with two arms, damped by its springs alone: where the arms are equal one mode leaves the
// hub at rest, and beside that value its sign is another. In the coordinates of the masses nothing
// jumps.
class SectionMapOfMasses : public ::testing::TestWithParam<const char*> {
 protected:
  static Scene hub() {
    return parse_scene(
        "[lumped]\nmasses = [1.0, 1.0, 1.0]\n"
        "[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 100\ndamping = 0.5\n"
        "[[lumped.spring]]\nbetween = [1, 2]\nstiffness = 100\ndamping = 0.7\n"
        "[[lumped.spring]]\nbetween = [1, 3]\nstiffness = 100\ndamping = 0.7\n"
        "[forcing]\nmass = 1\namplitude = 5\nfrequency = 14\n"
        "[[stop]]\nmass = 2\ngap = 0.01\nrestitution = 0.2\n",
        "hub");
  }
};

TEST_P(SectionMapOfMasses, DoesNotSeeTheSignsOfModes) {
  const SystemFamily family(hub(), GetParam());
  const double equal = family.value();
  const System reference = *family.at(equal);
  const SectionMap map(reference, {}, {});
  const Vector x =
      map.pack(reference, support::state_of({0.005, 0.002, -0.001}, {0.1, 0.05, -0.07}));
  const auto image = [&](double part) {
    return image_of(map, *family.at(equal * (1.0 + part)), x)->image;
  };
  const Vector here = image(0.0);
  for (const double part : {1e-6, 1e-9, -1e-9, -1e-6})
    EXPECT_LT((image(part) - here).norm(), 100.0 * std::abs(part) * here.norm()) << part;
  for (const double part : {-0.02, -1e-5, 0.0, 1e-5, 0.02}) {
    const double value = equal * (1.0 + part);
    const System system = *family.at(value), tangent = *family.tangent_at(value);
    const auto moved = image_of(map, system, x, &tangent);
    ASSERT_TRUE(moved);
    const Vector slope = slope_of(
        [&](double h) { return image_of(map, *family.at(value + h), x)->image; }, 1e-4 * equal);
    EXPECT_LT((slope - moved->by_parameters.col(0)).norm(), 1e-6 * slope.norm()) << part;
  }
}

INSTANTIATE_TEST_SUITE_P(Numbers, SectionMapOfMasses,
                         ::testing::Values("lumped.spring.2.stiffness", "lumped.spring.3.damping",
                                           "lumped.masses.2", "lumped.masses.3"));

}  // namespace
}  // namespace graze
