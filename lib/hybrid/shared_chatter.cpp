#include "graze/hybrid/shared_chatter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "graze/hybrid/motion.hpp"

namespace graze {
namespace {

// The tail shrinks as its speeds do: at this part of those it began with, what is left of it is
// less than a millionth.
constexpr double kPartLeft = 1.0 / (1 << 20);

// Impacts, contacts made and lost on a tail. A stop's own chatter is summed, so that one round over
// the stops takes ln(kPartLeft)/ln(r) impacts: 62 at r = 0.8, and a hundred rounds bring the speeds
// down to kPartLeft where each leaves 0.87 of them.
constexpr int kMostArrivals = 20000;

// Where more of the speed is left after as many, no end is in sight.
constexpr double kPartInSight = 0.5;

// The coordinates are the impulses' shares: x'' = D^-1 pushes, contact i at D.row(i).x = 0.
System contacts_alone(const SharedChatter& chatter, const Eigen::FullPivLU<Matrix>& factors) {
  const Eigen::Index k = chatter.pushes.size();
  System system;
  system.omega = Vector::Zero(k);
  system.delta = Vector::Zero(k);
  system.load = factors.solve(chatter.pushes);
  for (Eigen::Index i = 0; i < k; ++i)
    system.stops.push_back({chatter.delassus.row(i).transpose(), 0.0, Vector::Unit(k, i),
                            chatter.restitutions[static_cast<std::size_t>(i)]});
  return system;
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

}  // namespace

double speed_left(const SharedChatter& chatter) {
  const Vector forces = chatter.delassus.fullPivLu().solve(chatter.pushes);
  double most = 0.0;
  for (Eigen::Index i = 0; i < forces.size(); ++i)
    most = std::max(most, speed_of(chatter.speeds[i], forces[i], chatter.gaps[i]));
  return most;
}

std::optional<double> time_to_rest(const SharedChatter& chatter, double closure_speed) {
  const auto factors = chatter.delassus.fullPivLu();
  if (!factors.isInvertible()) return {};
  const System system = contacts_alone(chatter, factors);
  if (!(system.load->array() > 0.0).all()) return {};  // one of them would have to pull
  Motion<double> motion(system, {}, -factors.solve(chatter.gaps), factors.solve(chatter.speeds));
  const double first = speed_left(motion, *system.load), least = kPartLeft * first;
  // A fall at no more than the closure speed is over in less than this; longer flights are cut.
  const double flight = 2.0 * closure_speed / chatter.pushes.maxCoeff();
  for (int i = 0; i < kMostArrivals && speed_left(motion, *system.load) > least; ++i) {
    const Arrival<double> arrival = motion.fly(motion.instant().local + flight);
    if (arrival.kind == ArrivalKind::kUndecided || arrival.kind == ArrivalKind::kNotFinite ||
        arrival.kind == ArrivalKind::kRefused)
      return {};
    if (arrival.kind != ArrivalKind::kContact) continue;
    if (!(arrival.speed <= closure_speed)) return {};
    const std::vector<ImpactShare<double>> shares = motion.impact();
    for (const ImpactShare<double>& share : shares) {
      const Restitution& r = system.stops[static_cast<std::size_t>(share.stop)].restitution;
      if (share.hit && share.speed <= least) motion.close_chatter(share.stop, r.at(share.speed));
    }
  }
  const double time = motion.instant().local, left = speed_left(motion, *system.load) / first;
  if (left > kPartInSight) return {};
  // Times shrink with the speeds: in each stretch that leaves this part of the speed, by it.
  return left > kPartLeft ? time / (1.0 - left) : time;
}

}  // namespace graze
