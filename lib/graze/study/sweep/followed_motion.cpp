#include "graze/study/sweep/detail/followed_motion.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "graze/orbit/search/detail/random_start.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

constexpr std::size_t kQuarters = 4;

// The largest difference in each quarter of the states, in units of the system's scale.
std::array<double, kQuarters> differences(const MotionScale& scale,
                                          const std::vector<State>& period_states, std::size_t p) {
  std::array<double, kQuarters> largest{};
  const std::size_t count = period_states.size() - p;
  for (std::size_t i = 0; i < count; ++i) {
    const State &a = period_states[i], &b = period_states[i + p];
    double& quarter = largest[i * kQuarters / count];
    quarter =
        std::max({quarter, (b.q - a.q).cwiseAbs().maxCoeff() / scale.displacement,
                  ((b.qdot - a.qdot).cwiseAbs().array() / scale.velocity.array()).maxCoeff()});
  }
  return largest;
}

}  // namespace

bool is_nearing(const System& system, const SettledMotion& motion, int longest_period) {
  const MotionScale scale = motion_scale(system);
  for (std::size_t p = 1; p <= static_cast<std::size_t>(longest_period); ++p) {
    if (motion.period_states.size() < (kQuarters + 1) * p) continue;
    const auto largest = differences(scale, motion.period_states, p);
    // Strictly, so that a motion at rest within rounding is not followed further.
    if (std::is_sorted(largest.rbegin(), largest.rend()) && largest.back() < largest.front())
      return true;
  }
  return false;
}

SettledMotion follow_while_nearing(const System& system, const State& start, SettleOptions options,
                                   int longest_period, long long most_periods) {
  SettledMotion motion = settle(system, start, options);
  long long periods = motion.periods, impacts = motion.impacts_met;
  while (motion.kind == SettledKind::kNotPeriodic && periods < most_periods &&
         is_nearing(system, motion, longest_period) && is_clear(system, motion.at_end)) {
    // As many periods again as so far.
    options.periods = std::min(periods, most_periods - periods);
    options.max_impacts -= motion.impacts_met;
    motion = settle(system, State(motion.at_end), options);
    periods += motion.periods;
    impacts += motion.impacts_met;
  }
  motion.periods = periods;
  motion.impacts_met = impacts;
  return motion;
}

}  // namespace graze
