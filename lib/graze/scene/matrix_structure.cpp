#include "graze/scene/matrix_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/base/sha256.hpp"
#include "graze/fem/detail/text_lines.hpp"
#include "graze/fem/dof_values.hpp"
#include "graze/fem/matrix_file.hpp"
#include "graze/scene/detail/keys.hpp"

namespace graze {
namespace {

constexpr const char* kForm = "node.direction, or a number like \"7\"";

// The checksum of the files that a structure names, in one order; "#NAME" in a Nastran file name
// refers to a part of that file.
std::string files_checksum(const MatrixStructure& matrices) {
  std::string text;
  for (const std::string& name :
       {matrices.mass, matrices.stiffness, matrices.damping, matrices.dofs, matrices.coordinates,
        matrices.constraints_file, matrices.load_file}) {
    if (name.empty()) continue;
    std::error_code no_matter;
    const bool whole = std::filesystem::exists(name, no_matter);
    text += sha256(read_bytes(whole ? name : name.substr(0, name.rfind('#')))) + "\n";
  }
  return sha256(text);
}

// The degrees of freedom that a text names: one, or one at each node of a set of the mesh, "TIP.3".
std::vector<DofLabel> labels_of(const Scene& scene, const Mesh& mesh, const std::string& key,
                                const std::string& text) {
  if (const std::optional<DofLabel> label = label_from_text(text)) return {*label};
  const std::size_t dot = std::min(text.rfind('.'), text.size());
  const auto set = mesh.sets.find(in_capitals(text.substr(0, dot)));
  if (set == mesh.sets.end())
    throw scene_error(
        scene, key,
        fmt::format("\"{}\" is not allowed, it must be {}, or in place of the node a set of nodes "
                    "(*NSET) in the file of coordinates",
                    text, kForm));
  // As the direction of a node of the set is read.
  const std::optional<DofLabel> direction = label_from_text("1" + text.substr(dot));
  if (!direction || direction->direction == 0)
    throw scene_error(
        scene, key,
        fmt::format("\"{}\" names a set of nodes without a direction there, it must be "
                    "like \"{}.3\"",
                    text, text.substr(0, dot)));
  std::vector<DofLabel> labels;
  for (const long node : set->second)
    labels.push_back({node, direction->direction, direction->row});
  return labels;
}

DofLabel label_of(const Scene& scene, const Mesh& mesh, const std::string& key,
                  const std::string& text) {
  const std::vector<DofLabel> labels = labels_of(scene, mesh, key, text);
  if (labels.size() == 1) return labels.front();
  throw scene_error(scene, key,
                    fmt::format("\"{}\" is not allowed, the set has {} nodes, it must have one",
                                text, labels.size()));
}

std::vector<DofLabel> constraints_of(const Scene& scene, const MatrixStructure& matrices,
                                     const Mesh& mesh) {
  std::vector<DofLabel> held;
  for (const std::string& text : matrices.constraints)
    for (const DofLabel& label : labels_of(scene, mesh, "matrices.constraints", text))
      held.push_back(label);
  if (!matrices.constraints_file.empty())
    for (const DofLabel& label : read_dof_names(matrices.constraints_file)) held.push_back(label);
  return held;
}

// A hint for messages: CalculiX writes no row of a held degree of freedom, nor its mass.
const char* left_out(const Scene& scene) {
  return scene.matrices()->dofs.empty() ? ""
                                        : "; CalculiX leaves out what *BOUNDARY holds: written "
                                          "without it, all are there and can "
                                          "be held by constraints_file";
}

// A stop or a probe as a row over the free degrees of freedom.
Vector row_of(const Scene& scene, const StructuralMatrices& structure, const Mesh& mesh,
              const std::string& table, const std::string& node, const std::string& against) {
  Vector row = Vector::Zero(structure.size());
  const auto add = [&](const char* key, const std::string& text, double sign) {
    const std::string path = table + "." + key;
    const DofLabel label = label_of(scene, mesh, path, text);
    if (const std::optional<int> place = structure.find(label)) {
      row[*place] += sign;
      return;
    }
    const auto& held = structure.held;
    if (std::find(held.begin(), held.end(), label) == held.end())
      throw scene_error(scene, path, structure.absence(label) + left_out(scene));
  };
  if (node.empty()) throw scene_error(scene, table + ".node", "the key is missing");
  add("node", node, 1.0);
  if (!against.empty()) add("against", against, -1.0);
  if (row.isZero(0.0))
    throw scene_error(
        scene, table + ".node",
        fmt::format("the degree of freedom {} {}", node,
                    against.empty() ? "is held at zero" : "moves with the other one"));
  return row;
}

std::vector<double> as_list(const Vector& vector) { return {vector.begin(), vector.end()}; }

std::vector<double> load_participation(const Scene& scene, const MatrixStructure& matrices,
                                       const StructuralMatrices& structure, const Mesh& mesh,
                                       const Matrix& shapes) {
  if (!matrices.load_file.empty()) {
    if (!matrices.load.empty() || !matrices.load_values.empty())
      throw scene_error(scene, "matrices.load", "the load is in a file, it must be left out");
    return as_list(shapes.transpose() *
                   read_dof_values(matrices.load_file, structure.labels, structure.held));
  }
  const std::size_t count = matrices.load_values.size();
  if (count != 0 && count != matrices.load.size())
    throw scene_error(scene, "matrices.load_values",
                      fmt::format("the list has {} entries, it must have one for each of the {} of "
                                  "load",
                                  count, matrices.load.size()));
  if (matrices.load.empty()) return {};
  Vector load = Vector::Zero(structure.size());
  for (std::size_t i = 0; i < matrices.load.size(); ++i) {
    const std::string key = fmt::format("matrices.load.{}", i + 1);
    const DofLabel label = label_of(scene, mesh, key, matrices.load[i]);
    const std::optional<int> place = structure.find(label);
    if (!place)
      throw scene_error(
          scene, key,
          fmt::format("{} that is not held{}", structure.absence(label), left_out(scene)));
    const double value = count == 0 ? 1.0 : matrices.load_values[i];
    if (!std::isfinite(value))
      throw scene_error(scene, fmt::format("matrices.load_values.{}", i + 1),
                        fmt::format("{} is not allowed, it must be finite", value));
    load[*place] += value;
  }
  return as_list(shapes.transpose() * load);
}

Matrix stop_rows(const Scene& scene, const StructuralMatrices& structure, const Mesh& mesh) {
  Matrix rows(structure.size(), static_cast<Eigen::Index>(scene.stops.size()));
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    rows.col(static_cast<Eigen::Index>(i)) =
        row_of(scene, structure, mesh, numbered_path("stop", i + 1), scene.stops[i].node,
               scene.stops[i].against);
  return rows;
}

// Loads of a unit force at each stop and, where there is one, of a unit acceleration.
Matrix static_loads(const Matrix& rows, const StructuralMatrices& structure, int direction) {
  const auto inertia = structure.inertia_loads.find(direction);
  if (inertia == structure.inertia_loads.end()) return rows;
  Matrix loads(rows.rows(), rows.cols() + 1);
  loads << rows, inertia->second;
  return loads;
}

void add_static_displacements(const Matrix& rows, MatrixModes& found) {
  if (found.modes.static_displacements.cols() == 0) return;  // nothing was asked for
  const Matrix moved = rows.transpose() * found.modes.static_displacements;
  found.flexibility = moved.leftCols(rows.cols());
  if (moved.cols() > rows.cols()) found.under_gravity = moved.col(rows.cols());
}

// A structure that is held has about 1/(number of elements), a free one the rounding of its digits.
constexpr double kWeakHold = 1e-6;

std::map<int, double> weak_holds(const StructuralMatrices& structure) {
  std::map<int, double> weak;
  const SparseMatrix absolute = structure.stiffness.cwiseAbs();
  for (const int direction : {1, 2, 3}) {
    Vector r = Vector::Zero(structure.size());
    for (int i = 0; i < structure.size(); ++i)
      if (structure.labels[static_cast<std::size_t>(i)].direction == direction) r[i] = 1.0;
    const double scale = r.dot(absolute * r), held = std::abs(r.dot(structure.stiffness * r));
    if (held > kRigidEnergy * scale && held < kWeakHold * scale) weak[direction] = held / scale;
  }
  return weak;
}

}  // namespace

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
  const MatrixStructure* matrices = scene.matrices();
  return matrices && matrices->solved->damping ? &*matrices->solved->damping : nullptr;
}

