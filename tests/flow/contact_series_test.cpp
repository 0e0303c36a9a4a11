// Contacts by power series beside those by extrapolation, which know nothing of each other: the
// structure has several modes, and the contact is every one that has a series, or has none.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "graze/flow/stepped/detail/step_methods.hpp"

namespace graze {
namespace {

ContactForce law(double exponent, ContactDamping damping, double coefficient = 0.0) {
  ContactForce of{3e9, exponent, damping, coefficient, 0.0, 0.0, {}};
  if (exponent == 1.0) of.stiffness = 1e6;
  if (damping == ContactDamping::kOnset) {
    of.onset_depth = 2e-6;
    of.onset_sharpness = 3.0;
  }
  return of;
}

// Four modes, damped, loaded and forced, whose quickest turns about once within a contact.
SprungSystem structure(const ContactForce& contact) {
  const Vector row{{1.1, -2.3, 1.7, -2.9}};
  SprungSystem system;
  system.stiffness = Vector{{7e2, 2e5, 4e7, 3e8}};
  system.damping = Vector{{0.4, 3.0, 20.0, 900.0}};
  system.load = Vector{{9.0, -2.0, 1.0, 0.5}};
  system.force = Vector{{14.0, 5.0, -3.0, 2.0}};
  system.frequency = 900.0;
  system.springs.push_back({contact, row, row, true, row});
  return system;
}

StepSetting finest() {
  StepSetting setting;
  setting.tolerance = 1e-14;
  setting.speed = 1.0;
  setting.longest = std::numeric_limits<double>::infinity();
  return setting;
}

// Displacements and velocities at which the depth is `depth` and grows at `speed`.
struct Beginning {
  double depth = 0.0, speed = 0.1;
};

Vector state_at(const SprungSystem& system, const Beginning& from) {
  const Vector& row = system.springs[0].row;
  Vector x(8);
  x << 1e-3, -2e-4, 1e-6, 3e-7, 0.0, 0.0, 0.0, 0.0;
  x.tail(4) += row * (from.speed / row.squaredNorm());
  return x;
}

std::vector<Watch> watches_of(const ContactForce& contact, const Beginning& from) {
  Watch depth;
  depth.of_spring = SpringWatch::kDepth;
  depth.spring = 0;
  depth.multiplicity = from.depth > 0.0 ? 0 : 1;
  depth.departure = from.speed;
  Watch grip = depth;
  grip.of_spring = SpringWatch::kGrip;
  grip.multiplicity = 0;
  std::vector<Watch> watches = {depth};
  if (contact.parts_early()) watches.push_back(grip);
  return watches;
}

struct Passed {
  StepDescent found;
  Vector end, middle;
  SprungWorks works;
  double force = 0.0, depth = 0.0;
  long long evaluations = 0;
};

Passed pass(StepFlow& flow, const SprungSystem& system, const Beginning& from,
            double window = 1e-2) {
  const double depths[] = {from.depth};
  flow.start(0.3, state_at(system, from), depths);
  const std::vector<Watch> watches = watches_of(system.springs[0].law, from);
  std::vector<const Watch*> list;
  for (const Watch& watch : watches) list.push_back(&watch);
  Passed passed;
  passed.found = flow.first_descent(list, window, window, {}, 0.0);
  flow.state(passed.found.s, passed.end);
  passed.works = flow.works(passed.found.s);
  passed.evaluations = flow.evaluations();
  passed.force = flow.peak_force(0);
  passed.depth = flow.deepest(0);
  flow.state(0.37 * passed.found.s, passed.middle);
  return passed;
}

// Ten times what a step of either may err by, for some tens of steps.
constexpr double kClose = 1e-11;

void expect_same(const SprungSystem& system, const Beginning& from, double window = 1e-2) {
  const auto series = contact_flow(system, finest());
  const auto steps = bulirsch_stoer_flow(system, finest());
  const Passed by_series = pass(*series, system, from, window);
  const Passed by_steps = pass(*steps, system, from, window);
  ASSERT_EQ(by_series.found.watch, by_steps.found.watch);
  ASSERT_TRUE(by_series.found.finite);
  EXPECT_NEAR(by_series.found.s, by_steps.found.s, kClose * by_steps.found.s);
  const double speed = by_steps.end.tail(4).cwiseAbs().maxCoeff();
  const double size = by_steps.end.head(4).cwiseAbs().maxCoeff();
  for (const auto& [a, b] :
       {std::pair(&by_series.end, &by_steps.end), std::pair(&by_series.middle, &by_steps.middle)}) {
    EXPECT_LT((a->head(4) - b->head(4)).cwiseAbs().maxCoeff(), kClose * size);
    EXPECT_LT((a->tail(4) - b->tail(4)).cwiseAbs().maxCoeff(), kClose * speed);
  }
  EXPECT_NEAR(by_series.force / by_steps.force, 1.0, kClose);
  EXPECT_NEAR(by_series.depth / by_steps.depth, 1.0, kClose);
  const double energy = state_at(system, from).tail(4).squaredNorm() + speed * speed;
  EXPECT_NEAR(by_series.works.forcing, by_steps.works.forcing, kClose * energy);
  EXPECT_NEAR(by_series.works.dissipation, by_steps.works.dissipation, kClose * energy);
  EXPECT_NEAR(by_series.works.springs[0].lost, by_steps.works.springs[0].lost, kClose * energy);
  EXPECT_NEAR(by_series.works.springs[0].stored, by_steps.works.springs[0].stored, kClose * energy);
  EXPECT_LT((by_series.works.moved - by_steps.works.moved).cwiseAbs().maxCoeff(), kClose * size);
}

std::vector<ContactForce> laws_with_series() {
  return {law(1.5, ContactDamping::kNone),        law(1.5, ContactDamping::kPower, 5e9),
          law(1.5, ContactDamping::kPower, 2e11), law(1.5, ContactDamping::kConstant, 60.0),
          law(1.5, ContactDamping::kDepth, 4e6),  law(1.0, ContactDamping::kPower, 2e6),
          law(1.0, ContactDamping::kDepth, 2e6),  law(2.0, ContactDamping::kNone),
          law(2.5, ContactDamping::kPower, 1e10), law(3.0, ContactDamping::kNone)};
}

TEST(ContactSeries, IsTheContactThatStepsTake) {
  for (const ContactForce& contact : laws_with_series()) {
    SCOPED_TRACE(testing::Message()
                 << contact.exponent << " " << int(contact.damping) << " " << contact.coefficient);
    for (const double speed : {1e-4, 0.1, 3.0}) {
      SCOPED_TRACE(speed);
      expect_same(structure(contact), {0.0, speed});
    }
    // From within, deeper and on the way out.
    expect_same(structure(contact), {2e-6, 0.02});
    expect_same(structure(contact), {2e-6, -0.02});
  }
}

// One that is pressed back onto its spring before it leaves, and swings there up to the window.
TEST(ContactSeries, FollowsWhatIsPressed) {
  SprungSystem system = structure(law(1.5, ContactDamping::kPower, 5e9));
  system.load = 4e3 * system.springs[0].row;
  expect_same(system, {0.0, 1e-3}, 2e-3);
}

// Modes that closed stops couple come with full matrices.
TEST(ContactSeries, FollowsCoupledModes) {
  SprungSystem system = structure(law(1.5, ContactDamping::kPower, 5e9));
  Matrix coupled = Matrix(system.stiffness.col(0).asDiagonal());
  coupled(0, 1) = coupled(1, 0) = 3e3;
  coupled(2, 3) = -5e6;
  system.stiffness = coupled;
  Matrix damped = Matrix(system.damping.col(0).asDiagonal());
  damped(1, 2) = 7.0;
  system.damping = damped;
  system.springs[0].acting = Vector{{1.0, -2.2, 1.8, -3.0}};
  expect_same(system, {0.0, 0.1});
}

// What has no series is stepped through, bit for bit as by extrapolation.
TEST(ContactSeries, LeavesOthersToExtrapolation) {
  const auto expect_steps = [](const SprungSystem& system, const Beginning& from) {
    const auto series = contact_flow(system, finest());
    const auto steps = bulirsch_stoer_flow(system, finest());
    const Passed one = pass(*series, system, from), other = pass(*steps, system, from);
    EXPECT_EQ(one.evaluations, other.evaluations);
    EXPECT_EQ(one.found.s, other.found.s);
    EXPECT_EQ(one.end, other.end);
  };
  expect_steps(structure(law(2.2, ContactDamping::kNone)), {0.0, 0.1});
  expect_steps(structure(law(1.5, ContactDamping::kOnset, 60.0)), {0.0, 0.1});
  SprungSystem two = structure(law(1.5, ContactDamping::kNone));
  two.springs.push_back(two.springs[0]);
  two.springs[1].loaded = false;
  // One that is not loaded does nothing, so that there is a series all the same.
  EXPECT_LT(pass(*contact_flow(two, finest()), two, {0.0, 0.1}).evaluations, 400);
}

// At rest on the surface the variable of the series stands still; pushed, the contact begins by
// steps.
TEST(ContactSeries, BeginsAtRestBySteps) {
  SprungSystem system = structure(law(1.5, ContactDamping::kNone));
  const double push = 40.0;  // N
  system.load = push * system.springs[0].row;
  for (Matrix* absent : {&system.stiffness, &system.damping}) absent->setZero();
  system.force.setZero();
  const auto flow = contact_flow(system, finest());
  const double depths[] = {0.0};
  flow->start(0.0, state_at(system, {0.0, 0.0}), depths);
  // A mass pushed onto k x^(3/2) gets as deep as that stores the work of the push.
  const double deepest = std::pow(2.5 * push / system.springs[0].law.stiffness, 1.0 / 1.5);
  const double window = 4.0 * std::sqrt(deepest / (push * system.springs[0].row.squaredNorm()));
  flow->first_descent({}, window, window, {}, 0.0);
  EXPECT_NEAR(flow->deepest(0) / deepest, 1.0, 1e-11);
}

// Who sums over the steps by a rule of a few nodes finds the impulse, though the force begins and
// ends as t^(3/2): a free mass that is thrown back elastically takes 2 m v.
TEST(ContactSeries, StepsAreShortEnoughToSumOver) {
  const double mass = 0.3, v = 0.2;
  const Vector row = Vector::Constant(1, 1.0 / std::sqrt(mass));
  SprungSystem system{
      Matrix::Zero(1, 1), Matrix::Zero(1, 1), Vector::Zero(1), Vector::Zero(1), 0.0, {}};
  system.springs.push_back({law(1.5, ContactDamping::kNone), row, row, true, row});
  const auto flow = contact_flow(system, finest());
  Vector x(2);
  x << 0.0, std::sqrt(mass) * v;
  const double depths[] = {0.0};
  flow->start(0.0, x, depths);
  Watch depth;
  depth.of_spring = SpringWatch::kDepth;
  depth.spring = 0;
  depth.multiplicity = 1;
  depth.departure = v;
  const std::array<const Watch*, 1> watches = {&depth};
  const double end = flow->first_descent(watches, 1.0, 1.0, {}).s;
  double impulse = 0.0;
  flow->each_step(end, [&](double from, double to) {
    impulse += boost::math::quadrature::gauss<double, 7>::integrate(
        [&](double s) {
          flow->state(s, x);
          return system.springs[0].law.at(row[0] * x[0], row[0] * x[1]);
        },
        from, to);
  });
  EXPECT_NEAR(impulse / (2.0 * mass * v), 1.0, 1e-11);
}

}  // namespace
}  // namespace graze
