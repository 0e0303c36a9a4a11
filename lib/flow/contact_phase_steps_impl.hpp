// Definitions of contact_phase.hpp: phases that are integrated step by step.
#pragma once

#include <algorithm>
#include <cmath>
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
    for (const Observable<double>& observable : observables_) {
      Watch watch;
      watch.constant = observable.constant;
      watch.weights.resize(2 * step_scale_.size());
      watch.weights << observable.displacement.cwiseQuotient(step_scale_),
          observable.velocity.size() > 0 ? observable.velocity
                                         : Vector(Vector::Zero(step_scale_.size()));
      watch.harmonic_re = observable.harmonic.re;
      watch.harmonic_im = observable.harmonic.im;
      watches_.push_back(std::move(watch));
    }
  }
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
  step_flow_->start(theta, x);
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
