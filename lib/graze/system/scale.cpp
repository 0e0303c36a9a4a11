#include "graze/system/scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/system/detail/hub_state.hpp"

namespace graze {

namespace {

// The sum of the sizes of what modal forces do at a stop; of modes that damping couples each force
// may come to act there, by the bound of their product.
double push_at(const System& system, const Stop& stop, const Vector& force) {
  return system.coupling() ? stop.row.norm() * force.norm()
                           : stop.row.cwiseProduct(force).cwiseAbs().sum();
}

}  // namespace

double forced_reach_at(const System& system, const Vector& row) {
  double reach = 0.0;
  if (!system.forcing()) return reach;
  const double frequency = system.forcing()->frequency;
  const Vector force = system.forcing()->size();
  for (Eigen::Index j = 0; j < system.omega.size(); ++j)
    reach = std::max(reach, std::abs((system.coupling() ? row.norm() : row[j]) * force[j]) /
                                std::max(system.omega[j] * system.omega[j], frequency * frequency));
  return reach;
}

double reach_at(const System& system, const Stop& stop) {
  return std::max(std::abs(stop.gap), forced_reach_at(system, stop.row));
}

namespace {

// Largest acceleration at a stop by torque and weight on the structure at rest, m/s^2.
double hub_push(const Rotation& rotation, const Vector& row) {
  const double turning = std::abs(rotation.angle.dot(row));
  double push = 0.0;
  if (rotation.torque)
    for (const double torque : rotation.torque->values)
      push = std::max(push, std::abs(torque) * turning);
  if (rotation.weight)
    push += std::abs(rotation.weight->moment) * turning + std::abs(rotation.weight->pull.dot(row));
  return push;
}

// How far friction alone moves the structure where it acts, m.
double rubbed_reach(const System& system, const Friction& friction) {
  double reach = 0.0;
  const double frequency = system.forcing()->frequency;
  for (Eigen::Index j = 0; j < system.omega.size(); ++j)
    reach = std::max(reach, friction.sliding * friction.row[j] * friction.row[j] /
                                std::max(system.omega[j] * system.omega[j], frequency * frequency));
  return reach;
}

}  // namespace

MotionScale motion_scale(const System& system) {
  const double frequency = system.forcing()->frequency;
  MotionScale scale{0.0, 0.0, 0.0, {}};
  const auto include = [&](double reach, const Vector& row) {
    if (!(reach > scale.length)) return;
    scale.length = reach;
    scale.displacement = reach / row.norm();
  };
  for (const Stop& stop : system.stops) include(reach_at(system, stop), stop.row);
  for (const Friction& friction : system.frictions)
    include(std::max(forced_reach_at(system, friction.row), rubbed_reach(system, friction)),
            friction.row);
  if (!(scale.length > 0.0)) scale.length = scale.displacement = 1.0;
  scale.speed = scale.length * frequency;
  scale.velocity = scale.displacement * system.omega.cwiseMax(frequency);
  return scale;
}

double still_speed(const System& system) {
  // Some sixteen roundings of forced displacement and forcing frequency.
  return 16.0 * std::numeric_limits<double>::epsilon() * motion_scale(system).speed;
}

double still_gap(const System& system) { return 1e-12 * motion_scale(system).length; }

double speed_scale(const System& system, const State& start) {
  double scale = 0.0;
  for (const Stop& stop : system.stops) {
    const double distance = std::max(std::abs(stop.gap), std::abs(stop.row.dot(start.q)));
    const double forced = forced_reach_at(system, stop.row);
    // Over a distance d an acceleration a comes to sqrt(2 a d), however slowly it turns.
    if (forced > 0.0) {
      const double fall =
          std::sqrt(2.0 * push_at(system, stop, system.forcing()->size()) * distance);
      const double whole = forced * system.forcing()->frequency;
      scale = std::max(scale, distance > 0.0 ? std::min(whole, fall) : whole);
    }
    if (system.load()) {
      const double height = distance > 0.0 ? distance : forced;
      const double pushed = system.coupling() ? push_at(system, stop, *system.load())
                                              : std::abs(stop.row.dot(*system.load()));
      scale = std::max(scale, std::sqrt(2.0 * pushed * height));
    }
    if (system.turns()) {
      // As if all of the torque and of the weight acted on the way to the stop at once.
      const double push = hub_push(*system.rotation(), stop.row);
      scale = std::max(scale, std::sqrt(2.0 * push * distance));
    }
    const Vector swing = system.omega.cwiseProduct(start.q).cwiseAbs() + start.qdot.cwiseAbs();
    scale = std::max(scale, stop.row.cwiseAbs().dot(swing));
  }
  return scale;
}

double longest_flight(const System& system) {
  constexpr double kOscillations = 64.0;
  const Vector decay = decay_rates(system);
  double slowest = std::numeric_limits<double>::infinity();
  for (Eigen::Index j = 0; j < system.omega.size(); ++j) {
    const double rate = system.omega[j] > 0.0 ? system.omega[j] : decay[j];
    if (rate > 0.0) slowest = std::min(slowest, rate);
  }
  return std::isfinite(slowest) ? kOscillations * kTurn / slowest : slowest;
}

}  // namespace graze
