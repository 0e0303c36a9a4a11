// What a beam, a string and a bar have in common: a line along which a field u(x) bends or
// stretches, with
//
//   2 x elastic energy = integral of [stiffness (u^(d))^2 + tension u'^2] + springs,
//   2 x kinetic energy = integral of mass u'^2(t) + point masses,
//
// d = 2 of a beam (stiffness E I), d = 1 of a string (stiffness: its tension) and of a bar (E A).
// Every number has its rate of change along a direction of the scene, zero where none is asked for.
#pragma once

#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/detail/section_numbers.hpp"
#include "graze/scene/scene.hpp"
#include "graze/structure/detail/rated.hpp"

namespace graze {

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
