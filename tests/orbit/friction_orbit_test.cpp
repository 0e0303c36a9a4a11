// Periodic orbits with dry friction: Den Hartog's oscillator in closed form, slopes by differences.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/contact/detail/impulse.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/orbit_amplitudes.hpp"
#include "graze/orbit/problem/detail/section_map.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

void add_friction(System& system, const Vector& row, double sliding, double sticking,
                  double speed = 0.0) {
  system.frictions.push_back({row, momentum_direction(row), sliding, sticking, speed});
}

System den_hartog(double frequency, double force) {
  System system{Vector::Ones(1), NaturalModes{Vector::Zero(1)}, {}};
  system = support::forced(system, frequency, 0.0, Vector::Ones(1));
  add_friction(system, Vector::Ones(1), force, force);
  return system;
}

std::vector<Orbit> orbits_of(const System& system) {
  FinderOptions options;
  options.impacts = 0;
  return find_orbits(system, support::rest(system), options).orbits;
}

// J. P. Den Hartog, Trans. ASME 53 (1931), APM-53-9: the motion without stops, and the friction up
// to which there is one. Frequencies, in parts of the natural one, and friction, in parts of the
// force.
TEST(FrictionOrbits, HaveDenHartogsAmplitude) {
  constexpr double kPi = std::numbers::pi;
  int tried = 0;
  for (const double b : {0.42, 0.47, 0.6, 0.7, 0.85, 1.2, 1.35, 1.6, 2.0, 3.0})
    for (const double part : {0.35, 0.8}) {
      const double v = 1.0 / (1.0 - b * b), u = std::sin(kPi / b) / (b * (1.0 + std::cos(kPi / b)));
      const double most = std::sqrt(v * v / (u * u + 1.0 / std::pow(b, 4)));
      // Below that force the amplitude at resonance has no bound.
      const double force = part * std::min(most, 0.7);
      const System system = den_hartog(b, force);
      const std::vector<Orbit> orbits = orbits_of(system);
      ASSERT_EQ(orbits.size(), 1u) << b << " " << force;
      const Amplitudes found = orbit_amplitudes(system, orbits[0], {{Vector::Ones(1)}});
      EXPECT_NEAR(found.rows[0].highest, std::sqrt(v * v - force * force * u * u), 1e-10) << b;
      EXPECT_EQ(orbits[0].stable, true);
      ++tried;
    }
  EXPECT_EQ(tried, 20);
}

// The same oscillator piece by piece in long double, from rest until what it was has died out:
// sliding in closed form, the ends of pieces by bisection.
class PiecewiseDenHartog {
 public:
  using Real = long double;
  struct Piece {
    double phase = 0.0;  // where it begins
    Rubs what = Rubs::kSticks;
    double place = 0.0;
  };

  PiecewiseDenHartog(Real frequency, Real force) : b_(frequency), force_(force) {}

  // Those of one period, by phase.
  std::vector<Piece> last_period() {
    const Real period = 2 * std::numbers::pi_v<Real> / b_;
    std::vector<Piece> pieces;
    constexpr int kLast = 300;
    while (t_ < (kLast + 1) * period) {
      const bool sticks = !(std::abs(push(t_)) > force_);
      const auto note = [&](Rubs what) {
        if (t_ >= kLast * period && t_ < (kLast + 1) * period)
          pieces.push_back(
              {static_cast<double>(b_ * (t_ - kLast * period)), what, static_cast<double>(x_)});
      };
      if (sticks) {
        note(Rubs::kSticks);
        t_ = first_after(t_, [&](Real t) { return std::abs(push(t)) > force_; });
      }
      const bool forward = push(t_) > 0;
      note(forward ? Rubs::kForward : Rubs::kBackward);
      slide(forward ? 1 : -1);
    }
    return pieces;
  }

 private:
  Real push(Real t) const { return std::cos(b_ * t) - x_; }

