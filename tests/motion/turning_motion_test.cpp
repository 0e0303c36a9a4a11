// The motion of a beam on a hub, free and against stops.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "graze/assembly/detail/hub_system.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/angle.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/structure/detail/hub_beam.hpp"
#include "support/hub_scene.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

using support::stop_at;
using support::strip_on_hub;

Simulation run(const Scene& scene, double duration, std::vector<Event>* events = nullptr) {
  const System system = assemble(scene);
  SimulationOptions options;
  options.duration = duration;
  options.energy = true;
  RunListeners listeners;
  if (events) listeners.event = [events](const Event& event) { events->push_back(event); };
  return simulate(system, initial_state(scene, system), options, listeners);
}

double angle_of(const System& system, const Vector& y) { return system.rotation()->angle.dot(y); }

// Of the weight; the energy balance counts it as work.
double potential(const System& system, const Vector& y) {
  const WeightOnHub& weight = *system.rotation()->weight;
  const double angle = angle_of(system, y);
  return weight.moment * std::sin(angle) + weight.pull.dot(y) * std::cos(angle);
}

Initial bent(double angle, double rate) {
  return {{0.02, -0.002, 0.0005}, {0.1, 0.2, -0.1}, angle, rate};
}

TEST(TurningMotion, KeepsItsEnergy) {
  Scene scene = strip_on_hub();
  scene.initial = bent(0.3, 5.0);
  for (const bool weight : {false, true}) {
    if (weight) scene.gravity = Gravity{9.81};
    const System system = assemble(scene);
    const Simulation end = run(scene, 10.0);
    ASSERT_EQ(end.outcome, RunOutcome::kReachedEnd) << end.message;
    const State start = initial_state(scene, system);
    double before = end.energy->start, after = end.energy->now;
    if (weight) before += potential(system, start.q), after += potential(system, end.final.q);
    EXPECT_NEAR(after / before, 1.0, 1e-10);
    EXPECT_LT(std::abs(end.energy->defect()), 1e-10 * end.energy->size());
  }
}

TEST(TurningMotion, ThePrintedPairDoesNot) {
  Scene scene = strip_on_hub();
  scene.initial = bent(0.3, 5.0);
  scene.hub->equations = HubEquations::kPaper;
  const Simulation end = run(scene, 10.0);
  EXPECT_GT(std::abs(end.energy->now / end.energy->start - 1.0), 1e-4);
}

// The equations (15) and (16) of the paper for one mode, with the two terms that (16) lacks as a
// part of them, by Runge-Kutta steps that err by less than 1e-11.
Eigen::Vector4d stepped(const Scene& scene, double centrifugal, double completed, double end) {
  const HubBeam beam = hub_beam(scene);
  const Beam& strip = *scene.beam();
  const double s = beam.coupling[0], g = scene.gravity->acceleration, k = 1.875104068711961;
  const double w2 = std::pow(k / strip.length, 4) * strip.youngs_modulus * *strip.second_moment /
                    (strip.density * *strip.area);
  const double m = centrifugal * (1.0 - (centrifugal > 0.0 ? beam.stiffening(0, 0) : 0.0));
  const auto rate = [&](const Eigen::Vector4d& x) {
    const double angle = x[0], q = x[1], turn = x[2], u = x[3];
    Eigen::Matrix2d mass;
    mass << beam.inertia + completed * m * q * q, s, s, 1.0;
    const Eigen::Vector2d force(
        -2.0 * completed * turn * m * q * u -
            g * (beam.moment * std::cos(angle) - beam.pull[0] * q * std::sin(angle)),
        -(w2 - turn * turn * m) * q - g * beam.pull[0] * std::cos(angle));
    const Eigen::Vector2d acceleration = mass.inverse() * force;
    return Eigen::Vector4d(turn, u, acceleration[0], acceleration[1]);
  };
  Eigen::Vector4d x(scene.initial->angle, scene.initial->q[0], scene.initial->rate,
                    scene.initial->qdot[0]);
  const int steps = 100'000;
  const double h = end / steps;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector4d a = rate(x), b = rate(x + 0.5 * h * a), c = rate(x + 0.5 * h * b),
                          d = rate(x + h * c);
    x += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return x;
}

