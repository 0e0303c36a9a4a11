#include "graze/system/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/base/decompositions.hpp"
#include "graze/base/linear_equations.hpp"
#include "graze/contact/complementarity.hpp"
#include "graze/contact/impulse.hpp"
#include "graze/scene/check.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/system/assembly.hpp"
#include "graze/system/gap_value.hpp"

namespace graze {
namespace {

// Above this, solves with the collocation matrix keep fewer than half of the 16 digits.
constexpr double kIllConditioned = 1e8;

double sign_of(Side side) { return side == Side::kAbove ? 1.0 : -1.0; }

// Load per unit of forcing amplitude: the moving clamp accelerates by frequency^2 * amplitude.
double load_factor(const Forcing& forcing) {
  return forcing.kind == ForcingKind::kBase ? forcing.frequency * forcing.frequency : 1.0;
}

HarmonicForcing assemble_forcing(const Forcing& forcing, const Vector& participation) {
  return {forcing.frequency, forcing.phase,
          forcing.amplitude * load_factor(forcing) * participation};
}

HarmonicForcing forcing_tangent(const Forcing& forcing, const Forcing& rate,
                                const ModalModel& model, const ModalModel& model_rate) {
  const double factor_rate = forcing.kind == ForcingKind::kBase
                                 ? 2.0 * forcing.frequency * rate.frequency * forcing.amplitude
                                 : 0.0;
  return {rate.frequency, rate.phase,
          (rate.amplitude * load_factor(forcing) + factor_rate) * model.participation +
              forcing.amplitude * load_factor(forcing) * model_rate.participation};
}

RigidStop assemble_stop(const Scene& scene, const Stop& stop, const Vector& shape,
                        const Matrix& phi) {
  const double sign = sign_of(stop.side);
  const Vector row = sign * shape;
  const Vector direction =
      stop.impulse == Impulse::kMomentum
          ? momentum_direction(row)
          : collocation_direction(phi, collocation_index(*scene.beam(), stop.position), sign);
  return {row, stop.gap, direction, Restitution(stop.restitution)};
}

RigidStop stop_tangent(const Stop& stop, const Stop& rate, const RigidStop& assembled,
                       const Vector& shape_rate, const Matrix& phi, const Matrix& phi_rate) {
  const Vector row_rate = sign_of(stop.side) * shape_rate;
  const Vector direction_rate =
      stop.impulse == Impulse::kMomentum
          ? momentum_direction_rate(assembled.row, row_rate)
          : collocation_direction_rate(phi, phi_rate, assembled.direction);
  return {row_rate, rate.gap, direction_rate, Restitution(rate.restitution)};
}

bool is_preloaded(const System& system) {
  return std::any_of(system.stops.begin(), system.stops.end(),
                     [](const RigidStop& stop) { return stop.gap < 0.0; });
}

// Rest under the constant load with every stop's force >= 0 and gap >= 0:
//   q = W^-1 (load - D lambda),   lambda >= 0,   b.q <= a,   lambda (a - b.q) = 0.
std::optional<Vector> static_equilibrium(const System& system) {
  const Eigen::Index n = system.modes(), k = static_cast<Eigen::Index>(system.stops.size());
  if (system.omega.minCoeff() <= 0.0) return {};
  const Vector compliance = system.omega.cwiseAbs2().cwiseInverse();
  const Vector free =
      system.load ? Vector(compliance.cwiseProduct(*system.load)) : Vector(Vector::Zero(n));
  Matrix rows(n, k), directions(n, k);
  Vector beyond(k), rounding(k);
  for (Eigen::Index i = 0; i < k; ++i) {
    const RigidStop& stop = system.stops[static_cast<std::size_t>(i)];
    rows.col(i) = stop.row;
    directions.col(i) = stop.direction;
    const GapValue<double> gap = gap_value<double>(stop.row, free, stop.gap);
    beyond[i] = -gap.value;
    rounding[i] = gap.rounding;
  }
  const Matrix delassus = rows.transpose() * compliance.asDiagonal() * directions;
  const std::optional<Vector> force = solve_contacts<double>(delassus, beyond, rounding);
  if (!force || !force->allFinite()) return {};
  Vector q = free - compliance.cwiseProduct(directions * *force);
  // What is pressed is on its stop to the rounding of the gap itself, not only to that of the
  // solution.
  std::vector<Eigen::Index> pressed;
  for (Eigen::Index i = 0; i < k; ++i)
    if ((*force)[i] > 0.0) pressed.push_back(i);
  if (pressed.empty()) return q;
  const Matrix acting = delassus(pressed, pressed);
  for (int pass = 0; pass < 2; ++pass) {
    Vector left(static_cast<Eigen::Index>(pressed.size()));
    for (std::size_t a = 0; a < pressed.size(); ++a) {
      const RigidStop& stop = system.stops[static_cast<std::size_t>(pressed[a])];
      left[static_cast<Eigen::Index>(a)] = -gap_value<double>(stop.row, q, stop.gap).value;
    }
    q -= compliance.cwiseProduct(directions(Eigen::all, pressed) *
                                 solve_with_full_pivoting(acting, left));
  }
  return q;
}

}  // namespace

double System::period() const { return kTurn / forcing->frequency; }

System assemble(const Scene& scene) { return assemble(scene, modal_model(scene)); }

System assemble(const Scene& scene, const ModalModel& model) {
  System system{model.omega, model.delta, {}, {}, {}};
  if (scene.forcing) system.forcing = assemble_forcing(*scene.forcing, model.participation);
  if (scene.gravity) system.load = scene.gravity->acceleration * model.inertia;
  system.stops.reserve(scene.stops.size());
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    system.stops.push_back(
        assemble_stop(scene, scene.stops[i], model.shapes[i], model.collocation));
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
  System tangent{rate.omega, rate.delta, {}, {}, {}};
  if (scene.forcing)
    tangent.forcing = forcing_tangent(*scene.forcing, *direction.forcing, model, rate);
  if (scene.gravity)
    tangent.load = direction.gravity->acceleration * model.inertia +
                   scene.gravity->acceleration * rate.inertia;
  tangent.stops.reserve(scene.stops.size());
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    tangent.stops.push_back(stop_tangent(scene.stops[i], direction.stops[i], system.stops[i],
                                         rate.shapes[i], model.collocation, rate.collocation));
  return tangent;
}

State initial_state(const Scene& scene, const System& system) {
  const Eigen::Index n = system.modes();
  State state{Vector::Zero(n), Vector::Zero(n)};
  if (scene.initial) {
    state.q = Eigen::Map<const Vector>(scene.initial->q.data(), n);
    state.qdot = Eigen::Map<const Vector>(scene.initial->qdot.data(), n);
  } else if (is_preloaded(system)) {
    const std::optional<Vector> q = static_equilibrium(system);
    if (!q)
      throw scene_error(scene, "stop.gap",
                        "a preloaded stop (negative gap) without [initial] starts in static "
                        "equilibrium, which this structure does not have (a mode of frequency 0, "
                        "or stops that contradict each other); give [initial] a state clear of "
                        "the stops");
    state.q = *q;
  }
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const RigidStop& stop = system.stops[i];
    const GapValue<double> gap = gap_value<double>(stop.row, state.q, stop.gap);
    if (gap.value < -gap.rounding) {
      const std::string key =
          system.stops.size() == 1 ? "stop.gap" : fmt::format("stop.{}.gap", i + 1);
      throw scene_error(scene, scene.initial ? "initial.q" : key,
                        fmt::format("the motion starts {:.6g} m beyond stop {}; the displacement "
                                    "at the stop must not exceed its gap",
                                    -gap.value, i + 1));
    }
  }
  return state;
}

