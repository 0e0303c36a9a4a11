// Definitions of sprung_rates.hpp: how far gaps and contact forces have got from zero for certain.
#pragma once

#include <algorithm>

#include "graze/flow/stepped/detail/sprung_rates.hpp"

namespace graze::step_walk {

inline Sprung::Left Sprung::changed(const Watch& watch, double s, const State& z,
                                    long long steps) const {
  const Eigen::Index n = modes();
  const Eigen::Map<const Vector> moved(z.data(), n), velocity(z.data() + n, n);
  const Vector by_moved = unit_ * watch.weights.head(n).cwiseQuotient(scale_),
               by_velocity = unit_ * watch.weights.tail(n);
  const Vector error_moved = errors(moved, steps), error_velocity = errors(velocity, steps);
  Left sum{by_moved.dot(moved) + by_velocity.dot(velocity - start_velocity_),
           by_moved.cwiseAbs().dot(error_moved) + by_velocity.cwiseAbs().dot(error_velocity)};
  // The terms that cancel at the start are rounded: the sum is zero there.
  double size = std::abs(watch.constant) + watch.weights.head(n).cwiseAbs().dot(from_.cwiseAbs());
  const double theta = theta_ + system_.frequency * s;
  sum.value += watch.harmonic_re * (std::cos(theta) - std::cos(theta_)) -
               watch.harmonic_im * (std::sin(theta) - std::sin(theta_));
  size += std::hypot(watch.harmonic_re, watch.harmonic_im);
  for (Eigen::Index i = 0; i < watch.force_weights.size(); ++i) {
    const auto spring = static_cast<std::size_t>(i);
    if (!system_.springs[spring].loaded || watch.force_weights[i] == 0.0) continue;
    const ContactForce& law = system_.springs[spring].law;
    const Contact& contact = contacts_[spring];
    const Compression at = compression(spring, z);
    const double first = law.at(contact.start, contact.rate.dot(start_velocity_)),
                 now = law.at(at.depth, at.rate),
                 deeper = contact.depth.cwiseAbs().dot(error_moved),
                 quicker = contact.rate.cwiseAbs().dot(error_velocity);
    sum.value += watch.force_weights[i] * (now - first);
    sum.error += std::abs(watch.force_weights[i]) *
                 (law.at(std::abs(at.depth) + deeper, std::abs(at.rate) + quicker) -
                  law.at(std::abs(at.depth), std::abs(at.rate)));
    size += std::abs(watch.force_weights[i]) * (std::abs(now) + std::abs(first));
  }
  sum.error +=
      kGripRoundings * static_cast<double>(n) * std::numeric_limits<double>::epsilon() * size;
  return sum;
}

}  // namespace graze::step_walk
