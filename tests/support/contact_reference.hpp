// Motions against rigid stops and springs, several at once, integrated independently of the
// library: Gragg's and Bulirsch's extrapolation in plain steps, events where what lasts ceases to
// be positive, and after each event every contact judged from the start, by the laws alone. Impacts
// along the rows; at most two rigid stops. It says up to where it is sure: not beyond impacts that
// are slow or coincide, or forces that nearly vanish where they are judged.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "graze/motion/run_events.hpp"
#include "support/contact_motion.hpp"

namespace graze::support {

class ContactReference : private ContactMotion {
 public:
  struct Met {
    EventKind kind;
    double time;
    int stop;
  };

  using ContactMotion::ContactMotion;

  // The events until then, or until `most` of them or sure_until().
  const std::vector<Met>& run(double until, std::size_t most) {
    while (is_sure_ && time_ < until && events_.size() < most) step(until);
    sure_until_ = time_;
    return events_;
  }
  double sure_until() const { return sure_until_; }
  // Springs that an impact made let go, and grip; stops that opened as a spring was entered or
  // left.
  std::array<int, 3> coverage{};

 private:
  // What is positive while the contacts last.
  struct Watch {
    enum What { kGap, kForce, kDepth, kGrip, kSlack } what;
    int stop;
  };

  std::vector<Watch> watches() const {
    std::vector<Watch> list;
    for (int i = 0; i < stops(); ++i) {
      if (!stop(i).is_compliant()) {
        list.push_back({held_[at(i)] ? Watch::kForce : Watch::kGap, i});
        continue;
      }
      const Spring spring = springs_[at(i)];
      list.push_back({spring == kOpen ? Watch::kGap : Watch::kDepth, i});
      if (spring != kOpen && lets_go(i))
        list.push_back({spring == kLoaded ? Watch::kGrip : Watch::kSlack, i});
    }
    return list;
  }
  double value(const Watch& watch, double t, const Vector& y) const {
    switch (watch.what) {
      case Watch::kGap:
        return -depth(watch.stop, y);
      case Watch::kDepth:
        return depth(watch.stop, y);
      case Watch::kGrip:
        return grip(watch.stop, y);
      case Watch::kSlack:
        return -grip(watch.stop, y);
      case Watch::kForce: {
        const std::vector<int> on = held();
        const Vector f = forces(t, y, on);
        return f[std::find(on.begin(), on.end(), watch.stop) - on.begin()];
      }
    }
    return 0.0;
  }
  // Along the motion; its sign is what is asked for.
  double slope(const Watch& watch, double t, const Vector& y) const {
    if (watch.what == Watch::kGap) return -speed(watch.stop, y);
    if (watch.what == Watch::kDepth) return speed(watch.stop, y);
    constexpr double kSpan = 1e-6;
    const Vector along = kSpan * rate(t, y);
    return (value(watch, t + kSpan, y + along) - value(watch, t - kSpan, y - along)) /
           (2.0 * kSpan);
  }

  // By secants that keep the zero between them, the end that stays halved (Illinois); bisected
  // where both ends have one sign, as of what rises from zero.
  template <class Of>
  static double zero_between(const Of& of, double from, double to) {
    double first = of(from), last = of(to);
    if ((first > 0.0) == (last > 0.0)) first = -last;
    for (int i = 0, side = 0; i < 100 && to - from > 4e-16 * to; ++i) {
      double middle = to - last * (to - from) / (last - first);
      if (!(middle > from && middle < to)) middle = 0.5 * (from + to);
      const double value = of(middle);
      if (value == 0.0) return middle;
      if ((value > 0.0) == (last > 0.0)) {
        to = middle;
        last = value;
        if (side == 1) first *= 0.5;
        side = 1;
      } else {
        from = middle;
        first = value;
        if (side == -1) last *= 0.5;
        side = -1;
      }
    }
    return to;
  }

  // The first zero of a watch in (0, h]; none: infinity.
  double zero_within(const Watch& watch, double h, const Vector& end) const {
    const double last = value(watch, time_ + h, end), falls = slope(watch, time_ + h, end);
    const double starts = slope(watch, time_, y_);
    const bool from_zero = is_from_zero(watch);
    const auto at_time = [&](double s) { return value(watch, time_ + s, moved(s)); };
    const auto slope_at = [&](double s) { return slope(watch, time_ + s, moved(s)); };
    if (last > 0.0) {
      if (from_zero || !(starts < 0.0 && falls > 0.0))
        return std::numeric_limits<double>::infinity();
      const double least = zero_between(slope_at, 0.0, h);
      return at_time(least) > 0.0 ? std::numeric_limits<double>::infinity()
                                  : zero_between(at_time, 0.0, least);
    }
    return zero_between(at_time, from_zero ? zero_between(slope_at, 0.0, h) : 0.0, h);
  }
  // What an event has left at zero is positive next.
  bool is_from_zero(const Watch& watch) const {
    return left_at_ == time_ && std::any_of(left_.begin(), left_.end(), [&](const Watch& left) {
             return left.stop == watch.stop && left.what == watch.what;
           });
  }

  void step(double until) {
    double h = std::fmin(next_, std::fmin(longest_step(), until - time_)), error = 0.0;
    if (!(time_ + h > time_)) {
      time_ = until;
      return;
    }
    Vector end = moved(h, &error);
    while (error > 1e-14 && h > 1e-9) {
      h *= 0.5;
      end = moved(h, &error);
    }
    next_ = 2.0 * h;
    const std::vector<Watch> list = watches();
    const Watch* met = nullptr;
    double first = std::numeric_limits<double>::infinity(), second = first;
    for (const Watch& watch : list) {
      const double zero = zero_within(watch, h, end);
      if (zero < first) {
        second = first;
        first = zero;
        met = &watch;
      } else {
        second = std::fmin(second, zero);
      }
    }
    if (!met) {
      time_ += h;
      y_ = end;
      return;
    }
    y_ = moved(first);
    time_ += first;
    if (!(second > first + 1e-7)) return give_up();
    meet(*met);
    // What follows at once is not passed over.
    next_ = 1e-4;
  }

