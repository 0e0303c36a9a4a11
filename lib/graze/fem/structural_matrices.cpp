#include "graze/fem/structural_matrices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/base/errors.hpp"
#include "graze/fem/matrix_file.hpp"

namespace graze {
namespace {

using Places = std::map<DofLabel, int>;

// The matrix with its rows in the order of `places`; -1 leaves a row out.
SparseMatrix reordered(const LabelledMatrix& given, const Places& places, int size) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(given.matrix.nonZeros()));
  std::vector<int> to;
  for (const DofLabel& label : given.labels) to.push_back(places.at(label));
  for (int j = 0; j < given.matrix.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(given.matrix, j); entry; ++entry) {
      const int row = to[static_cast<std::size_t>(entry.row())];
      const int column = to[static_cast<std::size_t>(j)];
      if (row >= 0 && column >= 0) entries.emplace_back(row, column, entry.value());
    }
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void check_sizes(const LabelledMatrix& matrix, const LabelledMatrix& stiffness) {
  if (matrix.has_names != stiffness.has_names)
    throw InputError(fmt::format(
        "{}: its rows have {}, those of {} have {}; a file of their names (dofs) must bring them "
        "together",
        matrix.file, matrix.has_names ? "names" : "numbers only", stiffness.file,
        stiffness.has_names ? "names" : "numbers only"));
  if (!matrix.has_names && matrix.labels.size() != stiffness.labels.size())
    throw InputError(fmt::format("{}: the matrix has {} rows, the stiffness of {} has {}",
                                 matrix.file, matrix.labels.size(), stiffness.file,
                                 stiffness.labels.size()));
}

void name_rows(LabelledMatrix& matrix, const std::vector<DofLabel>& names,
               const std::filesystem::path& file) {
  if (matrix.has_names) return;
  if (matrix.labels.size() != names.size())
    throw InputError(fmt::format("{}: the matrix has {} rows, {} names {}", matrix.file,
                                 matrix.labels.size(), file.string(), names.size()));
  for (DofLabel& label : matrix.held) label = names[static_cast<std::size_t>(label.node - 1)];
  matrix.labels = names;
  matrix.has_names = true;
}

// All of them: first those of the stiffness.
std::vector<DofLabel> united_labels(const LabelledMatrix& mass, const LabelledMatrix& stiffness,
                                    const LabelledMatrix* damping) {
  std::vector<DofLabel> labels = stiffness.labels;
  std::vector<DofLabel> known = labels;
  std::sort(known.begin(), known.end());
  const auto add = [&](const LabelledMatrix& matrix) {
    const std::vector<DofLabel> before = known;
    for (const DofLabel& label : matrix.labels)
      if (!std::binary_search(before.begin(), before.end(), label)) {
        labels.push_back(label);
        known.push_back(label);
      }
    std::sort(known.begin(), known.end());
  };
  add(mass);
  if (damping) add(*damping);
  return labels;
}

Places places_of(const std::vector<DofLabel>& labels) {
  Places places;
  for (const DofLabel& label : labels) places.emplace(label, static_cast<int>(places.size()));
  return places;
}

// What a unit acceleration of the whole structure does, before rows are left out.
void add_inertia(StructuralMatrices& result, const SparseMatrix& mass,
                 const std::vector<DofLabel>& labels, const Places& kept) {
  std::map<int, Vector> fields;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const int direction = labels[i].direction;
    if (direction > 3) continue;
    auto [field, is_new] = fields.try_emplace(direction, Vector());
    if (is_new) field->second = Vector::Zero(mass.rows());
    field->second[static_cast<Eigen::Index>(i)] = 1.0;
  }
  for (const auto& [direction, field] : fields) {
    const Vector load = mass * field;
    Vector free(result.size());
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (const int place = kept.at(labels[i]); place >= 0)
        free[place] = load[static_cast<Eigen::Index>(i)];
    result.inertia_loads[direction] = free;
    result.total_masses[direction] = field.dot(load);
  }
}

