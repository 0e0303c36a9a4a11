// A table of numbers for NumPy, as a .npz file: an archive that holds each column as an array of
// its own, "time.npy" and so on.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "graze/record/file/files.hpp"
#include "graze/record/file/spool.hpp"

namespace graze {

// Takes rows as they come and makes columns of them at the end. Until then they are in a file
// without a name beside the archive, in blocks that hold column after column, so that memory holds
// one block however many rows there are. All functions throw FileError.
class NumpyArchive {
 public:
  // For the archive `file`, with at least one column.
  NumpyArchive(const std::filesystem::path& file, std::vector<std::string> columns);

  // Space for one more row, one number for each column, to be filled at once.
  double* add();
  // The archive, complete but for its commit. Nothing can be added to this any more.
  PendingFile finished();

 private:
  void put_away_block();
  void read_column(std::size_t column, const std::function<void(std::string_view)>& use);

  std::vector<std::string> columns_;
  PendingFile archive_;
  Spool blocks_;
  std::size_t block_rows_;    // of every block but the last
  std::vector<double> rows_;  // those that are in no block yet
  std::size_t count_ = 0;     // of all rows
};

}  // namespace graze
