#include "graze/assembly/assembly.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "graze/assembly/detail/driven_motion.hpp"
#include "graze/assembly/detail/hub_system.hpp"
#include "graze/assembly/detail/residual_springs.hpp"
#include "graze/assembly/detail/spring_law.hpp"
#include "graze/contact/detail/impulse.hpp"
#include "graze/scene/check.hpp"
#include "graze/scene/detail/table_paths.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

double sign_of(Side side) { return side == Side::kAbove ? 1.0 : -1.0; }

Stop assemble_stop(const Scene& scene, const SceneStop& stop, const Vector& shape,
                   const Matrix& phi, const ResidualSpring& residual) {
  const double sign = sign_of(stop.side);
  const Vector row = sign * shape;
  if (stop.spring)
    return {row, stop.gap - sign * residual.shift,
            spring_law(as_given(*stop.spring, residual.stiffness))};
  const Vector direction =
      stop.impulse == Impulse::kMomentum
          ? momentum_direction(row)
          : collocation_direction(phi, collocation_index(*scene.beam(), stop.position), sign);
  return {row, stop.gap, ImpactLaw{direction, Restitution(stop.restitution)}};
}

Stop stop_tangent(const SceneStop& stop, const SceneStop& rate, const Stop& assembled,
                  const Vector& shape_rate, const ResidualSpring& residual_rate, const Matrix& phi,
                  const Matrix& phi_rate) {
  const double sign = sign_of(stop.side);
  const Vector row_rate = sign * shape_rate;
  if (stop.spring)
    return {row_rate, rate.gap - sign * residual_rate.shift,
            spring_law_rate(as_given(*stop.spring, assembled.force().stiffness),
                            rate_as_given(*rate.spring, residual_rate.stiffness))};
  const Vector direction_rate =
      stop.impulse == Impulse::kMomentum
          ? momentum_direction_rate(assembled.row, row_rate)
          : collocation_direction_rate(phi, phi_rate, assembled.direction());
  return {row_rate, rate.gap, ImpactLaw{direction_rate, Restitution(rate.restitution)}};
}

// `spring`: along the spring in series; empty without.
Friction assemble_friction(const DryFriction& friction, const Vector& shape, const Vector& spring) {
  Friction made{shape,          momentum_direction(shape), friction.sliding(), friction.sticking(),
                friction.speed, friction.stop - 1};
  if (spring.size() > 0) made.series = {friction.series, spring, -made.direction};
  return made;
}

// What friction acts on must be independent: how friction that is statically indeterminate shares
// a load is not known.
void check_independent(const Scene& scene, const System& system) {
  std::vector<Vector> basis;
  for (std::size_t k = 0; k < system.frictions.size(); ++k) {
    Vector row = system.frictions[k].row;
    const double size = row.norm();
    for (int pass = 0; pass < 2; ++pass)
      for (const Vector& other : basis) row -= other.dot(row) * other;
    if (!(row.norm() > std::sqrt(std::numeric_limits<double>::epsilon()) * size))
      throw scene_error(scene, numbered_path("friction", k + 1),
                        size > 0.0 ? "the friction before holds what it acts on already, it must "
                                     "act elsewhere (of two at one place give the sum)"
                                   : "no mode moves it, it must act elsewhere");
    basis.push_back(row.normalized());
  }
}

// The constant modal force, by gravity and by loads; nullopt where there is neither.
std::optional<Vector> constant_load(const Scene& scene, const ModalModel& model) {
  std::optional<Vector> load;
  if (scene.gravity) load = scene.gravity->acceleration * model.inertia;
  for (std::size_t k = 0; k < scene.loads.size(); ++k) {
    const Vector push = scene.loads[k].force * model.loads[k];
    load = load ? Vector(*load + push) : push;
  }
  return load;
}

}  // namespace

System assemble(const Scene& scene) { return assemble(scene, modal_model(scene)); }

System assemble(const Scene& scene, const ModalModel& model) {
  if (scene.hub) return assemble_on_hub(scene, model);
  System system{model.omega, NaturalModes{model.delta}, {}, scene.units};
  if (scene.forcing) {
    DrivenMotion driven = driven_motion(scene, model);
    system.modal().forcing = std::move(driven.forcing);
    system.modal().carried = std::move(driven.carried);
  }
  system.modal().load = constant_load(scene, model);
  if (model.coupling.size() > 0) system.modal().coupling = model.coupling;
  if (model.coordinates.size() > 0) system.modal().coordinates = model.coordinates;
  system.stops.reserve(scene.stops.size());
  const std::vector<ResidualSpring> residual = residual_springs(scene, model);
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    system.stops.push_back(assemble_stop(scene, scene.stops[i], model.shapes[i], model.collocation,
                                         residual.empty() ? ResidualSpring{} : residual[i]));
  for (std::size_t k = 0; k < scene.frictions.size(); ++k)
    system.frictions.push_back(
        assemble_friction(scene.frictions[k], model.frictions[k], model.springs[k]));
  check_independent(scene, system);
  return system;
}

System system_tangent(const Scene& scene, const std::string& parameter) {
  const Scene direction = parameter_direction(scene, parameter);
  const ModalModel model = modal_model(scene);
  return system_tangent(scene, direction, model, modal_tangent(scene, model, direction),
                        assemble(scene, model));
}

System system_tangent(const Scene& scene, const Scene& direction, const ModalModel& model,
                      const ModalModel& rate, const System& system) {
  System tangent{rate.omega, NaturalModes{rate.delta}, {}};
  if (scene.forcing) {
    DrivenMotion driven = driven_motion_rate(scene, direction, model, rate);
    tangent.modal().forcing = std::move(driven.forcing);
    tangent.modal().carried = std::move(driven.carried);
  }
  // A product's derivative: once the forces move, once the shapes.
  tangent.modal().load = constant_load(direction, model);
  if (const std::optional<Vector> moved = constant_load(scene, rate))
    *tangent.modal().load += *moved;
  if (rate.coupling.size() > 0) tangent.modal().coupling = rate.coupling;
  if (rate.coordinates.size() > 0) tangent.modal().coordinates = rate.coordinates;
  tangent.stops.reserve(scene.stops.size());
  const std::vector<ResidualSpring> residual = residual_spring_rates(scene, direction, model, rate);
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    tangent.stops.push_back(stop_tangent(
        scene.stops[i], direction.stops[i], system.stops[i], rate.shapes[i],
        residual.empty() ? ResidualSpring{} : residual[i], model.collocation, rate.collocation));
  for (std::size_t k = 0; k < scene.frictions.size(); ++k) {
    const DryFriction &friction = scene.frictions[k], &moved = direction.frictions[k];
    tangent.frictions.push_back(
        {rate.frictions[k], momentum_direction_rate(system.frictions[k].row, rate.frictions[k]),
         friction.sliding_rate(moved), friction.sticking_rate(moved), moved.speed,
         friction.stop - 1});
    if (rate.springs[k].size() > 0)
      tangent.frictions.back().series = {moved.series, rate.springs[k],
                                         -tangent.frictions.back().direction};
  }
  return tangent;
}

}  // namespace graze
