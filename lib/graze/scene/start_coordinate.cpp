#include "graze/scene/start_coordinate.hpp"

#include <fmt/format.h>

#include "graze/base/errors.hpp"
#include "graze/scene/detail/numbers.hpp"
#include "graze/scene/discrete_matrices.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {

bool names_start_coordinate(const std::string& name) { return name.starts_with("initial."); }

namespace {

// The displacements, or velocities, of all coordinates that modal ones stand for.
std::vector<double> coordinates_of(const Scene& scene, const std::vector<double>& modal) {
  const Vector all =
      coordinate_rows(scene) *
      Eigen::Map<const Vector>(modal.data(), static_cast<Eigen::Index>(modal.size()));
  return {all.begin(), all.end()};
}

}  // namespace

double& start_coordinate(Scene& scene, const std::string& name) {
  const std::optional<Initial> before = scene.initial;
  const auto modes = static_cast<std::size_t>(scene.modes());
  if (!scene.initial) scene.initial.emplace();
  scene.initial->q.resize(modes, 0.0);
  scene.initial->qdot.resize(modes, 0.0);
  const bool own = has_own_matrices(scene);
  if (own && name.starts_with("initial.displacement.") && scene.initial->displacement.empty())
    scene.initial->displacement = coordinates_of(scene, scene.initial->q);
  if (own && name.starts_with("initial.velocity.") && scene.initial->velocity.empty())
    scene.initial->velocity = coordinates_of(scene, scene.initial->qdot);
  if (names_start_coordinate(name))
    if (double* number = found_number(scene, name, true)) return *number;
  scene.initial = before;
  const std::string coordinates =
      own ? fmt::format(", initial.displacement.1..{0} and initial.velocity.1..{0}",
                        scene.discrete()->solved->momenta.cols())
          : "";
  throw InputError(
      fmt::format("{}: the scene has no such number of its start; allowed are initial.q.1..{} and "
                  "initial.qdot.1..{}{}{}",
                  name, scene.modes(), scene.modes(),
                  scene.hub ? ", initial.angle and initial.rate" : "", coordinates));
}

Scene with_number(const Scene& scene, const std::string& name, double value) {
  if (!names_start_coordinate(name)) return with_parameter(scene, name, value);
  Scene changed = scene;
  start_coordinate(changed, name) = value;
  return changed;
}

std::string number_unit(const Scene& scene, const std::string& name) {
  if (!names_start_coordinate(name)) return parameter_unit(scene, name);
  Scene copy = scene;
  start_coordinate(copy, name);  // throws for a name that it does not have
  const KeyRow* row = key_row(name);
  return row ? unit_in(scene.units, row->unit) : "";
}

}  // namespace graze
