// The entries of a matrix as a file lists them, and the matrix that they make.
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

// The matrix of `size` rows, with the file and the labels of `into`, and whether it is symmetric. An
// entry that is listed twice is refused with its line, or added up (`adds`), as by programs that
// assemble. Throws InputError where it has no entries.
void set_entries(LabelledMatrix& into, int size, std::vector<MatrixEntry> entries,
                 EntryStorage storage, bool adds = false);

// From a dense matrix, likewise.
void set_entries(LabelledMatrix& into, const Matrix& dense);

// 1, 2, .. n.
std::vector<DofLabel> numbered_labels(int size);

}  // namespace graze
