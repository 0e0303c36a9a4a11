// Definitions of sprung_rates.hpp: powers, and the works that they add up to.
#pragma once

#include "graze/flow/stepped/detail/sprung_rates.hpp"

namespace graze::step_walk {

inline void Sprung::add_moving_powers(const State& z, double cosine, double s, State& slope) {
  const SprungSystem::Moving& moving = *system_.moving;
  const Eigen::Index n = modes();
  const Eigen::Map<const Vector> moved(z.data(), n), rate(z.data() + n, n);
  const double unit = unit_ * unit_ / work_unit_;
  const Vector place = from_ / unit_ + moved.cwiseQuotient(scale_);
  const Vector velocity = moving.place * place + moving.rate * rate;
  const Vector force = cosine / unit_ * moving.forcing + moving.force_place * place +
                       moving.force_rate * rate;
  slope[this->place(kWeight)] = 0.0;
  slope[this->place(kForcing)] = unit * velocity.dot(force);
  slope[this->place(kDissipation)] = unit * velocity.dot(moving.damping * velocity);
  double stops = 0.0;
  for (std::size_t i = 0; i < contacts_.size(); ++i)
    stops += Sprung::force(i, z) *
             (moving.rows[i].dot(velocity) - system_.springs[i].row.dot(rate));
  for (const SprungSystem::Holding& holding : moving.held)
    stops += holding.against.dot(velocity) * observed(holding.force, s, z);
  slope[this->place(kConstraint)] = -unit / unit_ * stops;
}

inline void Sprung::add_powers(const State& z, const Vector& resistance, double cosine, double s,
                               State& slope) {
  if (system_.moving) return add_moving_powers(z, cosine, s, slope);
  const Eigen::Index n = modes();
  const Eigen::Map<const Vector> velocity(z.data() + n, n);
  const double unit = unit_ * unit_ / work_unit_;
  const auto& powers = system_.powers;
  slope[place(kForcing)] = slope[place(kWeight)] = slope[place(kConstraint)] = 0.0;
  if (system_.frequency > 0.0)
    slope[place(kForcing)] =
        unit / unit_ * cosine * (powers ? powers->forcing : system_.force).dot(velocity);
  if (powers && powers->by_place.size() > 0) {
    const Eigen::Map<const Vector> moved(z.data(), n);
    slope[place(kForcing)] +=
        unit * velocity.dot(powers->by_place * (from_ / unit_ + moved.cwiseQuotient(scale_)) +
                            powers->by_rate * velocity);
  }
  slope[place(kDissipation)] =
      unit * (powers ? velocity.dot(powers->damping * velocity) : velocity.dot(resistance));
  if (!powers) return;
  for (const SprungSystem::Holding& holding : powers->held)
    slope[place(kConstraint)] -=
        unit / unit_ * holding.against.dot(velocity) * observed(holding.force, s, z);
}

inline SprungWorks Sprung::works(const State& z) const {
  SprungWorks works;
  works.moved = unit_ * Eigen::Map<const Vector>(z.data(), modes()).cwiseQuotient(scale_);
  works.forcing = work_unit_ * z[place(kForcing)];
  works.weight = work_unit_ * z[place(kWeight)];
  works.dissipation = work_unit_ * z[place(kDissipation)];
  works.constraint = work_unit_ * z[place(kConstraint)];
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const SprungSystem::Spring& spring = system_.springs[i];
    works.springs.push_back({unit_ * unit_ * z[place(kSprings + i)], 0.0});
    if (spring.loaded)
      works.springs.back().stored =
          spring.law.stored(compression(i, z).depth) - spring.law.stored(contacts_[i].start);
  }
  return works;
}

}  // namespace graze::step_walk
