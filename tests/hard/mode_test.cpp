// M rows: modes, sums, resonance, critical damping.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/base/linalg/decompositions.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/structure/detail/cantilever.hpp"
#include "support/reached.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using Precise = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                              boost::multiprecision::et_off>;
constexpr double kEps = std::numeric_limits<double>::epsilon();

TEST(HardCases, M1TipShapeIsTwo) {
  for (int j = 1; j <= 400; ++j) {
    const double b = cantilever_wave_number(j);
    support::expect_reached("M1", "|phi_j(L)| = 2, j = 1..400, over b_j",
                            support::off(cantilever_shape(j, 1.0), j % 2 == 1 ? 2.0 : -2.0) / b,
                            kEps);
  }
}

Scene collocated_beam(int modes, bool outer_half) {
  std::string points;
  for (int i = 1; i <= modes && outer_half; ++i)
    points += (i > 1 ? ", " : "points = [") +
              std::to_string(0.5 + 0.5 * (i - 1.0) / (modes - 1.0)) + (i == modes ? "]\n" : "");
  return parse_scene(
      "[beam]\nlength = 1.0\nyoungs_modulus = 1.0\nsecond_moment = 1.0\n"
      "density = 1.0\narea = 1.0\nmodes = " +
          std::to_string(modes) + "\ndiscretisation = \"collocation\"\n" + points +
          "[forcing]\nkind = \"base\"\namplitude = 1.0\nfrequency = 1.0\n"
          "[[stop]]\nposition = 1.0\ngap = 1.0\nrestitution = 0.8\n",
      "beam.toml");
}

TEST(HardCases, M2ConditionOfCollocationPoints) {
  for (int modes = 4; modes <= 40; ++modes) {
    const Scene scene = collocated_beam(modes, false);
    support::expect_reached("M2", "condition of the points iL/N against 2.07, N = 4 to 40",
                            support::off(collocation_condition(modal_model(scene)), 2.07), 0.02);
    EXPECT_TRUE(system_warnings(scene, assemble(scene)).empty());
  }
  EXPECT_NEAR(collocation_condition(modal_model(collocated_beam(4, true))), 11.7, 0.05);
  EXPECT_NEAR(collocation_condition(modal_model(collocated_beam(10, true))) / 2.5e6, 1.0, 0.02);
}

TEST(HardCases, M2IllConditionedPointsAreWarnedOf) {
  const Scene scene = collocated_beam(14, true);
  EXPECT_GT(collocation_condition(modal_model(scene)), 1e8);
  const std::vector<std::string> warnings = system_warnings(scene, assemble(scene));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("ill-conditioned"), std::string::npos) << warnings[0];
}

TEST(HardCases, M3SumsOfWaveNumbers) {
  double fourth = 0.0, eighth = 0.0;
  for (int j = 400; j >= 1; --j) {
    const double b4 = std::pow(cantilever_wave_number(j), 4);
    fourth += 1.0 / b4;
    eighth += 1.0 / (b4 * b4);
  }
  // Beyond mode 400: b = (j - 1/2) pi, sum of (j - 1/2)^-4 from 401 on = 1/(3 400^3) to 1e-6.
  const double tail = 1.0 / (3.0 * std::pow(400.0, 3) * std::pow(std::numbers::pi, 4));
  support::expect_reached("M3", "sum of b^-4 = 1/12", support::off(fourth + tail, 1.0 / 12.0),
                          1e-15);
  support::expect_reached("M3", "sum of b^-8 = 11/1680", support::off(eighth, 11.0 / 1680.0),
                          4.0 * kEps);
}

