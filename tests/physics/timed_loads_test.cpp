// Loads without a common period: frequencies of their own, signals from files and such as are drawn
// from a spectral density.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/angle.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/detail/random_course.hpp"
#include "graze/scene/reader.hpp"
#include "support/scratch_folder.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::RecordedRun;

const std::string kOneMass =
    "[lumped]\nmasses = [2]\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 18\n";

struct Started {
  Scene scene;
  System system;
  State start;
};
Started started(const std::string& text, const std::filesystem::path& folder = "") {
  Scene scene = parse_scene(text, (folder / "scene.toml").string());
  System system = assemble(scene);
  State start = initial_state(scene, system);
  return {std::move(scene), std::move(system), std::move(start)};
}

RecordedRun run_of(const Started& of, double seconds) {
  SimulationOptions options = support::for_seconds(seconds);
  options.energy = true;
  RecordedRun run = support::record_run(of.system, of.start, options);
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_LE(std::abs(run.result.energy->defect()), 1e-10 * run.result.energy->size());
  return run;
}

// u and u' of the mass of 2 kg.
double displacement(const Simulation& run) { return run.final.q[0] / std::sqrt(2.0); }

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

// 2 x'' + 18 x = 2 cos 2t + 5 cos(sqrt(5) t + 1), from rest: each harmonic with the free motion
// that puts it to rest at the start.
TEST(TimedLoads, IncommensurateFrequenciesWithoutContact) {
  const double nu = std::sqrt(5.0);
  const Started of = started(kOneMass + fmt::format("[[forcing]]\nmass = 1\namplitude = 2\nfrequency "
                                                 "= 2\n[[forcing]]\nmass = 1\namplitude = 5\n"
                                                 "frequency = {}\nphase = 1\n",
                                                 nu));
  EXPECT_FALSE(of.system.repeats());
  const auto part = [](double amplitude, double frequency, double phase, double t) {
    const double size = 0.5 * amplitude / (9.0 - frequency * frequency);
    return size * (std::cos(frequency * t + phase) - std::cos(phase) * std::cos(3.0 * t) +
                   frequency / 3.0 * std::sin(phase) * std::sin(3.0 * t));
  };
  for (const double t : {0.3, 7.0, 55.5, 400.25})
    EXPECT_NEAR(displacement(run_of(of, t).result), part(2.0, 2.0, 0.0, t) + part(5.0, nu, 1.0, t),
                1e-12 * std::sqrt(1.0 + t));
}

// A frequency that happens to be a multiple of the first is the load of that order.
TEST(TimedLoads, AFrequencyOfItsOwnIsThatOfAnOrder) {
  for (const char* law : {"restitution = 0.7\n", "restitution = 0\n",
                          "[stop.spring]\nstiffness = 300\n",
                          "[stop.spring]\nstiffness = 900\nexponent = 1.5\n"}) {
    SCOPED_TRACE(law);
    const std::string scene = kOneMass + "damping = 0.4\n[[forcing]]\nmass = 1\namplitude = 9\n"
                                      "frequency = 2\nphase = 0.2\n[[forcing]]\nmass = 1\n"
                                      "amplitude = 7\nphase = 0.9\n";
    const std::string stop = std::string("[[stop]]\nmass = 1\ngap = 0.1\n") + law;
    const RecordedRun own = run_of(started(scene + "frequency = 3\n" + stop), 40.0);
    const RecordedRun order = run_of(started(scene + "order = 1.5\n" + stop), 40.0);
    ASSERT_GT(order.events.size(), 20u);
    ASSERT_EQ(own.events.size(), order.events.size());
    for (std::size_t i = 0; i < own.events.size(); ++i) {
      EXPECT_EQ(own.events[i].kind, order.events[i].kind);
      EXPECT_NEAR(own.events[i].time, order.events[i].time, 1e-10);
      EXPECT_NEAR(own.events[i].speed, order.events[i].speed, 1e-9);
    }
  }
}

// x'' + 9 x = f/2, f linear over each piece: x = (f0 + f1 s)/18 + a cos 3s + b sin 3s.
struct Linear {
  double x = 0.0, v = 0.0;
  void pass(double f0, double f1, double s) {
    const double a = x - f0 / 18.0, b = (v - f1 / 18.0) / 3.0;
    x = (f0 + f1 * s) / 18.0 + a * std::cos(3.0 * s) + b * std::sin(3.0 * s);
    v = f1 / 18.0 - 3.0 * a * std::sin(3.0 * s) + 3.0 * b * std::cos(3.0 * s);
  }
};

