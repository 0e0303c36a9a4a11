#include "graze/fem/detail/numpy_array.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "graze/base/errors.hpp"
#include "graze/fem/detail/matrix_entries.hpp"
#include "graze/fem/detail/matrix_formats.hpp"

namespace graze {
namespace {

// The literal behind a key of the header, {'descr': '<f8', 'fortran_order': False, 'shape': (3, 3)}
std::optional<std::string> header_value(const std::string& header, const std::string& key) {
  std::size_t at = header.find("'" + key + "':");
  if (at == std::string::npos) return {};
  at += key.size() + 3;
  while (at < header.size() && header[at] == ' ') ++at;
  if (at >= header.size()) return {};
  const char ends = header[at] == '(' ? ')' : header[at] == '\'' ? '\'' : ',';
  const std::size_t end = header.find(ends, at + 1);
  if (end == std::string::npos) return {};
  return header.substr(at, end - at + (ends == ',' ? 0 : 1));
}

std::optional<std::vector<long>> shape_of(const std::string& text) {
  if (text.size() < 2 || text.front() != '(') return {};
  std::vector<long> shape;
  const char* at = text.c_str() + 1;
  while (*at != ')') {
    char* end = nullptr;
    const long size = std::strtol(at, &end, 10);
    if (end == at || size < 0) return {};
    shape.push_back(size);
    at = end;
    while (*at == ',' || *at == ' ' || *at == 'L') ++at;
    if (*at == '\0') return {};
  }
  return shape;
}

template <class Number>
void take_values(const char* bytes, std::size_t count, std::vector<double>& values) {
  values.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    Number number;
    std::memcpy(&number, bytes + i * sizeof number, sizeof number);
    values[i] = static_cast<double>(number);
  }
}

// How the values of one type are read, and their size.
struct ValueType {
  const char* name;
  std::size_t size;
  void (*take)(const char*, std::size_t, std::vector<double>&);
};
constexpr ValueType kTypes[] = {
    {"f8", 8, take_values<double>},        {"f4", 4, take_values<float>},
    {"i8", 8, take_values<std::int64_t>},  {"i4", 4, take_values<std::int32_t>},
    {"u8", 8, take_values<std::uint64_t>}, {"u4", 4, take_values<std::uint32_t>}};

// Characters of one byte (S) or four (U), of which the first is kept.
std::string characters(const std::string& bytes, std::size_t begin, bool wide) {
  std::string text;
  for (std::size_t i = begin; i < bytes.size(); i += wide ? 4 : 1)
    if (bytes[i] != '\0') text += bytes[i];
  return text;
}

std::size_t header_size(const std::string& name, const std::string& bytes, std::size_t& begin) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i]));
  };
  if (bytes.size() < 12 || bytes.compare(0, 6, "\x93NUMPY") != 0)
    throw InputError(
        fmt::format("{}: it is no .npy file, its first bytes must be \\x93NUMPY", name));
  const std::size_t version = byte(6);
  if (version < 1 || version > 3)
    throw InputError(fmt::format(
        "{}: version {} of the .npy format is not known, it must be 1 to 3", name, version));
  begin = version == 1 ? 10 : 12;
  std::size_t size = byte(8) + (byte(9) << 8);
  if (version > 1) size += (byte(10) << 16) + (byte(11) << 24);
  if (size > bytes.size() - begin)
    throw InputError(fmt::format("{}: the file ends within its header", name));
  return size;
}

}  // namespace

NumpyArray numpy_array(const std::string& name, const std::string& bytes) {
  std::size_t begin = 0;
  const std::size_t size = header_size(name, bytes, begin);
  const std::string header = bytes.substr(begin, size);
  const auto type = header_value(header, "descr"), order = header_value(header, "fortran_order"),
             shape = header_value(header, "shape");
  const auto sizes = shape ? shape_of(*shape) : std::nullopt;
  if (!type || !order || !sizes)
    throw InputError(fmt::format("{}: the header must hold descr, fortran_order and shape", name));
  NumpyArray array;
  array.shape = *sizes;
  array.is_fortran = *order == "True";
  begin += size;
  const std::string kind = type->size() > 3 ? type->substr(2, type->size() - 3) : "";
  if (!kind.empty() && (kind[0] == 'S' || kind[0] == 'U')) {
    array.text = characters(bytes, begin, kind[0] == 'U');
    return array;
  }
  const bool turned = type->size() > 1 && (*type)[1] == '>';
  for (const ValueType& known : kTypes) {
    if (kind != known.name || turned) continue;
    std::size_t count = 1;
    for (const long length : array.shape) {
      const auto n = static_cast<std::size_t>(length);
      if (n != 0 && count > bytes.size() / n)
        count = bytes.size() + 1;
      else
        count *= n;
    }
    if (count > bytes.size() || bytes.size() - begin != count * known.size)
      throw InputError(fmt::format("{}: the array of shape {} has {} bytes, which does not fit",
                                   name, *shape, bytes.size() - begin));
    known.take(bytes.data() + begin, count, array.values);
    return array;
  }
  throw InputError(fmt::format(
      "{}: values of the type {} are not allowed, they must be real numbers: '<f8', '<f4', '<i8' "
      "or '<i4'",
      name, *type));
}

