#include "graze/scene/matrix_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/products.hpp"
#include "graze/base/sha256.hpp"
#include "graze/fem/detail/matrix_entries.hpp"
#include "graze/fem/detail/text_lines.hpp"
#include "graze/fem/dof_values.hpp"
#include "graze/fem/matrix_file.hpp"
#include "graze/scene/detail/dof_names.hpp"
#include "graze/scene/detail/keys.hpp"
#include "graze/scene/discrete_matrices.hpp"

namespace graze {
namespace {

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

// Rows of points on the free degrees of freedom.
class PointRows {
 public:
  PointRows(const Scene& scene, const StructuralMatrices& structure, const Mesh& mesh)
      : scene_(scene), structure_(structure), mesh_(mesh) {}

  Eigen::Index size() const { return structure_.size(); }
  Vector row(const DofLabel& label) const {
    return Vector::Unit(structure_.size(), *structure_.find(label));
  }
  // `table`: that of the point, "stop.2".
  Vector row(const std::string& table, const auto& point) const {
    Vector row = Vector::Zero(structure_.size());
    const std::string key = table + (scene_.lumped() ? ".mass" : ".node");
    if (point.node.empty()) throw scene_error(scene_, key, "the key is missing");
    add(key, point.node, 1.0, row);
    if (!point.against.empty()) add(table + ".against", point.against, -1.0, row);
    if (row.isZero(0.0))
      throw scene_error(
          scene_, key,
          fmt::format("the {} {} {}", scene_.lumped() ? "mass" : "degree of freedom", point.node,
                      point.against.empty() ? "is held at zero" : "moves with the other one"));
    return row;
  }

 private:
  void add(const std::string& path, const std::string& text, double sign, Vector& row) const {
    if (const LumpedStructure* lumped = scene_.lumped()) {
      const std::optional<int> mass = mass_named(*lumped, text);
      const bool may_be_ground = sign < 0.0;  // of the point that it is measured from
      if (!mass || (*mass < 0 && !may_be_ground))
        throw scene_error(scene_, path, mass_refusal(*lumped, text, may_be_ground));
      if (*mass >= 0) row[*mass] += sign;
      return;
    }
    const DofLabel label = label_of(scene_, mesh_, path, text);
    if (const std::optional<int> place = structure_.find(label)) {
      row[*place] += sign;
      return;
    }
    const auto& held = structure_.held;
    if (std::find(held.begin(), held.end(), label) == held.end())
      throw scene_error(scene_, path, structure_.absence(label) + left_out(scene_));
  }

