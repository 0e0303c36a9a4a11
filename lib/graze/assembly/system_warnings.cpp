#include "graze/assembly/system_warnings.hpp"

#include <fmt/format.h>

#include <limits>

#include "graze/assembly/detail/residual_springs.hpp"
#include "graze/assembly/mode_table.hpp"
#include "graze/base/linalg/decompositions.hpp"
#include "graze/contact/detail/impulse.hpp"
#include "graze/scene/matrix_structure.hpp"

namespace graze {
namespace {

// Above this, solves with the collocation matrix keep fewer than half of the 16 digits.
constexpr double kIllConditioned = 1e8;

void add_flexibility_warnings(const Scene& scene, const ModalModel& model,
                              std::vector<std::string>& warnings) {
  const MatrixModes& matrices = *scene.discrete()->solved;
  const bool are_all = scene.modes() == matrices.free_count() - matrices.modes.massless;
  if (are_all && matrices.modes.massless == 0) return;  // nothing is left out
  const std::vector<StopFlexibility> list = stop_flexibilities(scene, model);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (scene.stops[i].spring && scene.stops[i].spring->is_residual) continue;
    if (list[i].kept < (1.0 - kSeenFlexibility) * *list[i].whole)
      warnings.push_back(fmt::format(
          "the {} modes have {:.4g} of the static flexibility {:.4g}{} at stop {}, {:.1f} %: {}",
          scene.modes(), list[i].kept, *list[i].whole, unit_behind(scene.units, "m/N"), i + 1,
          100.0 * list[i].kept / *list[i].whole,
          are_all ? "the rest is that of degrees of freedom without mass, which no mode has; the "
                    "contact depends on it unless the stop is where there is mass"
                  : "what the contact depends on is not converged, more modes bring it nearer"));
  }
}

// Nodes of the mesh whose rows a program left out, and with them their mass, where an acceleration
// of the whole structure would load them.
void add_missing_nodes(const Scene& scene, std::vector<std::string>& warnings) {
  const bool is_based = scene.has_load(ForcingKind::kBase);
  if (!is_based && !scene.gravity) return;
  const MatrixModes& matrices = *scene.discrete()->solved;
  if (!scene.matrices()->dofs.empty() && matrices.elements.empty())
    warnings.push_back(
        "the mesh is not known: where elements are C3D8I, S4 or B31, CalculiX writes their "
        "incompatible modes as nodes, which a moving base or gravity then loads; name its input "
        "file with *NODE and *ELEMENT as coordinates");
  std::vector<long> missing;
  for (const auto& [node, place] : matrices.coordinates) {
    const auto row = matrices.rows.lower_bound({node, 1});
    if (row == matrices.rows.end() || row->first.node != node) missing.push_back(node);
  }
  if (missing.empty() || matrices.rows.begin()->first.direction == 0) return;
  warnings.push_back(fmt::format(
      "{} of the {} nodes with coordinates have no row in the matrices, node {} the first: by "
      "their "
      "mass {} loads the structure as well, which is missing; CalculiX leaves out what *BOUNDARY "
      "holds: write the matrices without it and hold these nodes by constraints_file",
      missing.size(), matrices.coordinates.size(), missing.front(),
      is_based ? "the moving base" : "gravity"));
}

void add_matrix_warnings(const Scene& scene, const ModalModel& model,
                         std::vector<std::string>& warnings) {
  for (const auto& [direction, part] : scene.discrete()->solved->weak_holds)
    warnings.push_back(fmt::format(
        "the stiffness holds the structure in direction {} by {:.1g} of its entries only: of a "
        "free structure this is what few printed digits leave, and its rigid-body modes are not "
        "found as such",
        direction, part));
  if (std::string sentence = exchange_sentence(scene); !sentence.empty())
    warnings.push_back(std::move(sentence));
  if (scene.matrices()) add_missing_nodes(scene, warnings);
  add_flexibility_warnings(scene, model, warnings);
}

}  // namespace

double collocation_condition(const ModalModel& model) {
  return model.collocation.size() > 0 ? condition_number(model.collocation) : 0.0;
}

std::vector<std::string> system_warnings(const Scene& scene, const System& system) {
  std::vector<std::string> warnings;
  const ModalModel model = modal_model(scene);
  if (scene.discrete()) add_matrix_warnings(scene, model, warnings);
  const double condition = collocation_condition(model);
  if (condition > kIllConditioned)
    warnings.push_back(fmt::format(
        "the collocation points are ill-conditioned: condition number {:.3g}, above {:.0e}; "
        "points spread evenly over the beam (i L/N) have about 2",
        condition, kIllConditioned));
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    if (scene.stops[i].impulse != Impulse::kCollocation) continue;
    const Stop& stop = system.stops[i];
    // The gain grows with r; one that depends on the speed is not known beforehand.
    const double r = stop.restitution().is_constant() ? stop.restitution().at_rest() : 1.0;
    const double gain = worst_energy_gain(stop.row, stop.direction(), r);
    // For N = 1 the collocation law is the momentum law.
    if (gain > 1.0 + 16.0 * std::numeric_limits<double>::epsilon())
      warnings.push_back(
          fmt::format("the collocation impulse of stop {} is not normal in the mass metric: one "
                      "impact can multiply the kinetic energy by up to {:.6g}",
                      i + 1, gain));
  }
  return warnings;
}

}  // namespace graze