namespace {

void check_finite(const std::string& name, double value, long row, long column) {
  if (!std::isfinite(value))
    throw InputError(fmt::format("{}: the entry ({}, {}) is {}, it must be finite", name, row + 1,
                                 column + 1, value));
}

LabelledMatrix dense_matrix(const std::string& name, const NumpyArray& array) {
  if (array.shape.size() != 2 || array.shape[0] != array.shape[1] || array.values.empty())
    throw InputError(fmt::format(
        "{}: the array has {} dimension{}{}, it must be a square matrix", name, array.shape.size(),
        array.shape.size() == 1 ? "" : "s",
        array.shape.size() == 2 ? fmt::format(" and is {} x {}", array.shape[0], array.shape[1])
                                : ""));
  const long n = array.shape[0];
  Matrix dense(n, n);
  for (long j = 0; j < n; ++j)
    for (long i = 0; i < n; ++i) {
      check_finite(name, array.at(i, j), i, j);
      dense(i, j) = array.at(i, j);
    }
  LabelledMatrix result{name, {}, numbered_labels(static_cast<int>(n)), false, {}};
  set_entries(result, dense);
  return result;
}

using Arrays = std::map<std::string, NumpyArray>;

const NumpyArray& member(const std::string& name, const Arrays& arrays, const std::string& key) {
  const auto found = arrays.find(key);
  if (found == arrays.end())
    throw InputError(
        fmt::format("{}: the archive has no member {}, which scipy.sparse.save_npz "
                    "writes",
                    name, key));
  return found->second;
}

long whole(const std::string& name, const char* what, double value, double limit) {
  if (!(value >= 0.0 && value < limit) || value != std::floor(value))
    throw InputError(fmt::format("{}: {} holds {}, it must hold whole numbers from 0 to {}", name,
                                 what, value, limit - 1.0));
  return static_cast<long>(value);
}

// csr and csc list the same places of a symmetric matrix.
std::vector<MatrixEntry> compressed_entries(const std::string& name, const Arrays& arrays, long n) {
  const auto& data = member(name, arrays, "data").values;
  const auto& indices = member(name, arrays, "indices").values;
  const auto& starts = member(name, arrays, "indptr").values;
  const auto count = static_cast<double>(data.size());
  if (indices.size() != data.size() || starts.size() != static_cast<std::size_t>(n) + 1 ||
      starts.front() != 0.0 || starts.back() != count)
    throw InputError(fmt::format("{}: data, indices and indptr do not fit each other", name));
  std::vector<MatrixEntry> entries;
  for (long i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const long first = whole(name, "indptr", starts[k], count + 1.0),
               last = whole(name, "indptr", starts[k + 1], count + 1.0);
    for (long e = first; e < last; ++e) {
      const auto at = static_cast<std::size_t>(e);
      const long j = whole(name, "indices", indices[at], static_cast<double>(n));
      check_finite(name, data[at], i, j);
      entries.push_back({static_cast<int>(i), static_cast<int>(j), 0, data[at]});
    }
  }
  return entries;
}

std::vector<MatrixEntry> coordinate_entries(const std::string& name, const Arrays& arrays, long n) {
  const auto& data = member(name, arrays, "data").values;
  const auto& rows = member(name, arrays, "row").values;
  const auto& columns = member(name, arrays, "col").values;
  if (rows.size() != data.size() || columns.size() != data.size())
    throw InputError(fmt::format("{}: data, row and col do not fit each other", name));
  std::vector<MatrixEntry> entries;
  for (std::size_t k = 0; k < data.size(); ++k) {
    const long i = whole(name, "row", rows[k], static_cast<double>(n)),
               j = whole(name, "col", columns[k], static_cast<double>(n));
    check_finite(name, data[k], i, j);
    entries.push_back({static_cast<int>(i), static_cast<int>(j), 0, data[k]});
  }
  return entries;
}

LabelledMatrix sparse_matrix(const std::string& name, const Arrays& arrays) {
  const NumpyArray& shape = member(name, arrays, "shape");
  if (shape.values.size() != 2 || shape.values[0] != shape.values[1])
    throw InputError(fmt::format("{}: the matrix must be square", name));
  const long n = whole(name, "shape", shape.values[0], 20'000'001.0);
  const std::string& format = member(name, arrays, "format").text;
  if (format != "csr" && format != "csc" && format != "coo")
    throw InputError(fmt::format("{}: the format \"{}\" is not allowed, it must be csr, csc or coo",
                                 name, format));
  LabelledMatrix result{name, {}, numbered_labels(static_cast<int>(n)), false, {}};
  set_entries(
      result, static_cast<int>(n),
      format == "coo" ? coordinate_entries(name, arrays, n) : compressed_entries(name, arrays, n),
      EntryStorage::kEither, true);
  return result;
}

}  // namespace

LabelledMatrix read_npy(const std::string& name, const std::string& bytes) {
  return dense_matrix(name, numpy_array(name, bytes));
}

Vector read_npy_vector(const std::string& name, const std::string& bytes) {
  const NumpyArray array = numpy_array(name, bytes);
  long longest = 1;
  for (const long length : array.shape) longest = std::max(longest, length);
  if (array.values.size() != static_cast<std::size_t>(longest))
    throw InputError(fmt::format("{}: the array must be a vector", name));
  for (std::size_t i = 0; i < array.values.size(); ++i)
    check_finite(name, array.values[i], static_cast<long>(i), 0);
  return Eigen::Map<const Vector>(array.values.data(), longest);
}

LabelledMatrix read_npz(const std::filesystem::path& file) {
  const std::string name = file.string();
  Arrays arrays;
  for (const auto& [member_name, bytes] : zip_members(file)) {
    std::string key = member_name;
    if (key.size() > 4 && key.substr(key.size() - 4) == ".npy") key.resize(key.size() - 4);
    arrays.emplace(key, numpy_array(name + ": " + key, bytes));
  }
  if (arrays.count("format")) return sparse_matrix(name, arrays);
  if (arrays.size() != 1)
    throw InputError(fmt::format(
        "{}: the archive has {} arrays, it must be one of scipy.sparse.save_npz or hold one matrix",
        name, arrays.size()));
  return dense_matrix(name, arrays.begin()->second);
}

}  // namespace graze
