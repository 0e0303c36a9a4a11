// Intervals of numbers, rounded outward: what an operation returns holds its result for every
// choice of numbers from its operands. Each bound is moved by one rounding of itself, which is what
// the hardware's operations err by, and by a second one for those of the mathematics library.
//
// Moore, Kearfott & Cloud, Introduction to Interval Analysis, SIAM 2009, chapters 2 and 5.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace graze {

struct Interval {
  double low = 0.0, high = 0.0;

  Interval() = default;
  Interval(double number) : low(number), high(number) {}  // NOLINT(google-explicit-constructor)
  Interval(double from, double to) : low(from), high(to) {}

  bool contains(double number) const { return !(low > number) && !(high < number); }
  bool is_exactly(double number) const { return low == number && high == number; }
  double middle() const { return 0.5 * (low + high); }
  double width() const { return high - low; }
  // The largest size of a number in it.
  double size() const { return std::max(std::abs(low), std::abs(high)); }
};

// The interval widened by roundings of its bounds.
inline Interval outward(double low, double high) {
  constexpr double kRounding = 2.0 * std::numeric_limits<double>::epsilon();
  constexpr double kUnderflow = std::numeric_limits<double>::min();
  return {low - kRounding * std::abs(low) - kUnderflow,
          high + kRounding * std::abs(high) + kUnderflow};
}

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator+(const Interval& a, const Interval& b) {
  return outward(a.low + b.low, a.high + b.high);
}
inline Interval operator-(const Interval& a, const Interval& b) {
  return outward(a.low - b.high, a.high - b.low);
}
inline Interval operator*(const Interval& a, const Interval& b) {
  const double w = a.low * b.low, x = a.low * b.high, y = a.high * b.low, z = a.high * b.high;
  return outward(std::min(std::min(w, x), std::min(y, z)),
                 std::max(std::max(w, x), std::max(y, z)));
}
// Requires that the interval does not contain zero.
inline Interval inverse(const Interval& a) { return outward(1.0 / a.high, 1.0 / a.low); }

inline Interval square(const Interval& a) {
  const double most = a.size();
  const double least = a.contains(0.0) ? 0.0 : std::min(std::abs(a.low), std::abs(a.high));
  const Interval result = outward(least * least, most * most);
  return {std::max(result.low, 0.0), result.high};
}

// Requires numbers that are not negative.
inline Interval square_root(const Interval& a) {
  const Interval result =
      outward(std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0)));
  return {std::max(result.low, 0.0), result.high};
}

inline Interval exponential(const Interval& a) {
  const Interval result = outward(std::exp(a.low), std::exp(a.high));
  return {std::max(result.low, 0.0), result.high};
}

// e^a - 1
inline Interval exponential_less_one(const Interval& a) {
  return outward(std::expm1(a.low), std::expm1(a.high));
}

namespace interval_detail {

// The cosine over an interval by its values at the ends and the half turns between them.
inline Interval wide_cosine(const Interval& a) {
  const double from = std::cos(a.low), to = std::cos(a.high);
  // The angle counted in half turns, and their rounding on the safe side.
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * (1.0 + a.size());
  const double first = std::ceil((a.low - rounding) / std::numbers::pi);
  const double last = std::floor((a.high + rounding) / std::numbers::pi);
  if (last - first >= 1.0) return {-1.0, 1.0};
  Interval result(std::min(from, to) - rounding, std::max(from, to) + rounding);
  if (last == first) {
    if (std::fmod(first, 2.0) == 0.0)
      result.high = 1.0;
    else
      result.low = -1.0;
  }
  return {std::max(result.low, -1.0), std::min(result.high, 1.0)};
}

}  // namespace interval_detail

struct SineAndCosine {
  Interval sine, cosine;
};

inline SineAndCosine sine_and_cosine(const Interval& a) {
  const double middle = a.middle(), reach = 0.5 * a.width();
  // Over a short way either moves by no more than its slope there and half the square of the way.
  constexpr double kShort = 1e-3;
  if (!(reach < kShort)) {
    const Interval turned = a - outward(0.5 * std::numbers::pi, 0.5 * std::numbers::pi);
    return {interval_detail::wide_cosine(turned), interval_detail::wide_cosine(a)};
  }
  const double s = std::sin(middle), c = std::cos(middle);
  const double rounding = std::numeric_limits<double>::epsilon() * (2.0 + a.size());
  const auto around = [&](double at, double slope) {
    const double moves = (std::abs(slope) + 0.5 * reach) * reach + rounding;
    const Interval result = outward(at - moves, at + moves);
    return Interval(std::max(result.low, -1.0), std::min(result.high, 1.0));
  };
  return {around(s, c), around(c, s)};
}

// The intersection of both; `a` where rounding has left it empty.
inline Interval common(const Interval& a, const Interval& b) {
  const Interval both(std::max(a.low, b.low), std::min(a.high, b.high));
  return both.low <= both.high ? both : a;
}

}  // namespace graze