TEST(TimedLoads, ASignalIsExactAlongEachOfItsLines) {
  const ScratchFolder folder;
  write(folder / "load.csv", "t (ms);force (kN)\n200;0\n500;0,004\n900;-0,002\n1500;0,001\n");
  const double at[] = {0.2, 0.5, 0.9, 1.5}, force[] = {0.0, 4.0, -2.0, 1.0};
  const Started of = started(
      kOneMass + "[forcing]\nmass = 1\namplitude = 3\nsignal = { file = \"load.csv\" }\n",
      folder.string());
  Linear motion;
  double t = 0.2;
  for (int k = 0; k < 3; ++k) {
    const double h = at[k + 1] - at[k];
    motion.pass(3.0 * force[k], 3.0 * (force[k + 1] - force[k]) / h, h);
    t += h;
    EXPECT_NEAR(displacement(run_of(of, t).result), motion.x, 1e-13);
  }
  motion.pass(0.0, 0.0, 10.0);
  EXPECT_NEAR(displacement(run_of(of, t + 10.0).result), motion.x, 1e-12);
}

TEST(TimedLoads, ARepeatedSignalBeginsAgain) {
  const ScratchFolder folder;
  write(folder / "load.csv", "time,force\n0,1\n0.5,-1\n1.25,2\n");
  const Started of = started(
      kOneMass + "[forcing]\nmass = 1\nsignal = { file = \"load.csv\", repeat = true }\n",
      folder.string());
  Linear motion;
  for (int turn = 0; turn < 40; ++turn) {
    motion.pass(1.0, -4.0, 0.5);
    motion.pass(-1.0, 4.0, 0.75);
  }
  EXPECT_NEAR(displacement(run_of(of, 50.0).result), motion.x, 1e-11);
}

// A ground that is accelerated leaves a free mass behind by t^2/2 of it, and one that is accelerated
// evenly is a weight.
TEST(TimedLoads, AnAcceleratedBaseIsAWeight) {
  const ScratchFolder folder;
  write(folder / "ground.csv", "time,a\n0,-3\n40,-3\n");
  const std::string stop = "damping = 0.3\n[[stop]]\nmass = 1\ngap = 0.35\nrestitution = 0.8\n";
  const RecordedRun shaken = run_of(
      started(kOneMass + stop + "[forcing]\nkind = \"base\"\nsignal = { file = \"ground.csv\" }\n",
              folder.string()),
      39.0);
  const RecordedRun heavy = run_of(started(kOneMass + stop + "[gravity]\nacceleration = 3\n"), 39.0);
  ASSERT_GT(heavy.events.size(), 3u);
  ASSERT_EQ(shaken.events.size(), heavy.events.size());
  for (std::size_t i = 0; i < heavy.events.size(); ++i) {
    EXPECT_EQ(shaken.events[i].kind, heavy.events[i].kind);
    EXPECT_NEAR(shaken.events[i].time, heavy.events[i].time, 1e-10);
  }
}

// A free mass under a force that rises by 6 N/s, 2 x'' = 6 t: it is at .5 at t = 1, with the speed
// 1.5; a stop there holds it (r = 0) until the force is gone, at 4.
TEST(TimedLoads, ARampDrivesAMassAgainstAStop) {
  const ScratchFolder folder;
  write(folder / "ramp.csv", "time,force\n0,0\n2,12\n4,0\n6,-12\n");
  const Started of = started(
      "[lumped]\nmasses = [2]\n[forcing]\nmass = 1\nsignal = { file = \"ramp.csv\" }\n"
      "[[stop]]\nmass = 1\ngap = 0.5\nrestitution = 0\n",
      folder.string());
  const RecordedRun run = run_of(of, 5.0);
  ASSERT_EQ(run.events.size(), 3u);
  EXPECT_EQ(run.events[0].kind, EventKind::kImpact);
  EXPECT_NEAR(run.events[0].time, 1.0, 1e-14);
  EXPECT_NEAR(run.events[0].speed, 1.5, 1e-14);
  EXPECT_EQ(run.events[1].kind, EventKind::kStick);
  EXPECT_NEAR(run.events[1].force, 6.0, 1e-12);
  EXPECT_EQ(run.events[2].kind, EventKind::kRelease);
  EXPECT_NEAR(run.events[2].time, 4.0, 1e-12);
  EXPECT_NEAR(displacement(run.result), 0.5 - 0.5, 1e-11);  // -3 (t - 4)^2/6 s later
}

// Supports that all move alike are a base that moves: the same motion, seen from the ground.
TEST(TimedLoads, SupportsThatMoveTogetherAreTheBase) {
  const std::string masses =
      "[lumped]\nmasses = [2, 1]\n"
      "[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 50\ndamping = 0.7\n"
      "[[lumped.spring]]\nbetween = [\"ground\", 2]\nstiffness = 30\ndamping = 0.2\n"
      "[[lumped.spring]]\nbetween = [1, 2]\nstiffness = 20\ndamping = 0.1\n";
  const double w = 3.7, size = 0.2;
  const std::string moves = fmt::format("amplitude = {}\nphase = -1.5707963267948966\n", size);
  const Started base = started(
      masses + "[forcing]\nkind = \"base\"\nfrequency = 3.7\n" + moves +
      "[[stop]]\nmass = 1\nagainst = 2\ngap = 0.02\nrestitution = 0.6\n");
  const Started supports = started(
      masses + "[[forcing]]\nkind = \"support\"\nmass = 1\nfrequency = 3.7\n" + moves +
      "[[forcing]]\nkind = \"support\"\nmass = 2\n" + moves +
      "[[stop]]\nmass = 1\nagainst = 2\ngap = 0.02\nrestitution = 0.6\n" +
      fmt::format("[initial]\nvelocity = [{0}, {0}]\n", size * w));
  const RecordedRun from_base = run_of(base, 15.0), from_ground = run_of(supports, 15.0);
  ASSERT_GT(from_base.events.size(), 5u);
  ASSERT_EQ(from_base.events.size(), from_ground.events.size());
  for (std::size_t i = 0; i < from_base.events.size(); ++i)
    EXPECT_NEAR(from_base.events[i].time, from_ground.events[i].time, 1e-11);
  const Matrix& shapes = base.scene.discrete()->solved->modes.shapes;
  const Vector apart = shapes * (from_ground.result.final.q - from_base.result.final.q);
  for (const double moved : apart) EXPECT_NEAR(moved, size * std::sin(w * 15.0), 1e-11);
}

