// Definitions of motion.hpp: dry friction behind a spring (Friction::Series).
//
//   closed: what rubs sticks, while its spring pulls with no more than the friction;
//   forward, backward: it follows its place, the spring stretched by the whole friction.
#pragma once

#include <cmath>
#include <limits>

#include "graze/motion/detail/motion.hpp"

namespace graze {

// Of the spring in series with friction that slides, m.
template <class Real>
double Motion<Real>::spring_length(int i) const {
  const Friction& friction = system_.friction(i);
  return (pushes(i, true) ? friction.sliding : -friction.sliding) / friction.series->stiffness;
}

// How the pull of springs leaves their limits from here on: where it is at one now, as a power of
// time, and never where the place is held, too.
template <class Real>
void Motion<Real>::note_series() {
  using std::abs;
  for (const int i : frictions_) {
    const Friction& friction = system_.friction(i);
    if (!friction.series || contact(i) != Contact::kClosed) continue;
    const int spring = system_.index_of_following(i);
    const Real pull = Real(friction.series->stiffness) * stop(spring).row.dot(now_.q);
    const Real rounding = 64 * std::numeric_limits<double>::epsilon() * Real(friction.sliding);
    now_.multiplicities[static_cast<std::size_t>(i)] =
        !is_independent(spring, held())                 ? kHeldIdle
        : abs(pull) < Real(friction.sliding) - rounding ? 0
        : pull > 0                                      ? kCameForward
                                                        : kCameBackward;
  }
}

// What rubs behind a spring that pulls with the whole force is as far from its place, and as fast.
template <class Real>
void Motion<Real>::follow(int i) {
  const MetStop& spring = stop(system_.index_of_following(i));
  now_.q += spring.direction * (Real(spring_length(i)) - spring.row.dot(now_.q));
  now_.qdot -= spring.direction * spring.row.dot(now_.qdot);
}

// At a start: the spring pulls with no more than the friction, and what rubs is at rest unless its
// place stretches the spring further. A start of that kind that was solved for misses the limit by
// rounding; what is taken from the motion by beginning at it is of the square of that.
template <class Real>
void Motion<Real>::begin_series(int i) {
  using std::abs;
  const Friction& friction = system_.friction(i);
  const MetStop& spring = stop(system_.index_of_following(i));
  const Real pull = Real(friction.series->stiffness) * spring.row.dot(now_.q);
  const Real speed = approach_speed(i) + spring.row.dot(now_.qdot);  // of its place
  const Real limit = Real(friction.sliding);
  const Real missed = std::sqrt(std::numeric_limits<double>::epsilon()) * limit;
  const bool stretches = pull > 0 ? speed > 0 : speed < 0;
  const bool slides = stretches && abs(pull) >= limit - missed;
  if (slides || abs(pull) > limit) slide(i, pull > 0, 0);
  if (!slides) stand(i);
}

// An impact moves the place alone.
template <class Real>
void Motion<Real>::judge_series(int i, Jumped what) {
  if (contact(i) == Contact::kClear) return begin_series(i);
  if (contact(i) == Contact::kClosed || what != Jumped::kVelocities) return;
  follow(i);
  const Real speed = approach_speed(i);
  if (contact(i) == Contact::kForward ? !(speed > 0) : !(speed < 0)) stand(i);
}

}  // namespace graze
