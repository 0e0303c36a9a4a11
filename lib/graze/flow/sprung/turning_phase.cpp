#include "graze/flow/sprung/detail/turning_phase.hpp"

#include <cmath>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/contact/detail/impulse.hpp"

namespace graze {
namespace {

System with_joint(const System& system, Joint joint, double angle) {
  System holding = system;
  const Vector& row = system.rotation()->angle;
  if (joint == Joint::kHeld)
    holding.stops.push_back({row, angle, ImpactLaw{momentum_direction(row)}});
  return holding;
}

std::vector<int> constrained_stops(const System& holding, const PhaseKey& key) {
  std::vector<int> constrained = key.closed;
  if (key.joint == Joint::kHeld) constrained.push_back(static_cast<int>(holding.stops.size()) - 1);
  return constrained;
}

}  // namespace

SprungEquations TurningPhase::equations_of(const System& holding, const PhaseKey& key) {
  SprungEquations equations{ConstrainedStructure<double>(holding, constrained_stops(holding, key)),
                            {}};
  const ConstrainedStructure<double>& structure = equations.structure;
  SprungSystem& sprung = equations.system;
  const Eigen::Index m = structure.size();
  const LinearSystem<double>& modes = structure.reduced;
  sprung.stiffness = modes.omega.cwiseAbs2();
  sprung.damping = sprung.force = Vector::Zero(m);
  sprung.load = modes.load.size() > 0 ? modes.load : Vector(Vector::Zero(m));
  Turning& turning = sprung.turning.emplace(
      Turning{TurningStructure(holding), Vector::Zero(holding.modes()), {}, {}});
  turning.structure.set_joint(key.joint);
  if (!structure.is_free()) {
    const Matrix& rows = structure.rows;
    turning.held = structure.rest;
    turning.basis = structure.basis;
    turning.across = LuFactors(rows.transpose() * rows).inverse() * rows.transpose();
  }
  add_springs(holding, key, structure, sprung);
  return equations;
}

TurningPhase::TurningPhase(const System& system, const PhaseKey& key,
                           const std::optional<StepSetting>& steps, double angle)
    : TurningPhase(with_joint(system, key.joint, angle), key, steps) {}

TurningPhase::TurningPhase(const System& holding, const PhaseKey& key,
                           const std::optional<StepSetting>& steps)
    : SprungPhase(holding, key, equations_of(holding, key)) {
  for (std::size_t c = 0; c < structure().constrained.size(); ++c) {
    Watch& hold = watches()[static_cast<std::size_t>(structure().constrained[c])];
    hold.constant = 0.0;
    hold.of_spring = SpringWatch::kHold;
    hold.spring = static_cast<int>(c);
  }
  if (key.joint != Joint::kFree) {
    Watch watch;
    watch.is_told = false;
    if (key.joint == Joint::kHeld) {
      watch.constant = *holding.rotation()->friction;
      watch.of_spring = SpringWatch::kHold;
      watch.spring = static_cast<int>(structure().constrained.size()) - 1;
      for (const double factor : {-1.0, 1.0}) {
        watch.factor = factor;
        joint_watches_.push_back(watch);
      }
    } else {
      const Vector along = structure().seen(turning().structure.angle_row());
      watch.weights = Vector::Zero(2 * along.size());
      watch.weights.tail(along.size()) = key.joint == Joint::kForward ? along : Vector(-along);
      joint_watches_.push_back(watch);
    }
  }
  integrate(steps);
}

void TurningPhase::start(const double& theta, const Vector& q, const Vector& qdot,
                         const double& time) {
  equations().turning->structure.begin(time);
  SprungPhase::start(theta, q, qdot, time);
}

ForcesAtStart TurningPhase::at_start() const {
  const TurningMotion motion{start_q(), start_qdot()};
  const TurningStructure& structure = turning().structure;
  const Vector push = spring_push(start_q(), start_qdot());
  ForcesAtStart at;
  at.force = structure.force(motion, 0.0) - push;
  at.acceleration = turning().acceleration(at.force, start_q());
  const Vector push_rate =
      spring_push_rate(SprungPhase::equations(), depths(), start_qdot(), at.acceleration);
  at.force_rate = structure.force_rate(motion, at.acceleration) - push_rate;
  at.jerk = turning().jerk(motion, at.acceleration, at.force_rate);
  at.size = structure.force_size(motion, 0.0);
  at.rate_size = structure.highest_frequency() * at.size + push_rate.cwiseAbs();
  at.size += push.cwiseAbs();
  return at;
}

double TurningPhase::force_at(int stop, const double& s, const Vector& q,
                              const Vector& qdot) const {
  return turning().hold_forces(turning().structure.force({q, qdot}, s) - spring_push(q, qdot),
                               q)[structure().column_of(stop)];
}

double TurningPhase::force_rate(int stop) const {
  const ForcesAtStart at = at_start();
  return turning().hold_rates({start_q(), start_qdot()}, at.acceleration,
                              at.force_rate)[structure().column_of(stop)];
}

// A joint that is at rest and starts to rotate leaves zero as s or s^2.
void TurningPhase::watch_joint(const MotionState<double>& /*now*/, std::vector<Watched>& list) {
  const TurningStructure& structure = turning().structure;
  if (key().joint == Joint::kForward || key().joint == Joint::kBackward) {
    Watch& turned = joint_watches_.front();
    turned.multiplicity = 0;
    turned.departure = 0.0;
    if (structure.stands_still(start_qdot())) {
      const ForcesAtStart at = at_start();
      const double sign = key().joint == Joint::kForward ? 1.0 : -1.0;
      const double rate = structure.rate(at.acceleration);
      const double rounding = kForceRoundings * structure.angle_row().cwiseAbs().dot(at.size);
      turned.multiplicity = std::abs(rate) > rounding ? 1 : 2;
      turned.departure = sign * (turned.multiplicity == 1 ? rate : 0.5 * structure.rate(at.jerk));
    }
  }
  for (const Watch& watch : joint_watches_) list.push_back({-1, &watch, ArrivalKind::kJoint});
}

}  // namespace graze
