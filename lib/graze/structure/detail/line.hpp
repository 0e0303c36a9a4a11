// What a beam, a string and a bar have in common: a line along which a field u(x) bends or
// stretches, with
//
//   2 x elastic energy = integral of [stiffness (u^(d))^2 + tension u'^2] + springs,
//   2 x kinetic energy = integral of mass u'^2(t) + point masses,
//
// d = 2 of a beam (stiffness E I), d = 1 of a string (stiffness: its tension) and of a bar (E A).
// Every number has its rate of change along a direction of the scene, zero where none is asked for.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/detail/section_numbers.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// A number and its rate of change along one direction of the scene.
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

// Stiffness and mass per length as polynomials in (x - start)/(end - start).
struct LinePiece {
  Rated start, end;  // m
  Quartic stiffness{}, mass{};
};

// u = 0, u' = 0 or both, at one place.
struct LineSupport {
  Rated x;
  bool holds_value = false, holds_slope = false;
};

struct LineSpring {
  Rated x;
  Rated stiffness;  // N/m, or N m/rad against the slope; > 0
  bool on_slope = false;
};

struct LineMass {
  Rated x;
  Rated mass, inertia;  // kg, kg m^2
};

struct Line {
  int order = 2;  // d
  Rated length;
  std::vector<LinePiece> pieces;  // from 0 to the length, without gaps
  std::vector<LineSupport> supports;
  std::vector<LineSpring> springs;
  std::vector<LineMass> masses;
  Rated tension;  // N, of a beam
};

// Of a checked scene with a beam, a string or a bar; `direction`: a scene of the same shape that
// holds rates, or null.
Line line_of(const Scene& scene, const Scene* direction);

// The section of a beam where it is the same everywhere; `rate`: the beam of the direction, or
// null.
SectionNumbers<Rated> even_section(const Beam& beam, const Beam* rate);

// The beam's own thickness, or the height or diameter of its section at x, m.
double thickness_at(const Beam& beam, double x);

}  // namespace graze
