// The .npy format of NumPy (numpy.lib.format, versions 1 to 3) and the members of a .npz archive.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace graze {

struct NumpyArray {
  std::vector<long> shape;     // empty: one value
  bool is_fortran = false;     // column by column
  std::string text;            // for an array of bytes or characters, instead of the values
  std::vector<double> values;  // in the order of the file

  // The value at (i, j) of an array with two dimensions.
  double at(long i, long j) const {
    return values[static_cast<std::size_t>(is_fortran ? i + j * shape[0] : i * shape[1] + j)];
  }
};

// `name`: what messages call it. Throws InputError where the bytes are no such array of real
// numbers or of text.
NumpyArray numpy_array(const std::string& name, const std::string& bytes);

// The members of a zip archive by their names. Throws FileError where it cannot be read, InputError
// where it is no archive.
std::map<std::string, std::string> zip_members(const std::filesystem::path& file);

}  // namespace graze
