// Symmetric matrices of finite-element models, read from files of the programs that write them. The
// name of the file, and its first lines, give its format:
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
// Abaqus, CalculiX and scipy may list one triangle: when no off-diagonal entry has its mirror image
// listed, every entry stands for both.
#pragma once

#include <filesystem>
#include <vector>

#include "graze/fem/labelled_matrix.hpp"

namespace graze {

// Throws FileError where the file cannot be read, InputError ("file:line: sentence") where it is no
// such matrix: malformed, not square, complex, not symmetric, not finite.
LabelledMatrix read_matrix(const std::filesystem::path& file);
// The same for one that need not be symmetric.
LabelledMatrix read_general_matrix(const std::filesystem::path& file);

// Names of degrees of freedom, one a line, "12.3" or "7"; `#` starts a comment. Throws likewise,
// also where a name stands twice.
std::vector<DofLabel> read_dof_names(const std::filesystem::path& file);

// The names of the rows of a matrix in their order (a .dof file of CalculiX), likewise; rows of one
// name are numbered, "12.3.1", "12.3.2", ..
std::vector<DofLabel> read_row_names(const std::filesystem::path& file);

}  // namespace graze
