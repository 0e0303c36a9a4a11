// Every impact obeys its law: v+ = -r(v) v- on a single stop, along its direction and without
// moving the structure; complementarity where several stops are touched.
#include "graze/contact/detail/impulse.hpp"
#include "graze/motion/detail/motion.hpp"
#include "property/scene_property.hpp"

namespace graze {
namespace {

using property::Prepared;
using property::relative;
using property::Summary;

// Roundings of an approach speed: a dot product of eight terms, before and after.
constexpr double kOfSpeed = 1e-14;
constexpr double kOfLength = 1e-12;

struct Before {
  Vector q, qdot;
  std::vector<bool> closed;
};

struct Law {
  double speed = 0.0, after = 0.0, target = 0.0;  // m/s
  double impulse = 0.0;                           // m/s along the stop itself
};

class ImpactCheck {
 public:
  ImpactCheck(const Prepared& prepared, Motion<double>& motion, Summary& summary)
      : system_(prepared.system),
        momentum_(
            std::all_of(prepared.scene.stops.begin(), prepared.scene.stops.end(),
                        [](const SceneStop& stop) { return stop.impulse == Impulse::kMomentum; })),
        motion_(motion),
        summary_(summary),
        reached_(motion.q().cwiseAbs()) {}

  bool is_momentum_law() const { return momentum_; }
  void note_reach() { reached_ = reached_.cwiseMax(motion_.q().cwiseAbs()); }

  // At a contact: applies the impact.
  void check(const Arrival<double>& arrival) {
    check_arrival(arrival);
    Before before{motion_.q(), motion_.qdot(), {}};
    for (std::size_t i = 0; i < system_.stops.size(); ++i)
      before.closed.push_back(motion_.is_closed(static_cast<int>(i)));
    const auto shares = motion_.impact();
    RC_ASSERT(motion_.q() == before.q);
    const Vector& after = motion_.qdot();
    // Velocities that cancel in the sum of several impulses.
    double size = before.qdot.lpNorm<1>() + after.lpNorm<1>();
    for (const auto& share : shares)
      size += share.impulse * stop(share.stop).direction().lpNorm<1>();
    Vector expected = before.qdot;
    for (const auto& share : shares) {
      check_share(share, before, size, shares.size() == 1);
      expected -= share.impulse * stop(share.stop).direction();
    }
    summary_.require("jump off its directions/speed",
                     relative((after - expected).lpNorm<Eigen::Infinity>(), size),
                     shares.size() == 1 ? kOfSpeed : 1e-12, where());
    check_energy(before, shares);
    summary_.count(shares.size() == 1 ? "single impacts" : "impacts on several stops");
  }

 private:
  const Stop& stop(int i) const { return system_.stops[static_cast<std::size_t>(i)]; }
  std::string where() const {
    return fmt::format("at period {} and {:.17g} s", motion_.instant().period,
                       motion_.instant().local);
  }

  void check_arrival(const Arrival<double>& arrival) {
    const Stop& s = stop(arrival.stop);
    const double length = property::length_at(system_, s) + s.row.cwiseAbs().dot(reached_);
    summary_.require("gap at contact/length", relative(std::abs(motion_.gap(arrival.stop)), length),
                     kOfLength, where());
    RC_ASSERT(arrival.speed > 0.0);
  }

  void check_share(const ImpactShare<double>& share, const Before& before, double size,
                   bool alone) {
    const Stop& s = stop(share.stop);
    const bool closed = before.closed[static_cast<std::size_t>(share.stop)];
    Law law;
    law.speed = closed ? 0.0 : s.row.dot(before.qdot);
    law.after = s.row.dot(motion_.qdot());
    law.target = law.speed > 0.0 ? -s.restitution().at(law.speed) * law.speed : 0.0;
    // Where nothing rebounds, in a corner that impacts would never leave or without any room.
    if (!alone && law.target != 0.0 && share.speed_after == 0.0) {
      law.target = 0.0;
      summary_.count("shares without rebound");
    }
    const double unit = s.row.lpNorm<Eigen::Infinity>() * size;
    if (alone) {
      summary_.require("v+ + r v-, single/speed", relative(std::abs(law.after - law.target), unit),
                       kOfSpeed, where());
      return;
    }
    summary_.require("pull of an impact", -share.impulse, 0.0, where());
    summary_.require("v+ + r v-, several/speed", relative(law.after - law.target, unit), 1e-13,
                     where());
    if (share.impulse > 0.0)
      summary_.require("p (v+ + r v-), several/speed",
                       relative(std::abs(law.after - law.target), unit), 1e-13, where());
  }

  // Under the momentum law no impact adds energy, whatever the restitutions: every stop that takes
  // part is approached or at rest, or nothing rebounds.
  void check_energy(const Before& before, const std::vector<ImpactShare<double>>& shares) {
    if (!momentum_) return;
    const double energy = before.qdot.squaredNorm(), after = motion_.qdot().squaredNorm();
    summary_.require(
        shares.size() == 1 ? "energy added/energy, single" : "energy added/energy, several",
        relative(after - energy, energy), 1e-13, where());
  }

  const System& system_;
  const bool momentum_;
  Motion<double>& motion_;
  Summary& summary_;
  Vector reached_;  // by each coordinate, as far as seen
};

TEST(RandomScene, ImpactsObeyTheirLaw) {
  property::for_random_scenes([](const Prepared& prepared, Summary& summary) {
    const double end = property::kPeriods * support::time_unit(prepared);
    Motion<double> motion(prepared.system, {}, prepared.start.q, prepared.start.qdot);
    ImpactCheck impact(prepared, motion, summary);
    const bool forced = prepared.system.repeats();
    summary.count("scenes");
    for (long long impacts = 0; impacts < property::kMostImpacts;) {
      const auto& now = motion.instant();
      if (forced ? static_cast<double>(now.period) >= property::kPeriods : now.local >= end) break;
      const auto arrival = motion.fly(forced ? motion.flow().period() : end);
      impact.note_reach();
      if (arrival.kind == ArrivalKind::kContact) {
        ++impacts;
        impact.check(arrival);
      } else if (arrival.kind == ArrivalKind::kUndecided || arrival.kind == ArrivalKind::kRefused) {
        summary.count(arrival.kind == ArrivalKind::kRefused ? "refused" : "undecided");
        break;
      }
      if (arrival.kind == ArrivalKind::kNotFinite) {
        // Only an oblique law can make the motion grow.
        RC_ASSERT(!impact.is_momentum_law());
        summary.count("grew beyond all numbers");
        break;
      }
    }
  });
}

}  // namespace
}  // namespace graze
