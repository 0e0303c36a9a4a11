#include "graze/fem/structural_matrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "graze/base/errors.hpp"
#include "graze/fem/matrix_file.hpp"

namespace graze {
namespace {

using Places = std::map<DofLabel, int>;

// The matrix with its rows and columns in the order of places; -1 leaves one out.
struct Order {
  const Places& places;
  int size;
};
SparseMatrix reordered(const LabelledMatrix& given, const Order& rows, const Order& columns) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(given.matrix.nonZeros()));
  std::vector<std::array<int, 2>> to;
  for (const DofLabel& label : given.labels)
    to.push_back({rows.places.at(label), columns.places.at(label)});
  for (int j = 0; j < given.matrix.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(given.matrix, j); entry; ++entry) {
      const int row = to[static_cast<std::size_t>(entry.row())][0];
      const int column = to[static_cast<std::size_t>(j)][1];
      if (row >= 0 && column >= 0) entries.emplace_back(row, column, entry.value());
    }
  SparseMatrix matrix(rows.size, columns.size);
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

// All labels: first those of the stiffness.
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

// All rows that have the name, each with its number where there are several.
std::vector<DofLabel> rows_named(const Places& places, const DofLabel& name) {
  std::vector<DofLabel> rows;
  for (auto row = places.lower_bound(name); row != places.end(); ++row) {
    const DofLabel& label = row->first;
    const bool is_named = label == name || (name.row == 0 && label.node == name.node &&
                                            label.direction == name.direction);
    if (!is_named) break;
    rows.push_back(label);
  }
  return rows;
}

// Adds the loads of a unit acceleration of the whole structure, before rows are left out.
void add_inertia(StructuralMatrices& result, const SparseMatrix& mass,
                 const std::vector<DofLabel>& labels, const Places& kept,
                 const std::set<long>& nodes) {
  std::map<int, Vector> fields;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const int direction = labels[i].direction;
    if (direction > 3 || (!nodes.empty() && !nodes.contains(labels[i].node))) continue;
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

std::string StructuralMatrices::absence(const DofLabel& label) const {
  int rows = 0;
  for (const std::vector<DofLabel>* list : {&labels, &held})
    for (const DofLabel& other : *list)
      rows += other.node == label.node && other.direction == label.direction && other.row > 0;
  const std::string name = label_text({label.node, label.direction});
  if (rows > 0)
    return fmt::format("{0} is the name of {1} rows, it must be one of {0}.1 to {0}.{1}", name,
                       rows);
  return fmt::format("the matrices have no degree of freedom {}", label_text(label));
}

std::vector<int> StructuralMatrices::rows_with_mass() const {
  std::vector<int> rows;
  for (int i = 0; i < size(); ++i)
    if (!is_zero_row(mass, i)) rows.push_back(i);
  return rows;
}

StructuralMatrices join_matrices(const LabelledMatrix& mass, const LabelledMatrix& stiffness,
                                 const LabelledMatrix* damping,
                                 const std::vector<DofLabel>& constraints,
                                 const std::set<long>& nodes) {
  check_sizes(mass, stiffness);
  if (damping) check_sizes(*damping, stiffness);
  const std::vector<DofLabel> labels = united_labels(mass, stiffness, damping);
  const Places all = places_of(labels);
  std::vector<DofLabel> held = stiffness.held;
  for (const DofLabel& label : constraints) {
    const std::vector<DofLabel> rows = rows_named(all, label);
    if (rows.empty())
      throw InputError(fmt::format("{}: the matrix has no degree of freedom {} to be held",
                                   stiffness.file, label_text(label)));
    held.insert(held.end(), rows.begin(), rows.end());
  }
  std::sort(held.begin(), held.end());
  StructuralMatrices result;
  result.mass_file = mass.file;
  result.stiffness_file = stiffness.file;
  Places free_places, held_places;
  for (const DofLabel& label : labels) {
    const bool is_held = std::binary_search(held.begin(), held.end(), label);
    free_places[label] = is_held ? -1 : result.size();
    held_places[label] = is_held ? static_cast<int>(result.held.size()) : -1;
    (is_held ? result.held : result.labels).push_back(label);
  }
  if (result.labels.empty())
    throw InputError(fmt::format("{}: every degree of freedom is held", stiffness.file));
  const Order kept{free_places, result.size()}, whole{all, static_cast<int>(labels.size())},
      left{held_places, static_cast<int>(result.held.size())};
  result.mass = reordered(mass, kept, kept);
  result.held_mass = reordered(mass, kept, left);
  result.stiffness = reordered(stiffness, kept, kept);
  result.held_stiffness = reordered(stiffness, kept, left);
  if (damping) {
    result.damping = reordered(*damping, kept, kept);
    result.held_damping = reordered(*damping, kept, left);
    result.damping_file = damping->file;
  }
  add_inertia(result, reordered(mass, whole, whole), labels, free_places, nodes);
  result.couplings = coupled_nodes(stiffness);
  check_rows(result);
  return result;
}

StructuralMatrices read_structure(const MatrixFiles& files,
                                  const std::vector<DofLabel>& constraints) {
  LabelledMatrix mass = read_matrix(files.mass), stiffness = read_matrix(files.stiffness);
  std::optional<LabelledMatrix> damping;
  if (files.damping) damping = read_general_matrix(*files.damping);
  if (files.dofs) {
    const std::vector<DofLabel> names = read_row_names(*files.dofs);
    if (mass.has_names && stiffness.has_names && (!damping || damping->has_names))
      throw InputError(
          fmt::format("{}: the matrices have the names of their rows, this file of names (dofs) "
                      "must be left out",
                      files.dofs->string()));
    name_rows(mass, names, *files.dofs);
    name_rows(stiffness, names, *files.dofs);
    if (damping) name_rows(*damping, names, *files.dofs);
  }
  return join_matrices(mass, stiffness, damping ? &*damping : nullptr, constraints, files.nodes);
}

}  // namespace graze
