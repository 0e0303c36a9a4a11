// A motion with dry friction, rigid stops and undamped linear springs, integrated in long double:
// Taylor series of the linear equations in short steps, events by bisection, and at each event the
// one state of all friction at rest, of those tried, that contradicts nothing.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "support/systems.hpp"

namespace graze::support {

class FrictionReference {
 public:
  using Real = long double;
  using Reals = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  enum Slides { kBack = -1, kSticks = 0, kOn = 1, kIdle = 2 };  // idle: nothing presses there
  struct Happened {
    double time = 0.0;
    EventKind kind{};
    int index = 0;  // of the stop or the friction
  };

  FrictionReference(const System& system, const State& start)
      : system_(system), n_(system.modes()), q_(start.q.cast<Real>()), v_(start.qdot.cast<Real>()) {
    for (const Stop& stop : system.stops)
      loaded_.push_back(stop.is_compliant() && stop.row.dot(start.q) > stop.gap);
    for (const Friction& one : system.frictions) {
      rows_.push_back(one.row.cast<Real>());
      const Real speed = rows_.back().dot(v_) - Real(one.speed);
      const bool idle = one.stop >= 0 && !loaded_[static_cast<std::size_t>(one.stop)];
      slides_.push_back(idle ? kIdle : speed > 0 ? kOn : speed < 0 ? kBack : kSticks);
    }
    decide(standing());
    events_.clear();
  }

  // Up to `end`, or to where impacts crowd together.
  const std::vector<Happened>& run(Real end) {
    const Real step = Real(0.02) / quickest();
    while (time_ < end && !crowded_) advance(std::min(step, end - time_));
    return events_;
  }
  double time() const { return static_cast<double>(time_); }
  bool crowded() const { return crowded_; }
  const Reals& q() const { return q_; }

 private:
  struct Place {
    Reals q, v;
    Real time;
  };

