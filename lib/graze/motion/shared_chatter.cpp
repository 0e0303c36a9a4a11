#include "graze/motion/detail/shared_chatter.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/motion/detail/motion.hpp"

namespace graze {
namespace {

// The tail shrinks with its speeds: when they have fallen to this part of the initial ones, less
// than a millionth of it is left.
constexpr double kPartLeft = 1.0 / (1 << 20);

// Most impacts, and contacts made and lost, on a tail. A stop's own chatter is summed, so that one
// round over the stops takes ln(kPartLeft)/ln(r) impacts: 62 at r = 0.8, and a hundred rounds bring
// the speeds down to kPartLeft where each leaves 0.87 of them.
constexpr int kMostArrivals = 20000;

// When more of the speed than this is left after that many, no end is in sight.
constexpr double kPartInSight = 0.5;

// D: how the impulse of each acts on the approach speed at each.
PivotedLu<double> factors_of(const SharedChatter& chatter) {
  return PivotedLu<double>(chatter.rows.transpose() * chatter.directions);
}

// The chatter in orthonormal coordinates of the space that the impulses span, in which parallel
// rows and directions remain parallel.
struct ContactsAlone {
  System system;
  State start;
};
ContactsAlone contacts_alone(const SharedChatter& chatter, const PivotedLu<double>& factors) {
  const Eigen::Index k = chatter.pushes.size();
  const Matrix basis = orthonormal_columns<double>(chatter.directions, k);
  const Matrix rows = basis.transpose() * chatter.rows;
  const Matrix directions = basis.transpose() * chatter.directions;
  ContactsAlone alone;
  alone.system.omega = Vector::Zero(k);
  alone.system.modal().delta = Vector::Zero(k);
  alone.system.modal().load = directions * factors.solve(chatter.pushes);
  for (Eigen::Index i = 0; i < k; ++i)
    alone.system.stops.push_back(
        {rows.col(i), 0.0,
         ImpactLaw{directions.col(i), chatter.restitutions[static_cast<std::size_t>(i)]}});
  alone.start = {-directions * factors.solve(chatter.gaps),
                 directions * factors.solve(chatter.speeds)};
  return alone;
}

double speed_of(double speed, double force, double gap) {
  return std::sqrt(speed * speed + 2.0 * force * std::max(gap, 0.0));
}

double speed_left(const Motion<double>& motion, const Vector& forces) {
  double most = 0.0;
  for (Eigen::Index i = 0; i < forces.size(); ++i) {
    const int stop = static_cast<int>(i);
    most = std::max(most, speed_of(motion.approach_speed(stop), forces[i], motion.gap(stop)));
  }
  return most;
}

double fastest_hit(const std::vector<ImpactShare<double>>& shares) {
  double fastest = 0.0;
  for (const ImpactShare<double>& share : shares)
    if (share.hit) fastest = std::max(fastest, share.speed);
  return fastest;
}

// Sums each stop's own chatter.
void close_each(Motion<double>& motion, const std::vector<ImpactShare<double>>& shares,
                const ContactsAlone& alone) {
  for (const ImpactShare<double>& share : shares) {
    const Restitution& r = alone.system.stops[static_cast<std::size_t>(share.stop)].restitution();
    if (share.hit) motion.close_chatter(share.stop, r.at(share.speed));
  }
}

}  // namespace

double speed_left(const SharedChatter& chatter) {
  const Vector forces = factors_of(chatter).solve(chatter.pushes);
  double most = 0.0;
  for (Eigen::Index i = 0; i < forces.size(); ++i)
    most = std::max(most, speed_of(chatter.speeds[i], forces[i], chatter.gaps[i]));
  return most;
}

std::optional<double> time_to_rest(const SharedChatter& chatter, double closure_speed) {
  const auto factors = factors_of(chatter);
  if (!factors.is_invertible()) return {};
  const Vector forces = factors.solve(chatter.pushes);
  if (!(forces.array() > 0.0).all()) return {};  // one of them would have to pull
  const ContactsAlone alone = contacts_alone(chatter, factors);
  Motion<double> motion(alone.system, {}, alone.start.q, alone.start.qdot);
  const double first = speed_left(motion, forces), least = kPartLeft * first;
  // A fall at no more than the closure speed is over in less than this; longer flights are cut.
  const double flight = 2.0 * closure_speed / chatter.pushes.maxCoeff();
  for (int i = 0; i < kMostArrivals && speed_left(motion, forces) > least; ++i) {
    const Arrival<double> arrival = motion.fly(motion.instant().local + flight);
    if (arrival.fails()) return {};
    if (arrival.kind != ArrivalKind::kContact) continue;
    if (!(arrival.speed <= closure_speed)) return {};
    const std::vector<ImpactShare<double>> shares = motion.impact();
    if (fastest_hit(shares) <= least && !motion.rest_together(least))
      close_each(motion, shares, alone);
  }
  const double time = motion.instant().local, left = speed_left(motion, forces) / first;
  if (left > kPartInSight) return {};
  // Times shrink in proportion to the speeds, so the rest is a geometric series.
  return left > kPartLeft ? time / (1.0 - left) : time;
}

}  // namespace graze
