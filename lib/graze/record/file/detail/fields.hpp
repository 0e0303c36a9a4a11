// The parts of values that are not written by their members: lists of any length, and numbers of
// other libraries (value_text.hpp).
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/record/file/detail/value_text.hpp"

namespace graze {

template <class Archive, class List>
void list_fields(Archive& archive, List& values) {
  if constexpr (Archive::kReads) {
    values.clear();
    while (archive.has_more()) archive(values.emplace_back());
  } else {
    for (const auto& value : values) archive(value);
  }
}
template <class Archive, class T>
void fields(Archive& archive, std::vector<T>& values) {
  list_fields(archive, values);
}
template <class Archive, class T>
void fields(Archive& archive, std::deque<T>& values) {
  list_fields(archive, values);
}
template <class Archive, class T, std::size_t size>
void fields(Archive& archive, std::array<T, size>& values) {
  for (T& value : values) archive(value);
}
template <class Archive, class T>
void fields(Archive& archive, std::optional<T>& value) {
  if constexpr (Archive::kReads) {
    value.reset();
    if (archive.has_more()) archive(value.emplace());
  } else if (value) {
    archive(*value);
  }
}
// A cell that was not run has no contents.
template <class Archive, class Cell>
requires requires(Cell& cell) { cell.is_known; }
void fields(Archive& archive, Cell& cell) {
  if constexpr (Archive::kReads) {
    if (!archive.has_more()) return;
  } else if (!cell.is_known) {
    return;
  }
  with_members(cell, [&](auto&... members) { (archive(members), ...); });
}
template <class Archive, class First, class Second>
void fields(Archive& archive, std::pair<First, Second>& pair) {
  archive(pair.first), archive(pair.second);
}
// A variant is written with the index of its alternative.
template <class Archive, class... Types>
void fields(Archive& archive, std::variant<Types...>& value) {
  std::size_t place = value.index();
  archive(place);
  if constexpr (Archive::kReads) {
    std::size_t i = 0;
    const auto read = [&]<class T>(T alternative) {
      if (i++ != place) return;
      archive(alternative);
      value = std::move(alternative);
    };
    if (place >= sizeof...(Types)) throw UnreadableText();
    (read(Types{}), ...);
  } else {
    std::visit([&](const auto& alternative) { archive(alternative); }, value);
  }
}
template <class Archive>
void fields(Archive& archive, Complex& number) {
  double re = number.real(), im = number.imag();
  archive(re), archive(im);
  number = {re, im};
}
template <class Archive>
void fields(Archive& archive, Vector& values) {
  if constexpr (Archive::kReads) {
    std::vector<double> read;
    list_fields(archive, read);
    values = Eigen::Map<const Vector>(read.data(), static_cast<Eigen::Index>(read.size()));
  } else {
    for (const double value : values) archive(value);
  }
}
template <class Archive>
void fields(Archive& archive, Matrix& matrix) {
  Eigen::Index rows = matrix.rows(), columns = matrix.cols();
  archive(rows), archive(columns);
  Vector values = matrix.reshaped();
  archive(values);
  if constexpr (Archive::kReads) {
    if (rows < 0 || columns < 0 || values.size() != rows * columns) throw UnreadableText();
    matrix = values.reshaped(rows, columns);
  }
}

}  // namespace graze