std::vector<std::pair<long, long>> coupled_nodes(const LabelledMatrix& stiffness) {
  std::vector<std::pair<long, long>> pairs;
  const auto label = [&](Eigen::Index i) { return stiffness.labels[static_cast<std::size_t>(i)]; };
  for (int j = 0; j < stiffness.matrix.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(stiffness.matrix, j); entry; ++entry) {
      const DofLabel a = label(entry.row()), b = label(j);
      if (a.direction > 0 && a.node < b.node) pairs.emplace_back(a.node, b.node);
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

bool is_zero_row(const SparseMatrix& symmetric, int row) {
  for (SparseMatrix::InnerIterator entry(symmetric, row); entry; ++entry)
    if (entry.value() != 0.0) return false;
  return true;
}

void check_rows(const StructuralMatrices& structure) {
  std::string names;
  int count = 0;
  for (int i = 0; i < structure.size(); ++i) {
    if (!is_zero_row(structure.mass, i) || !is_zero_row(structure.stiffness, i)) continue;
    if (++count <= 5)
      names +=
          (names.empty() ? "" : ", ") + label_text(structure.labels[static_cast<std::size_t>(i)]);
  }
  if (count == 0) return;
  throw InputError(fmt::format(
      "{}: {} degree{} of freedom {} neither stiffness nor mass: {}{}. Hold what nothing moves "
      "(constraints)",
      structure.stiffness_file, count, count == 1 ? "" : "s", count == 1 ? "has" : "have", names,
      count > 5 ? ", .." : ""));
}

}  // namespace

std::optional<int> StructuralMatrices::find(const DofLabel& label) const {
  const auto found = std::find(labels.begin(), labels.end(), label);
  if (found == labels.end()) return {};
  return static_cast<int>(found - labels.begin());
}

std::vector<int> StructuralMatrices::rows_with_mass() const {
  std::vector<int> rows;
  for (int i = 0; i < size(); ++i)
    if (!is_zero_row(mass, i)) rows.push_back(i);
  return rows;
}

StructuralMatrices join_matrices(const LabelledMatrix& mass, const LabelledMatrix& stiffness,
                                 const LabelledMatrix* damping,
                                 const std::vector<DofLabel>& constraints) {
  check_sizes(mass, stiffness);
  if (damping) check_sizes(*damping, stiffness);
  const std::vector<DofLabel> labels = united_labels(mass, stiffness, damping);
  const Places all = places_of(labels);
  std::vector<DofLabel> held = constraints;
  held.insert(held.end(), stiffness.held.begin(), stiffness.held.end());
  for (const DofLabel& label : held)
    if (!all.count(label))
      throw InputError(fmt::format("{}: the matrix has no degree of freedom {} to be held",
                                   stiffness.file, label_text(label)));
  std::sort(held.begin(), held.end());
  StructuralMatrices result;
  result.mass_file = mass.file;
  result.stiffness_file = stiffness.file;
  Places kept;
  for (const DofLabel& label : labels) {
    const bool is_held = std::binary_search(held.begin(), held.end(), label);
    kept[label] = is_held ? -1 : result.size();
    (is_held ? result.held : result.labels).push_back(label);
  }
  if (result.labels.empty())
    throw InputError(fmt::format("{}: every degree of freedom is held", stiffness.file));
  result.mass = reordered(mass, kept, result.size());
  result.stiffness = reordered(stiffness, kept, result.size());
  if (damping) {
    result.damping = reordered(*damping, kept, result.size());
    result.damping_file = damping->file;
  }
  add_inertia(result, reordered(mass, all, static_cast<int>(labels.size())), labels, kept);
  result.couplings = coupled_nodes(stiffness);
  check_rows(result);
  return result;
}

StructuralMatrices read_structure(const MatrixFiles& files,
                                  const std::vector<DofLabel>& constraints) {
  LabelledMatrix mass = read_matrix(files.mass), stiffness = read_matrix(files.stiffness);
  std::optional<LabelledMatrix> damping;
  if (files.damping) damping = read_matrix(*files.damping);
  if (files.dofs) {
    const std::vector<DofLabel> names = read_dof_names(*files.dofs);
    name_rows(mass, names, *files.dofs);
    name_rows(stiffness, names, *files.dofs);
    if (damping) name_rows(*damping, names, *files.dofs);
  }
  return join_matrices(mass, stiffness, damping ? &*damping : nullptr, constraints);
}

}  // namespace graze