  template <class Condition>
  Real first_after(Real from, const Condition& holds) const {
    constexpr Real kScan = 0.02L;
    Real low = from, high = from + kScan;
    while (!holds(high)) {
      low = high;
      high += kScan;
    }
    for (int i = 0; i < 70; ++i) {
      const Real middle = low + (high - low) / 2;
      (holds(middle) ? high : low) = middle;
    }
    return high;
  }

  void slide(int sign) {
    const Real c = 1 / (1 - b_ * b_), rest = -sign * force_, t0 = t_;
    const Real a = x_ - rest - c * std::cos(b_ * t0), b = c * b_ * std::sin(b_ * t0);
    const auto speed = [&](Real t) {
      return -a * std::sin(t - t0) + b * std::cos(t - t0) - c * b_ * std::sin(b_ * t);
    };
    t_ = first_after(t0, [&](Real t) { return !(sign * speed(t) > 0); });
    x_ = rest + a * std::cos(t_ - t0) + b * std::sin(t_ - t0) + c * std::cos(b_ * t_);
  }

  Real b_, force_, t_ = 0, x_ = 0;
};

// Den Hartog's motions with one stop in half a period, and with two.
TEST(FrictionOrbits, StopAsPiecesInClosedForm) {
  const std::vector<std::tuple<double, double, int>> cases{
      {0.4, 0.3, 2},  {0.5, 0.5, 2},  {0.7, 0.8, 2}, {0.9, 0.9, 2}, {1.3, 0.8, 2},
      {0.25, 0.3, 2}, {0.85, 0.9, 2}, {0.2, 0.3, 4}, {0.3, 0.1, 4}, {0.15, 0.5, 4}};
  for (const auto& [frequency, force, stops] : cases) {
    const auto wanted = PiecewiseDenHartog(frequency, force).last_period();
    const auto rests = std::ranges::count(wanted, Rubs::kSticks, &PiecewiseDenHartog::Piece::what);
    ASSERT_EQ(rests, stops) << frequency << " " << force;
    const System system = den_hartog(frequency, force);
    const std::vector<Orbit> orbits = orbits_of(system);
    ASSERT_EQ(orbits.size(), 1u) << frequency << " " << force;
    std::vector<OrbitRubbing> found = orbits[0].rubbing;
    ASSERT_EQ(found.size(), wanted.size()) << frequency << " " << force;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(found[i].what, wanted[i].what) << frequency << " " << force << " " << i;
      EXPECT_NEAR(found[i].at.phase, wanted[i].phase, 1e-10) << frequency << " " << force;
    }
    double highest = 0.0;
    for (const auto& piece : wanted) highest = std::max(highest, piece.place);
    const Amplitudes seen = orbit_amplitudes(system, orbits[0], {{Vector::Ones(1)}});
    EXPECT_NEAR(seen.rows[0].highest, highest, 1e-10) << frequency << " " << force;
    EXPECT_EQ(orbits[0].stable, true);
    // Where it stops nothing is left of its speed before.
    EXPECT_LE(std::abs(orbits[0].multipliers.back().value), 1e-12);
  }
}

struct Rubbing {
  System system;
  Vector start;
  const char* what;
};

// Slides both ways; sticks; sticks to a belt and slips under less force; meets a stop as well.
std::vector<Rubbing> rubbing_systems() {
  std::vector<Rubbing> list;
  System two{Vector(2), NaturalModes{Vector(2)}, {}};
  two.omega << 1.0, 2.3;
  two.modal().delta << 0.03, 0.05;
  Vector force(2), row(2), other(2);
  force << 1.0, 0.4;
  row << 0.8, 0.5;
  other << 0.3, -0.7;
  two = support::forced(two, 0.55, 0.3, force);
  Vector start(4);
  start << 0.2, -0.1, 0.4, 0.3;
  System sliding = two;
  add_friction(sliding, row, 0.2, 0.2);
  list.push_back({sliding, start, "slides"});
  System sticking = two;
  add_friction(sticking, row, 0.7, 0.7);
  add_friction(sticking, other, 0.15, 0.15);
  list.push_back({sticking, start, "sticks"});
  System dragged = two;
  add_friction(dragged, row, 0.3, 0.45, 0.25);
  list.push_back({dragged, start, "on a belt"});
  System stopped = dragged;
  stopped.stops.push_back({other, 0.2, ImpactLaw{momentum_direction(other), 0.7}});
  list.push_back({stopped, start, "with a stop"});
  return list;
}

