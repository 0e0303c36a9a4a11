// The rows of a matrix whose file names them by labels, in the order of these.
#pragma once

#include <map>
#include <vector>

#include "graze/fem/detail/matrix_entries.hpp"

namespace graze {

struct LabelledEntry {
  DofLabel row, column;
  int line = 0;
  double value = 0.0;
};

// All labels that occur, sorted, and the entries by their places among them.
inline std::vector<MatrixEntry> indexed(const std::vector<LabelledEntry>& listed,
                                        std::vector<DofLabel>& labels) {
  std::map<DofLabel, int> places;
  for (const LabelledEntry& entry : listed) {
    places.emplace(entry.row, 0);
    places.emplace(entry.column, 0);
  }
  labels.clear();
  for (auto& [label, place] : places) {
    place = static_cast<int>(labels.size());
    labels.push_back(label);
  }
  std::vector<MatrixEntry> entries;
  entries.reserve(listed.size());
  for (const LabelledEntry& entry : listed)
    entries.push_back({places.at(entry.row), places.at(entry.column), entry.line, entry.value});
  return entries;
}

}  // namespace graze