std::optional<State> clear_start(const Scene& scene, const System& system) {
  try {
    return initial_state(scene, system);
  } catch (const InputError&) {
    return {};
  }
}

double collocation_condition(const Scene& scene) {
  return uses_collocation(scene) ? condition_number(modal_model(scene).collocation) : 0.0;
}

std::vector<std::string> system_warnings(const Scene& scene, const System& system) {
  std::vector<std::string> warnings;
  const double condition = collocation_condition(scene);
  if (condition > kIllConditioned)
    warnings.push_back(fmt::format(
        "the collocation points are ill-conditioned: condition number {:.3g}, above {:.0e}; "
        "points spread evenly over the beam (i L/N) have about 2",
        condition, kIllConditioned));
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    if (scene.stops[i].impulse != Impulse::kCollocation) continue;
    const RigidStop& stop = system.stops[i];
    // The gain grows with r; one that depends on the speed is not known beforehand.
    const double r = stop.restitution.is_constant() ? stop.restitution.at_rest() : 1.0;
    const double gain = worst_energy_gain(stop.row, stop.direction, r);
    // For N = 1 the collocation law is the momentum law.
    if (gain > 1.0 + 16.0 * std::numeric_limits<double>::epsilon())
      warnings.push_back(fmt::format(
          "the collocation impulse of stop {} is oblique: one impact can multiply the kinetic "
          "energy by up to {:.6g}",
          i + 1, gain));
  }
  return warnings;
}

}  // namespace graze