void solve_matrices(Scene& scene) {
  auto& matrices = std::get<MatrixStructure>(scene.structure);
  const std::string checksum = files_checksum(matrices);
  if (!matrices.checksum.empty() && matrices.checksum != checksum)
    throw scene_error(scene, "matrices.checksum",
                      fmt::format("the files have the checksum {}, they have been changed since "
                                  "this scene was written",
                                  checksum));
  matrices.checksum = checksum;
  MatrixFiles files{matrices.mass, matrices.stiffness, {}, {}};
  if (!matrices.damping.empty()) files.damping = matrices.damping;
  if (!matrices.dofs.empty()) files.dofs = matrices.dofs;
  Mesh mesh;
  if (!matrices.coordinates.empty()) mesh = read_mesh(matrices.coordinates);
  // A file of nodes without elements may leave some out.
  if (!mesh.elements.empty())
    for (const auto& [node, place] : mesh.nodes) files.nodes.insert(node);
  const StructuralMatrices structure = read_structure(files, constraints_of(scene, matrices, mesh));
  const auto found = std::make_shared<MatrixModes>();
  const Matrix rows = stop_rows(scene, structure, mesh);
  if (matrices.modes > static_cast<int>(structure.rows_with_mass().size()))
    throw scene_error(scene, "matrices.modes",
                      fmt::format("{} is not allowed, the matrices have {}", matrices.modes,
                                  mode_limit_text(structure)));
  found->modes =
      lowest_modes(structure, matrices.modes, static_loads(rows, structure, matrices.direction));
  for (const DofLabel& label : structure.labels)
    found->rows.emplace(label, static_cast<Eigen::Index>(found->rows.size()));
  for (const DofLabel& label : structure.held) found->rows.emplace(label, -1);
  found->total_masses = structure.total_masses;
  const Matrix& shapes = found->modes.shapes;
  for (const auto& [direction, load] : structure.inertia_loads)
    found->inertia[direction] = shapes.transpose() * load;
  if (structure.damping) found->damping = modal_damping(structure, found->modes);
  if (!mesh.nodes.empty()) {
    found->coordinates = std::move(mesh.nodes);
    found->elements = std::move(mesh.elements);
    found->couplings = structure.couplings;
  }
  found->weak_holds = weak_holds(structure);
  add_static_displacements(rows, *found);
  matrices.modal = {as_list(found->modes.omega), {}, {}, {}};
  matrices.modal.participation = load_participation(scene, matrices, structure, mesh, shapes);
  if (const auto along = found->inertia.find(matrices.direction); along != found->inertia.end())
    matrices.modal.inertia = as_list(along->second);
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    scene.stops[i].shape = as_list(shapes.transpose() * rows.col(static_cast<Eigen::Index>(i)));
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    Probe& probe = scene.probes[i];
    if (is_of_hub(probe.quantity)) continue;
    probe.shape =
        as_list(shapes.transpose() * row_of(scene, structure, mesh, numbered_path("probe", i + 1),
                                            probe.node, probe.against));
  }
  matrices.solved = found;
}

}  // namespace graze
