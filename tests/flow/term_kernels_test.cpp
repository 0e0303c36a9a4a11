// Exponentials on the vector unit against long double, on every unit that this processor has.
#include "graze/flow/term_kernels.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "graze/flow/curve_terms.hpp"

namespace graze {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

struct Turned {
  double re = 0.0, im = 0.0;
};

Turned turned(double decay, double frequency, double s) {
  std::array<double, kColumnStep> decays{}, halves{}, re{}, im{};
  decays[0] = decay;
  halves[0] = 0.5 * frequency;
  turn_terms(decays.data(), halves.data(), 1, halves[0], s, re.data(), im.data());
  return {re[0], im[0]};
}

// Runs a check on the units that the processor has, the widest first, down to the plainest.
void on_every_unit(const std::function<void()>& check) {
  const auto all = hwy::SupportedTargets();
  auto left = all;
  int units = 0;
  while (left != 0) {
    hwy::DisableTargets(all & ~left);
    hwy::GetChosenTarget().DeInit();
    check();
    ++units;
    left &= left - 1;  // the best is the lowest bit
  }
  hwy::DisableTargets(0);
  hwy::GetChosenTarget().DeInit();
  EXPECT_GE(units, 1);
}

// Half the frequency times s is rounded before anything else: the exact value is that of the
// rounded angle.
TEST(TermKernels, AreThoseOfLongDoubleToAFewRoundings) {
  on_every_unit([] {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> exponent(-9.0, 5.5), decays(-4.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
      const double angle = std::pow(10.0, exponent(random)), decay = std::pow(10.0, decays(random));
      const Turned got = turned(decay, 2.0 * angle, 1.0);
      const long double lost = std::expm1(-static_cast<long double>(decay)),
                        sine = std::sin(static_cast<long double>(angle)),
                        cosine = std::cos(static_cast<long double>(angle));
      const long double re = lost - (1.0L + lost) * 2.0L * sine * sine,
                        im = (1.0L + lost) * 2.0L * sine * cosine;
      const double size = std::min(1.0, decay) + std::min(1.0, 2.0 * angle);
      EXPECT_NEAR(got.re, static_cast<double>(re), 4.0 * kEps * size) << angle << " " << decay;
      EXPECT_NEAR(got.im, static_cast<double>(im), 4.0 * kEps * size) << angle << " " << decay;
    }
  });
}

// Whose |e^{i w s}| were not 1 on the average would give energy to every arc: 1e6 arcs may add up
// to a tenth of the 1e-11 that hard case E2 allows, 1e-18 each. The mean of so many draws is known
// to 1e-16/sqrt(4e6) = 5e-20.
TEST(TermKernels, KeepTheEnergyOnTheAverage) {
  on_every_unit([] {
    std::mt19937_64 random(11);
    for (const double top : {1.5, 40.0}) {
      std::uniform_real_distribution<double> angles(0.0, top);
      long double sum = 0.0L;
      constexpr int kDraws = 4000000;
      for (int i = 0; i < kDraws; ++i) {
        const Turned got = turned(0.0, 2.0 * angles(random), 1.0);
        const long double re = got.re, im = got.im;
        sum += 2.0L * re + re * re + im * im;
      }
      EXPECT_LT(std::abs(static_cast<double>(sum / kDraws)), 1e-18) << top;
    }
  });
}

// Sums do not depend on where the vectors end, nor on the unit beyond rounding.
TEST(TermKernels, SumsAreThoseOfTheTermsOneByOne) {
  on_every_unit([] {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (std::size_t count = 1; count <= 19; ++count)
      for (const int m : {0, 1, 3}) {
        CurveTerms<double> all;
        CurvePoint<double> sum, each;
        sum.third = each.third = 0.0;
        const auto shares = std::make_unique<TermShares<double>>();
        for (std::size_t j = 0; j < count; ++j) {
          const double decay = 0.1 * static_cast<double>(j % 3),
                       frequency = 1.0 + 2.0 * static_cast<double>(j);
          const PlanarNumber<double> k{unit(random), unit(random)};
          all.add(decay, frequency);
          all.set(j, k, 0.0);
          CurveTerms<double> one;
          one.add(decay, frequency);
          one.set(0, k, 0.0);
          one.add_to(0.37, m, each, *shares);
        }
        all.add_to(0.37, m, sum, *shares);
        const double size = std::pow(40.0, m + 3) * static_cast<double>(count);
        EXPECT_NEAR(sum.value, each.value, kEps * size) << count << " " << m;
        EXPECT_NEAR(sum.slope, each.slope, kEps * size) << count << " " << m;
        EXPECT_NEAR(sum.curvature, each.curvature, kEps * size) << count << " " << m;
        EXPECT_NEAR(sum.bound, each.bound, 10.0 * kEps * each.bound) << count << " " << m;
        EXPECT_NEAR(sum.third, each.third, 10.0 * kEps * each.third) << count << " " << m;
        EXPECT_NEAR(sum.noise, each.noise, 1e-10 * each.noise) << count << " " << m;
      }
  });
}

}  // namespace
}  // namespace graze
