// Friction behind springs (Jenkins elements): pieces in closed form, slopes by differences.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/problem/detail/section_map.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// Behind a spring what rubs has a place of its own, which the state of the section holds.
TEST(FrictionMap, BehindASpringHasTheSlopesOfItsDifferences) {
  const std::string text =
      "[lumped]\nmasses = [1.0, 0.5]\n"
      "[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 10.0\ndamping = 0.1\n"
      "[[lumped.spring]]\nbetween = [1, 2]\nstiffness = 4.0\ndamping = 0.02\n"
      "[forcing]\nkind = \"point\"\nmass = 1\namplitude = 2.0\nfrequency = 3.0\n"
      "[[friction]]\nmass = 2\nagainst = 1\nforce = 0.4\nseries = 5.0\nparallel = 1.0\n"
      "[[stop]]\nmass = 2\ngap = 0.3\nrestitution = 0.7\n";
  const Scene scene = parse_scene(text, "jenkins");
  for (const double theta : {0.95, 1.9, 3.9, 6.0, 0.4, 3.0, 5.0}) {  // at the last it slides
    const System system = assemble(scene);
    SegmentOptions options;
    options.closure_speed = 1e-9;
    const SectionMap map(system, {}, options);
    const auto there = map.follow(system, map.pack(system, initial_state(scene, system)), theta, 3);
    ASSERT_TRUE(there);
    State start{there->end.q, there->end.qdot};
    // A little beyond the limit, to which each start is then put back.
    const Friction::Series& spring = *system.frictions[0].series;
    const double length = spring.row.dot(start.q);
    if (std::abs(std::abs(length) - 0.4 / 5.0) < 1e-9)
      start.q += spring.direction * (1e-5 * length);
    const Vector x = map.pack(system, start);
    const auto at = [&](const System& of, const Vector& from) {
      return map.image(of, from, theta, 1, false, {})->image;
    };
    constexpr double kStep = 1e-7;
    const auto own = map.image(system, x, theta, 1, false, {});
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      const Vector by = kStep * Vector::Unit(x.size(), j);
      const Vector slope = (at(system, x + by) - at(system, x - by)) / (2.0 * kStep);
      EXPECT_LE((slope - own->jacobian.col(j)).norm(), 5e-6 * (1.0 + slope.norm()))
          << j << " " << theta << "\n"
          << slope.transpose() << "\n"
          << own->jacobian.col(j).transpose();
    }
    for (const char* name : {"friction.series", "friction.parallel", "friction.force",
                             "lumped.masses.1", "lumped.spring.1.stiffness", "stop.gap"}) {
      const System tangent = system_tangent(scene, name);
      const System* along = &tangent;
      const auto image = map.image(system, x, theta, 1, false, std::span(&along, 1));
      ASSERT_TRUE(image) << name;
      const double value = *parameter_value(scene, name);
      const auto moved = [&](double step) {
        return at(assemble(with_parameter(scene, name, value + step)), x);
      };
      const Vector slope = (moved(kStep) - moved(-kStep)) / (2.0 * kStep);
      EXPECT_LE((slope - image->by_parameters.col(0)).norm(), 5e-6 * (1.0 + slope.norm()))
          << name << " " << theta << "\n"
          << slope.transpose() << "\n"
          << image->by_parameters.col(0).transpose();
    }
  }
}

// m u'' + K u + R = cos(w t) behind a stop, R = k (u - z) while z is at rest, R = +-L while it
// follows: pieces in closed form, in long double, with the events between them by bisection.
class JenkinsPieces {
 public:
  using Real = long double;
  struct Event {
    EventKind kind;
    double time;
  };
  JenkinsPieces(Real m, Real k, Real in_series, Real force, Real w, Real a, Real r)
      : mass(m), spring(k), series(in_series), limit(force), frequency(w), gap(a), restitution(r) {}

  std::vector<Event> run(Real end) {
    std::vector<Event> events;
    const Real step = 1e-3L;
    while (time_ < end) {
      if (passes(step) < 0) {
        move(step);
        continue;
      }
      Real low = 0, high = step;
      for (int i = 0; i < 80; ++i) {
        const Real middle = low + (high - low) / 2;
        (passes(middle) < 0 ? low : high) = middle;
      }
      const int what = passes(high);
      move(high);
      if (what == 0) {
        events.push_back({EventKind::kImpact, static_cast<double>(time_)});
        v_ *= -restitution;
        if (way_ != 0 && way_ * v_ < 0) stick(events);
      } else if (way_ == 0) {
        way_ = u_ > z_ ? 1 : -1;
        events.push_back({EventKind::kSlip, static_cast<double>(time_)});
      } else {
        stick(events);
      }
    }
    return events;
  }

