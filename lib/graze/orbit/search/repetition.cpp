#include "graze/orbit/search/repetition.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/system/scale.hpp"

namespace graze {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Differences this small, in units of the motion, are the rounding of some hundred operations a
// period.
constexpr double kRounding = 1024.0 * std::numeric_limits<double>::epsilon();

double beyond_rounding(double difference, double rounding) {
  return difference > rounding ? difference : 0.0;
}

// Rounding of the phases and relative speeds of two impacts whose speeds sum to `speeds`; `speed`
// is their scale. An impact speed is a difference of forced velocities and has their rounding; the
// smaller it is, the less its instant is known.
double impact_rounding(double speeds, double speed) { return kRounding * (1.0 + speed / speeds); }

}  // namespace

PeriodHistory::PeriodHistory(const System& system, const State& start, long long most)
    : modes_(system.modes()), scale_(motion_scale(system)), speed_(scale_.speed), most_(most) {
  push_state(period_states_, start.q, start.qdot);
}

void PeriodHistory::push_state(Tail<double>& list, const Vector& q, const Vector& qdot) const {
  for (const double value : q) list.push(value);
  for (const double value : qdot) list.push(value);
}

State PeriodHistory::state(const Tail<double>& list, long long index) const {
  State state{Vector(modes_), Vector(modes_)};
  for (Eigen::Index j = 0; j < modes_; ++j) {
    state.q[j] = list[2 * modes_ * index + j];
    state.qdot[j] = list[2 * modes_ * index + modes_ + j];
  }
  return state;
}

void PeriodHistory::add_impact(const MetImpact& impact, const Vector& q, const Vector& qdot) {
  impacts_.push(impact);
  push_state(before_, q, qdot);
}

void PeriodHistory::end_period(const Vector& q, const Vector& qdot, Contacts contacts) {
  Period period{counted_, static_cast<int>(impacts_.end() - counted_), contacts};
  const bool is_first = periods() == 0;
  first_phases_.push(period.impacts > 0 ? impacts_[counted_].phase
                     : is_first         ? 0.0
                                        : first_phases_[periods() - 1]);
  if (!is_first) period.counts = periods_[periods() - 1].counts << 8;
  period.counts |= static_cast<std::uint64_t>(std::min(period.impacts, 255));
  periods_.push(period);
  counted_ = impacts_.end();
  push_state(period_states_, q, qdot);
  const long long oldest = periods() - most_;
  if (oldest <= periods_.begin()) return;
  periods_.forget_before(oldest);
  first_phases_.forget_before(oldest);
  period_states_.forget_before(2 * modes_ * oldest);
  impacts_.forget_before(periods_[oldest].first);
  before_.forget_before(2 * modes_ * periods_[oldest].first);
}

State PeriodHistory::state_at_start(long long period) const {
  return state(period_states_, period);
}

std::vector<MetImpact> PeriodHistory::impacts_since(long long from) const {
  std::vector<MetImpact> list;
  if (from >= periods()) return list;
  for (long long i = periods_[from].first; i < impacts_.end(); ++i) list.push_back(impacts_[i]);
  return list;
}

long long PeriodHistory::impact_count_since(long long from) const {
  return from < periods() ? impacts_.end() - periods_[from].first : 0;
}

std::vector<State> PeriodHistory::states_before_impacts_since(long long from) const {
  std::vector<State> list;
  if (from >= periods()) return list;
  for (long long i = periods_[from].first; i < impacts_.end(); ++i)
    list.push_back(state(before_, i));
  return list;
}

PeriodHistory::Contacts PeriodHistory::contacts_since(long long from) const {
  Contacts all{false, true};
  for (long long n = from; n < periods(); ++n) {
    all.any = all.any || periods_[n].contacts.any;
    all.sprung = all.sprung || periods_[n].contacts.sprung;
    all.closed = all.closed || periods_[n].contacts.closed;
    all.held = all.held && periods_[n].contacts.held;
  }
  return all;
}