  Real quickest() const {
    Real rate = system_.forcing() ? Real(system_.forcing()->frequency) : Real(0);
    for (Eigen::Index j = 0; j < n_; ++j)
      rate = std::max<Real>(rate, Real(system_.omega[j]) + 2 * Real(system_.delta()[j]));
    for (const Stop& stop : system_.stops)
      if (stop.is_compliant())
        rate += std::sqrt(Real(stop.force().stiffness)) * Real(stop.row.norm());
    return rate;
  }
  Reals loads(Real time) const {
    Reals sum = Reals::Zero(n_);
    if (system_.load()) sum += system_.load()->cast<Real>();
    if (const HarmonicForcing* forcing = system_.forcing())
      sum += forcing->amplitude.cast<Real>() *
             std::cos(Real(forcing->frequency) * time + Real(forcing->phase));
    for (std::size_t k = 0; k < rows_.size(); ++k)
      if (system_.frictions[k].stop < 0)
        sum -= Real(slides_[k]) * Real(system_.frictions[k].sliding) * rows_[k];
    return sum;
  }
  // The row of a spring with what slides there.
  Reals pushing(std::size_t stop, Reals row) const {
    for (std::size_t k = 0; k < rows_.size(); ++k)
      if (system_.frictions[k].stop == static_cast<int>(stop) && slides_[k] != kIdle)
        row += Real(slides_[k]) * Real(system_.frictions[k].sliding) * rows_[k];
    return row;
  }
  // Up to which a friction sticks, N.
  Real limit(std::size_t k, const Reals& q) const {
    const Friction& one = system_.frictions[k];
    if (one.stop < 0) return Real(one.sticking);
    const Stop& stop = system_.stops[static_cast<std::size_t>(one.stop)];
    return Real(one.sticking) * Real(stop.force().stiffness) *
           (stop.row.cast<Real>().dot(q) - Real(stop.gap));
  }
  // Of compressed springs, by places counted from these gaps, or from 0.
  Reals pushed(const Reals& q, bool from_gaps) const {
    Reals push = Reals::Zero(n_);
    for (std::size_t i = 0; i < loaded_.size(); ++i) {
      if (!loaded_[i]) continue;
      const Stop& stop = system_.stops[i];
      const Reals row = stop.row.cast<Real>();
      push -= Real(stop.force().stiffness) * (row.dot(q) - (from_gaps ? Real(stop.gap) : Real(0))) *
              pushing(i, row);
    }
    return push;
  }
  Reals free_acceleration(const Reals& q, const Reals& v, Real time) const {
    return pushed(q, true) + loads(time) - 2 * system_.delta().cast<Real>().cwiseProduct(v) -
           system_.omega.cast<Real>().cwiseAbs2().cwiseProduct(q);
  }
  std::vector<std::size_t> sticking() const {
    std::vector<std::size_t> list;
    for (std::size_t k = 0; k < slides_.size(); ++k)
      if (slides_[k] == kSticks) list.push_back(k);
    return list;
  }
  RealMatrix rows_of(const std::vector<std::size_t>& list) const {
    RealMatrix rows(n_, static_cast<Eigen::Index>(list.size()));
    for (std::size_t a = 0; a < list.size(); ++a)
      rows.col(static_cast<Eigen::Index>(a)) = rows_[list[a]];
    return rows;
  }
  // Forces of what sticks, N, in its order.
  Reals held_forces(const Place& at) const {
    const RealMatrix rows = rows_of(sticking());
    if (rows.cols() == 0) return {};
    return RealMatrix(rows.transpose() * rows)
        .fullPivLu()
        .solve(Reals(rows.transpose() * free_acceleration(at.q, at.v, at.time)));
  }
  // Derivatives of all orders follow from the two before.
  Place after(Real s) const {
    const RealMatrix rows = rows_of(sticking());
    const RealMatrix gram = rows.transpose() * rows;
    const auto held = [&](Reals force) -> Reals {
      if (rows.cols() == 0) return force;
      return force - rows * gram.fullPivLu().solve(Reals(rows.transpose() * force));
    };
    const HarmonicForcing* forcing = system_.forcing();
    const Real w = forcing ? Real(forcing->frequency) : Real(0);
    const Real theta = forcing ? w * time_ + Real(forcing->phase) : Real(0);
    Reals before = q_, now = v_;
    Place place{q_, v_, time_ + s};
    Real power = 1, rate = 1;  // s^k/k!, w^k
    place.q += s * v_;
    for (int k = 0; k < 24; ++k) {
      Reals force = pushed(before, k == 0) - 2 * system_.delta().cast<Real>().cwiseProduct(now) -
                    system_.omega.cast<Real>().cwiseAbs2().cwiseProduct(before);
      if (forcing) {
        const Real quarter[] = {std::cos(theta), -std::sin(theta), -std::cos(theta),
                                std::sin(theta)};
        force += forcing->amplitude.cast<Real>() * (rate * quarter[k % 4]);
      }
      if (k == 0) {
        force += system_.load() ? Reals(system_.load()->cast<Real>()) : Reals(Reals::Zero(n_));
        for (std::size_t i = 0; i < rows_.size(); ++i)
          if (system_.frictions[i].stop < 0)
            force -= Real(slides_[i]) * Real(system_.frictions[i].sliding) * rows_[i];
      }
      const Reals next = held(force);
      power *= s / (k + 1);
      rate *= w;
      place.v += power * next;
      place.q += power * s / (k + 2) * next;
      before = now;
      now = next;
    }
    return place;
  }
  // What must stay positive: gaps of stops, speeds of sliding, what is left of limits (both signs).
  std::vector<Real> margins(const Place& at) const {
    std::vector<Real> list;
    for (std::size_t i = 0; i < loaded_.size(); ++i) {
      const Stop& stop = system_.stops[i];
      list.push_back((loaded_[i] ? Real(-1) : Real(1)) *
                     (Real(stop.gap) - stop.row.cast<Real>().dot(at.q)));
    }
    const Reals forces = held_forces(at);
    Eigen::Index held = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const Friction& one = system_.frictions[k];
      if (slides_[k] == kSticks) {
        list.push_back(limit(k, at.q) - forces[held]);
        list.push_back(limit(k, at.q) + forces[held++]);
      } else if (slides_[k] == kIdle) {
        list.push_back(1);
        list.push_back(1);
      } else {
        list.push_back(Real(slides_[k]) * (rows_[k].dot(at.v) - Real(one.speed)));
        list.push_back(1);
      }
    }
    return list;
  }
  int first_negative(const Place& at) const {
    const std::vector<Real> list = margins(at);
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i] < 0 && !ignored_[i]) return static_cast<int>(i);
    return -1;
  }
  void advance(Real step) {
    ignored_.assign(system_.stops.size() + 2 * rows_.size(), false);
    // What has just begun at zero is looked at once it is positive, a short step later.
    const std::vector<Real> here = margins({q_, v_, time_});
    Real next = step;
    const Real least = std::sqrt(std::numeric_limits<Real>::epsilon()) * 100;
    for (std::size_t i = 0; i < here.size(); ++i)
      if (here[i] < least) {
        const std::vector<Real> soon = margins(after(step / 1024));
        ignored_[i] = soon[i] < here[i] ? false : true;
        if (ignored_[i]) next = step / 512;
      }
    step = next;
    const Place end = after(step);
    if (first_negative(end) < 0) {
      move(end);
      return;
    }
    Real low = 0, high = step;
    for (int i = 0; i < 90; ++i) {
      const Real middle = low + (high - low) / 2;
      (first_negative(after(middle)) < 0 ? low : high) = middle;
    }
    const int which = first_negative(after(high));
    move(after(high));
    happen(which);
  }
  void move(const Place& place) {
    q_ = place.q;
    v_ = place.v;
    time_ = place.time;
  }
  void happen(int which) {
    const auto stops = static_cast<int>(system_.stops.size());
    if (which < stops && system_.stops[static_cast<std::size_t>(which)].is_compliant()) {
      const auto i = static_cast<std::size_t>(which);
      loaded_[i] = !loaded_[i];
      for (std::size_t k = 0; k < rows_.size(); ++k) {
        if (system_.frictions[k].stop != which) continue;
        const Real speed = rows_[k].dot(v_) - Real(system_.frictions[k].speed);
        slides_[k] = !loaded_[i] ? kIdle : speed > 0 ? kOn : kBack;
      }
      return note(loaded_[i] ? EventKind::kContact : EventKind::kSeparation, which);
    }
    if (which < stops) return impact(which);
    const auto k = static_cast<std::size_t>((which - stops) / 2);
    if (slides_[k] == kSticks) {
      slides_[k] = (which - stops) % 2 == 0 ? kOn : kBack;
      note(EventKind::kSlip, static_cast<int>(k));
      if (system_.frictions[k].sliding != system_.frictions[k].sticking) decide(sticking());
      return;
    }
    std::vector<std::size_t> list = sticking();
    list.push_back(k);
    decide(list);
  }
  void impact(int i) {
    const Stop& stop = system_.stops[static_cast<std::size_t>(i)];
    const Reals row = stop.row.cast<Real>();
    const Real speed = row.dot(v_);
    crowded_ = time_ - last_impact_ < Real(0.1) / quickest() || speed < Real(1e-5);
    last_impact_ = time_;
    v_ -= (1 + Real(stop.restitution().at_rest())) * speed * stop.direction().cast<Real>();
    note(EventKind::kImpact, i);
    std::vector<std::size_t> still;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (slides_[k] == kIdle) continue;
      const Real slip = rows_[k].dot(v_) - Real(system_.frictions[k].speed);
      if (std::abs(slip) < Real(1e-16)) {
        still.push_back(k);
        continue;
      }
      const Slides now = slip > 0 ? kOn : kBack;
      if (now != slides_[k])
        note(slides_[k] == kSticks ? EventKind::kSlip : EventKind::kReversal, static_cast<int>(k));
      slides_[k] = now;
    }
    if (!still.empty()) decide(still);
  }
  std::vector<std::size_t> standing() const { return sticking(); }
  // Tries the states of these until one fits, those that stick most first.
  void decide(std::vector<std::size_t> list) {
    const std::vector<Slides> before = slides_;
    int all = 1;
    for (std::size_t a = 0; a < list.size(); ++a) all *= 3;
    std::vector<std::pair<int, int>> order;  // how many slide, which trial
    for (int trial = 0; trial < all; ++trial) {
      int slide = 0;
      for (int rest = trial, a = 0; a < static_cast<int>(list.size()); ++a, rest /= 3)
        slide += rest % 3 != 0;
      order.push_back({slide, trial});
    }
    std::sort(order.begin(), order.end());
    for (const auto& [count, trial] : order) {
      for (int rest = trial, a = 0; a < static_cast<int>(list.size()); ++a, rest /= 3)
        slides_[list[static_cast<std::size_t>(a)]] = rest % 3 == 0   ? kSticks
                                                     : rest % 3 == 1 ? kOn
                                                                     : kBack;
      if (fits(list)) break;
    }
    for (const std::size_t k : list) {
      if (slides_[k] == before[k]) continue;
      note(slides_[k] == kSticks  ? EventKind::kFrictionStick
           : before[k] == kSticks ? EventKind::kSlip
                                  : EventKind::kReversal,
           static_cast<int>(k));
    }
    // What sticks has the speed of its belt.
    const std::vector<std::size_t> held = sticking();
    if (held.empty()) return;
    const RealMatrix rows = rows_of(held);
    Reals off = rows.transpose() * v_;
    for (std::size_t a = 0; a < held.size(); ++a)
      off[static_cast<Eigen::Index>(a)] -= Real(system_.frictions[held[a]].speed);
    v_ -= rows * RealMatrix(rows.transpose() * rows).fullPivLu().solve(off);
  }
  bool fits(const std::vector<std::size_t>& list) const {
    const Place at{q_, v_, time_};
    const Reals forces = held_forces(at);
    const std::vector<std::size_t> held = sticking();
    for (std::size_t a = 0; a < held.size(); ++a)
      if (std::abs(forces[static_cast<Eigen::Index>(a)]) > limit(held[a], q_) + Real(1e-15))
        return false;
    Reals acceleration = free_acceleration(q_, v_, time_);
    if (!held.empty()) acceleration -= rows_of(held) * forces;
    return std::all_of(list.begin(), list.end(), [&](std::size_t k) {
      return slides_[k] == kSticks || Real(slides_[k]) * rows_[k].dot(acceleration) > 0;
    });
  }
  void note(EventKind kind, int index) {
    events_.push_back({static_cast<double>(time_), kind, index});
  }

  const System& system_;
  Eigen::Index n_;
  Reals q_, v_;
  Real time_ = 0, last_impact_ = -1;
  bool crowded_ = false;
  std::vector<Reals> rows_;
  std::vector<Slides> slides_;
  std::vector<bool> ignored_, loaded_;
  std::vector<Happened> events_;
};

}  // namespace graze::support
