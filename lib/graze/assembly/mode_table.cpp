#include "graze/assembly/mode_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "graze/assembly/beam_shape.hpp"
#include "graze/base/angle.hpp"
#include "graze/base/errors.hpp"
#include "graze/fem/detail/text_lines.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/structure/static_response.hpp"

namespace graze {
namespace {

const MatrixModes* matrices_of(const Scene& scene) {
  return scene.discrete() ? scene.discrete()->solved.get() : nullptr;
}

std::vector<DirectionShare> directions_of(const Scene& scene, const ModalModel& model) {
  std::vector<DirectionShare> shares;
  if (const MatrixModes* matrices = matrices_of(scene)) {
    for (const auto& [direction, inertia] : matrices->inertia)
      shares.push_back({direction, inertia, matrices->total_masses.at(direction)});
    return shares;
  }
  if (model.inertia.size() == 0) return shares;
  shares.push_back({0, model.inertia, {}});
  // Those of a collocation are no projections of the mass.
  const Beam* beam = scene.beam();
  if (scene.span() && !(beam && beam->discretisation == Projection::kCollocation))
    shares.back().total_mass = total_mass(scene);
  return shares;
}

std::vector<std::string> notes_of(const MatrixModes& matrices, Units units) {
  const StructuralModes& modes = matrices.modes;
  const long held = std::count_if(matrices.rows.begin(), matrices.rows.end(),
                                  [](const auto& row) { return row.second < 0; });
  std::vector<std::string> notes = {
      fmt::format("{} degrees of freedom, {} held", matrices.free_count(), held)};
  if (modes.massless > 0)
    notes.front() += fmt::format("; {} without mass follow{} the others statically", modes.massless,
                                 modes.massless == 1 ? "s" : "");
  if (modes.massless_motions > 0)
    notes.push_back(fmt::format(
        "the mass matrix is singular, as reduced integration leaves it: {} of those without mass "
        "are "
        "combinations of degrees of freedom{}",
        modes.massless_motions,
        modes.idle == 0
            ? ""
            : fmt::format(", {} of which no stiffness holds either (hourglasses), which are "
                          "left out of shapes and displacements",
                          modes.idle)));
  if (modes.is_dense)
    notes.push_back("all modes were found");
  else if (modes.counted)
    notes.push_back(fmt::format(
        "{} modes below {:.6g}{} by Sylvester's law of inertia, equal to the number found",
        *modes.counted, modes.counted_below, unit_behind(units, "rad/s")));
  else
    notes.push_back(
        fmt::format("modes not counted ({}); a second iteration met none that is "
                    "missing",
                    modes.not_counted));
  if (matrices.damping && matrices.damping->is_proportional)
    notes.push_back(fmt::format("proportional damping, {:.6g} M + {:.6g} K", matrices.damping->mass,
                                matrices.damping->stiffness));
  return notes;
}

// Modes with periods beyond an hour belong to no structure that meets stops. All of them are that
// slow when masses of kilograms and stiffnesses of 1e3 N/m and more have changed places.
constexpr double kSlowMode = 1e-3;  // rad/s

}  // namespace

std::string exchange_sentence(const Scene& scene) {
  const MatrixModes* matrices = matrices_of(scene);
  if (!matrices || scene.units != Units::kSi) return "";
  const Vector& omega = matrices->modes.omega;
  const double highest = omega[omega.size() - 1];
  if (highest == 0.0 || highest >= kSlowMode) return "";
  return fmt::format(
      "all {} modes lie below {:.2g} rad/s, a period of {:.2g} h: matrices.mass and "
      "matrices.stiffness seem to be exchanged",
      omega.size(), highest, kTurn / highest / 3600.0);
}

std::vector<StopFlexibility> stop_flexibilities(const Scene& scene, const ModalModel& model) {
  const Matrix kept = static_response_of_modes(model).flexibility;
  const std::optional<StaticResponse> whole = static_response(scene);
  std::vector<StopFlexibility> list;
  for (Eigen::Index i = 0; i < kept.rows(); ++i) {
    list.push_back({kept(i, i), {}});
    if (whole) list.back().whole = whole->flexibility(i, i);
  }
  return list;
}

ModeTable mode_table(const Scene& scene) {
  // What a uniform acceleration does, whether the scene has one or not.
  Scene asked = scene;
  const bool has_inertia = !scene.modal() || !scene.modal()->inertia.empty();
  if (has_inertia)
    asked.gravity = Gravity{1.0};
  else
    asked.gravity.reset();
  const ModalModel model = modal_model(asked);
  ModeTable table;
  table.omega = model.omega;
  table.decay = model.delta;
  table.rigid = static_cast<int>((model.omega.array() == 0.0).count());
  table.directions = directions_of(scene, model);
  table.flexibilities = stop_flexibilities(scene, model);
  if (const MatrixModes* matrices = matrices_of(scene)) {
    table.residuals = matrices->modes.residuals;
    table.notes = notes_of(*matrices, scene.units);
    if (std::string sentence = exchange_sentence(scene); !sentence.empty())
      table.notes.push_back(std::move(sentence));
  }
  return table;
}

std::optional<NamedShapes> named_shapes(const Scene& scene) {
  NamedShapes shapes;
  if (const MatrixModes* matrices = matrices_of(scene)) {
    shapes.values = matrices->modes.shapes;
    shapes.names.resize(static_cast<std::size_t>(shapes.values.rows()));
    for (const auto& [label, row] : matrices->rows)
      if (row >= 0) shapes.names[static_cast<std::size_t>(row)] = label_text(label);
    return shapes;
  }
  const std::optional<BeamPlaces> places = beam_places(scene, 1001);
  if (!places) return {};
  shapes.values = places->rows;
  for (int i = 0; i <= 1000; ++i) shapes.names.push_back(std::to_string(i));
  return shapes;
}

NamedShapes read_shapes(const std::string& file) {
  TextLines lines(file, read_bytes(file));
  NamedShapes shapes;
  std::vector<std::vector<double>> rows;
  while (lines.next()) {
    const std::string_view text = trimmed(lines.line());
    if (text.empty() || text.front() == '#') continue;
    const auto& parts = lines.parts();
    if (parts.size() < 2 || (!rows.empty() && parts.size() != rows.front().size() + 1))
      lines.fail("the line must hold a degree of freedom and its displacement in each shape");
    if (!label_from_text(std::string(parts[0])))
      lines.fail(
          fmt::format("\"{}\" is no degree of freedom, node.direction or a number", parts[0]));
    shapes.names.emplace_back(parts[0]);
    rows.emplace_back();
    for (std::size_t i = 1; i < parts.size(); ++i) rows.back().push_back(lines.real(parts[i]));
  }
  if (rows.empty()) lines.fail_at(0, "the file has no shapes");
  shapes.values.resize(static_cast<Eigen::Index>(rows.size()),
                       static_cast<Eigen::Index>(rows.front().size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j)
      shapes.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j];
  return shapes;
}

ModalAssurance modal_assurance(const NamedShapes& first, const NamedShapes& second) {
  std::map<std::string, Eigen::Index> places;
  for (std::size_t i = 0; i < second.names.size(); ++i)
    places.emplace(second.names[i], static_cast<Eigen::Index>(i));
  std::vector<std::pair<Eigen::Index, Eigen::Index>> common;
  for (std::size_t i = 0; i < first.names.size(); ++i)
    if (const auto found = places.find(first.names[i]); found != places.end())
      common.emplace_back(static_cast<Eigen::Index>(i), found->second);
  if (common.empty())
    throw InputError("--mac: both sets of shapes have no degree of freedom in common");
  Matrix a(common.size(), first.values.cols()), b(common.size(), second.values.cols());
  for (std::size_t k = 0; k < common.size(); ++k) {
    a.row(static_cast<Eigen::Index>(k)) = first.values.row(common[k].first);
    b.row(static_cast<Eigen::Index>(k)) = second.values.row(common[k].second);
  }
  ModalAssurance result{Matrix::Zero(a.cols(), b.cols()), static_cast<int>(common.size())};
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
      const double size = a.col(i).squaredNorm() * b.col(j).squaredNorm();
      if (size > 0.0) result.values(i, j) = std::pow(a.col(i).dot(b.col(j)), 2.0) / size;
    }
  return result;
}

}  // namespace graze