// Its multipliers are those of the motion over one turn of the signal, by differences.
TEST(TimedLoads, OrbitsUnderARepeatedSignal) {
  const ScratchFolder folder;
  write(folder / "load.csv", "time,force\n0,9\n0.6,-9\n1.5,3\n2.1,9\n");
  const Started of = started(
      kOneMass + "damping = 1.5\n[forcing]\nmass = 1\nsignal = { file = \"load.csv\", repeat = "
              "true }\n[[stop]]\nmass = 1\ngap = 0.3\nrestitution = 0.7\n",
      folder.string());
  EXPECT_TRUE(of.system.repeats());
  EXPECT_NEAR(of.system.period(), 2.1, 1e-15);
  FinderOptions options;
  options.impacts.reset();
  const FoundOrbits found = find_orbits(of.system, of.start, options);
  ASSERT_FALSE(found.orbits.empty());
  const Orbit& orbit = found.orbits.front();
  ASSERT_TRUE(orbit.section);
  ASSERT_GT(orbit.impacts.size(), 0u);
  const MotionState<double>& at = orbit.section->states.front();
  const auto end = [&](double q, double qdot) {
    RunState state = simulate(of.system, of.start, support::for_seconds(0.0)).state;
    state.motion = at;
    state.motion.q[0] += q;
    state.motion.qdot[0] += qdot;
    state.motion.instant.period = 0;
    SimulationOptions run;
    run.duration = at.instant.local + 2.1 * orbit.period;
    return resume(of.system, state, run).final;
  };
  const State back = end(0.0, 0.0);
  EXPECT_NEAR(back.q[0], at.q[0], 1e-11);
  EXPECT_NEAR(back.qdot[0], at.qdot[0], 1e-11);
  const double h = 1e-6;
  Matrix map(2, 2);
  for (int k = 0; k < 2; ++k) {
    const State up = end(k == 0 ? h : 0.0, k == 1 ? h : 0.0),
                down = end(k == 0 ? -h : 0.0, k == 1 ? -h : 0.0);
    map.col(k) << (up.q[0] - down.q[0]) / (2.0 * h), (up.qdot[0] - down.qdot[0]) / (2.0 * h);
  }
  const Complex sum = orbit.multipliers[0].value + orbit.multipliers[1].value;
  const Complex product = orbit.multipliers[0].value * orbit.multipliers[1].value;
  EXPECT_NEAR(sum.real(), map.trace(), 1e-8);
  EXPECT_NEAR(product.real(), map.determinant(), 1e-8);
}

// The mean square is the area of the density, and harmonics carry it where it is.
TEST(TimedLoads, ADrawnCourseHasItsDensity) {
  const SpectralDensity density{{2.0, 5.0, 8.0}, {0.0, 3.0, 0.0}};
  const double duration = 64.0, step = 1.0 / 32.0;
  for (const unsigned seed : {1u, 7u}) {
    const auto course = drawn_course(density, duration, step, seed);
    ASSERT_EQ(course->values.size(), 2049u);
    EXPECT_EQ(course->values.back(), course->values.front());
    double square = 0.0, mean = 0.0;
    for (std::size_t k = 0; k < 2048; ++k) {
      square += course->values[k] * course->values[k] / 2048.0;
      mean += course->values[k] / 2048.0;
    }
    EXPECT_NEAR(square, 9.0, 1e-10);  // the trapezoidal sum of a triangle is exact
    EXPECT_NEAR(mean, 0.0, 1e-13);
    for (const double frequency : {1.0, 3.0, 5.0, 7.5}) {
      std::complex<double> sum = 0.0;
      for (std::size_t k = 0; k < 2048; ++k)
        sum += course->values[k] * std::polar(2.0 / 2048.0, -kTurn * frequency * course->times[k]);
      EXPECT_NEAR(0.5 * std::norm(sum) * duration, density.at(frequency), 1e-10);
    }
  }
  EXPECT_NE(drawn_course(density, duration, step, 1)->values,
            drawn_course(density, duration, step, 2)->values);
}

}  // namespace
}  // namespace graze
