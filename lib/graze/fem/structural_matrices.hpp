// Mass, stiffness and damping of a structure over its free degrees of freedom,
//
//   M u'' + C u' + K u = f,
//
// read from files and brought into one order.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "graze/fem/labelled_matrix.hpp"

namespace graze {

// A displacement counts as rigid-body motion where its strain energy is within rounding of zero:
// phi^T K phi| <= kRigidEnergy * |phi|^T |K| |phi|, |K| the matrix of the absolute values. Below
// minus that the stiffness counts as indefinite.
inline constexpr double kRigidEnergy = 1e3 * 2.220446049250313e-16;

struct MatrixFiles {
  std::filesystem::path mass, stiffness;
  std::optional<std::filesystem::path> damping{};
  std::optional<std::filesystem::path> dofs{};  // names of the rows, for files without names
  // The nodes of the mesh, if all are known. Rows of other nodes, which CalculiX uses for the
  // incompatible modes of C3D8I, S4 and B31, are no displacements of the structure as a whole.
  std::set<long> nodes{};
};

struct StructuralMatrices {
  SparseMatrix mass, stiffness;         // n x n; kg, N/m of displacements
  std::optional<SparseMatrix> damping;  // n x n, N s/m; need not be symmetric
  std::vector<DofLabel> labels;         // n, of the free degrees of freedom
  std::vector<DofLabel> held;           // those left out, in the order of the files
  // The columns of the same matrices by which those held act on the free ones, n by as many.
  SparseMatrix held_mass, held_stiffness;
  std::optional<SparseMatrix> held_damping;
  // By direction 1, 2, 3 (0 where degrees of freedom have none): the forces M r by which a unit
  // acceleration of all of them, held ones included, loads the free ones (n), and r^T M r. Where
  // the nodes of the mesh are known, of those alone.
  std::map<int, Vector> inertia_loads;
  std::map<int, double> total_masses;
  // Pairs of nodes that an entry of the stiffness couples, held ones included; for a frame its
  // bars. Empty where the degrees of freedom belong to no nodes.
  std::vector<std::pair<long, long>> couplings;
  std::string mass_file, stiffness_file, damping_file;  // for messages

  int size() const { return static_cast<int>(labels.size()); }
  // Rows of the mass that are not zero, ascending. The other degrees of freedom follow these
  // statically, so that there are as many modes.
  std::vector<int> rows_with_mass() const;
  // Index of a free degree of freedom; nullopt when there is none of that name.
  std::optional<int> find(const DofLabel& label) const;
  // Why there is none of that name, a sentence.
  std::string absence(const DofLabel& label) const;
};

// `constraints`: degrees of freedom that are held at zero, beside those that a file holds itself;
// where several rows have one name, it holds all of them.
// Throws FileError and InputError as read_matrix, and InputError where sizes or names do not fit
// each other, where a constraint has no such degree of freedom, and where a free degree of freedom
// has neither mass nor stiffness.
StructuralMatrices read_structure(const MatrixFiles& files,
                                  const std::vector<DofLabel>& constraints = {});

// The same from given matrices. Labels of the stiffness come first, further ones of the mass next;
// entries that one matrix does not have are zero.
StructuralMatrices join_matrices(const LabelledMatrix& mass, const LabelledMatrix& stiffness,
                                 const LabelledMatrix* damping,
                                 const std::vector<DofLabel>& constraints = {},
                                 const std::set<long>& nodes = {});

}  // namespace graze
