// The record of a motion, forcing period by forcing period: how nearly it repeats, and its distance
// from its limit.
//
// With d_n the difference between one repetition and the next, D is the largest of the last five,
// D' that of the five before. If differences go on shrinking by R = D/D' in five, their sum is at
// most
//
//   remaining = 5 D R/(1 - R),
//
// the distance from the orbit. A multiplier of 0.99 makes it about a hundred times the last
// difference. Five, so that differences that oscillate while they shrink (complex multipliers) do
// not pass for settled where they cross zero; if the last two repetitions shrink by less, their
// ratio counts. Still it is an estimate and no bound: a fast deviation can hide a slow one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "graze/orbit/problem/impact_pattern.hpp"
#include "graze/system/scale.hpp"

namespace graze {

struct MetImpact {
  long long period = 0;  // whole forcing periods before it
  int stop = 0;          // index from 0
  double phase = 0.0;    // frequency t + phase within its period, rad
  double speed = 0.0;    // approach speed, m/s
};

class PeriodHistory {
 public:
  static constexpr int kWindow = 5;  // repetitions whose largest difference counts

  // Contacts of the stops in a period.
  struct Contacts {
    bool any = false;     // a stop was closed or compressed at some time
    bool held = false;    // a stop was closed all the time, without impact or release
    bool sprung = false;  // one was compressed at some time
    bool closed = false;  // one was closed at some time
  };

  // Records at least `most` periods. Requires forcing.
  PeriodHistory(const System& system, const State& start, long long most);

  void add_impact(const MetImpact& impact, const Vector& q, const Vector& qdot);
  // Ends the period, in this state.
  void end_period(const Vector& q, const Vector& qdot, Contacts contacts);

  long long periods() const { return static_cast<long long>(periods_.end()); }
  // The first period that is still recorded.
  long long oldest() const { return periods_.begin(); }
  State state_at_start(long long period) const;
  // The impacts of the periods from `from` on, and the states just before them.
  std::vector<MetImpact> impacts_since(long long from) const;
  long long impact_count_since(long long from) const;
  std::vector<State> states_before_impacts_since(long long from) const;
  Contacts contacts_since(long long from) const;

  // The smallest p up to `longest` after which the motion repeats, or 0: the last `repetitions` (>=
  // 2) times p periods are known, and in them the same stops are hit, at phases (rad) and relative
  // speeds that agree to `tolerance`; without any impact the states do.
  int repetition(int longest, int repetitions, double tolerance) const;
  // The largest difference between the last p periods and those before: of phases (rad), relative
  // speeds, and states in units of the system's scale; 0 within rounding, infinite when other stops
  // are hit or too few periods are recorded.
  double difference(int p) const;
  // The estimate above; infinite when the differences do not shrink or too few periods are
  // recorded.
  double remaining(int p) const;

 private:
  // A list without its dropped beginning; indices count from the first item ever.
  template <class T>
  class Tail {
   public:
    // Reserves as much as most motions need.
    Tail() { items_.reserve(kRoom); }
    void push(const T& item) { items_.push_back(item); }
    const T& operator[](long long i) const { return items_[static_cast<std::size_t>(i - base_)]; }
    long long begin() const { return begin_; }
    long long end() const { return base_ + static_cast<long long>(items_.size()); }
    void forget_before(long long i) {
      begin_ = i;
      // Items are moved only when half of the memory is unused: once in a while.
      if (2 * (begin_ - base_) < static_cast<long long>(items_.size()) + 64) return;
      items_.erase(items_.begin(), items_.begin() + static_cast<std::ptrdiff_t>(begin_ - base_));
      base_ = begin_;
    }

   private:
    static constexpr std::size_t kRoom = 256;
    std::vector<T> items_;
    long long base_ = 0, begin_ = 0;
  };
  struct Period {
    long long first = 0;  // impact
    int impacts = 0;
    Contacts contacts;
    // Numbers of impacts of this period and those before, a byte each, the last one lowest; 255
    // stands for more.
    std::uint64_t counts = 0;
  };

  void push_state(Tail<double>& list, const Vector& q, const Vector& qdot) const;
  State state(const Tail<double>& list, long long index) const;
  bool repeats(int p, int repetitions, double tolerance) const;
  double impact_difference(long long period, int p) const;
  double state_difference(long long period, int p) const;
  double largest(long long from, long long until, int p) const;

  Eigen::Index modes_;
  MotionScale scale_;
  double speed_;  // scale of impact speeds, m/s
  long long most_;
  Tail<Period> periods_;
  // Phase of the first impact of each period, or of the latest period before that has any; 0
  // without.
  Tail<double> first_phases_;
  Tail<MetImpact> impacts_;
  Tail<double> before_;         // 2N numbers an impact
  Tail<double> period_states_;  // 2N numbers a period and one more: at its start
  long long counted_ = 0;       // impacts of the periods that are over
};

}  // namespace graze
