// Definitions of contact_phase.hpp: phases that are integrated step by step.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "graze/flow/contact_phase.hpp"
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
    if (coupled_flow_) {
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
        const RigidStop& stop = system.stops[static_cast<std::size_t>(i)];
        const Vector row = closed_.empty() ? stop.row : Vector(basis_.transpose() * stop.row);
        const Vector acting = left_.size() > 0 ? Vector(left_ * stop.row) : row;
        sprung.springs.push_back({*stop.spring, row, acting, loaded});
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
    if (system.forcing) powers.forcing = basis_.transpose() * system.forcing->amplitude;
    powers.damping = basis_.transpose() * (2.0 * system.delta).asDiagonal() * basis_;
    for (const int i : closed_) {
      const RigidStop& stop = system.stops[static_cast<std::size_t>(i)];
      // A contact force of 1 N accelerates by -direction |row|^2.
      powers.held.push_back({watches_[static_cast<std::size_t>(i)],
                             stop.row.squaredNorm() * basis_.transpose() * stop.direction});
    }
  }
}

template <class Real>
void ContactPhase<Real>::spring_by(const System& system, const std::optional<StepSetting>& steps) {
  if constexpr (std::is_same_v<Real, double>) {
    step_scale_ = Vector::Ones(reduced_.omega.size());
    add_watches(step_scale_);
    SprungSystem& sprung = sprung_.emplace(sprung_system(system));
    const auto count = static_cast<Eigen::Index>(sprung.springs.size());
    for (std::size_t c = 0; c < closed_.size(); ++c) {
      // A spring pushes the structure off what holds it.
      Watch& force = watches_[static_cast<std::size_t>(closed_[c])];
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
      setting.tolerance = kContactTolerance;
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
const Watch& ContactPhase<Real>::watch(int stop, int multiplicity) {
  Watch& watch = watches_[static_cast<std::size_t>(stop)];
  watch.multiplicity = multiplicity;
  if constexpr (std::is_same_v<Real, double>) {
    // Taylor's coefficient of the zero that it starts from.
    if (multiplicity > 0)
      watch.departure =
          gap(stop, 0.0, true).at(0.0, multiplicity - 1).slope / std::tgamma(multiplicity + 1.0);
  }
  return watch;
}

template <class Real>
void ContactPhase<Real>::start_steps(double theta, const Vector& q, const Vector& qdot) {
  Vector x(2 * step_scale_.size());
  if (closed_.empty())
    x << step_scale_.cwiseProduct(q), qdot;
  else if constexpr (std::is_same_v<Real, double>)
    x << step_scale_.cwiseProduct(reduced_coordinates(q)), basis_.transpose() * qdot;
  step_flow_->start(theta, x, depths_);
}

template <class Real>
void ContactPhase<Real>::step_state(double s, Vector& q, Vector& qdot) const {
  Vector x;
  step_flow_->state(s, x);
  const Eigen::Index n = step_scale_.size();
  if (closed_.empty()) {
    q = x.head(n).cwiseQuotient(step_scale_);
    qdot = x.tail(n);
  } else if constexpr (std::is_same_v<Real, double>) {
    q = held_ + basis_ * x.head(n).cwiseQuotient(step_scale_);
    qdot = basis_ * x.tail(n);
  }
}

}  // namespace graze