  const Scene& scene_;
  const StructuralMatrices& structure_;
  const Mesh& mesh_;
};

std::vector<double> as_list(const Vector& vector) { return {vector.begin(), vector.end()}; }

Vector load_of(const Scene& scene, const MatrixStructure& matrices,
               const StructuralMatrices& structure, const Mesh& mesh) {
  if (!matrices.load_file.empty()) {
    if (!matrices.load.empty() || !matrices.load_values.empty())
      throw scene_error(scene, "matrices.load", "the load is in a file, it must be left out");
    return read_dof_values(matrices.load_file, structure.labels, structure.held);
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
  return load;
}

// Where a support moves the structure is pushed by what held degrees of freedom do to free ones.
MovedSupport support_of_matrices(const Scene& scene, const StructuralMatrices& structure,
                                 const Mesh& mesh, const HarmonicLoad& load,
                                 const std::string& table, const MatrixModes& found) {
  const std::string key = table + ".node";
  if (load.at.node.empty()) throw scene_error(scene, key, "the key is missing");
  if (!load.at.against.empty())
    throw scene_error(scene, table + ".against", "a support moves in space, it must be left out");
  MovedSupport support{Matrix::Zero(structure.size(), 3), {}};
  Matrix& forces = support.forces;
  for (const DofLabel& label : labels_of(scene, mesh, key, load.at.node)) {
    const auto held = std::find(structure.held.begin(), structure.held.end(), label);
    if (held == structure.held.end())
      throw scene_error(
          scene, key,
          structure.find(label)
              ? fmt::format("{} is free, a support must be held (constraints)", label_text(label))
              : structure.absence(label) + left_out(scene));
    const Eigen::Index k = held - structure.held.begin();
    forces.col(0) -= structure.held_stiffness.col(k);
    if (structure.held_damping) forces.col(1) -= structure.held_damping->col(k);
    forces.col(2) -= structure.held_mass.col(k);
    support.coordinates.push_back(std::distance(found.rows.begin(), found.rows.find(label)));
  }
  if (forces.isZero(0.0))
    throw scene_error(
        scene, key,
        fmt::format("nothing connects {} with what is free, it must hold something", load.at.node));
  if (load.signal && !forces.rightCols(2).isZero(0.0))
    throw scene_error(scene, table + ".signal",
                      "mass or damping connects the support, whose force would jump at each "
                      "instant of the signal; the load must be a harmonic, or the support be "
                      "connected by stiffness alone");
  return support;
}

void add_supports(const Scene& scene, const StructuralMatrices& structure, const Mesh& mesh,
                  const PointRows& rows, MatrixModes& found) {
  std::size_t number = 0;
  for (const HarmonicLoad* load : scene.harmonic_loads()) {
    const std::string table = numbered_path("forcing", ++number);
    if (load->kind != ForcingKind::kSupport) continue;
    if (scene.matrices()) {
      found.supports.push_back(support_of_matrices(scene, structure, mesh, *load, table, found));
      continue;
    }
    const Vector on = rows.row(table, load->at);
    const std::array<double, 2> springs = support_of(scene, *load);
    MovedSupport support{Matrix::Zero(structure.size(), 3), {}};
    support.forces.leftCols(2) << springs[0] * on, springs[1] * on;
    found.supports.push_back(std::move(support));
  }
}

// Of stops, loads and the points of the forcing; of supports the forces per unit of displacement.
Matrix acting_points(const Scene& scene, const PointRows& rows, const MatrixModes& found) {
  std::vector<Vector> list;
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    list.push_back(rows.row(numbered_path("stop", i + 1), scene.stops[i]));
  for (std::size_t i = 0; i < scene.loads.size(); ++i)
    list.push_back(rows.row(numbered_path("load", i + 1), scene.loads[i]));
  for (std::size_t i = 0; i < scene.frictions.size(); ++i) {
    Vector place = rows.row(numbered_path("friction", i + 1), scene.frictions[i]);
    if (scene.frictions[i].series > 0.0) {
      const Vector rubs = rows.row(label_of_rubbing(scene, i));
      list.push_back(rubs);
      place -= rubs;
    }
    list.push_back(std::move(place));
  }
  std::size_t number = 0, support = 0;
  for (const HarmonicLoad* load : scene.harmonic_loads())
    if (++number; load->has_place())
      list.push_back(load->kind == ForcingKind::kSupport
                         ? Vector(found.supports[support++].forces.col(0))
                         : rows.row(numbered_path("forcing", number), load->at));
  Matrix points(rows.size(), static_cast<Eigen::Index>(list.size()));
  for (std::size_t k = 0; k < list.size(); ++k) points.col(static_cast<Eigen::Index>(k)) = list[k];
  return points;
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

StructuralMatrices matrices_of_files(const Scene& scene, const Mesh& mesh) {
  const MatrixStructure& matrices = *scene.matrices();
  MatrixFiles files{matrices.mass, matrices.stiffness, {}, {}};
  if (!matrices.damping.empty()) files.damping = matrices.damping;
  if (!matrices.dofs.empty()) files.dofs = matrices.dofs;
  // A file of nodes without elements may leave some out.
  if (!mesh.elements.empty())
    for (const auto& [node, place] : mesh.nodes) files.nodes.insert(node);
  return read_structure(files, constraints_of(scene, matrices, mesh));
}

StructuralMatrices matrices_of_scene(const Scene& scene, const Mesh& mesh) {
  check_discrete(scene);
  const DiscreteMatrices own = discrete_matrices(scene, scene);
  const bool lumped = scene.lumped() != nullptr;
  std::vector<DofLabel> labels = numbered_labels(own_coordinates(scene));
  for (std::size_t k = 0; k < scene.frictions.size(); ++k)
    if (scene.frictions[k].series > 0.0) labels.push_back(label_of_rubbing(scene, k));
  const auto labelled = [&](const char* name, const Matrix& matrix) {
    return LabelledMatrix{name, matrix.sparseView(), labels, false, {}};
  };
  const LabelledMatrix damping =
      labelled(lumped ? "lumped.spring.damping" : "matrices.damping", own.damping);
  std::vector<DofLabel> held;
  if (!lumped) held = constraints_of(scene, *scene.matrices(), mesh);
  return join_matrices(labelled(lumped ? "lumped.masses" : "matrices.mass", own.mass),
                       labelled(lumped ? "lumped.spring" : "matrices.stiffness", own.stiffness),
                       own.damping.isZero(0.0) ? nullptr : &damping, held);
}

void check_checksum(const Scene& scene, MatrixStructure& matrices) {
  const std::string checksum = files_checksum(matrices);
  if (!matrices.checksum.empty() && matrices.checksum != checksum)
    throw scene_error(scene, "matrices.checksum",
                      fmt::format("the files have the checksum {}, they have been changed since "
                                  "this scene was written",
                                  checksum));
  matrices.checksum = checksum;
}

// The first coordinate that a mode moves goes along +u: of masses in a chain each mode moves the
// first one, so that its sign is kept whatever the numbers.
void give_signs(Matrix& shapes) {
  constexpr double kMoves = 1e-8;  // of the largest displacement: more than rounding
  for (Eigen::Index j = 0; j < shapes.cols(); ++j) {
    const double least = kMoves * shapes.col(j).cwiseAbs().maxCoeff();
    Eigen::Index i = 0;
    while (i + 1 < shapes.rows() && std::abs(shapes(i, j)) <= least) ++i;
    if (shapes(i, j) < 0.0) shapes.col(j) *= -1.0;
  }
}

Matrix all_momenta(const StructuralMatrices& structure, const MatrixModes& found) {
  const Matrix free = transposed_product<double>(found.modes.shapes, structure.mass);
  Matrix momenta = Matrix::Zero(free.rows(), static_cast<Eigen::Index>(found.rows.size()));
  Eigen::Index column = 0;  // labels are numbers, in their order
  for (const auto& [label, row] : found.rows) {
    if (row >= 0) momenta.col(column) = free.col(row);
    ++column;
  }
  return momenta;
}

// Fills in what the scene sees of the modes.
void give_modes(Scene& scene, const PointRows& rows, const MatrixModes& found) {
  const Matrix& shapes = found.modes.shapes;
  DiscreteStructure& given = *scene.discrete();
  given.modal = {as_list(found.modes.omega), {}, {}, {}};
  const MatrixStructure* matrices = scene.matrices();
  if (found.load.size() > 0) given.modal.participation = as_list(shapes.transpose() * found.load);
  if (const auto along = found.inertia.find(matrices ? matrices->direction : 0);
      along != found.inertia.end())
    given.modal.inertia = as_list(along->second);
  Eigen::Index column = 0;
  const auto next_shape = [&] { return as_list(shapes.transpose() * found.points.col(column++)); };
  for (SceneStop& stop : scene.stops) stop.shape = next_shape();
  for (PointLoad& load : scene.loads) load.shape = next_shape();
  for (DryFriction& friction : scene.frictions) {
    friction.shape = next_shape();
    if (friction.series > 0.0) friction.spring_shape = next_shape();
  }
  if (scene.forcing && scene.forcing->has_place()) scene.forcing->at.shape = next_shape();
  for (HarmonicLoad& load : scene.further)
    if (load.has_place()) load.at.shape = next_shape();
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    Probe& probe = scene.probes[i];
    if (is_of_hub(probe.quantity)) continue;
    probe.shape = as_list(shapes.transpose() * rows.row(numbered_path("probe", i + 1), probe));
  }
  const auto count = static_cast<std::size_t>(shapes.cols());
  if (!scene.initial) return;
  if (scene.initial->q.size() < count) scene.initial->q.resize(count, 0.0);
  if (scene.initial->qdot.size() < count) scene.initial->qdot.resize(count, 0.0);
}

}  // namespace

StructuralMatrices structural_matrices(const Scene& scene, const Mesh& mesh) {
  return has_own_matrices(scene) ? matrices_of_scene(scene, mesh) : matrices_of_files(scene, mesh);
}

void solve_matrices(Scene& scene) {
  const bool own = has_own_matrices(scene);
  auto* matrices = std::get_if<MatrixStructure>(&scene.structure);
  if (!own) check_discrete(scene);
  if (!own) check_checksum(scene, *matrices);
  Mesh mesh;
  if (matrices && !matrices->coordinates.empty()) mesh = read_mesh(matrices->coordinates);
  const StructuralMatrices structure = structural_matrices(scene, mesh);
  const auto found = std::make_shared<MatrixModes>();
  const PointRows rows(scene, structure, mesh);
  for (const DofLabel& label : structure.labels)
    found->rows.emplace(label, static_cast<Eigen::Index>(found->rows.size()));
  for (const DofLabel& label : structure.held) found->rows.emplace(label, -1);
  add_supports(scene, structure, mesh, rows, *found);
  found->points = acting_points(scene, rows, *found);
  if (matrices) found->load = load_of(scene, *matrices, structure, mesh);
  const Matrix stops = found->points.leftCols(static_cast<Eigen::Index>(scene.stops.size()));
  const int most = static_cast<int>(structure.rows_with_mass().size());
  const int asked = scene.discrete()->modes, count = own && asked == 0 ? most : asked;
  if (count > most)
    throw scene_error(
        scene, fmt::format("{}.modes", scene.structure_name()),
        fmt::format("{} is not allowed, the matrices have {}", count, mode_limit_text(structure)));
  const int direction = matrices ? matrices->direction : 0;
  found->modes = lowest_modes(structure, count, static_loads(stops, structure, direction));
  if (own) give_signs(found->modes.shapes);
  if (own) found->momenta = all_momenta(structure, *found);
  found->total_masses = structure.total_masses;
  for (const auto& [along, load] : structure.inertia_loads)
    found->inertia[along] = found->modes.shapes.transpose() * load;
  if (structure.damping)
    found->damping =
        modal_damping(structure, found->modes, own ? kProportionalExactly : kProportional);
  if (!mesh.nodes.empty()) {
    found->coordinates = mesh.nodes;
    found->elements = mesh.elements;
    found->couplings = structure.couplings;
  }
  if (!own) found->weak_holds = weak_holds(structure);
  add_static_displacements(stops, *found);
  give_modes(scene, rows, *found);
  scene.discrete()->solved = found;
}

}  // namespace graze
