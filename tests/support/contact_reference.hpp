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
#include "graze/system/system.hpp"

namespace graze::support {

class ContactReference {
 public:
  struct Met {
    EventKind kind;
    double time;
    int stop;
  };

  ContactReference(const System& system, const State& start)
      : system_(system), held_(system.stops.size(), false), springs_(system.stops.size(), kOpen) {
    y_.resize(2 * system.modes());
    y_ << start.q, start.qdot;
    for (int i = 0; i < stops(); ++i)
      if (stop(i).is_compliant() && depth(i, y_) > 0.0)
        springs_[at(i)] = holds(i, y_) ? kLoaded : kParted;
  }

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
  enum Spring { kOpen, kLoaded, kParted };
  // What is positive while the contacts last.
  struct Watch {
    enum What { kGap, kForce, kDepth, kGrip, kSlack } what;
    int stop;
  };

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int stops() const { return static_cast<int>(system_.stops.size()); }
  const Stop& stop(int i) const { return system_.stops[at(i)]; }
  int n() const { return system_.modes(); }
  double depth(int i, const Vector& y) const { return stop(i).row.dot(y.head(n())) - stop(i).gap; }
  double speed(int i, const Vector& y) const { return stop(i).row.dot(y.tail(n())); }

  static double damping_over_power(const ContactForce& law, double x) {
    switch (law.damping) {
      case ContactDamping::kConstant:
        return law.coefficient;
      case ContactDamping::kOnset:
        return law.coefficient *
               std::exp(std::min(2.0 * law.onset_sharpness * (x / law.onset_depth - 1.0), 0.0));
      case ContactDamping::kDepth:
      case ContactDamping::kPower:
        return law.coefficient;
      case ContactDamping::kNone:
        break;
    }
    return 0.0;
  }
  // F over the power of x that all terms hold.
  double grip(int i, const Vector& y) const {
    const ContactForce& law = stop(i).force();
    const double x = std::fmax(depth(i, y), 0.0), v = speed(i, y);
    const double damped = damping_over_power(law, x) * v;
    if (law.damping == ContactDamping::kDepth)
      return law.stiffness * std::pow(x, law.exponent - 1.0) + damped;
    if (law.damping == ContactDamping::kPower) return law.stiffness + damped;
    return law.stiffness * std::pow(x, law.exponent) + damped;
  }
  double force(int i, const Vector& y) const {
    const ContactForce& law = stop(i).force();
    const double x = std::fmax(depth(i, y), 0.0);
    if (law.damping == ContactDamping::kDepth) return x * grip(i, y);
    if (law.damping == ContactDamping::kPower) return std::pow(x, law.exponent) * grip(i, y);
    return grip(i, y);
  }
  bool lets_go(int i) const {
    const ContactForce& law = stop(i).force();
    return law.separation == Separation::kAtZeroForce && law.damping != ContactDamping::kNone;
  }
  bool holds(int i, const Vector& y) const { return !lets_go(i) || grip(i, y) >= 0.0; }

  Vector free_acceleration(double t, const Vector& y) const {
    Vector a = -system_.omega.cwiseAbs2().cwiseProduct(y.head(n())) -
               2.0 * system_.delta().cwiseProduct(y.tail(n()));
    if (system_.load()) a += *system_.load();
    if (const HarmonicForcing* f = system_.forcing())
      a += f->amplitude * std::cos(f->frequency * t + f->phase);
    for (int i = 0; i < stops(); ++i)
      if (springs_[at(i)] == kLoaded) a -= force(i, y) * stop(i).row;
    return a;
  }
  std::vector<int> held() const {
    std::vector<int> list;
    for (int i = 0; i < stops(); ++i)
      if (held_[at(i)]) list.push_back(i);
    return list;
  }
  // That bring what these stops see of the vector to the targets: D p = seen - target.
  Vector impulses(const std::vector<int>& on, const Vector& of, const Vector& target) const {
    const auto k = static_cast<Eigen::Index>(on.size());
    Matrix d(k, k);
    Vector seen(k);
    for (Eigen::Index a = 0; a < k; ++a) {
      seen[a] = stop(on[static_cast<std::size_t>(a)]).row.dot(of) - target[a];
      for (Eigen::Index b = 0; b < k; ++b)
        d(a, b) = stop(on[static_cast<std::size_t>(a)])
                      .row.dot(stop(on[static_cast<std::size_t>(b)]).row);
    }
    if (k == 1) return seen / d(0, 0);
    const double det = d(0, 0) * d(1, 1) - d(0, 1) * d(1, 0);
    return Vector{{(d(1, 1) * seen[0] - d(0, 1) * seen[1]) / det,
                   (d(0, 0) * seen[1] - d(1, 0) * seen[0]) / det}};
  }
  Vector forces(double t, const Vector& y, const std::vector<int>& on) const {
    return impulses(on, free_acceleration(t, y),
                    Vector::Zero(static_cast<Eigen::Index>(on.size())));
  }
  Vector rate(double t, const Vector& y) const {
    Vector a = free_acceleration(t, y);
    const std::vector<int> on = held();
    if (!on.empty()) {
      const Vector f = forces(t, y, on);
      for (std::size_t k = 0; k < on.size(); ++k)
        a -= f[static_cast<Eigen::Index>(k)] * stop(on[k]).row;
    }
    Vector out(2 * n());
    out << y.tail(n()), a;
    return out;
  }

  // One step of h by Gragg's midpoint rule with 2, 4 .. 12 parts, extrapolated; its error.
  Vector moved(double h, double* error = nullptr) const {
    constexpr int kRows = 6;
    std::array<Vector, kRows> table;
    Vector before;
    const Vector first = rate(time_, y_);
    for (int row = 0; row < kRows; ++row) {
      const int parts = 2 * (row + 1);
      const double part = h / parts;
      Vector a = y_, b = y_ + part * first;
      for (int k = 1; k < parts; ++k) {
        const Vector c = a + 2.0 * part * rate(time_ + k * part, b);
        a = b;
        b = c;
      }
      Vector value = 0.5 * (a + b + part * rate(time_ + h, b));
      for (int column = 1; column <= row; ++column) {
        const double ratio = (row + 1.0) / (row + 1.0 - column);
        const Vector next =
            value + (value - table[static_cast<std::size_t>(column - 1)]) / (ratio * ratio - 1.0);
        table[static_cast<std::size_t>(column - 1)] = value;
        value = next;
      }
      if (row == kRows - 1) before = table[kRows - 2];
      table[static_cast<std::size_t>(row)] = value;
    }
    const Vector& end = table[kRows - 1];
    if (error) *error = (end - before).norm() / (1.0 + end.norm());
    return end;
  }

  double longest_step() const {
    double quickest = system_.omega.maxCoeff();
    if (system_.forcing()) quickest = std::fmax(quickest, system_.forcing()->frequency);
    for (int i = 0; i < stops(); ++i)
      if (springs_[at(i)] != kOpen) {
        const ContactForce& law = stop(i).force();
        const double mobility = stop(i).row.squaredNorm();
        quickest += std::sqrt(law.exponent * law.stiffness * mobility) + law.coefficient * mobility;
      }
    return 1.0 / quickest;
  }

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
  const System& system_;
  double time_ = 0.0, next_ = std::numeric_limits<double>::infinity(), sure_until_ = 0.0;
  Vector y_;
  std::vector<bool> held_;
  std::vector<Spring> springs_;
  std::vector<Met> events_;
  bool is_sure_ = true;
  std::vector<Watch> left_;  // at zero, by the last event
  double left_at_ = -1.0;
};

}  // namespace graze::support
