// Exponentials on the vector unit against long double, on every unit that this processor has.
#include "graze/flow/exact/detail/term_kernels.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "graze/flow/exact/detail/curve_terms_impl.hpp"
#include "graze/flow/exact/extended.hpp"

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
    std::uniform_real_distribution<double> exponent(-9.0, 5.5), decays(-12.0, 2.8);
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

// Some terms, their sums at s and what each adds, in the scalar's own code.
template <class Real>
struct Summed {
  CurvePoint<Real> point;
  TermShares<Real> shares;
};

template <class Real>
std::unique_ptr<Summed<Real>> summed(std::size_t count, double s, int m) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  CurveTerms<Real> terms;
  for (std::size_t j = 0; j < count; ++j) {
    terms.add(0.1 * static_cast<double>(j % 3), 1.0 + 2.0 * static_cast<double>(j));
    const double re = unit(random), im = unit(random);
    terms.set(j, PlanarNumber<Real>{Real(re), Real(im)}, Real(0));
  }
  auto sums = std::make_unique<Summed<Real>>();
  sums->point.third = 0;
  terms.add_to(Real(s), m, sums->point, sums->shares);
  return sums;
}

// Against the same terms in 50 digits, one after the other: the sums, and the shares on which
// certified steps stand. A term turns by up to 170 rad here: its angle is rounded at eps of that.
TEST(TermKernels, SumsAndSharesAreThoseOfFiftyDigits) {
  on_every_unit([] {
    for (const std::size_t count : {1u, 2u, 3u, 4u, 5u, 7u, 8u, 9u, 15u, 16u, 17u, 64u, 85u})
      for (const double s : {0.0, 1e-9, 0.37, 1.0})
        for (const int m : {0, 1, 3}) {
          SCOPED_TRACE(std::to_string(count) + " terms, s " + std::to_string(s) + ", m " +
                       std::to_string(m));
          const auto got = summed<double>(count, s, m);
          const auto meant = summed<Extended>(count, s, m);
          const double top = 2.0 * static_cast<double>(count);
          const auto near = [&](double value, const Extended& expected, int order, double terms) {
            const double size = std::pow(top, order) * terms;
            EXPECT_NEAR(value, static_cast<double>(expected), 4.0 * kEps * size * (1.0 + top * s));
          };
          const auto all = static_cast<double>(count);
          near(got->point.value, meant->point.value, m, all);
          near(got->point.slope, meant->point.slope, m + 1, all);
          near(got->point.curvature, meant->point.curvature, m + 2, all);
          near(got->point.bound, meant->point.bound, m + 2, all);
          near(got->point.third, meant->point.third, m + 3, all);
          EXPECT_EQ(got->point.noise > 0.0, meant->point.noise > 0);
          if (count > kMostShares) continue;
          for (std::size_t j = 0; j < count; ++j) {
            near(got->shares.slope[j], meant->shares.slope[j], m + 1, 2.0);
            near(got->shares.curvature[j], meant->shares.curvature[j], m + 2, 2.0);
            near(got->shares.third[j], meant->shares.third[j], m + 3, 2.0);
            near(got->shares.fall[j], meant->shares.fall[j], m, 4.0);
          }
        }
  });
}

// What is not a number must not come out as one.
TEST(TermKernels, KeepWhatIsNotFinite) {
  on_every_unit([] {
    for (const double s :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
      EXPECT_FALSE(std::isfinite(turned(0.1, 2.0, s).im)) << s;
  });
}

}  // namespace
}  // namespace graze