  void give_up() { is_sure_ = false; }
  void tell(EventKind kind, int i) { events_.push_back({kind, time_, i}); }
  void leave(int i, Watch::What as) {
    if (left_at_ != time_) left_.clear();
    left_at_ = time_;
    left_.push_back({as, i});
  }

  void meet(const Watch& watch) {
    const int i = watch.stop;
    const std::size_t told = events_.size();
    if (!stop(i).is_compliant()) {
      if (watch.what == Watch::kForce) {
        tell(EventKind::kRelease, i);
        held_[at(i)] = false;
        return leave(i, Watch::kGap);
      }
      return hit(i);
    }
    Spring& spring = springs_[at(i)];
    if (std::abs(speed(i, y_)) < kSlow &&
        (watch.what == Watch::kGap || watch.what == Watch::kDepth))
      return give_up();
    switch (watch.what) {
      case Watch::kGap:
        spring = kLoaded;
        tell(EventKind::kContact, i);
        leave(i, Watch::kDepth);
        break;
      case Watch::kDepth:
        if (spring == kLoaded) tell(EventKind::kSeparation, i);
        spring = kOpen;
        leave(i, Watch::kGap);
        break;
      case Watch::kGrip:
        if (!(depth(i, y_) > kSlow * kSlow)) return give_up();
        tell(EventKind::kSeparation, i);
        spring = kParted;
        return leave(i, Watch::kSlack);
      case Watch::kSlack:
        tell(EventKind::kContact, i);
        spring = kLoaded;
        return leave(i, Watch::kGrip);
      case Watch::kForce:
        break;
    }
    share_out(held());
    if (events_.size() > told + 1) ++coverage[2];
  }

  // With b.q' = 0 where it is held; what would pull lets go.
  void hit(int i) {
    const double v = speed(i, y_), r = stop(i).restitution().at(v);
    if (v < (r > 0.0 ? 10.0 : 1.0) * kSlow) return give_up();
    std::vector<int> on = held();
    on.push_back(i);
    const auto jump = [&](const std::vector<int>& which) {
      Vector target = Vector::Zero(static_cast<Eigen::Index>(which.size()));
      target[target.size() - 1] = -r * v;
      return impulses(which, y_.tail(n()), target);
    };
    Vector p = jump(on);
    tell(EventKind::kImpact, i);
    if (on.size() == 2 && !(p[0] > kSlow * v)) return give_up();
    for (std::size_t k = 0; k < on.size(); ++k)
      y_.tail(n()) -= p[static_cast<Eigen::Index>(k)] * stop(on[k]).row;
    leave(i, Watch::kGap);
    for (int k = 0; k < stops(); ++k) judge_spring(k);
    on = held();
    if (r == 0.0) on.push_back(i);
    share_out(on);
  }

  void judge_spring(int k) {
    Spring& spring = springs_[at(k)];
    if (spring == kOpen || !lets_go(k)) return;
    if (std::abs(grip(k, y_)) < kSlow) return give_up();
    const Spring now = grip(k, y_) > 0.0 ? kLoaded : kParted;
    if (now == spring) return;
    tell(now == kLoaded ? EventKind::kContact : EventKind::kSeparation, k);
    ++coverage[now == kLoaded ? 1 : 0];
    spring = now;
  }

  // Which of these stops hold the structure from now on: forces >= 0, and accelerations into the
  // others <= 0.
  void share_out(const std::vector<int>& on) {
    if (on.empty()) return;
    for (int kept = (1 << on.size()) - 1; kept >= 0; --kept) {
      std::vector<int> holding;
      for (std::size_t k = 0; k < on.size(); ++k)
        if (kept & (1 << k)) holding.push_back(on[k]);
      Vector a = free_acceleration(time_, y_);
      bool fits = true;
      if (!holding.empty()) {
        const Vector f = forces(time_, y_, holding);
        for (std::size_t k = 0; k < holding.size(); ++k) {
          const double one = f[static_cast<Eigen::Index>(k)];
          fits = fits && one > 0.0;
          if (std::abs(one) < kSlow) return give_up();
          a -= one * stop(holding[k]).row;
        }
      }
      for (std::size_t k = 0; k < on.size(); ++k)
        if (!(kept & (1 << k))) {
          const double into = stop(on[k]).row.dot(a);
          fits = fits && into < 0.0;
          if (std::abs(into) < kSlow) return give_up();
        }
      if (!fits) continue;
      for (std::size_t k = 0; k < on.size(); ++k) {
        const bool now = (kept & (1 << k)) != 0;
        if (now != held_[at(on[k])]) tell(now ? EventKind::kStick : EventKind::kRelease, on[k]);
        if (!now && held_[at(on[k])]) leave(on[k], Watch::kGap);
        held_[at(on[k])] = now;
      }
      return;
    }
    give_up();
  }

  static constexpr double kSlow = 2e-3;
  double next_ = std::numeric_limits<double>::infinity(), sure_until_ = 0.0;
  std::vector<Met> events_;
  bool is_sure_ = true;
  std::vector<Watch> left_;  // at zero, by the last event
  double left_at_ = -1.0;
};

}  // namespace graze::support
