// Multipliers from the impact factors: against tabled ones, over many impacts, and next to grazing.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "graze/assembly/assembly.hpp"
#include "graze/base/angle.hpp"
#include "graze/base/linalg/detail/product_eigenvalues.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/detail/saltation.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "support/product_reference.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// The closed form's point of a row of closed_form_orbits.csv.
ImpactPoint tabled_point(const System& system, const support::TableRow& row) {
  const int period = std::stoi(row.at("period"));
  const ClosedFormAnswer answer = closed_form(system, 0, period);
  ImpactPoint nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap)) {
    const double apart =
        std::abs(std::remainder(point.theta - support::number(row, "phase"), kTurn));
    if (apart < distance) {
      distance = apart;
      nearest = point;
    }
  }
  EXPECT_LE(distance, 1e-9);
  return nearest;
}

std::vector<Complex> tabled_multipliers(const support::TableRow& row) {
  std::vector<Complex> list;
  for (int i = 1;; ++i) {
    const auto cell = row.find("mult_re" + std::to_string(i));
    if (cell == row.end() || cell->second.empty()) return list;
    list.emplace_back(support::number(row, "mult_re" + std::to_string(i)),
                      support::number(row, "mult_im" + std::to_string(i)));
  }
}

double distance_to(const std::vector<Eigenvalue>& values, Complex expected) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Eigenvalue& value : values)
    smallest = std::min(smallest, std::abs(value.value - expected));
  return smallest;
}

// The orbit of `point`, repeated: an orbit of `laps` times its periods and impacts.
struct Repeated {
  ImpactPattern pattern;
  std::vector<ImpactPoint> points;
};
Repeated repeated(const ImpactPoint& point, int period, int laps) {
  Repeated orbit{{period * laps, std::vector<int>(static_cast<std::size_t>(laps), 0)}, {}};
  for (int i = 0; i < laps; ++i)
    orbit.points.push_back({point.theta + kTurn * period * i, point.before});
  return orbit;
}

TEST(Multipliers, OfARepeatedOrbitArePowers) {
  int compared = 0;
  for (const support::TableRow& row : support::read_table("closed_form_orbits.csv")) {
    SCOPED_TRACE(row.at("case") + " at phase " + row.at("phase"));
    const System system = assemble(support::reference_scene("orbits/" + row.at("case")));
    const ImpactPoint point = tabled_point(system, row);
    const int period = std::stoi(row.at("period"));
    // How far the computed multipliers of one lap are from those of the table: what the point's own
    // rounding moves, over the distance to the others.
    const std::vector<Eigenvalue> once = orbit_multipliers(system, {period, {0}}, {point});
    for (const int laps : {2, 3, 8}) {
      const Repeated orbit = repeated(point, period, laps);
      const std::vector<Eigenvalue> values = orbit_multipliers(system, orbit.pattern, orbit.points);
      ASSERT_EQ(values.size(), static_cast<std::size_t>(2 * system.modes()));
      for (const Complex& multiplier : tabled_multipliers(row)) {
        const double relative = distance_to(once, multiplier) / std::abs(multiplier);
        EXPECT_LE(relative, 1e-9);
        const Complex expected = std::pow(multiplier, laps);
        ++compared;
        EXPECT_LE(distance_to(values, expected) / std::abs(expected),
                  laps * (2.0 * relative + 1e-11))
            << "laps = " << laps << ", " << multiplier;
      }
    }
  }
  EXPECT_GE(compared, 100);
}

TEST(Multipliers, OfManyImpactsKeepTheSmallOneThatTheProductLoses) {
  // P1 of the hard cases, W = 2.8: multipliers -2.646309419411 and -.1932341572841.
  const System system = assemble(support::reference_scene("orbits/sdof_2_8"));
  const ClosedFormAnswer answer = closed_form(system, 0, 1);
  for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap)) {
    if (std::abs(point.before.qdot[0] - 0.33448213190105355) > 1e-9) continue;
    const int laps = 16;
    const Repeated orbit = repeated(point, 1, laps);
    const double small = std::pow(0.1932341572841, laps), large = std::pow(2.646309419411, laps);
    const std::vector<Eigenvalue> values = orbit_multipliers(system, orbit.pattern, orbit.points);
    ASSERT_EQ(values.size(), 2u);
    EXPECT_NEAR(values[0].value.real() / large, 1.0, 1e-10);
    EXPECT_NEAR(values[1].value.real() / small, 1.0, 1e-10);
    EXPECT_LE(values[1].error, 1e-10 * small);
    const std::vector<Eigenvalue> formed =
        eigenvalues(monodromy_matrix(system, orbit.pattern, orbit.points));
    EXPECT_GE(std::abs(formed[1].value.real() / small - 1.0), 1e-6);
    return;
  }
  FAIL() << "no such orbit";
}

