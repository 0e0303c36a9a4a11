#include "graze/assembly/initial_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "graze/assembly/detail/hub_system.hpp"
#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/contact/detail/complementarity.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/structure/modal_model.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

bool is_preloaded(const System& system) {
  return std::any_of(system.stops.begin(), system.stops.end(),
                     [](const Stop& stop) { return stop.gap < 0.0; });
}

// Artificial stiffness of a mode of frequency 0, (rad/s)^2, which is held by its preloaded stops
// only: their stiffness replaces its own; 0 for all other modes.
Vector lent_stiffness(const System& system) {
  Vector lent = Vector::Zero(system.modes());
  for (const Stop& stop : system.stops) {
    if (!stop.is_compliant() || !(stop.gap < 0.0)) continue;
    const double stiffness = stop.force().by_depth(-stop.gap, 0.0);
    for (Eigen::Index j = 0; j < lent.size(); ++j)
      if (!(system.omega[j] > 0.0)) lent[j] += stiffness * stop.row[j] * stop.row[j];
  }
  return lent;
}

// The structure pressed by forces at its stops: a unit force at one stop moves the structure off
// the others by `delassus`; without forces it lies `beyond` them.
struct Pressed {
  Vector compliance, free;  // of the modes; rest without stops
  Matrix rows, directions;
  Matrix delassus;
  Vector beyond, rounding;
};

// The lent stiffness pulls the structure to `rest`.
Pressed pressed_against(const System& system, const Vector& lent, const Vector& rest) {
  const Eigen::Index n = system.modes(), k = static_cast<Eigen::Index>(system.stops.size());
  Pressed at{(system.omega.cwiseAbs2() + lent).cwiseInverse(),
             Vector::Zero(n),
             Matrix(n, k),
             Matrix(n, k),
             {},
             Vector(k),
             Vector(k)};
  if (system.load()) at.free = at.compliance.cwiseProduct(*system.load());
  at.free += at.compliance.cwiseProduct(lent).cwiseProduct(rest);
  for (Eigen::Index i = 0; i < k; ++i) {
    const Stop& stop = system.stops[static_cast<std::size_t>(i)];
    at.rows.col(i) = stop.row;
    at.directions.col(i) = stop.direction();
    const GapValue<double> gap = gap_value<double>(stop.row, at.free, stop.gap);
    at.beyond[i] = -gap.value;
    at.rounding[i] = gap.rounding;
  }
  at.delassus = at.rows.transpose() * at.compliance.asDiagonal() * at.directions;
  return at;
}

// The forces of springs F(x) and rigid stops (x <= 0) together, x = beyond - D F, by Newton's
// method: each spring is replaced by its tangent at the depth reached so far, which is a contact
// with the compliance 1/F'(x). A spring that is not touched has no tangent and takes no part until
// it is reached. Returns nullopt when the iteration does not settle.
std::optional<Vector> static_forces(const System& system, const Pressed& at) {
  constexpr int kMostSteps = 200;
  const Eigen::Index k = at.beyond.size();
  Vector depth = at.beyond, force = Vector::Zero(k);
  for (int step = 0; step < kMostSteps; ++step) {
    std::vector<Eigen::Index> near;
    Matrix acting = at.delassus;
    Vector beyond = at.beyond;
    for (Eigen::Index i = 0; i < k; ++i) {
      const auto* law = std::get_if<ContactForce>(&system.stops[static_cast<std::size_t>(i)].law);
      if (law && !(depth[i] > 0.0)) continue;
      near.push_back(i);
      if (!law) continue;
      const double slope = law->by_depth(depth[i], 0.0);
      acting(i, i) += 1.0 / slope;
      beyond[i] += law->at(depth[i], 0.0) / slope - depth[i];
    }
    const std::optional<Vector> found =
        solve_contacts<double>(acting(near, near), beyond(near).eval(), at.rounding(near).eval());
    if (!found || !found->allFinite()) return {};
    Vector next = Vector::Zero(k);
    next(near) = *found;
    const double change = (next - force).cwiseAbs().maxCoeff();
    force = next;
    depth = at.beyond - at.delassus * force;
    if (change <= 16.0 * std::numeric_limits<double>::epsilon() * force.cwiseAbs().maxCoeff())
      return force;
  }
  return {};
}

struct Balance {
  Vector q, force;
};

