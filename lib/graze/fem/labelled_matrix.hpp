// A symmetric matrix of a finite-element model, read from a file of one of the programs that write
// such matrices. The format is told by the file itself:
//
//   .mtx         Matrix Market (its first line says so): coordinate or array, real or integer,
//                general or symmetric; else Abaqus (*MATRIX GENERATE): "MATRIX INPUT" with lines of
//                row node, row dof, column node, column dof, value, or "COORDINATE" with row,
//                column, value
//   .sti, .mas, .dam   CalculiX: row, column, value; the names of the rows in a .dof file
//   .npy         NumPy, two-dimensional
//   .npz         scipy.sparse.save_npz (csr, csc or coo), or numpy.savez of one dense matrix
//   .bdf, .dat, .nas, .pch   Nastran DMIG: square or symmetric, real; "file.pch#KAAX" names one of
//                several
//
// Abaqus, CalculiX and scipy may list one triangle: where no entry beside the diagonal has its
// mirror image listed, all of them stand for both.
#pragma once

#include <Eigen/SparseCore>
#include <filesystem>
#include <string>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/fem/dof_label.hpp"

namespace graze {

// By columns, both triangles stored.
using SparseMatrix = Eigen::SparseMatrix<double>;

struct LabelledMatrix {
  std::string file;  // for messages
  SparseMatrix matrix;
  std::vector<DofLabel> labels;  // of its rows; 1, 2, .. where the file has no names
  bool has_names = false;        // the labels are those of the file
  std::vector<DofLabel> held;    // to which the program gave the stiffness it holds a node with
};

// Largest difference of two entries that mirror each other, relative to the largest of both and of
// the geometric mean of their diagonal entries, up to which a matrix counts as symmetric; both are
// then replaced by their mean.
inline constexpr double kAllowedAsymmetry = 1e-8;

// Throws FileError where the file cannot be read, InputError ("file:line: sentence") where it is no
// such matrix: malformed, not square, complex, not symmetric, not finite.
LabelledMatrix read_matrix(const std::filesystem::path& file);

// The names of the rows in their order, one a line, "12.3" or "7" (a .dof file of CalculiX); `#`
// starts a comment. Throws likewise, also where a name stands twice.
std::vector<DofLabel> read_dof_names(const std::filesystem::path& file);

}  // namespace graze