TEST(TurningMotion, FollowsEachPairOfEquations) {
  struct Pair {
    bool centrifugal;
    HubEquations equations;
  };
  std::vector<double> angles;
  for (const Pair& pair : {Pair{true, HubEquations::kConsistent}, Pair{true, HubEquations::kPaper},
                           Pair{false, HubEquations::kConsistent}}) {
    Scene scene = strip_on_hub(1);
    scene.gravity = Gravity{9.81};
    scene.initial = Initial{{0.02}, {0.1}, 0.3, 5.0};
    scene.hub->centrifugal = pair.centrifugal;
    scene.hub->equations = pair.equations;
    const System system = assemble(scene);
    const Simulation end = run(scene, 1.0);
    ASSERT_EQ(end.outcome, RunOutcome::kReachedEnd) << end.message;
    const Eigen::Vector4d x =
        stepped(scene, pair.centrifugal, pair.equations == HubEquations::kConsistent, 1.0);
    angles.push_back(x[0]);
    EXPECT_NEAR(angle_of(system, end.final.q), x[0], 1e-9);
    EXPECT_NEAR(angle_of(system, end.final.qdot), x[2], 1e-7);
    EXPECT_NEAR((system.rotation()->beam * end.final.q)[0], x[1], 1e-10);
  }
  // They are three motions.
  EXPECT_GT(std::abs(angles[0] - angles[1]), 1e-4);
  EXPECT_GT(std::abs(angles[0] - angles[2]), 1e-4);
}

// Angular momentum about the centre: J r + s.q' + q.(1 - c) q r, which in these coordinates is
// e.M y' over the first coordinate's share.
TEST(TurningMotion, KeepsItsAngularMomentum) {
  Scene scene = strip_on_hub();
  scene.initial = bent(0.3, 5.0);
  const System system = assemble(scene);
  const auto momentum = [&](const State& state) {
    // The turning of the whole is the first coordinate: dL/dtheta' = (dL/dy_0')/e_0.
    const double rate = angle_of(system, state.qdot);
    return state.qdot[0] / system.rotation()->angle[0] +
           added_inertia(*system.rotation(), state.q) * rate;
  };
  const State start = initial_state(scene, system);
  const double before = momentum(start);
  EXPECT_NEAR(momentum(run(scene, 3.0).final) / before, 1.0, 1e-11);
}

// One mode on a hub too heavy to feel it: q'' = -(w^2 - r^2 (1 - c)) q.
TEST(TurningMotion, AHeavyHubMakesTheBeamStiffer) {
  Scene scene = strip_on_hub(1);
  scene.hub->inertia = 1e8;
  scene.initial = Initial{{0.01}, {0.0}, 0.0, 60.0};
  const System system = assemble(scene);
  const double w = system.omega[1];
  const double c = hub_beam(scene).stiffening(0, 0);
  const double turning = std::sqrt(w * w - 3600.0 * (1.0 - c));
  EXPECT_GT(turning, 1.05 * w);
  const Simulation end = run(scene, 0.05);
  const double q = (system.rotation()->beam * end.final.q)[0];
  EXPECT_NEAR(q, 0.01 * std::cos(turning * 0.05), 1e-11);
}

// A beam so stiff that it hardly bends: a rod, J theta'' = T - moment cos(theta). What is missing
// falls with the stiffness.
TEST(TurningMotion, AStiffBeamIsARod) {
  std::vector<double> misses;
  for (const double factor : {1e2, 1e3}) {
    Scene scene = strip_on_hub(2);
    std::get<Beam>(scene.structure).youngs_modulus *= factor;
    const double inertia = scene.hub->inertia + support::beam_inertia(scene);
    scene.hub->torque = TorquePulse{0.5, 0.2};
    const System system = assemble(scene);
    const double rate = 0.5 * 0.2 / inertia;
    const Simulation end = run(scene, 0.5);
    misses.push_back(angle_of(system, end.final.q) / (rate * 0.4) - 1.0);
    // A pendulum let go from the horizontal is on the other side after 2 K(sin(pi/4))
    // sqrt(J/moment).
    scene.hub->torque.reset();
    scene.gravity = Gravity{9.81};
    const System pendulum = assemble(scene);
    const double swing = 2.0 * std::comp_ellint_1(std::sqrt(0.5)) *
                         std::sqrt(inertia / pendulum.rotation()->weight->moment);
    misses.push_back(angle_of(pendulum, run(scene, swing).final.q) / (0.5 * kTurn) + 1.0);
  }
  EXPECT_LT(std::abs(misses[0]), 1e-3);
  EXPECT_LT(std::abs(misses[1]), 1e-3);
  EXPECT_LT(std::abs(misses[2]), 1e-4);
  EXPECT_LT(std::abs(misses[3]), 1e-4);
}