// Whether the stops that press, by more than rounding, leave no mode of frequency 0 free.
bool hold_free_modes(const System& system, const Vector& lent, const Pressed& at,
                     const Vector& force) {
  std::vector<Eigen::Index> free, pressed;
  for (Eigen::Index j = 0; j < lent.size(); ++j)
    if (lent[j] > 0.0) free.push_back(j);
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    const double preload = std::max(-system.stops[static_cast<std::size_t>(i)].gap, 0.0);
    if (force[i] * at.delassus(i, i) > std::sqrt(std::numeric_limits<double>::epsilon()) * preload)
      pressed.push_back(i);
  }
  if (pressed.size() < free.size()) return false;
  const Matrix rows = at.rows(free, pressed);
  return PivotedLu<double>(rows * rows.transpose()).is_invertible();
}

// Moves the pull of the lent stiffness to where the structure lies, until that stiffness carries no
// force: each round about halves the distance. Forces are known to some roundings.
std::optional<Balance> balance_of_free_modes(const System& system, const Vector& lent, Vector q) {
  constexpr int kMostRounds = 200;
  constexpr double kRoundings = 16.0;
  for (int round = 0; round < kMostRounds; ++round) {
    const Pressed at = pressed_against(system, lent, q);
    const std::optional<Vector> force = static_forces(system, at);
    if (!force) return {};
    const Vector next = at.free - at.compliance.cwiseProduct(at.directions * *force);
    const Vector moved = at.rows.transpose() * (next - q);
    q = next;
    if ((moved.cwiseAbs().array() <= kRoundings * at.rounding.array()).all() && q.allFinite()) {
      if (!hold_free_modes(system, lent, at, *force)) return {};
      return Balance{q, *force};
    }
  }
  return {};
}

// Rest under the constant load with every stop's force >= 0 and gap >= 0, or its spring's force:
//   q = W^-1 (load - D lambda),   lambda >= 0,   b.q <= a,   lambda (a - b.q) = 0,
//   at a spring lambda = F(b.q - a).
std::optional<Vector> static_equilibrium(const System& system) {
  const Vector lent = lent_stiffness(system);
  if ((system.omega + lent).minCoeff() <= 0.0) return {};
  Pressed at = pressed_against(system, lent, Vector::Zero(system.modes()));
  std::optional<Vector> force = static_forces(system, at);
  if (!force) return {};
  Vector q = at.free - at.compliance.cwiseProduct(at.directions * *force);
  if (!lent.isZero(0.0)) {
    std::optional<Balance> balance = balance_of_free_modes(system, lent, q);
    if (!balance) return {};
    q = std::move(balance->q);
    force = std::move(balance->force);
  }
  // What is pressed is on its rigid stop to the rounding of the gap itself, not only to that of the
  // solution.
  std::vector<Eigen::Index> pressed;
  for (Eigen::Index i = 0; i < force->size(); ++i)
    if ((*force)[i] > 0.0 && !system.stops[static_cast<std::size_t>(i)].is_compliant())
      pressed.push_back(i);
  if (pressed.empty()) return q;
  const Matrix acting = at.delassus(pressed, pressed);
  for (int pass = 0; pass < 2; ++pass) {
    Vector left(static_cast<Eigen::Index>(pressed.size()));
    for (std::size_t a = 0; a < pressed.size(); ++a) {
      const Stop& stop = system.stops[static_cast<std::size_t>(pressed[a])];
      left[static_cast<Eigen::Index>(a)] = -gap_value<double>(stop.row, q, stop.gap).value;
    }
    q -= at.compliance.cwiseProduct(at.directions(Eigen::all, pressed) *
                                    PivotedLu<double>(acting).solve(left));
  }
  return q;
}

// The state of the system at t = 0; what lies on a stop within the rounding of where that is then
// lies on it.
State seen_from_stops(const System& system, const State& structure) {
  constexpr double kRoundings = 16.0 * std::numeric_limits<double>::epsilon();
  const double phase = system.forcing()->phase;
  State state = system_state(system, structure, phase);
  for (const Stop& stop : system.stops) {
    double size = std::abs(stop.gap) + stop.row.cwiseAbs().dot(structure.q.cwiseAbs());
    for (const Harmonic& one : *system.carried()) size += std::abs(stop.row.dot(one.at(phase)));
    if (!(std::abs(stop.gap - stop.row.dot(state.q)) <= kRoundings * size)) continue;
    Eigen::Index most = 0;
    stop.row.cwiseAbs().maxCoeff(&most);
    state.q[most] = 0.0;
    state.q[most] = (stop.gap - stop.row.dot(state.q)) / stop.row[most];
  }
  return state;
}

