#include "graze/fem/detail/matrix_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/base/errors.hpp"

namespace graze {
namespace {

std::string told(const std::string& file, int line, const std::string& sentence) {
  return line == 0 ? fmt::format("{}: {}", file, sentence)
                   : fmt::format("{}:{}: {}", file, line, sentence);
}

[[noreturn]] void fail(const std::string& file, int line, const std::string& sentence) {
  throw InputError(told(file, line, sentence));
}

std::string place(const std::vector<DofLabel>& labels, int row, int column) {
  return fmt::format("({}, {})", label_text(labels[static_cast<std::size_t>(row)]),
                     label_text(labels[static_cast<std::size_t>(column)]));
}

using Entries = std::vector<MatrixEntry>;

bool before(const MatrixEntry& a, const MatrixEntry& b) {
  return a.column != b.column ? a.column < b.column : a.row < b.row;
}

// Sorted by column and row, each place once.
void unite(const std::string& file, Entries& entries, const std::vector<DofLabel>& labels,
           bool adds) {
  std::stable_sort(entries.begin(), entries.end(), before);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (kept > 0 && entries[kept - 1].row == entries[i].row &&
        entries[kept - 1].column == entries[i].column) {
      if (!adds)
        fail(file, entries[i].line,
             fmt::format("the entry {} stands twice, first in line {}",
                         place(labels, entries[i].row, entries[i].column), entries[kept - 1].line));
      entries[kept - 1].value += entries[i].value;
      continue;
    }
    entries[kept++] = entries[i];
  }
  entries.resize(kept);
}

const MatrixEntry* find(const Entries& entries, int row, int column) {
  const MatrixEntry wanted{row, column, 0, 0.0};
  const auto found = std::lower_bound(entries.begin(), entries.end(), wanted, before);
  return found != entries.end() && found->row == row && found->column == column ? &*found : nullptr;
}

// Calls visit(entry, mirror, other) once for each pair of mirror images, `other` the value of the
// second, which is null where it is not listed.
template <class Visit>
void each_pair(Entries& entries, const Visit& visit) {
  for (MatrixEntry& entry : entries) {
    if (entry.row == entry.column) continue;
    const MatrixEntry* mirror = find(entries, entry.column, entry.row);
    // A pair is handled once, when the later of its columns is reached.
    if (mirror && entry.row > entry.column) continue;
    if (!visit(entry, mirror, mirror ? mirror->value : 0.0)) return;
  }
}

// Why the matrix is not symmetric; empty where it is.
std::string asymmetry_of(const std::string& file, Entries& entries, const Vector& diagonal,
                         const std::vector<DofLabel>& labels) {
  std::string why;
  each_pair(entries, [&](const MatrixEntry& entry, const MatrixEntry*, double other) {
    const double scale = std::max({std::sqrt(diagonal[entry.row] * diagonal[entry.column]),
                                   std::abs(entry.value), std::abs(other)});
    const double difference = std::abs(entry.value - other);
    if (difference <= kAllowedAsymmetry * scale) return true;
    why = told(file, entry.line,
               fmt::format("the matrix is not symmetric: the entry {} is {} and the entry {} is "
                           "{}; their difference is {:.2g} of its scale, allowed is {:g}",
                           place(labels, entry.row, entry.column), entry.value,
                           place(labels, entry.column, entry.row), other, difference / scale,
                           kAllowedAsymmetry));
    return false;
  });
  return why;
}

// Replaces each pair of mirror images by their mean.
void make_symmetric(Entries& entries) {
  Entries missing;
  each_pair(entries, [&](MatrixEntry& entry, const MatrixEntry* mirror, double other) {
    const double mean = other + 0.5 * (entry.value - other);
    entry.value = mean;
    if (mirror)
      const_cast<MatrixEntry*>(mirror)->value = mean;
    else
      missing.push_back({entry.column, entry.row, entry.line, mean});
    return true;
  });
  entries.insert(entries.end(), missing.begin(), missing.end());
}

}  // namespace

std::vector<DofLabel> numbered_labels(int size) {
  std::vector<DofLabel> labels(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i) labels[static_cast<std::size_t>(i)].node = i + 1;
  return labels;
}

void set_entries(LabelledMatrix& into, int size, Entries entries, EntryStorage storage, bool adds) {
  const std::string& file = into.file;
  const std::vector<DofLabel>& labels = into.labels;
  if (size == 0 || entries.empty()) fail(file, 0, "the matrix has no entries");
  unite(file, entries, labels, adds);
  Vector diagonal = Vector::Zero(size);
  const MatrixEntry* pair = nullptr;
  for (const MatrixEntry& entry : entries) {
    if (entry.row == entry.column)
      diagonal[entry.row] = std::abs(entry.value);
    else if (pair == nullptr && find(entries, entry.column, entry.row))
      pair = &entry;
  }
  if (storage == EntryStorage::kOneTriangle && pair)
    fail(
        file, pair->line,
        fmt::format("the entry {} and its mirror image are both listed, of a symmetric matrix only "
                    "one of them must be",
                    place(labels, pair->row, pair->column)));
  if (storage == EntryStorage::kFull || (storage == EntryStorage::kEither && pair)) {
    into.asymmetry = asymmetry_of(file, entries, diagonal, labels);
    if (into.asymmetry.empty()) make_symmetric(entries);
  } else {
    const std::size_t listed = entries.size();
    for (std::size_t i = 0; i < listed; ++i)
      if (entries[i].row != entries[i].column)
        entries.push_back({entries[i].column, entries[i].row, entries[i].line, entries[i].value});
  }
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(entries.size());
  for (const MatrixEntry& entry : entries)
    triplets.emplace_back(entry.row, entry.column, entry.value);
  entries = {};
  into.matrix.resize(size, size);
  into.matrix.setFromTriplets(triplets.begin(), triplets.end());
}

void set_entries(LabelledMatrix& into, const Matrix& dense) {
  Entries entries;
  for (int j = 0; j < dense.cols(); ++j)
    for (int i = 0; i < dense.rows(); ++i)
      if (dense(i, j) != 0.0) entries.push_back({i, j, 0, dense(i, j)});
  set_entries(into, static_cast<int>(dense.rows()), std::move(entries), EntryStorage::kFull);
}

}  // namespace graze