// A table of points is what lies between them: trapezia of angular impulse.
TEST(TurningMotion, ATorqueTableJumpsAndSlopes) {
  Scene scene = strip_on_hub(3);
  scene.hub->torque = TorqueTable{{0.1, 0.2, 0.2, 0.35}, {0.3, 0.5, -0.2, 0.4}};
  const System system = assemble(scene);
  scene.initial.reset();
  const Simulation end = run(scene, 0.6);
  const double impulse = 0.5 * (0.3 + 0.5) * 0.1 + 0.5 * (-0.2 + 0.4) * 0.15;
  const double rate = angle_of(system, end.final.qdot);
  const double momentum = end.final.qdot[0] / system.rotation()->angle[0] +
                          added_inertia(*system.rotation(), end.final.q) * rate;
  EXPECT_NEAR(momentum / impulse, 1.0, 1e-11);
  EXPECT_LT(std::abs(end.energy->defect()), 1e-11 * end.energy->size());
}

TEST(TurningMotion, ImpactsKeepTheMomentumOffTheContact) {
  Scene scene = strip_on_hub(4);
  scene.initial = Initial{{0.02, -0.002, 0.0005, 0.0}, {0.1, 0.2, -0.1, 0.0}, 0.0, 5.0};
  scene.stops = {stop_at(0.5, 0.2, 0.6)};
  scene.hub->torque = TorquePulse{0.4, 100.0};
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  Motion<double> motion(system, {}, start.q, start.qdot);
  for (int impacts = 0; impacts < 20;) {
    const Arrival<double> arrival = motion.fly(10.0);
    ASSERT_NE(arrival.kind, ArrivalKind::kTime);
    if (arrival.kind != ArrivalKind::kContact) continue;
    const Vector before = motion.qdot();
    motion.impact();
    ++impacts;
    const Vector change = motion.qdot() - before;
    const double added = added_inertia(*system.rotation(), motion.q());
    const Vector impulse = change + added * angle_of(system, change) * system.rotation()->angle;
    const Vector& row = system.stops[0].row;
    const Vector off = impulse - row * (row.dot(impulse) / row.squaredNorm());
    EXPECT_LT(off.norm(), 1e-13 * impulse.norm());
    EXPECT_NEAR(row.dot(motion.qdot()), -0.6 * row.dot(before), 1e-13 * std::abs(row.dot(before)));
  }
}

// Pressed onto a stop by the torque and damped, it comes to rest: N (x + alpha) = T.
TEST(TurningMotion, RestsOnAStopUnderTorque) {
  Scene scene = strip_on_hub(3);
  scene.damping = RayleighDamping{20.0, 1e-4};
  scene.hub->torque = TorquePulse{0.4, 60.0};
  scene.stops = {stop_at(0.45, 0.01, 0.3)};
  std::vector<Event> events;
  const Simulation end = run(scene, 10.0, &events);
  ASSERT_EQ(end.outcome, RunOutcome::kReachedEnd) << end.message;
  ASSERT_EQ(end.stuck.size(), 1u);
  EXPECT_NEAR(end.forces[0], 0.4 / 0.47, 1e-6);
  EXPECT_LT(std::abs(end.energy->defect()), 1e-10 * end.energy->size());
  EXPECT_EQ(end.totals.smallest_gap, 0.0);
}