// With its stops where they are at t = 0.
System at_start(const System& system) {
  System there = system;
  if (!system.carried()) return there;
  for (const Harmonic& one : *system.carried())
    for (Stop& stop : there.stops) stop.gap += stop.row.dot(one.at(system.forcing()->phase));
  return there;
}

Vector as_vector(const std::vector<double>& list) {
  return Eigen::Map<const Vector>(list.data(), static_cast<Eigen::Index>(list.size()));
}

// Modal velocities of a uniform motion of the whole structure at 1 m/s.
Vector uniform_motion(const Scene& scene) {
  if (scene.modal()) return as_vector(scene.modal()->inertia);
  Scene pushed = scene;
  pushed.gravity = Gravity{1.0};
  return modal_model(pushed).inertia;
}

// Where a scene says that its structure starts, without a hub.
State given_start(const Scene& scene) {
  const Initial& initial = *scene.initial;
  const auto modal = [&](const std::vector<double>& own, const std::vector<double>& coordinates) {
    if (coordinates.empty()) return as_vector(own);
    if (scene.span()) return modal_coordinates(scene, initial.positions, coordinates);
    return Vector(
        scene.discrete()->solved->momenta.leftCols(static_cast<Eigen::Index>(coordinates.size())) *
        as_vector(coordinates));
  };
  State state{modal(initial.q, initial.displacement), modal(initial.qdot, initial.velocity)};
  if (initial.speed) state.qdot += *initial.speed * uniform_motion(scene);
  return state;
}

// The key of the scene that places the structure at the start.
std::string start_key(const Initial& initial) {
  const bool bent =
      std::any_of(initial.q.begin(), initial.q.end(), [](double q) { return q != 0.0; });
  if (initial.in_equilibrium) return "initial.at";
  if (!initial.displacement.empty()) return "initial.displacement";
  return !bent && initial.angle != 0.0 ? "initial.angle" : "initial.q";
}

}  // namespace

State initial_state(const Scene& scene, const System& system) {
  const Eigen::Index n = system.modes();
  State state{Vector::Zero(n), Vector::Zero(n)};
  if (scene.initial && system.turns()) {
    const Vector q = as_vector(scene.initial->q), qdot = as_vector(scene.initial->qdot);
    state.q = turning_coordinates(*system.rotation(), scene.initial->angle, q);
    state.qdot = turning_coordinates(*system.rotation(), scene.initial->rate, qdot);
  } else if (scene.initial) {
    state = given_start(scene);
  }
  const bool at_rest = scene.initial && scene.initial->in_equilibrium;
  const System there = at_start(system);
  if (at_rest || (!scene.initial && is_preloaded(there))) {
    const std::optional<Vector> q = static_equilibrium(there);
    if (!q)
      throw scene_error(
          scene, at_rest ? "initial.at" : "stop.gap",
          fmt::format("{} in static equilibrium, which this structure does not have (a mode of "
                      "frequency 0 that {} from both sides, or stops that contradict each other); "
                      "say where it starts in [initial]",
                      at_rest ? "the motion starts"
                              : "a preloaded stop (negative gap) without [initial] starts",
                      at_rest ? "nothing holds" : "its preloads do not hold"));
    state.q = *q;
  }
  if (system.carried()) state = seen_from_stops(system, state);
  // Springs in series with friction pull with nothing at first.
  for (const Friction& friction : system.frictions)
    if (friction.series)
      state.q -= friction.series->direction * friction.series->row.dot(state.q);
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const Stop& stop = system.stops[i];
    const GapValue<double> gap = gap_value<double>(stop.row, state.q, stop.gap);
    if (!stop.is_compliant() && gap.value < -gap.rounding) {
      const std::string key =
          system.stops.size() == 1 ? "stop.gap" : fmt::format("stop.{}.gap", i + 1);
      throw scene_error(scene, scene.initial ? start_key(*scene.initial) : key,
                        fmt::format("the motion starts {:.6g}{} beyond stop {}; the displacement "
                                    "at the stop must not exceed its gap",
                                    -gap.value, unit_behind(scene.units, "m"), i + 1));
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
