// The energy balance of compliant stops, and runs that are cut within a contact.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/contact/detail/restitution_damping.hpp"
#include "graze/flow/sprung/detail/sprung_phase.hpp"
#include "graze/motion/simulation.hpp"
#include "support/contact_laws.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

ContactForce law_of(double exponent, ContactDamping damping, double coefficient,
                    Separation separation = Separation::kAtZeroForce) {
  const double stiffness = exponent == 1.0 ? 2e5 : 4e7;
  return {stiffness, exponent, damping, coefficient, 0.0, 0.0, separation};
}

// Three modes that a force and a load move against a compliant stop.
System three_modes(const ContactForce& law) {
  System system;
  system.omega = Vector{{10.0, 61.0, 173.0}};
  system.modal().delta = Vector{{0.3, 0.5, 0.9}};
  system.modal().forcing = HarmonicForcing{8.0, 0.7, Vector{{1.3, 0.7, 0.2}}};
  system.modal().load = Vector{{0.2, -0.1, 0.05}};
  const Vector row{{1.0, -0.9, 0.8}};
  system.stops.push_back({row, 0.003, law});
  return system;
}

SimulationOptions counted(double seconds) {
  SimulationOptions options = support::for_seconds(seconds);
  options.energy = true;
  return options;
}

// Every step errs by kStepTolerance of the velocities, one independently of the other; a step takes
// 13 evaluations.
double error_of_steps(const Simulation& run) {
  return 2.0 * kStepTolerance * std::sqrt(static_cast<double>(run.evaluations) / 13.0) *
         run.energy->size();
}

class CompliantEnergy : public ::testing::TestWithParam<ContactForce> {};

TEST_P(CompliantEnergy, EnergyBalanceCloses) {
  const System system = three_modes(GetParam());
  const auto run = support::record_run(system, support::rest(system), counted(20.0));
  ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_GT(run.result.totals.impacts, 20);
  EXPECT_LT(std::abs(run.result.energy->defect()), error_of_steps(run.result));
  double by_events = 0.0;
  for (const Event& event : run.events)
    if (event.kind == EventKind::kSeparation) by_events += event.energy_change;
  EXPECT_NEAR(by_events, run.result.energy->work.contact, 1e-12 * run.result.energy->size());
  EXPECT_NEAR(run.result.totals.energy_lost - run.result.totals.energy_added, -by_events,
              1e-12 * run.result.energy->size());
}

// Bit for bit, wherever it is cut: between contacts, and within one.
TEST_P(CompliantEnergy, CutRunGoesOnAsIfItHadNot) {
  const System system = three_modes(GetParam());
  const auto whole = support::record_run(system, support::rest(system), counted(4.0));
  ASSERT_EQ(whole.result.outcome, RunOutcome::kReachedEnd);
  const Event* separation = nullptr;
  for (const Event& event : whole.events)
    if (event.kind == EventKind::kSeparation) separation = &event;
  ASSERT_NE(separation, nullptr);
  for (const double cut : {1.0, separation->time - 0.5 * separation->duration}) {
    std::vector<Event> events;
    RunListeners listeners;
    listeners.event = [&](const Event& event) { events.push_back(event); };
    const Simulation before = simulate(system, support::rest(system), counted(cut), listeners);
    const Simulation after = resume(system, before.state, counted(4.0), listeners);
    EXPECT_EQ(after.final.q, whole.result.final.q);
    EXPECT_EQ(after.final.qdot, whole.result.final.qdot);
    ASSERT_EQ(events.size(), whole.events.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
      EXPECT_EQ(events[i].time, whole.events[i].time);
      EXPECT_EQ(events[i].peak_force, whole.events[i].peak_force);
      EXPECT_EQ(events[i].duration, whole.events[i].duration);
      EXPECT_EQ(events[i].energy_change, whole.events[i].energy_change);
    }
  }
}

TEST_P(CompliantEnergy, BalanceMayBeginWhereARunWasCut) {
  const System system = three_modes(GetParam());
  SimulationOptions uncounted = counted(1.0);
  uncounted.energy = false;
  const Simulation before = simulate(system, support::rest(system), uncounted);
  const Simulation after = resume(system, before.state, counted(4.0));
  ASSERT_TRUE(after.energy);
  EXPECT_LE(std::abs(after.energy->defect()), 1e-12 * after.energy->size());
}

INSTANTIATE_TEST_SUITE_P(Laws, CompliantEnergy,
                         ::testing::Values(law_of(1.0, ContactDamping::kNone, 0.0),
                                           law_of(1.0, ContactDamping::kConstant, 60.0),
                                           law_of(1.0, ContactDamping::kConstant, 60.0,
                                                  Separation::kAtZeroDepth),
                                           law_of(1.5, ContactDamping::kNone, 0.0),
                                           law_of(1.5, ContactDamping::kPower, 8e7)));

