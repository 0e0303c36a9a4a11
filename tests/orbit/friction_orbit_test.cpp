// Periodic orbits with dry friction: Den Hartog's oscillator in closed form, slopes by differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "graze/contact/detail/impulse.hpp"
#include "graze/orbit/orbit_amplitudes.hpp"
#include "graze/orbit/problem/detail/section_map.hpp"
#include "graze/orbit/search/finder.hpp"
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

}  // namespace
}  // namespace graze
