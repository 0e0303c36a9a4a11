// What is asked of the modes that solve_matrices found.
#include "graze/scene/discrete_matrices.hpp"
#include "graze/scene/matrix_structure.hpp"

namespace graze {

std::optional<Vector> MatrixModes::row(const std::string& text) const {
  const std::optional<DofLabel> label = label_from_text(text);
  if (!label) return {};
  const auto place = rows.find(*label);
  if (place == rows.end()) return {};
  if (place->second < 0) return Vector::Zero(modes.count());
  return Vector(modes.shapes.row(place->second));
}

std::array<double, 3> MatrixModes::displacement(long node, Eigen::Index mode) const {
  std::array<double, 3> moved{};
  for (int direction = 1; direction <= 3; ++direction) {
    // The mean where there are several rows, as for the layers of a shell.
    int count = 0;
    double sum = 0.0;
    for (auto place = rows.lower_bound({node, direction});
         place != rows.end() && place->first.node == node && place->first.direction == direction;
         ++place, ++count)
      if (place->second >= 0) sum += modes.shapes(place->second, mode);
    if (count > 0) moved[static_cast<std::size_t>(direction - 1)] = sum / count;
  }
  return moved;
}

const ModalDamping* damping_of_matrices(const Scene& scene) {
  const DiscreteStructure* given = scene.discrete();
  return given && given->solved->damping ? &*given->solved->damping : nullptr;
}

Matrix coordinate_rows(const Scene& scene) {
  if (!has_own_matrices(scene)) return {};
  const MatrixModes& found = *scene.discrete()->solved;
  Matrix rows = Matrix::Zero(static_cast<Eigen::Index>(found.rows.size()), found.modes.count());
  Eigen::Index i = 0;
  for (const auto& [label, row] : found.rows) {
    if (row >= 0) rows.row(i) = found.modes.shapes.row(row);
    ++i;
  }
  return rows;
}

}  // namespace graze
