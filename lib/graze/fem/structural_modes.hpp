// The lowest natural modes of a structure of matrices,
//
//   K phi_j = w_j^2 M phi_j,   phi_i^T M phi_j = 1 if i = j else 0,
//
// by shift-invert Lanczos (Spectra) on sparse Cholesky factors (CHOLMOD), or dense where the
// structure is small. The shift is 0, and negative where the structure is free to move as a rigid
// body. Reference: Ericsson & Ruhe, Math. Comp. 35 (1980) 1251.
//
// Degrees of freedom s without mass follow those with mass, m, statically: with S = K - shift M,
//
//   S u = f,  M = [0 0; 0 M_m]:  u_s = K_ss^-1 (f_s - K_sm u_m),
//   (K_mm - K_ms K_ss^-1 K_sm) phi_m = w^2 M_m phi_m,
//
// which is the product of the factors of all of S with the mass, without forming K_ss^-1: vectors
// in the range of S^-1 M satisfy the rows s, and a row r of the structure has the displacement (r_m
// - K_ms K_ss^-1 r_s)^T phi_m = r^T phi in a mode. The same holds for any M that is semidefinite,
// as with reduced integration, for the combinations of degrees of freedom without mass.
#pragma once

#include <optional>
#include <string>

#include "graze/fem/structural_matrices.hpp"

namespace graze {

// Up to this number of degrees of freedom, or of those with mass, all modes are found at once by
// dense algebra.
inline constexpr int kDenseSize = 500, kFewMasses = 60;

// Factors of L D L^T beyond this cost are not made for counting modes: the simplicial form, which
// pivots of either sign need, runs at about 1e9 operations a second.
inline constexpr double kLargestCount = 6e10;

struct StructuralModes {
  Vector omega;      // rad/s, ascending, m; exactly 0 for rigid-body modes
  Matrix shapes;     // n x m, kg^-1/2: u = shapes q
  Vector residuals;  // m: |K phi - w^2 M phi| / ||K||phi| + w^2 |M||phi||
  // Error of the squares of the frequencies by independent rounding of the entries of the
  // stiffness, (rad/s)^2, m: eps/2 times the root of sum (phi_i K_ij phi_j)^2.
  Vector square_roundings;
  int rigid = 0;             // the first ones are rigid-body modes
  int free_motions = 0;      // as many as the structure has, of which `rigid` are among the m modes
  double shift = 0.0;        // (rad/s)^2, used by the iteration
  bool is_dense = false;     // all modes of the structure were found
  int massless = 0;          // there are n - massless modes; of these
  int massless_motions = 0;  // are combinations of degrees of freedom that have mass, and
  int idle = 0;              // have no stiffness either; shapes and displacements are without them
  // The number of modes below `counted_below` (rad/s) by Sylvester's law of inertia, the same as
  // were found there. nullopt when they were not counted; `not_counted` says why, and a second
  // iteration, orthogonal to the modes found, then met none below the last of them.
  std::optional<int> counted;
  double counted_below = 0.0;
  std::string not_counted;
  // For each column b of the loads: static displacement K^-1 b, n x k; for a free structure
  // relative to its rigid-body modes (inertia relief).
  Matrix static_displacements;
  // The same error for the displacement of each load along itself, m per unit of load, k.
  Vector static_roundings;

  int count() const { return static_cast<int>(omega.size()); }
};

// The `count` lowest modes, 1 to the number of degrees of freedom with mass; `loads`: n x k, may
// have no column. Throws InputError where there are fewer modes, where the mass has a negative
// eigenvalue, where the stiffness is not positive semidefinite or lets degrees of freedom without
// mass move freely, and where modes cannot be found to a residual of 1e-8 or some are missing.
StructuralModes lowest_modes(const StructuralMatrices& structure, int count,
                             const Matrix& loads = Matrix());

// How many modes there are, for messages: "3 degrees of freedom that are not held".
std::string mode_limit_text(const StructuralMatrices& structure);

}  // namespace graze
