// A matrix of a finite-element model whose rows have names.
#pragma once

#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/fem/dof_label.hpp"

namespace graze {

// Column-major, with both triangles stored.
using SparseMatrix = Eigen::SparseMatrix<double>;

struct LabelledMatrix {
  std::string file;  // for messages
  SparseMatrix matrix;
  std::vector<DofLabel> labels;  // of its rows; 1, 2, .. where the file has no names
  bool has_names = false;        // the labels are those of the file
  std::vector<DofLabel> held;    // rows to which the program gave the stiffness of a held node
  // Where it is not symmetric, as the damping of what turns need not be: a sentence with an entry
  // that shows it. Else empty, and mirror images are the same.
  std::string asymmetry{};
};

// Largest difference of two entries that mirror each other, relative to the largest of both and of
// the geometric mean of their diagonal entries, up to which a matrix counts as symmetric; both are
// then replaced by their mean.
inline constexpr double kAllowedAsymmetry = 1e-8;

}  // namespace graze
