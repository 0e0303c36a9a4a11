// Definitions of contact_phase.hpp: phases that are integrated step by step.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "graze/flow/contact_phase.hpp"
#include "graze/flow/contact_phase_joint_impl.hpp"
#include "graze/flow/step_methods.hpp"

namespace graze {

template <class Real>
void ContactPhase<Real>::step_by(const StepSetting& setting) {
  if constexpr (std::is_same_v<Real, double>) {
    if (coupled_flow_) {
      step_scale_ = coupled_flow_->scale();
      step_flow_ = graze::step_flow(coupled_flow_->first_order(), setting);
    } else {
      const Eigen::Index n = reduced_.omega.size();
      // A soft mode moves by what the forcing does to it.
      const double slowest = std::max(reduced_.frequency, 1e-3 * reduced_.omega.norm());
      step_scale_ = reduced_.omega.cwiseMax(slowest > 0.0 ? slowest : 1.0);
      const auto or_zero = [n](const Vector& list) {
        return list.size() > 0 ? list : Vector(Vector::Zero(n));
      };
      step_flow_ = graze::step_flow(
          ModalRates{step_scale_, reduced_.omega.cwiseAbs2().cwiseQuotient(step_scale_),
                     2.0 * reduced_.delta, or_zero(reduced_.load), or_zero(reduced_.amplitude),
                     reduced_.frequency},
          setting);
    }
    add_watches(step_scale_);
  }
}

template <class Real>
void ContactPhase<Real>::add_watches(const Vector& scale) {
  if constexpr (std::is_same_v<Real, double>) {
    for (const Observable<double>& observable : observables_) {
      Watch watch;
      watch.constant = observable.constant;
      watch.weights.resize(2 * scale.size());
      watch.weights << observable.displacement.cwiseQuotient(scale),
          observable.velocity.size() > 0 ? observable.velocity : Vector(Vector::Zero(scale.size()));
      watch.harmonic_re = observable.harmonic.re;
      watch.harmonic_im = observable.harmonic.im;
      watches_.push_back(std::move(watch));
    }
  }
}

// The reduced motion with its springs, on the displacements themselves.
template <class Real>
SprungSystem ContactPhase<Real>::sprung_system(const System& system) const {
  SprungSystem sprung;
  if constexpr (std::is_same_v<Real, double>) {
    const Eigen::Index m = reduced_.omega.size();
    const auto or_zero = [m](const Vector& list) {
      return list.size() > 0 ? list : Vector(Vector::Zero(m));
    };
    if (system.turns()) {
      sprung.stiffness = reduced_.omega.cwiseAbs2();
      sprung.damping = Vector::Zero(m);
      sprung.load = or_zero(reduced_.load);
      sprung.force = Vector::Zero(m);
      sprung.turning = turning(system);
    } else if (coupled_flow_) {
      const FirstOrderSystem& whole = coupled_flow_->first_order();
      sprung.stiffness =
          -whole.generator.bottomLeftCorner(m, m) * coupled_flow_->scale().asDiagonal();
      sprung.damping = -whole.generator.bottomRightCorner(m, m);
      sprung.load = whole.load.tail(m);
      sprung.force = whole.force.tail(m);
      sprung.frequency = whole.frequency;
    } else {
      sprung.stiffness = reduced_.omega.cwiseAbs2();
      sprung.damping = 2.0 * reduced_.delta;
      sprung.load = or_zero(reduced_.load);
      sprung.force = or_zero(reduced_.amplitude);
      sprung.frequency = reduced_.forced ? reduced_.frequency : 0.0;
    }
    const auto add = [&](const std::vector<int>& stops, bool loaded) {
      for (const int i : stops) {
        const Stop& stop = system.stops[static_cast<std::size_t>(i)];
        const Vector row = holds_.empty() ? stop.row : Vector(basis_.transpose() * stop.row);
        const Vector acting = left_.size() > 0 ? Vector(left_ * stop.row) : row;
        sprung.springs.push_back({stop.force(), row, acting, loaded, stop.row});
      }
    };
    add(springs_.loaded, true);
    add(springs_.parted, false);
  }
  return sprung;
}

// An oblique law projects along other directions than it holds; what forces do is told before that.
template <class Real>
void ContactPhase<Real>::add_powers(const System& system, SprungSystem& sprung) const {
  if constexpr (std::is_same_v<Real, double>) {
    if (left_.size() == 0) return;
    SprungSystem::Powers& powers = sprung.powers.emplace();
    powers.forcing = Vector::Zero(basis_.cols());
    if (system.forcing()) powers.forcing = basis_.transpose() * system.forcing()->amplitude;
    powers.damping = basis_.transpose() * (2.0 * system.delta()).asDiagonal() * basis_;
    for (const int i : holds_) {
      const Stop& stop = system.stops[static_cast<std::size_t>(i)];
      // A contact force of 1 N accelerates by -direction |row|^2.
      powers.held.push_back({watches_[static_cast<std::size_t>(i)],
                             stop.row.squaredNorm() * basis_.transpose() * stop.direction()});
    }
  }
}

template <class Real>
void ContactPhase<Real>::spring_by(const System& system, const std::optional<StepSetting>& steps) {
  if constexpr (std::is_same_v<Real, double>) {
    for (const Stop& stop : system.stops) {
      whole_rows_.push_back(stop.row);
      gaps_.push_back(stop.gap);
    }
    step_scale_ = Vector::Ones(reduced_.omega.size());
    add_watches(step_scale_);
    SprungSystem& sprung = sprung_.emplace(sprung_system(system));
    const auto count = static_cast<Eigen::Index>(sprung.springs.size());
    for (std::size_t c = 0; c < holds_.size(); ++c) {
      if (system.turns()) {
        Watch& hold = watches_[static_cast<std::size_t>(holds_[c])];
        hold.constant = 0.0;
        hold.of_spring = SpringWatch::kHold;
        hold.spring = static_cast<int>(c);
        continue;
      }
      // A spring pushes the structure off what holds it.
      Watch& force = watches_[static_cast<std::size_t>(holds_[c])];
      const auto column = static_cast<Eigen::Index>(c);
      force.force_weights.resize(count);
      for (Eigen::Index k = 0; k < count; ++k) {
        const auto place = static_cast<std::size_t>(k);
        const int i = place < springs_.loaded.size()
                          ? springs_.loaded[place]
                          : springs_.parted[place - springs_.loaded.size()];
        force.force_weights[k] =
            -shares_.col(column).dot(system.stops[static_cast<std::size_t>(i)].row) /
            rows_.col(column).squaredNorm();
      }
    }
    add_powers(system, sprung);
    if (system.turns() && system.rotation()->friction) watch_joint(*system.rotation()->friction);
    for (Eigen::Index k = 0; k < count; ++k) {
      Watch watch;
      watch.spring = static_cast<int>(k);
      watch.of_spring = SpringWatch::kDepth;
      depth_watches_.push_back(watch);
      watch.of_spring = sprung.springs[static_cast<std::size_t>(k)].loaded ? SpringWatch::kGrip
                                                                           : SpringWatch::kSlack;
      grip_watches_.push_back(watch);
    }
    StepSetting setting = steps.value_or(StepSetting{});
    setting.speed = 1.0;  // the state counts in speeds of the contact
    if (!steps) {
      setting.tolerance = kStepTolerance;
      setting.longest = std::numeric_limits<double>::infinity();
    }
    step_flow_ = steps ? graze::step_flow(sprung, setting) : bulirsch_stoer_flow(sprung, setting);
  }
}

template <class Real>
const Watch& ContactPhase<Real>::depth_watch(std::size_t spring, int multiplicity,
                                             double departure) {
  Watch& watch = depth_watches_[spring];
  watch.multiplicity = multiplicity;
  watch.departure = departure;
  return watch;
}

template <class Real>
const Watch& ContactPhase<Real>::grip_watch(std::size_t spring, int multiplicity) {
  grip_watches_[spring].multiplicity = multiplicity;
  return grip_watches_[spring];
}

template <class Real>
const Watch& ContactPhase<Real>::watch(int stop, int multiplicity) {
  Watch& watch = watches_[static_cast<std::size_t>(stop)];
  watch.multiplicity = multiplicity;
  if constexpr (std::is_same_v<Real, double>) {
    // Taylor's coefficient of the zero that it starts from.
    const double rate = multiplicity == 4  ? gap_rate(stop, 3).slope
                        : multiplicity > 0 ? gap_rate(stop, multiplicity).value
                                           : 0.0;
    if (multiplicity > 0) watch.departure = rate / std::tgamma(multiplicity + 1.0);
  }
  return watch;
}

template <class Real>
CurvePoint<Real> ContactPhase<Real>::gap_rate(int stop, int order) {
  if constexpr (std::is_same_v<Real, double>) {
    if (turns()) return turning_gap_rate(stop, order);
  }
  return gap_along(stop, Real(0), true).at(Real(0), order);
}

// The rows do not turn: what changes their rates are the accelerations alone.
template <class Real>
CurvePoint<Real> ContactPhase<Real>::turning_gap_rate(int stop, int order) const {
  CurvePoint<Real> point;
  if constexpr (std::is_same_v<Real, double>) {
    const TurningStructure& structure = sprung_->turning->structure;
    const Vector& row = whole_rows_[static_cast<std::size_t>(stop)];
    const AtStart at = at_start();
    const double rates[] = {-row.dot(start_qdot_), -row.dot(at.acceleration), -row.dot(at.jerk)};
    point.value = rates[order - 1];
    if (order < 3) point.slope = rates[order];
    const Vector size = order == 1 ? Vector(start_qdot_.cwiseAbs())
                                   : structure.force_size({start_q_, start_qdot_}, 0.0);
    point.noise = kRoundingsOfTurning * row.cwiseAbs().dot(size);
    if (order == 3) point.noise *= structure.highest_frequency();
  }
  return point;
}

// Of a structure that turns.
template <class Real>
typename ContactPhase<Real>::AtStart ContactPhase<Real>::at_start() const {
  AtStart at;
  if constexpr (std::is_same_v<Real, double>) {
    const Turning& turning = *sprung_->turning;
    const TurningMotion motion{start_q_, start_qdot_};
    at.force = turning.structure.force(motion, 0.0) - spring_push(start_q_, start_qdot_);
    at.acceleration = turning.acceleration(at.force, start_q_);
    at.force_rate =
        turning.structure.force_rate(motion, at.acceleration) - spring_push_rate(at.acceleration);
    at.jerk = turning.jerk(motion, at.acceleration, at.force_rate);
  }
  return at;
}

// On all coordinates, N, and its rate, N/s.
template <class Real>
Vector ContactPhase<Real>::spring_push(const Vector& q, const Vector& qdot) const {
  Vector push = Vector::Zero(q.size());
  if constexpr (std::is_same_v<Real, double>) {
    for (std::size_t k = 0; k < springs_.loaded.size(); ++k) {
      const SprungSystem::Spring& spring = sprung_->springs[k];
      const double depth =
          spring.whole_row.dot(q) - gaps_[static_cast<std::size_t>(springs_.loaded[k])];
      push += spring.law.at(depth, spring.whole_row.dot(qdot)) * spring.whole_row;
    }
  }
  return push;
}

template <class Real>
Vector ContactPhase<Real>::spring_push_rate(const Vector& acceleration) const {
  Vector push = Vector::Zero(acceleration.size());
  if constexpr (std::is_same_v<Real, double>) {
    for (std::size_t k = 0; k < springs_.loaded.size(); ++k) {
      const SprungSystem::Spring& spring = sprung_->springs[k];
      const double depth = depths_[k], rate = spring.whole_row.dot(start_qdot_);
      push += (spring.law.by_depth(depth, rate) * rate +
               spring.law.resistance(depth) * spring.whole_row.dot(acceleration)) *
              spring.whole_row;
    }
  }
  return push;
}

template <class Real>
double ContactPhase<Real>::sprung_force_at(int stop, double s, const Vector& q,
                                           const Vector& qdot) const {
  if constexpr (std::is_same_v<Real, double>) {
    const auto place =
        static_cast<std::size_t>(std::find(holds_.begin(), holds_.end(), stop) - holds_.begin());
    if (sprung_->turning) {
      const Turning& turning = *sprung_->turning;
      return turning.holds(turning.structure.force({q, qdot}, s) - spring_push(q, qdot),
                           q)[static_cast<Eigen::Index>(place)];
    }
    const Vector y = reduced_coordinates(q), ydot = basis_.transpose() * qdot;
    const double free = observed<Real>(observables_[static_cast<std::size_t>(stop)],
                                       start_phase() + reduced_.frequency * s, y, ydot)
                            .value;
    const auto column = static_cast<Eigen::Index>(place);
    return free - shares_.col(column).dot(spring_push(q, qdot)) / rows_.col(column).squaredNorm();
  }
  return 0.0;
}

template <class Real>
double ContactPhase<Real>::force_rate_at_start(int stop) const {
  if constexpr (std::is_same_v<Real, double>) {
    const AtStart at = at_start();
    const auto place = std::find(holds_.begin(), holds_.end(), stop) - holds_.begin();
    return sprung_->turning->hold_rates({start_q_, start_qdot_}, at.acceleration,
                                        at.force_rate)[place];
  }
  return 0.0;
}

template <class Real>
Turning ContactPhase<Real>::turning(const System& system) const {
  Turning turning{TurningStructure(system), Vector::Zero(system.modes()), {}, {}};
  turning.structure.set_joint(joint_);
  if constexpr (std::is_same_v<Real, double>) {
    if (holds_.empty()) return turning;
    turning.held = held_;
    turning.basis = basis_;
    turning.across = LuFactors(rows_.transpose() * rows_).inverse() * rows_.transpose();
  }
  return turning;
}

template <class Real>
void ContactPhase<Real>::start_steps(double theta, const Vector& q, const Vector& qdot) {
  if (turns()) {
    sprung_->turning->structure.begin(time_);
    start_q_ = q;
    start_qdot_ = qdot;
  }
  Vector x(2 * step_scale_.size());
  if (holds_.empty())
    x << step_scale_.cwiseProduct(q), qdot;
  else if constexpr (std::is_same_v<Real, double>)
    x << step_scale_.cwiseProduct(reduced_coordinates(q)), basis_.transpose() * qdot;
  step_flow_->start(theta, x, depths_, time_);
}

template <class Real>
void ContactPhase<Real>::step_state(double s, Vector& q, Vector& qdot) const {
  Vector x;
  step_flow_->state(s, x);
  const Eigen::Index n = step_scale_.size();
  if (holds_.empty()) {
    q = x.head(n).cwiseQuotient(step_scale_);
    qdot = x.tail(n);
  } else if constexpr (std::is_same_v<Real, double>) {
    q = held_ + basis_ * x.head(n).cwiseQuotient(step_scale_);
    qdot = basis_ * x.tail(n);
  }
}

}  // namespace graze
