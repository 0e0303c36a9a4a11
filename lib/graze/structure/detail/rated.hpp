// A number and its rate of change along one direction of the scene.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace graze {

struct Rated {
  double value = 0.0, rate = 0.0;
};

inline Rated operator+(Rated a, Rated b) { return {a.value + b.value, a.rate + b.rate}; }
inline Rated operator-(Rated a, Rated b) { return {a.value - b.value, a.rate - b.rate}; }
inline Rated operator*(Rated a, Rated b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate};
}
inline Rated operator*(double a, Rated b) { return {a * b.value, a * b.rate}; }
inline Rated operator/(Rated a, Rated b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.rate - quotient * b.rate) / b.value};
}
inline Rated root(Rated a) {
  const double value = std::sqrt(a.value);
  return {value, value > 0.0 ? 0.5 * a.rate / value : 0.0};
}

// a_0 + a_1 x + .. + a_4 x^4
using Quartic = std::array<Rated, 5>;

// Powers above the fourth, which no section has, are left out.
inline Quartic operator*(const Quartic& a, const Quartic& b) {
  Quartic product{};
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; i + j < product.size(); ++j)
      product[i + j] = product[i + j] + a[i] * b[j];
  return product;
}
inline Quartic operator*(Rated factor, const Quartic& a) {
  Quartic product{};
  for (std::size_t i = 0; i < a.size(); ++i) product[i] = factor * a[i];
  return product;
}
inline Quartic operator-(const Quartic& a, const Quartic& b) {
  Quartic difference{};
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  return difference;
}
inline Rated scaled(double factor, Rated a) { return factor * a; }
inline Quartic scaled(double factor, const Quartic& a) { return Rated{factor, 0.0} * a; }
inline Rated value_at(const Quartic& a, Rated x) {
  Rated sum = a.back();
  for (std::size_t i = a.size() - 1; i-- > 0;) sum = sum * x + a[i];
  return sum;
}

}  // namespace graze