// x'' + .1 x' + x = F cos(1.6 t), a = .5, r = .8, at F = F_g (1 - 10^-k): G2 of the hard cases.
TEST(Multipliers, NextToGrazingTheSmallOneIsDeterminantOverTrace) {
  const double traces[][2] = {{1, 10.014975674}, {4, 9777.742627}, {8, 97774968.02}};
  const double determinant = 0.64 * std::exp(-0.1 * kTurn / 1.6);
  for (const auto& [k, trace] : traces) {
    SCOPED_TRACE(k);
    const System system = support::forced_oscillator(
        1.0, 0.05, 0.5, 0.8, 1.6, 0.784091831356506353 * (1.0 - std::pow(10.0, -k)));
    const ClosedFormAnswer answer = closed_form(system, 0, 1);
    ASSERT_TRUE(answer.form);
    int found = 0;
    for (const ImpactPoint& point : answer.form->solutions(0.5)) {
      const double v = point.before.qdot[0];
      if (!(v > 0.0 && v < 1.0)) continue;
      ++found;
      const std::vector<Eigenvalue> values = orbit_multipliers(system, {1, {0}}, {point});
      ASSERT_EQ(values.size(), 2u);
      // Of l^2 - trace l + determinant.
      const double large = 0.5 * (trace + std::sqrt(trace * trace - 4.0 * determinant));
      // As in the catalogue: storing 1.6 and .1 moves the trace by 2e-8 at k = 8.
      const double relative = std::max(1e-10, 40.0 * 2.2e-16 * std::pow(10.0, k));
      EXPECT_NEAR(std::abs(values[0].value.real()) / large, 1.0, relative);
      EXPECT_NEAR(std::abs(values[1].value.real()) / (determinant / large), 1.0, relative);
      // Whatever the trace: both multiply to the determinant, up to roundings of the factors.
      EXPECT_NEAR(values[0].value.real() * values[1].value.real() / determinant, 1.0,
                  1e-13 + 4.0 * 2.2e-16 * trace);
    }
    EXPECT_EQ(found, 1);
  }
}

// The closed form's orbit of the paper's beam whose impact is as slow as `speed`, by the gap.
std::optional<std::pair<System, ImpactPoint>> slow_impact(int modes, double speed) {
  System system = assemble(support::shipped_scene(
      "05_wagg_one_mode", {"beam.modes=" + std::to_string(modes), "forcing.frequency=100"}));
  const ClosedFormAnswer answer = closed_form(system, 0, 1);
  if (!answer.form) return {};
  const auto speed_at = [&](double gap, std::size_t which) {
    return system.stops[0].row.dot(answer.form->solutions(gap)[which].before.qdot) - speed;
  };
  const double reach = 0.99 * std::abs(answer.form->kappa);
  for (const std::size_t which : {0u, 1u})
    for (int i = -100; i < 100; ++i) {
      double low = reach * i / 100.0, high = reach * (i + 1) / 100.0;
      if (!(speed_at(low, which) * speed_at(high, which) < 0.0)) continue;
      for (int halving = 0; halving < 100; ++halving) {
        const double middle = 0.5 * (low + high);
        (speed_at(middle, which) * speed_at(low, which) > 0.0 ? low : high) = middle;
      }
      // The two solutions change places somewhere: no zero of the speed.
      if (std::abs(speed_at(low, which)) > 0.1 * speed) continue;
      system.stops[0].gap = low;
      return std::make_pair(system, answer.form->solutions(low)[which]);
    }
  return {};
}

TEST(Multipliers, NextToGrazingTheyMultiplyToTheDeterminantWithAnyNumberOfModes) {
  for (const int modes : {1, 2, 4, 8})
    for (const double speed : {1e-3, 1e-5, 1e-7}) {
      SCOPED_TRACE(std::to_string(modes) + " modes, " + std::to_string(speed) + " m/s");
      const auto slow = slow_impact(modes, speed);
      ASSERT_TRUE(slow);
      const auto& [system, point] = *slow;
      const std::vector<Eigenvalue> values = orbit_multipliers(system, {1, {0}}, {point});
      ASSERT_EQ(values.size(), static_cast<std::size_t>(2 * modes));
      const double r = system.stops[0].restitution().at_rest();
      Complex product = 1.0;
      for (const Eigenvalue& value : values) product *= value.value;
      const double expected = r * r * std::exp(-2.0 * system.period() * system.delta().sum());
      EXPECT_NEAR(product.real() / expected, 1.0, 1e-8);
      EXPECT_GT(std::abs(values.front().value) * speed, 1e-3);  // grows like 1/v
    }
}

