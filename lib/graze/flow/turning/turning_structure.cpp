#include "graze/flow/turning/detail/turning_structure.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "graze/system/detail/gap_value.hpp"

namespace graze {

TurningStructure::TurningStructure(const System& system)
    : stiffness_(system.omega.cwiseAbs2()), rotation_(*system.rotation()) {
  highest_ = system.omega.maxCoeff();
  lowest_ = highest_;
  for (const double w : system.omega)
    if (w > 0.0) lowest_ = std::min(lowest_, w);
  begin(0.0);
}

void TurningStructure::begin(double time) {
  torque_ = torque_rate_ = 0.0;
  smooth_for_ = std::numeric_limits<double>::infinity();
  if (!rotation_.torque) return;
  const std::vector<double>&times = rotation_.torque->times, &values = rotation_.torque->values;
  const auto next = std::upper_bound(times.begin(), times.end(), time);
  if (next == times.end()) return;
  smooth_for_ = *next - time;
  if (next == times.begin()) return;
  const auto k = static_cast<std::size_t>(next - times.begin());
  torque_rate_ = (values[k] - values[k - 1]) / (times[k] - times[k - 1]);
  torque_ = values[k - 1] + torque_rate_ * (time - times[k - 1]);
}

double TurningStructure::smooth_for() const { return smooth_for_; }

double TurningStructure::friction() const {
  if (!rotation_.friction || joint_ == Joint::kFree || joint_ == Joint::kHeld) return 0.0;
  return joint_ == Joint::kForward ? *rotation_.friction : -*rotation_.friction;
}

Vector TurningStructure::turning_force(const TurningMotion& at, double s) const {
  const Vector& e = rotation_.angle;
  double along = torque(s) - friction();  // e times this
  Vector sum = Vector::Zero(e.size());
  if (stretches()) {
    const double r = rate(at.velocity);
    const Vector stretched = rotation_.stretch * at.y;
    sum += (r * r) * stretched;
    if (rotation_.consistent) along -= 2.0 * r * stretched.dot(at.velocity);
  }
  if (rotation_.weight) {
    const double angle = e.dot(at.y), cosine = std::cos(angle), sine = std::sin(angle);
    along -= rotation_.weight->moment * cosine - rotation_.weight->pull.dot(at.y) * sine;
    sum -= cosine * rotation_.weight->pull;
  }
  return sum + along * e;
}

Vector TurningStructure::force(const TurningMotion& at, double s) const {
  Vector sum = turning_force(at, s) - stiffness_.cwiseProduct(at.y);
  if (rotation_.damping.size() > 0) sum -= rotation_.damping * at.velocity;
  return sum;
}

Vector TurningStructure::force_size(const TurningMotion& at, double s) const {
  const Vector e = rotation_.angle.cwiseAbs();
  double along = std::abs(torque(s)) + std::abs(friction());
  Vector sum = stiffness_.cwiseProduct(at.y.cwiseAbs());
  if (rotation_.damping.size() > 0) sum += rotation_.damping.cwiseAbs() * at.velocity.cwiseAbs();
  if (stretches()) {
    const double r = rate(at.velocity);
    const Vector stretched = rotation_.stretch.cwiseAbs() * at.y.cwiseAbs();
    sum += (r * r) * stretched;
    along += 2.0 * std::abs(r) * stretched.dot(at.velocity.cwiseAbs());
  }
  if (rotation_.weight) {
    const Vector pull = rotation_.weight->pull.cwiseAbs();
    along += std::abs(rotation_.weight->moment) + pull.dot(at.y.cwiseAbs());
    sum += pull;
  }
  return sum + along * e;
}

Vector TurningStructure::force_rate(const TurningMotion& at, const Vector& acceleration) const {
  const Vector& e = rotation_.angle;
  double along = torque_rate_;
  Vector sum = -stiffness_.cwiseProduct(at.velocity);
  if (rotation_.damping.size() > 0) sum -= rotation_.damping * acceleration;
  const double r = rate(at.velocity), r_rate = rate(acceleration);
  if (stretches()) {
    const Matrix& a = rotation_.stretch;
    const Vector stretched = a * at.y, stretching = a * at.velocity;
    sum += (2.0 * r * r_rate) * stretched + (r * r) * stretching;
    if (rotation_.consistent)
      along -= 2.0 * (r_rate * stretched.dot(at.velocity) +
                      r * (stretched.dot(acceleration) + stretching.dot(at.velocity)));
  }
  if (rotation_.weight) {
    const Vector& pull = rotation_.weight->pull;
    const double angle = e.dot(at.y), cosine = std::cos(angle), sine = std::sin(angle);
    along += rotation_.weight->moment * r * sine + pull.dot(at.velocity) * sine +
             pull.dot(at.y) * r * cosine;
    sum += (r * sine) * pull;
  }
  return sum + along * e;
}

double TurningStructure::added_inertia(const Vector& y) const {
  return graze::added_inertia(rotation_, y);
}

double TurningStructure::added_inertia_rate(const TurningMotion& at) const {
  return stretches() && rotation_.consistent ? 2.0 * at.y.dot(rotation_.stretch * at.velocity)
                                             : 0.0;
}

Vector TurningStructure::accelerated(const Vector& force, const Vector& y) const {
  const Vector& e = rotation_.angle;
  const double m = added_inertia(y);
  return force - (m * e.dot(force) / (1.0 + m * e.squaredNorm())) * e;
}

bool TurningStructure::stands_still(const Vector& velocity) const {
  return std::abs(rate(velocity)) <= speed_rounding<double>(rotation_.angle, velocity);
}

double TurningStructure::torque_power(const TurningMotion& at, double s) const {
  return torque(s) * rate(at.velocity);
}

double TurningStructure::weight_power(const TurningMotion& at) const {
  if (!rotation_.weight) return 0.0;
  const double angle = rotation_.angle.dot(at.y), cosine = std::cos(angle), sine = std::sin(angle);
  const Vector& pull = rotation_.weight->pull;
  return -rate(at.velocity) * (rotation_.weight->moment * cosine - pull.dot(at.y) * sine) -
         pull.dot(at.velocity) * cosine;
}

double TurningStructure::dissipation(const TurningMotion& at) const {
  double power = friction() * rate(at.velocity);
  if (rotation_.damping.size() > 0) power += at.velocity.dot(rotation_.damping * at.velocity);
  return power;
}

double TurningStructure::kinetic_energy(const TurningMotion& at) const {
  const double r = rate(at.velocity);
  return 0.5 * (at.velocity.squaredNorm() + added_inertia(at.y) * r * r);
}

}  // namespace graze
