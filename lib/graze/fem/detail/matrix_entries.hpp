// The entries of a matrix as a file lists them, and the symmetric matrix that they make.
#pragma once

#include <string>
#include <vector>

#include "graze/fem/labelled_matrix.hpp"

namespace graze {

struct MatrixEntry {
  int row = 0, column = 0;  // from 0
  int line = 0;             // of the file; 0: it has none
  double value = 0.0;
};

enum class EntryStorage {
  kOneTriangle,  // an entry stands for its mirror image too, which must not be listed
  kFull,         // what is not listed is zero
  kEither        // the former where no entry has its mirror image listed
};

// An entry that is listed twice is refused with its line, or added up (`adds`), as by programs that
// assemble. Throws InputError where the matrix is not symmetric or has no entries.
SparseMatrix symmetric_matrix(const std::string& file, int size, std::vector<MatrixEntry> entries,
                              EntryStorage storage, const std::vector<DofLabel>& labels,
                              bool adds = false);

// From a dense matrix, likewise.
SparseMatrix symmetric_matrix(const std::string& file, const Matrix& dense,
                              const std::vector<DofLabel>& labels);

// 1, 2, .. n.
std::vector<DofLabel> numbered_labels(int size);

}  // namespace graze
