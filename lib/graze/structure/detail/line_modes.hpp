// Modes of a line by elements of high order (line_mesh.hpp).
//
// The unknowns z of an element are its strain in units in which its elastic energy is |z|^2/2. A
// spring is a support that yields, and its yielding one more unknown, e = sqrt(k) u(x). All
// conditions are then linear equations in the rigid motions and z: what can be, is solved for the
// rigid motions, of the rest the null space is taken by reflections. The elastic energy stays
// |v|^2/2, the kinetic one |B v'|^2/2, and the frequencies are the reciprocals of the singular
// values of B: no stiffness matrix is formed, and a low frequency has the digits of a high one,
// about eps w_j/w_1. The rigid motions that the supports leave, found by counting, are taken out of
// B first; their frequencies are 0.
//
// Tension adds T |S v|^2/2 of the slopes S; then v = L^-T x with 1 + T S^T S = L L^T.
#pragma once

#include <optional>

#include "graze/structure/detail/line_mesh.hpp"

namespace graze {

struct LineModes {
  LineMesh mesh;
  int asked = 0;    // how many modes the scene has
  Vector omega;     // rad/s, all modes of the elements, the rigid ones first, rising
  Matrix unknowns;  // y of each mode of unit modal mass: unknowns of the mesh by modes
  int rigid = 0;    // modes that are rigid motions, at most 2
  // The largest relative change of a frequency from the discretisation before; of the modes up to
  // kWellResolved, and of those beyond (0 without any).
  double change = 0.0, change_beyond = 0.0;

  Vector row(double x, int derivative) const {  // of the asked modes
    return unknowns.leftCols(asked).transpose() * mesh.row(x, derivative);
  }
};

// Up to here frequencies are resolved to 1e-10, beyond to 1e-6.
inline constexpr int kWellResolved = 32;

// Compression at which the line buckles, or why there are no modes.
struct LineFault {
  std::optional<double> critical_compression;  // N, > 0, or 0 where it holds none
  bool unresolved = false;                     // no discretisation was fine enough
};

struct LineSolution {
  std::optional<LineModes> modes;
  LineFault fault;
};

LineSolution line_modes(const Line& line, int asked);

// Rates of the requested modes along the direction in which the numbers of the line change.
struct LineRates {
  Vector omega;     // asked
  Matrix unknowns;  // unknowns by asked
};

// Why modes have no rates: two modes of one frequency that the direction would mix (numbered from
// 1), or things at one place of which the direction moves only one.
struct NoRates {
  int first = 0, second = 0;
  bool torn = false;
};

struct LineRatesOrNot {
  std::optional<LineRates> rates;
  NoRates fault;
};

LineRatesOrNot line_rates(const Line& line, const LineModes& modes);

// Integrals of mass times shape, point masses among them, and of the shape alone, over the line;
// with their rates, which are empty without `rates`.
struct LineLoads {
  Vector inertia, length;
  Vector inertia_rate, length_rate;
};
LineLoads line_loads(const Line& line, const LineModes& modes, const LineRates* rates);

}  // namespace graze