// The same on a spring, whose depth then carries the force.
TEST(TurningMotion, RestsOnASpringUnderTorque) {
  Scene scene = strip_on_hub(3);
  scene.damping = RayleighDamping{20.0, 1e-4};
  scene.hub->torque = TorquePulse{0.4, 60.0};
  SceneStop stop = stop_at(0.45, 0.01, 0.0);
  stop.spring = Spring{1e5, 1.0, {}, {}, Separation::kAtZeroForce};
  scene.stops = {stop};
  const System system = assemble(scene);
  const Simulation end = run(scene, 10.0);
  ASSERT_EQ(end.outcome, RunOutcome::kReachedEnd) << end.message;
  EXPECT_NEAR((system.stops[0].row.dot(end.final.q) - 0.01) * 1e5, 0.4 / 0.47, 1e-6);
  EXPECT_LT(std::abs(end.energy->defect()), 1e-10 * end.energy->size());
}

// Released: the torque ends, the bent beam pushes itself off.
TEST(TurningMotion, LeavesAStopWhenTheForceIsGone) {
  Scene scene = strip_on_hub(3);
  scene.damping = RayleighDamping{20.0, 1e-4};
  scene.hub->torque = TorquePulse{0.4, 5.0};
  scene.stops = {stop_at(0.45, 0.01, 0.3)};
  std::vector<Event> events;
  const Simulation end = run(scene, 5.5, &events);
  ASSERT_EQ(end.outcome, RunOutcome::kReachedEnd) << end.message;
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.back().kind, EventKind::kRelease);
  EXPECT_GT(events.back().time, 5.0);
  EXPECT_LT(std::abs(end.energy->defect()), 1e-10 * end.energy->size());
}

// Stiff, so that the hub's friction stands alone: it is turned by what exceeds the friction, comes
// to rest after (T - c) d/c more seconds, and stays there.
TEST(TurningMotion, FrictionStopsTheHub) {
  Scene scene = strip_on_hub(2);
  std::get<Beam>(scene.structure).youngs_modulus *= 1e3;
  scene.damping = RayleighDamping{0.0, 1e-4};
  scene.hub->friction = 0.2;
  scene.hub->torque = TorquePulse{0.5, 0.1};
  const System system = assemble(scene);
  const double inertia = scene.hub->inertia + support::beam_inertia(scene);
  const Simulation end = run(scene, 1.0);
  ASSERT_EQ(end.outcome, RunOutcome::kReachedEnd) << end.message;
  EXPECT_NEAR(angle_of(system, end.final.qdot), 0.0, 1e-30);
  const double turned = 0.5 * 0.3 / inertia * 0.01 * (1.0 + 0.3 / 0.2);
  EXPECT_NEAR(angle_of(system, end.final.q) / turned, 1.0, 2e-3);
  EXPECT_NEAR(end.energy->work.forcing, 0.5 * angle_of(system, run(scene, 0.1).final.q), 1e-9);
  EXPECT_LT(std::abs(end.energy->defect()), 1e-10 * end.energy->size());
}

// Less torque than that does not turn it.
TEST(TurningMotion, FrictionHoldsTheHub) {
  Scene scene = strip_on_hub(2);
  scene.hub->friction = 0.2;
  scene.hub->torque = TorquePulse{0.19, 0.1};
  const System system = assemble(scene);
  const Simulation end = run(scene, 1.0);
  EXPECT_NEAR(angle_of(system, end.final.q), 0.0, 1e-30);
  // A slope reaches it where it says so: the hub stands until then, t = 0.2/(0.4/s).
  scene.hub->torque = TorqueTable{{0.0, 1.0}, {0.0, 0.4}};
  EXPECT_NEAR(angle_of(system, run(scene, 0.5 - 1e-9).final.q), 0.0, 1e-30);
  const Simulation turned = run(scene, 0.51);
  ASSERT_EQ(turned.outcome, RunOutcome::kReachedEnd) << turned.message;
  EXPECT_GT(angle_of(system, turned.final.q), 0.0);
}

