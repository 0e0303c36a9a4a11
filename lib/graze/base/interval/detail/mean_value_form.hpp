// A function of one variable over a cell [c - h, c + h]: an interval for its value at the middle,
// for its values over the cell, and for its slopes over the cell. By the mean value theorem
//
//   f(cell) lies in f(c) + f'(cell) [-h, h],
//
// which each operation intersects with what intervals alone say: the excess over the true range
// then shrinks with the square of the cell and not only with the cell (Moore, Kearfott & Cloud,
// Introduction to Interval Analysis, SIAM 2009, section 6.4).
#pragma once

#include "graze/base/interval/detail/interval.hpp"

namespace graze {

struct MeanValueForm {
  Interval middle;     // f(c)
  Interval value;      // f over the cell
  Interval slope;      // f' over the cell
  double reach = 0.0;  // h; 0 of a constant

  MeanValueForm() = default;
  MeanValueForm(double constant)  // NOLINT(google-explicit-constructor)
      : middle(constant), value(constant) {}
  MeanValueForm(const Interval& at_middle, const Interval& over, const Interval& slopes,
                double half)
      : middle(at_middle), value(over), slope(slopes), reach(half) {
    if (!(reach > 0.0)) return;
    value = common(value, middle + slope * Interval(-reach, reach));
    middle = common(middle, value);
  }

  // The variable itself.
  static MeanValueForm variable(double low, double high) {
    const double c = low + 0.5 * (high - low);
    return {Interval(c), Interval(low, high), Interval(1.0), std::max(high - c, c - low)};
  }

  bool is_constant() const { return reach == 0.0; }
  bool is_exactly(double number) const { return is_constant() && value.is_exactly(number); }
};

inline MeanValueForm operator-(const MeanValueForm& a) {
  return {-a.middle, -a.value, -a.slope, a.reach};
}
inline MeanValueForm operator+(const MeanValueForm& a, const MeanValueForm& b) {
  return {a.middle + b.middle, a.value + b.value, a.slope + b.slope, std::max(a.reach, b.reach)};
}
inline MeanValueForm operator-(const MeanValueForm& a, const MeanValueForm& b) {
  return {a.middle - b.middle, a.value - b.value, a.slope - b.slope, std::max(a.reach, b.reach)};
}
inline MeanValueForm operator*(const MeanValueForm& a, const MeanValueForm& b) {
  if (b.is_constant()) return {a.middle * b.middle, a.value * b.value, a.slope * b.value, a.reach};
  if (a.is_constant()) return {a.middle * b.middle, a.value * b.value, a.value * b.slope, b.reach};
  return {a.middle * b.middle, a.value * b.value, a.slope * b.value + a.value * b.slope,
          std::max(a.reach, b.reach)};
}
// Requires that no value is zero, as do quotients by it.
inline MeanValueForm inverse(const MeanValueForm& a) {
  const Interval over = inverse(a.value);
  return {inverse(a.middle), over, -(a.slope * square(over)), a.reach};
}
inline MeanValueForm operator/(const MeanValueForm& a, const MeanValueForm& b) {
  return a * inverse(b);
}
inline MeanValueForm square(const MeanValueForm& a) {
  return {square(a.middle), square(a.value), Interval(2.0) * a.value * a.slope, a.reach};
}
// Requires positive values.
inline MeanValueForm square_root(const MeanValueForm& a) {
  const Interval root = square_root(a.value);
  return {square_root(a.middle), root, Interval(0.5) * a.slope * inverse(root), a.reach};
}
inline MeanValueForm exponential(const MeanValueForm& a) {
  const Interval over = exponential(a.value);
  return {exponential(a.middle), over, a.slope * over, a.reach};
}
inline MeanValueForm exponential_less_one(const MeanValueForm& a) {
  return {exponential_less_one(a.middle), exponential_less_one(a.value),
          a.slope * exponential(a.value), a.reach};
}
struct SineAndCosineForms {
  MeanValueForm sine, cosine;
};

inline SineAndCosineForms sine_and_cosine(const MeanValueForm& a) {
  const SineAndCosine middle = sine_and_cosine(a.middle);
  if (a.is_constant())
    return {{middle.sine, middle.sine, {}, 0.0}, {middle.cosine, middle.cosine, {}, 0.0}};
  const SineAndCosine over = sine_and_cosine(a.value);
  return {{middle.sine, over.sine, a.slope * over.cosine, a.reach},
          {middle.cosine, over.cosine, -(a.slope * over.sine), a.reach}};
}
inline MeanValueForm sine(const MeanValueForm& a) { return sine_and_cosine(a).sine; }
inline MeanValueForm cosine(const MeanValueForm& a) { return sine_and_cosine(a).cosine; }

}  // namespace graze
