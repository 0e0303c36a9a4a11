// Cantilever modes against 50-digit tables, quadrature and closed sums.
#include "graze/structure/detail/cantilever.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/reference.hpp"

namespace graze {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

TEST(Cantilever, WaveNumbersAreThePrintedOnes) {
  EXPECT_DOUBLE_EQ(cantilever_wave_number(1), 1.8751040687119611664);
  EXPECT_DOUBLE_EQ(cantilever_wave_number(2), 4.6940911329741745764);
  EXPECT_DOUBLE_EQ(cantilever_wave_number(3), 7.8547574382376125649);
  EXPECT_DOUBLE_EQ(cantilever_wave_number(4), 10.995540734875466991);
  for (const support::TableRow& row : support::read_table("mode_shapes.csv"))
    EXPECT_NEAR(cantilever_wave_number(std::stoi(row.at("j"))) / support::number(row, "b"), 1.0,
                2.0 * kEps);
}

// The error is a few eps b: the argument b xi is rounded.
TEST(Cantilever, ShapesAndTheirDerivativesAgreeWithTheTable) {
  const std::pair<const char*, double> places[] = {
      {"_1", 1.0}, {"_0.5", 0.5}, {"_0.6667", 2.0 / 3.0}};
  for (const support::TableRow& row : support::read_table("mode_shapes.csv")) {
    const int j = std::stoi(row.at("j"));
    const double b = support::number(row, "b");
    for (const auto& [suffix, xi] : places) {
      EXPECT_NEAR(cantilever_shape(j, xi), support::number(row, std::string("phi") + suffix),
                  4.0 * kEps * b)
          << "mode " << j << " at " << xi;
      EXPECT_NEAR(cantilever_slope(j, xi), support::number(row, std::string("slope") + suffix),
                  4.0 * kEps * b * b)
          << "mode " << j << " at " << xi;
      EXPECT_NEAR(cantilever_curvature(j, xi),
                  support::number(row, std::string("curvature") + suffix), 4.0 * kEps * b * b * b)
          << "mode " << j << " at " << xi;
    }
  }
}

TEST(Cantilever, TipIsTwoForEveryMode) {
  for (int j = 1; j <= 2000; ++j) {
    const double b = cantilever_wave_number(j);
    EXPECT_NEAR(cantilever_shape(j, 1.0), j % 2 == 1 ? 2.0 : -2.0, kEps * b) << j;
    EXPECT_NEAR(cantilever_shape(j, 0.0), 0.0, kEps * b) << j;
    EXPECT_NEAR(cantilever_slope(j, 0.0), 0.0, kEps * b * b) << j;
  }
}

TEST(Cantilever, SlopeIsTheDerivativeOfTheShape) {
  for (const int j : {1, 2, 3, 10, 40, 200}) {
    const double h = 1e-3 / cantilever_wave_number(j);
    for (const double xi : {0.05, 0.3, 0.62, 0.97}) {
      const double difference =
          (8.0 * (cantilever_shape(j, xi + h) - cantilever_shape(j, xi - h)) -
           (cantilever_shape(j, xi + 2.0 * h) - cantilever_shape(j, xi - 2.0 * h))) /
          (12.0 * h);
      EXPECT_NEAR(cantilever_slope(j, xi), difference, 1e-9 * cantilever_wave_number(j)) << j;
    }
  }
}

TEST(Cantilever, CurvatureIsTheDerivativeOfTheSlope) {
  for (const int j : {1, 2, 3, 10, 40, 200}) {
    const double b = cantilever_wave_number(j), h = 1e-3 / b;
    for (const double xi : {0.05, 0.3, 0.62, 0.97}) {
      const double difference =
          (8.0 * (cantilever_slope(j, xi + h) - cantilever_slope(j, xi - h)) -
           (cantilever_slope(j, xi + 2.0 * h) - cantilever_slope(j, xi - 2.0 * h))) /
          (12.0 * h);
      EXPECT_NEAR(cantilever_curvature(j, xi), difference, 1e-9 * b * b) << j;
    }
  }
}

// Seen from the free end the curvature is a mode of the beam clamped there: shape'' obeys the same
// equation, and a free end has neither curvature nor its derivative.
TEST(Cantilever, CurvatureIsTheShapeSeenFromTheOtherEnd) {
  for (int j = 1; j <= 2000; ++j) {
    const double b = cantilever_wave_number(j), sign = j % 2 == 1 ? 1.0 : -1.0;
    EXPECT_NEAR(cantilever_curvature(j, 0.0), 2.0 * b * b, kEps * b * b * b) << j;
    EXPECT_NEAR(cantilever_curvature(j, 1.0), 0.0, kEps * b * b * b) << j;
    for (const double xi : {0.1, 0.37, 0.5, 0.81})
      EXPECT_NEAR(cantilever_curvature(j, xi), sign * b * b * cantilever_shape(j, 1.0 - xi),
                  8.0 * kEps * b * b * b)
          << j;
  }
}

// Five-point Gauss-Legendre quadrature on equal pieces.
template <class F>
double integral(const F& f, int pieces) {
  const double x[] = {0.0, 0.5384693101056831, 0.9061798459386640};
  const double w[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  double sum = 0.0;
  for (int k = 0; k < pieces; ++k) {
    const double middle = (k + 0.5) / pieces, half = 0.5 / pieces;
    sum += half * w[0] * f(middle);
    for (int i = 1; i < 3; ++i)
      sum += half * w[i] * (f(middle - half * x[i]) + f(middle + half * x[i]));
  }
  return sum;
}

TEST(Cantilever, ModesAreOrthonormal) {
  const int modes[] = {1, 2, 3, 5, 8, 13, 25, 40};
  for (const int i : modes) {
    for (const int j : modes) {
      const double product = integral(
          [&](double xi) { return cantilever_shape(i, xi) * cantilever_shape(j, xi); }, 200);
      EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-12) << i << " " << j;
    }
  }
}

TEST(Cantilever, MeanIsTheIntegral) {
  for (const int j : {1, 2, 3, 10, 40}) {
    EXPECT_NEAR(cantilever_mean(j),
                integral([&](double xi) { return cantilever_shape(j, xi); }, 200), 1e-13)
        << j;
  }
}

TEST(Cantilever, MeansExpandUnity) {
  // sum of squared means -> integral of 1; the tail is that of 4/b^2 with b = (j - 1/2) pi.
  double sum = 0.0;
  for (int j = 400; j >= 1; --j) sum += std::pow(cantilever_mean(j), 2);
  EXPECT_NEAR(sum, 1.0 - 4.0 / (std::numbers::pi * std::numbers::pi * 400.0), 1e-7);
}

TEST(Cantilever, StaticTipDeflectionConvergesWithTheCubeOfTheModes) {
  // Unit force at the tip of the unit cantilever: 1/3 = sum phi_j(1)^2/b_j^4; what N modes leave
  // is 12/(3 pi^4 N^3) of it, to a relative 1/N^2.
  double deflection = 0.0;
  for (int j = 1; j <= 200; ++j) {
    deflection += std::pow(cantilever_shape(j, 1.0), 2) / std::pow(cantilever_wave_number(j), 4);
    if (j != 10 && j != 50 && j != 100) continue;
    const double error = 1.0 - 3.0 * deflection;
    const double expected = 12.0 / (3.0 * std::pow(std::numbers::pi, 4) * std::pow(j, 3));
    EXPECT_NEAR(error / expected, 1.0, 1.0 / (j * j)) << j;
  }
}

}  // namespace
}  // namespace graze