// A beam plucked beside a hub that friction holds vibrates as if it were clamped.
TEST(TurningMotion, AHeldHubIsAClamp) {
  Scene scene = strip_on_hub(2);
  scene.hub->friction = 10.0;
  scene.initial = Initial{{0.01, 0.001}, {0.0, 0.0}, 0.4, 0.0};
  const System system = assemble(scene);
  const Vector clamped = modal_model(scene).omega;
  const Simulation end = run(scene, 0.3);
  const Vector q = system.rotation()->beam * end.final.q;
  EXPECT_NEAR(q[0], 0.01 * std::cos(clamped[0] * 0.3), 1e-13);
  EXPECT_NEAR(q[1], 0.001 * std::cos(clamped[1] * 0.3), 1e-13);
  EXPECT_NEAR(angle_of(system, end.final.q), 0.4, 1e-15);
}

// Thrown off the stop again and again, brought back by the torque against friction.
TEST(TurningMotion, FrictionAndImpacts) {
  Scene scene = strip_on_hub(3);
  scene.damping = RayleighDamping{5.0, 1e-5};
  scene.hub->friction = 0.1;
  scene.hub->torque = TorquePulse{0.4, 60.0};
  scene.stops = {stop_at(0.45, 0.05, 0.5)};
  const Simulation end = run(scene, 3.0);
  ASSERT_EQ(end.outcome, RunOutcome::kReachedEnd) << end.message;
  EXPECT_GT(end.totals.impacts, 3);
  EXPECT_LT(std::abs(end.energy->defect()), 1e-9 * end.energy->size());
}

// Against a ball, with several sets of contacts between which the hub stands still and is turned
// on; at a standstill its rate is rounding of either sign.
TEST(TurningMotion, FrictionHoldsAndLetsGoAtAnyRounding) {
  for (const char* modes : {"3", "6"})
    for (const char* friction : {"0.01", "0.02", "0.05", "0.1"}) {
      const Scene scene = support::shipped_scene(
          "17_yigit_lee_wang_1",
          {std::string("beam.modes=") + modes, std::string("hub.friction.coulomb=") + friction});
      const Simulation end = run(scene, 1.5);
      EXPECT_EQ(end.outcome, RunOutcome::kReachedEnd) << modes << " " << friction << end.message;
    }
}

// Chatter, rest and release by the hundred; what leaves a stop without speed is not met again by
// rounding.
TEST(TurningMotion, LeavesEveryStopThatItRestedOn) {
  Scene scene = strip_on_hub(3);
  for (const double gap : {0.01, 0.05, 0.12, 0.2})
    for (const double torque : {0.1, 0.24, 0.7}) {
      scene.hub->torque = TorquePulse{torque, 60.0};
      scene.stops = {stop_at(0.6, gap, 0.46)};
      const Simulation end = run(scene, 1.5);
      EXPECT_EQ(end.outcome, RunOutcome::kReachedEnd) << gap << " " << torque << end.message;
      EXPECT_GT(end.totals.impacts, 0);
      EXPECT_LT(std::abs(end.energy->defect()), 1e-9 * end.energy->size());
    }
}

TEST(TurningMotion, IsGoneOnWithAsIfItHadNotEnded) {
  Scene scene = strip_on_hub(3);
  scene.hub->torque = TorquePulse{1.0, 0.05};
  scene.stops = {stop_at(0.45, 0.05, 0.5)};
  const System system = assemble(scene);
  SimulationOptions options;
  std::vector<double> whole, parts;
  RunListeners listeners;
  listeners.event = [&](const Event& event) { whole.push_back(event.time); };
  options.duration = 1.0;
  const Simulation once = simulate(system, initial_state(scene, system), options, listeners);
  listeners.event = [&](const Event& event) { parts.push_back(event.time); };
  options.duration = 0.0333;
  Simulation part = simulate(system, initial_state(scene, system), options, listeners);
  for (const double end : {0.05, 0.41, 1.0}) {
    options.duration = end;
    part = resume(system, part.state, options, listeners);
  }
  EXPECT_GT(whole.size(), 1u);
  EXPECT_EQ(whole, parts);
  EXPECT_EQ(once.final.q, part.final.q);
}

}  // namespace
}  // namespace graze