 private:
  Real mass, spring, series, limit, frequency, gap, restitution;
  struct Place {
    Real u, v;
  };
  void stick(std::vector<Event>& events) {
    z_ = u_ - way_ * limit / series;
    way_ = 0;
    events.push_back({EventKind::kFrictionStick, static_cast<double>(time_)});
  }
  Place after(Real s) const {
    const Real square = (spring + (way_ == 0 ? series : 0)) / mass, w = std::sqrt(square);
    const Real load = (way_ == 0 ? series * z_ : -way_ * limit) / mass / square;
    const Real forced = 1 / mass / (square - frequency * frequency);
    const Real a = u_ - load - forced * std::cos(frequency * time_);
    const Real b = (v_ + forced * frequency * std::sin(frequency * time_)) / w;
    const Real t = time_ + s;
    return {a * std::cos(w * s) + b * std::sin(w * s) + load + forced * std::cos(frequency * t),
            w * (b * std::cos(w * s) - a * std::sin(w * s)) -
                forced * frequency * std::sin(frequency * t)};
  }
  // 0: the stop, 1: the friction, where it is passed; -1: neither is.
  int passes(Real s) const {
    const Place at = after(s);
    if (at.u > gap && at.v > 0) return 0;
    if (way_ == 0 ? series * std::abs(at.u - z_) > limit && (at.u - z_) * at.v > 0
                  : way_ * at.v < 0)
      return 1;
    return -1;
  }
  void move(Real s) {
    const Place at = after(s);
    u_ = at.u;
    v_ = at.v;
    time_ += s;
  }

  Real time_ = 0, u_ = 0, v_ = 0, z_ = 0;
  int way_ = 0;
};

TEST(FrictionBehindASpring, MovesAsInPieces) {
  support::Dice dice(11);
  for (int i = 0; i < 25; ++i) {
    const double mass = dice.uniform(0.5, 2.0), spring = dice.uniform(0.5, 2.0),
                 series = dice.uniform(0.5, 5.0), limit = dice.uniform(0.1, 0.6),
                 frequency = dice.uniform(0.4, 2.5), gap = dice.uniform(0.3, 1.5),
                 restitution = dice.uniform(0.4, 0.9);
    const Scene scene = parse_scene(
        fmt::format("[lumped]\nmasses = [{}]\n[[lumped.spring]]\nbetween = [0, 1]\n"
                    "stiffness = {}\n[forcing]\nkind = \"point\"\nmass = 1\namplitude = 1.0\n"
                    "frequency = {}\n[[friction]]\nmass = 1\nforce = {}\nseries = {}\n"
                    "[[stop]]\nmass = 1\ngap = {}\nrestitution = {}\n",
                    mass, spring, frequency, limit, series, gap, restitution),
        "jenkins");
    const System system = assemble(scene);
    SimulationOptions options = support::for_seconds(40.0);
    options.energy = true;
    const auto run = support::record_run(system, initial_state(scene, system), options);
    const auto wanted =
        JenkinsPieces(mass, spring, series, limit, frequency, gap, restitution).run(40.0L - 1e-6L);
    EXPECT_LE(std::abs(run.result.energy->defect()), 1e-12 * run.result.energy->size()) << i;
    ASSERT_GE(run.events.size(), wanted.size()) << i;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      EXPECT_EQ(run.events[k].kind, wanted[k].kind) << i << " " << k;
      ASSERT_NEAR(run.events[k].time, wanted[k].time, 1e-10) << i << " " << k;
    }
  }
}

// Two masses that a Jenkins element joins in space: the relative motion is that of the reduced mass
// on the element, and their common motion is uniform.
TEST(FrictionBehindASpring, ActsOnBothItsPlaces) {
  const double m = 1.0, n = 0.5, k = 4.0, limit = 0.7, speed = 1.3;
  const Scene scene =
      parse_scene(fmt::format("[lumped]\nmasses = [{}, {}]\n[[friction]]\nmass = 2\nagainst = 1\n"
                              "force = {}\nseries = {}\n[initial]\nvelocity = [0.0, {}]\n",
                              m, n, limit, k, speed),
                  "joined");
  const System system = assemble(scene);
  const auto run =
      support::record_run(system, initial_state(scene, system), support::for_seconds(10.0));
  const double reduced = m * n / (m + n), w = std::sqrt(k / reduced);
  // It slips where k (speed/w) sin w t = L, and stops as L slows the reduced mass.
  const double slips = std::asin(limit * w / (k * speed)) / w;
  const double left = speed * std::cos(w * slips), sticks = slips + left * reduced / limit;
  ASSERT_GE(run.events.size(), 2u);
  EXPECT_EQ(run.events[0].kind, EventKind::kSlip);
  EXPECT_NEAR(run.events[0].time, slips, 1e-13);
  EXPECT_EQ(run.events[1].kind, EventKind::kFrictionStick);
  EXPECT_NEAR(run.events[1].time, sticks, 1e-13);
  const Matrix& shapes = scene.discrete()->solved->modes.shapes;
  const Vector moved = shapes * run.result.final.q, fast = shapes * run.result.final.qdot;
  EXPECT_NEAR(m * moved[0] + n * moved[1], n * speed * 10.0, 1e-12);
  // From then on it swings about where the spring is not stretched.
  const double phase = w * (10.0 - sticks),
               middle = speed / w * std::sin(w * slips) + left * (sticks - slips) -
                        0.5 * limit / reduced * (sticks - slips) * (sticks - slips) - limit / k;
  EXPECT_NEAR(moved[1] - moved[0], middle + limit / k * std::cos(phase), 1e-12);
  EXPECT_NEAR(fast[1] - fast[0], -limit / k * w * std::sin(phase), 1e-12);
}

}  // namespace
}  // namespace graze