// A free mass gives up 1 - e^2 of its energy.
TEST(CompliantEnergyOfAMass, IsWhatItsRestitutionLeaves) {
  const double k = 1e5, v = 0.5;
  for (const double zeta : {0.05, 0.3, 0.8})
    for (const Separation rule : {Separation::kAtZeroForce, Separation::kAtZeroDepth}) {
      System system = support::oscillator(0.0, 0.0, 0.25, 0.0);
      system.stops.front().law = ContactForce{
          k, 1.0, ContactDamping::kConstant, 2.0 * zeta * std::sqrt(k), 0.0, 0.0, rule};
      const auto run = support::record_run(system, support::state_of({0.0}, {v}), counted(1.0));
      const double e = rule == Separation::kAtZeroForce ? restitution_at_zero_force(zeta)
                                                        : restitution_at_zero_depth(zeta);
      ASSERT_EQ(run.events.size(), 2u);
      EXPECT_NEAR(run.events[1].energy_change, -0.5 * v * v * (1.0 - e * e), 1e-12 * v * v);
      EXPECT_NEAR(run.result.totals.energy_lost, 0.5 * v * v * (1.0 - e * e), 1e-12 * v * v);
    }
}

// What nothing damps gives back all that it took, without rounding: no stop adds or loses energy.
// A free mass compresses it until the spring holds its energy, k x^(n+1)/(n+1) = v^2/2.
TEST(CompliantEnergyOfAMass, IsGivenBackByASpring) {
  const double k = 3e5, v = 0.7;
  for (const double n : {1.0, 1.5, 2.2}) {
    System system = support::oscillator(0.0, 0.0, 0.25, 0.0);
    system.stops.front().law = ContactForce{k, n};
    const auto run = support::record_run(system, support::state_of({0.0}, {v}), counted(1.0));
    ASSERT_EQ(run.events.size(), 2u);
    EXPECT_EQ(run.events[1].energy_change, 0.0);
    EXPECT_EQ(run.result.totals.energy_added, 0.0);
    EXPECT_EQ(run.result.totals.energy_lost, 0.0);
    const double depth = std::pow(0.5 * (n + 1.0) * v * v / k, 1.0 / (n + 1.0));
    EXPECT_NEAR(*run.result.totals.smallest_gap, -depth, 1e-12 * depth);
    EXPECT_EQ(run.result.totals.penetration, 0.0);
  }
}

// Its force falls to zero below the surface, and grips there again with what the spring still
// holds: from surface to surface no passive stop adds energy.
TEST(CompliantEnergyOfABeam, IsNotAddedByContactsThatPartBelowTheSurface) {
  for (const char* scene : {"17_yigit_lee_wang_1", "18_yigit_lee_wang_2"}) {
    const Scene beam = support::shipped_scene(scene);
    const System system = assemble(beam);
    const auto run = support::record_run(system, initial_state(beam, system), counted(0.4));
    ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    double structure = 0.0;
    bool gained = false;
    for (const Event& event : run.events)
      if (event.kind == EventKind::kSeparation) {
        structure += event.energy_change;
        gained = gained || event.energy_change > 0.0;
      }
    EXPECT_TRUE(gained) << scene;
    EXPECT_EQ(run.result.totals.energy_added, 0.0) << scene;
    EXPECT_NEAR(run.result.totals.energy_lost, -structure, 1e-15);
    EXPECT_NEAR(run.result.totals.energy_lost, -run.result.energy->work.contact, 1e-14);
  }
}

// A spring that is compressed while an oblique law holds the structure on another stop.
TEST(CompliantEnergyBesideAnObliqueStop, EnergyBalanceCloses) {
  System system = three_modes(law_of(1.0, ContactDamping::kConstant, 20.0));
  system.modal().load = Vector{{3.0, 1.0, -2.0}};
  const Vector row{{0.7, 1.0, -0.6}}, along{{0.4, 0.9, 0.3}};
  system.stops.push_back({row, 0.002, ImpactLaw{along / row.dot(along), Restitution{0.2}}});
  const auto run = support::record_run(system, support::rest(system), counted(10.0));
  ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_GT(run.result.totals.stuck_time, 0.01);
  EXPECT_NE(run.result.energy->work.constraint, 0.0);
  EXPECT_NE(run.result.energy->work.contact, 0.0);
  EXPECT_LT(std::abs(run.result.energy->defect()), 1e-12 * run.result.energy->size());
}

}  // namespace
}  // namespace graze
