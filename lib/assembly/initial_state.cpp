#include "graze/assembly/initial_state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/base/linear_equations.hpp"
#include "graze/contact/complementarity.hpp"
#include "graze/system/gap_value.hpp"

namespace graze {
namespace {

bool is_preloaded(const System& system) {
  return std::any_of(system.stops.begin(), system.stops.end(),
                     [](const RigidStop& stop) { return stop.gap < 0.0 && !stop.spring; });
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

State initial_state(const Scene& scene, const System& system) {
  const Eigen::Index n = system.modes();
  State state{Vector::Zero(n), Vector::Zero(n)};
  if (scene.initial) {
    state.q = Eigen::Map<const Vector>(scene.initial->q.data(), n);
    state.qdot = Eigen::Map<const Vector>(scene.initial->qdot.data(), n);
  } else if (is_preloaded(system)) {
    System rigid = system;
    std::erase_if(rigid.stops, [](const RigidStop& stop) { return stop.spring.has_value(); });
    const std::optional<Vector> q = static_equilibrium(rigid);
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
    if (!stop.spring && gap.value < -gap.rounding) {
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

}  // namespace graze