TEST(Multipliers, ArePutInUnitsOfTheFlow) {
  // Eight modes up to 2e4 rad/s: in plain units the stiffness of the fast ones sets all errors.
  const System system = assemble(
      support::shipped_scene("05_wagg_one_mode", {"beam.modes=8", "forcing.frequency=100"}));
  const ClosedFormAnswer answer = closed_form(system, 0, 1);
  ASSERT_TRUE(answer.form);
  for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap)) {
    const auto plain = eigenvalues(monodromy_matrix(system, {1, {0}}, {point}));
    const auto scaled = orbit_multipliers(system, {1, {0}}, {point});
    ASSERT_EQ(plain.size(), scaled.size());
    double worst_plain = 0.0, worst_scaled = 0.0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      EXPECT_LE(distance_to(plain, scaled[i].value), plain[i].error + scaled[i].error);
      worst_plain = std::max(worst_plain, plain[i].error);
      worst_scaled = std::max(worst_scaled, scaled[i].error);
    }
    EXPECT_LE(worst_scaled, 1e-11);
    EXPECT_LE(1e3 * worst_scaled, worst_plain);
  }
}

TEST(Multipliers, OfManyModesAreTold) {
  // Quick modes that are damped away leave multipliers of 1e-50 and less beside those that count.
  const char* const dampings[] = {"{rayleigh={mass=4.0,stiffness=1e-7}}",
                                  "{rayleigh={mass=0.5,stiffness=1e-5}}", "{viscous=0.5}"};
  for (const int modes : {32, 128, 256})
    for (const std::string damping : dampings) {
      if (modes == 256 && damping == dampings[2]) continue;  // seconds
      SCOPED_TRACE(std::to_string(modes) + " modes, damping = " + damping);
      const System system = assemble(support::shipped_scene(
          "05_wagg_one_mode", {"beam.modes=" + std::to_string(modes), "damping=" + damping,
                               "stop.restitution=0.7", "forcing.frequency=31"}));
      const ClosedFormAnswer answer = closed_form(system, 0, 1);
      ASSERT_TRUE(answer.form);
      const ImpactPoint point = answer.form->solutions(system.stops[0].gap).front();
      for (const int laps : {1, modes == 32 ? 2 : 1}) {
        const Repeated orbit = repeated(point, 1, laps);
        const std::vector<Eigenvalue> values =
            orbit_multipliers(system, orbit.pattern, orbit.points);
        ASSERT_EQ(values.size(), static_cast<std::size_t>(2 * modes));
        for (const Eigenvalue& value : values) EXPECT_LE(value.error, 1e-6);
      }
    }
}

// The flow of a mode over t in 50 digits, under critical damping.
Eigen::Matrix<Extended, 2, 2> extended_flow(double omega, double delta, double t) {
  const Extended w = omega, d = delta, s = t, turn = sqrt(w * w - d * d);
  const Extended sine = exp(-d * s) * sin(turn * s) / turn, cosine = exp(-d * s) * cos(turn * s);
  Eigen::Matrix<Extended, 2, 2> flow;
  flow << cosine + d * sine, sine, -w * w * sine, cosine - d * sine;
  return flow;
}

TEST(Multipliers, OfManyTurnsBetweenImpactsAreWithinTheirErrors) {
  // Hundreds to thousands of radians: the rounding of the exponents is above that of the factors.
  support::Dice dice(31);
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double delta = dice.uniform(0.0, 1e-4);
    const System system = support::forced_oscillator(1.0, delta, dice.uniform(0.1, 0.5), 0.9,
                                                     dice.uniform(1e-3, 1e-2), 1.0);
    const ClosedFormAnswer answer = closed_form(system, 0, 1);
    ASSERT_TRUE(answer.form);
    for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap)) {
      const ImpactPattern pattern{1, {0}};
      const Matrix saltation = saltation_matrix(system, system.stops[0], point.before, point.theta);
      const support::ExtendedMatrix product =
          extended_flow(1.0, delta, flight_time(system, pattern, {point}, 0)) *
          saltation.cast<Extended>();
      const auto compared = support::compare(orbit_multipliers(system, pattern, {point}),
                                             support::extended_eigenvalues(product));
      worst = std::max(worst, compared.of_error);
    }
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_GE(worst, 1e-3);  // and no wider than that
}

TEST(Multipliers, OfPlasticImpactsHaveOneExactZero) {
  // r = 0 forgets the approach speed; the deviation of the gap lives on in when the impact happens,
  // so that each factor has rank 2N - 1. One is left out of what follows it: the zero is simple.
  System system = assemble(
      support::shipped_scene("05_wagg_one_mode", {"beam.modes=3", "forcing.frequency=100"}));
  system.stops[0].impact().restitution = 0.0;
  const ClosedFormAnswer answer = closed_form(system, 0, 1);
  ASSERT_TRUE(answer.form);
  for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap))
    for (const int laps : {2, 3}) {
      const Repeated orbit = repeated(point, 1, laps);
      const std::vector<Eigenvalue> values = orbit_multipliers(system, orbit.pattern, orbit.points);
      ASSERT_EQ(values.size(), 6u);
      EXPECT_EQ(values[5].value, 0.0);
      for (int i = 0; i < 5; ++i) EXPECT_NE(values[static_cast<std::size_t>(i)].value, 0.0);
    }
}

}  // namespace
}  // namespace graze