// Difference of the impacts of a period from those p periods before.
double PeriodHistory::impact_difference(long long period, int p) const {
  const Period &now = periods_[period], &then = periods_[period - p];
  if (now.impacts != then.impacts || now.contacts.any != then.contacts.any ||
      now.contacts.held != then.contacts.held)
    return kInfinity;
  double largest = 0.0;
  for (int i = 0; i < now.impacts; ++i) {
    const MetImpact &a = impacts_[then.first + i], &b = impacts_[now.first + i];
    if (a.stop != b.stop) return kInfinity;
    const double speeds = std::abs(a.speed) + std::abs(b.speed);
    const double difference =
        std::max(std::abs(b.phase - a.phase), std::abs(b.speed - a.speed) / speeds);
    largest = std::max(largest, beyond_rounding(difference, impact_rounding(speeds, speed_)));
  }
  return largest;
}

// Difference of the state at the end of a period from that p periods before.
double PeriodHistory::state_difference(long long period, int p) const {
  const long long now = 2 * modes_ * (period + 1), then = 2 * modes_ * (period + 1 - p);
  double largest = 0.0;
  for (Eigen::Index j = 0; j < modes_; ++j) {
    largest = std::max(largest, std::abs(period_states_[now + j] - period_states_[then + j]) /
                                    scale_.displacement);
    largest = std::max(
        largest, std::abs(period_states_[now + modes_ + j] - period_states_[then + modes_ + j]) /
                     scale_.velocity[j]);
  }
  return beyond_rounding(largest, kRounding);
}

// For most motions a p is ruled out quickly: by the numbers of impacts in the last periods, or by
// the first impact of the latest period that has any, which is among those compared unless p is
// short.
int PeriodHistory::repetition(int longest, int repetitions, double tolerance) const {
  const long long most = std::min<long long>(longest, (periods() - oldest()) / repetitions);
  if (most <= 0) return 0;
  const long long last = periods() - 1;
  const bool any = impacts_.begin() < impacts_.end();
  const long long hit = any ? impacts_[impacts_.end() - 1].period : -1;
  const long long clear = std::min(most, (last - hit) / (repetitions - 1));
  for (int p = 1; p <= clear; ++p)
    if (repeats(p, repetitions, tolerance)) return p;
  if (clear == most) return 0;
  // Two impacts have less rounding than the known one alone.
  const double apart =
      std::max(tolerance, impact_rounding(impacts_[periods_[hit].first].speed, speed_));
  const double phase = first_phases_[last];
  const Eigen::Map<const Eigen::ArrayXd> phases(&first_phases_[last - most], most);
  if (!((phases - phase).abs().minCoeff() <= apart)) return 0;
  const std::uint64_t counts = periods_[last].counts;
  for (int p = static_cast<int>(clear) + 1; p <= most; ++p) {
    if (std::abs(first_phases_[last - p] - phase) > apart) continue;
    const int compared = std::min((repetitions - 1) * p, 8);
    if ((counts ^ periods_[last - p].counts) << (64 - 8 * compared) != 0) continue;
    if (repeats(p, repetitions, tolerance)) return p;
  }
  return 0;
}

bool PeriodHistory::repeats(int p, int repetitions, double tolerance) const {
  const long long now = periods(), from = now - static_cast<long long>(repetitions - 1) * p;
  const bool impacts = impact_count_since(from) > 0;
  // From the newest back: a motion that does not repeat shows it in its last period.
  for (long long n = now - 1; n >= from; --n)
    if (!(impact_difference(n, p) <= tolerance) ||
        (!impacts && !(state_difference(n, p) <= tolerance)))
      return false;
  return true;
}

double PeriodHistory::largest(long long from, long long until, int p) const {
  if (from - p < oldest()) return kInfinity;
  double largest = 0.0;
  for (long long n = from; n < until; ++n)
    largest = std::max({largest, impact_difference(n, p), state_difference(n, p)});
  return largest;
}

double PeriodHistory::difference(int p) const { return largest(periods() - p, periods(), p); }

double PeriodHistory::remaining(int p) const {
  const long long now = periods(), window = static_cast<long long>(kWindow) * p;
  const double late = largest(now - window, now, p);
  if (late == 0.0) return 0.0;
  const double early = largest(now - 2 * window, now - window, p);
  if (!(late < early) || !std::isfinite(early)) return kInfinity;
  const double last = difference(p), before = largest(now - 2LL * p, now - p, p);
  const double latest = before > 0.0 ? std::pow(last / before, kWindow) : 0.0;
  const double ratio = std::max(late / early, latest);
  if (!(ratio < 1.0)) return kInfinity;
  return kWindow * late * ratio / (1.0 - ratio);
}

}  // namespace graze