TEST(FrictionMap, HasTheSlopesOfItsDifferences) {
  for (const Rubbing& one : rubbing_systems()) {
    SegmentOptions options;
    options.closure_speed = 1e-9;
    const SectionMap map(one.system, {}, options);
    // A few periods on, where it has the events that last.
    const auto there = map.follow(one.system, one.start, 0.3, 3);
    ASSERT_TRUE(there) << one.what;
    const Vector x = map.pack(one.system, {there->end.q, there->end.qdot});
    System tangent = one.system;
    tangent.omega << 0.3, -0.2;
    tangent.modal().delta << 0.01, 0.02;
    tangent.modal().forcing->amplitude << 0.5, -0.3;
    tangent.modal().forcing->frequency = 0.2;
    tangent.modal().forcing->phase = 0.0;
    for (std::size_t k = 0; k < tangent.frictions.size(); ++k) {
      Vector moved(2);
      moved << 0.1, -0.2;
      const Friction& friction = one.system.frictions[k];
      const bool drops = friction.sliding != friction.sticking;
      tangent.frictions[k] = {moved, momentum_direction_rate(friction.row, moved), 0.1,
                              drops ? 0.13 : 0.1, 0.05};
    }
    for (Stop& stop : tangent.stops) {
      stop.gap = 0.1;
      stop.row.setZero();
      stop.law = ImpactLaw{Vector::Zero(2), Restitution{0.0}};
    }
    const System* along = &tangent;
    const auto image = map.image(one.system, x, 0.3, 1, false, std::span(&along, 1));
    ASSERT_TRUE(image) << one.what;
    const auto at = [&](const Vector& from) {
      return map.image(one.system, from, 0.3, 1, false, {})->image;
    };
    constexpr double kStep = 1e-6;
    for (Eigen::Index j = 0; j < 4; ++j) {
      const Vector by = kStep * Vector::Unit(4, j);
      const Vector slope = (at(x + by) - at(x - by)) / (2.0 * kStep);
      EXPECT_LE((slope - image->jacobian.col(j)).norm(), 2e-6 * (1.0 + slope.norm()))
          << one.what << " " << j << "\n"
          << slope.transpose() << "\n"
          << image->jacobian.col(j).transpose();
    }
    const auto moved_to = [&](double step) {
      System moved = one.system;
      moved.omega += step * tangent.omega;
      moved.modal().delta += step * tangent.delta();
      moved.modal().forcing->amplitude += step * tangent.forcing()->amplitude;
      moved.modal().forcing->frequency += step * tangent.forcing()->frequency;
      for (std::size_t k = 0; k < moved.frictions.size(); ++k) {
        Friction& friction = moved.frictions[k];
        const Friction& rate = tangent.frictions[k];
        friction.row += step * rate.row;
        friction.direction = momentum_direction(friction.row);
        friction.sliding += step * rate.sliding;
        friction.sticking += step * rate.sticking;
        friction.speed += step * rate.speed;
      }
      for (Stop& stop : moved.stops) stop.gap += step * 0.1;
      const auto there = map.image(moved, x, 0.3, 1, false, {});
      EXPECT_TRUE(there) << map.why_no_image(moved, x, 0.3, 1);
      return there ? there->image : Vector(Vector::Zero(4));
    };
    const Vector slope = (moved_to(kStep) - moved_to(-kStep)) / (2.0 * kStep);
    EXPECT_LE((slope - image->by_parameters.col(0)).norm(), 2e-6 * (1.0 + slope.norm()))
        << one.what << "\n"
        << slope.transpose() << "\n"
        << image->by_parameters.col(0).transpose();
  }
}

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
