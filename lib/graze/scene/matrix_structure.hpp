// The modes of a discrete structure: found once for a scene and shared by its copies.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "graze/fem/mesh_file.hpp"
#include "graze/fem/modal_damping.hpp"
#include "graze/fem/structural_modes.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// What a support that moves does to the free degrees of freedom.
struct MovedSupport {
  Matrix forces;  // per unit of its displacement, velocity and acceleration, n by 3
  // Of matrices: the coordinates that move, in the order of MatrixModes::rows.
  std::vector<Eigen::Index> coordinates;
};

struct MatrixModes {
  StructuralModes modes;
  std::optional<ModalDamping> damping{};  // of a damping matrix
  std::map<DofLabel, Eigen::Index> rows;  // of the shapes; -1 of what is held at zero
  // Under a unit acceleration in direction 1, 2, 3 (0 where degrees of freedom have none): the
  // modal forces Phi^T M r, kg^1/2, whose squares are effective masses, and the whole mass r^T M r.
  std::map<int, Vector> inertia;
  std::map<int, double> total_masses;
  // Static displacements of the stops, without the rigid motion where the structure is free: m/N
  // under 1 N at each stop, stops by stops; and s^2 under a unit acceleration in the scene's
  // direction, empty where the structure has none.
  Matrix flexibility;
  Vector under_gravity;
  // Directions in which the stiffness holds the structure, but so weakly that it may be a free one
  // printed with few digits: r^T K r relative to r^T |K| r, r a displacement of all of it.
  std::map<int, double> weak_holds;
  std::map<long, std::array<double, 3>> coordinates;  // of nodes, m; empty: not known
  std::vector<MeshElement> elements;                  // of their file; may be none
  // Pairs of nodes that the stiffness couples, where coordinates are known.
  std::vector<std::pair<long, long>> couplings;
  // Rows on the free degrees of freedom of the stops, the loads and, at a point or a support, the
  // forcing, n by as many.
  Matrix points;
  std::vector<MovedSupport> supports;  // of the loads of that kind, in their order
  Vector load;  // of the forcing "load" on the free degrees of freedom, N per unit; empty: none
  // Phi^T M on all coordinates of a structure whose matrices stand in the scene, N by their number.
  Matrix momenta;

  int free_count() const { return static_cast<int>(modes.shapes.rows()); }
  // Displacement of a node in a mode along x, y, z; zero where it has no such degree of freedom.
  std::array<double, 3> displacement(long node, Eigen::Index mode) const;
  // Displacements of a degree of freedom, m by modes; zeros if it is held. Returns nullopt when the
  // structure has no such degree of freedom.
  std::optional<Vector> row(const std::string& label) const;
};

// The matrices over the free degrees of freedom: those of the files, which are read, or of the
// scene.
StructuralMatrices structural_matrices(const Scene& scene, const Mesh& mesh);

// The damping matrix in the modes; null for a scene without one.
const ModalDamping* damping_of_matrices(const Scene& scene);

// Computes the modes of a scene's discrete structure, of matrices in files after reading these, and
// fills in the modal structure and the shapes at stops, loads and probes. The reader calls it; a
// scene made in code needs it before it is checked or assembled, and again when its numbers, files,
// modes, constraints, load or points have changed. Throws FileError where a file cannot be read,
// InputError where it cannot be used or where a degree of freedom does not exist.
void solve_matrices(Scene& scene);

// The displacements of all masses, or rows of matrices in the scene, of each mode, kg^-1/2, n by N;
// empty for another structure. Zero for what is held.
Matrix coordinate_rows(const Scene& scene);

}  // namespace graze
