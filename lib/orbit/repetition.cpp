#include "graze/orbit/repetition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "graze/orbit/passage.hpp"
#include "graze/orbit/shooting.hpp"

namespace graze {
namespace {

constexpr double kRepeats = 1e-6;
constexpr int kRepetitions = 3;

struct PeriodStart {
  State state;
  bool sticks = false;  // during the period that ends here
};

}  // namespace

Repetition find_repetition(const System& system, const State& start,
                           const RepetitionOptions& options) {
  const ShootingScale scale = shooting_scale(system);
  const auto distance = [&](const State& a, const State& b) {
    return std::max((a.q - b.q).cwiseAbs().maxCoeff() / scale.displacement,
                    (a.qdot - b.qdot).cwiseQuotient(scale.velocity).cwiseAbs().maxCoeff());
  };
  Repetition result;
  std::deque<PeriodStart> starts{{start, false}};  // the latest first
  const auto repeats = [&](std::size_t p) {
    if (starts.size() <= kRepetitions * p) return false;
    for (std::size_t k = 1; k <= kRepetitions; ++k)
      if (distance(starts.front().state, starts[k * p].state) > kRepeats) return false;
    return true;
  };
  bool sticks = false;
  PassageOptions passage;
  passage.closure_speed = options.closure_speed;
  passage.max_impacts = options.max_impacts;
  passage.stop = options.stop;
  passage.keep_impacts = false;
  passage.flight = [&](const ContactPhase<double>& phase, const Instant<double>&, double) {
    sticks = sticks || !phase.closed().empty();
  };
  passage.period_start = [&](const MotionState<double>& now) {
    starts.push_front({{now.q, now.qdot}, sticks});
    sticks = false;
    const auto most = static_cast<std::size_t>(kRepetitions * options.longest_period + 1);
    if (starts.size() > most) starts.pop_back();
    for (int p = 1; p <= options.longest_period && result.period == 0; ++p)
      if (repeats(static_cast<std::size_t>(p))) result.period = p;
    return result.period == 0;
  };
  const Passage passed = pass(system, Motion<double>(system, {}, start.q, start.qdot).state(),
                              {options.periods, 0.0}, passage);
  if (result.period == 0) {
    result.why_not = !passed.failure.empty()
                         ? passed.failure
                         : fmt::format(
                               "nothing of up to {} forcing periods repeats within {} "
                               "periods",
                               options.longest_period, options.periods);
    return result;
  }
  const auto p = static_cast<std::size_t>(result.period);
  result.at_start = starts[p].state;
  for (std::size_t k = 0; k < p; ++k) result.sticks = result.sticks || starts[k].sticks;
  return result;
}

}  // namespace graze