TEST(HardCases, M3StaticTipDeflectionConverges) {
  // Unit tip force on the unit cantilever: 1/3 = sum phi_j(1)^2/b_j^4.
  double deflection = 0.0;
  for (int j = 1; j <= 100; ++j) {
    deflection += std::pow(cantilever_shape(j, 1.0), 2) / std::pow(cantilever_wave_number(j), 4);
    if (j != 25 && j != 50 && j != 100) continue;
    const double error = 12.0 / (3.0 * std::pow(std::numbers::pi, 4) * std::pow(j, 3));
    // The tail of (j - 1/2)^-4 is that of the integral up to a relative 1/(8 N^2) * 4.
    EXPECT_NEAR((1.0 / 3.0 - deflection) * 3.0 / (3.0 * error), 1.0 / 3.0 * 1.0, 1.0 / (j * j));
  }
}

// Undamped response from rest under cos(W t): 2 sin((W+w)t/2) sin((W-w)t/2)/((w-W)(w+W)) in 50
// digits; its limit is t sin(w t)/(2 w).
double precise_resonance(double omega, double frequency, double time) {
  const Precise w = omega, f = frequency, t = time;
  if (w == f) return static_cast<double>(t * sin(w * t) / (2 * w));
  return static_cast<double>((cos(f * t) - cos(w * t)) / ((w - f) * (w + f)));
}

TEST(HardCases, M5UndampedResonance) {
  const double time = 50.0, omega = 1.0;
  std::vector<double> detunings{0.0, 0.1};
  for (int k = 2; k <= 15; ++k) detunings.push_back(std::pow(10.0, -k));
  for (const double size : detunings) {
    for (const double detuning : {size, -size}) {
      const double frequency = omega + detuning;
      const System system = support::forced_oscillator(omega, 0.0, 1.0, 0.8, frequency, 1.0);
      const ExactFlow<double> flow(system);
      Arc<double> arc(flow);
      arc.start(0.0, Vector::Zero(1), Vector::Zero(1));
      Vector q(1), qdot(1);
      arc.state(time, q, qdot);
      const double expected = precise_resonance(omega, frequency, time);
      support::expect_reached("M5", "undamped resonance at t = 50, any detuning, relative",
                              support::relative(q[0], expected), 1e-13);
    }
  }
}

// Free and forced motion near critical damping, in 50 digits with the complex roots' product form.
double precise_near_critical(double zeta, double frequency, double time) {
  const Precise z = zeta, f = frequency, t = time;
  const Precise discriminant = (1 - z) * (1 + z);
  Precise cosine = 1, sine = t;  // C and S without the decay
  if (discriminant > 0) {
    const Precise root = sqrt(discriminant);
    cosine = cos(root * t), sine = sin(root * t) / root;
  } else if (discriminant < 0) {
    const Precise root = sqrt(-discriminant);
    cosine = cosh(root * t), sine = sinh(root * t) / root;
  }
  const Precise decay = exp(-z * t), re = 1 - f * f, im = 2 * z * f;
  const Precise norm = re * re + im * im;
  const Precise p0 = re / norm, p0_rate = f * im / norm;
  const Precise p = (re * cos(f * t) + im * sin(f * t)) / norm;
  return static_cast<double>(decay * ((cosine + z * sine) * (1 - p0) + sine * (-1 - p0_rate)) + p);
}

TEST(HardCases, M5AcrossCriticalDamping) {
  std::vector<double> zetas{1.0};
  for (int k = 1; k <= 15; ++k) {
    zetas.push_back(1.0 + std::pow(10.0, -k));
    zetas.push_back(1.0 - std::pow(10.0, -k));
  }
  for (const double zeta : zetas) {
    for (const double time : {0.1, 1.0, 5.0, 50.0}) {
      const System system = support::forced_oscillator(1.0, zeta, 1.0, 0.8, 0.7, 1.0);
      const ExactFlow<double> flow(system);
      Arc<double> arc(flow);
      arc.start(0.0, Vector::Ones(1), -Vector::Ones(1));
      Vector q(1), qdot(1);
      arc.state(time, q, qdot);
      const double expected = precise_near_critical(zeta, 0.7, time);
      // Relative to the motion's own size, which the start and the forced response give.
      support::expect_reached("M5", "across critical damping", support::off(q[0], expected), 1e-13);
    }
  }
}

}  // namespace
}  // namespace graze
