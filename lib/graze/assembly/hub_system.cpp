#include "graze/assembly/detail/hub_system.hpp"

#include "graze/assembly/detail/spring_law.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/contact/detail/impulse.hpp"
#include "graze/structure/detail/hub_beam.hpp"

namespace graze {
namespace {

TorqueHistory torque_history(const Torque& torque) {
  if (const auto* pulse = std::get_if<TorquePulse>(&torque))
    return {{0.0, pulse->duration}, {pulse->amplitude, pulse->amplitude}};
  const TorqueTable& table = std::get<TorqueTable>(torque);
  return {table.times, table.values};
}

// Its place moves by (position + radius) times the angle, and with the beam.
Stop stop_on_hub(const SceneStop& stop, const Vector& shape, double radius,
                 const Rotation& rotation) {
  const double sign = stop.side == Side::kAbove ? 1.0 : -1.0;
  const Vector row =
      sign * ((stop.position + radius) * rotation.angle + rotation.beam.transpose() * shape);
  if (stop.spring) return {row, stop.gap, spring_law(*stop.spring)};
  return {row, stop.gap, ImpactLaw{momentum_direction(row), Restitution(stop.restitution)}};
}

}  // namespace

System assemble_on_hub(const Scene& scene, const ModalModel& model) {
  const Hub& hub = *scene.hub;
  const HubBeam beam = hub_beam(scene);
  const HubModes modes = hub_modes(model.omega, beam.coupling, beam.inertia);
  Rotation rotation{modes.angle, modes.beam};
  if (!model.delta.isZero(0.0))
    rotation.damping = modes.beam.transpose() * (2.0 * model.delta).asDiagonal() * modes.beam;
  if (beam.stiffening.size() > 0) {
    const Eigen::Index n = model.omega.size();
    rotation.stretch =
        modes.beam.transpose() * (Matrix::Identity(n, n) - beam.stiffening) * modes.beam;
  }
  rotation.consistent = hub.equations == HubEquations::kConsistent;
  if (scene.gravity) {
    const double g = scene.gravity->acceleration;
    rotation.weight = WeightOnHub{g * beam.moment, g * (modes.beam.transpose() * beam.pull)};
  }
  if (hub.torque) rotation.torque = torque_history(*hub.torque);
  rotation.friction = hub.friction;
  System system{modes.omega, rotation, {}, scene.units};
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    system.stops.push_back(stop_on_hub(scene.stops[i], model.shapes[i], hub.radius, rotation));
  return system;
}

Vector turning_coordinates(const Rotation& rotation, double angle, const Vector& q) {
  const Eigen::Index n = q.size();
  Matrix whole(n + 1, n + 1);
  whole << rotation.angle.transpose(), rotation.beam;
  Vector x(n + 1);
  x << angle, q;
  return LuFactors(whole).solve(x);
}

}  // namespace graze
