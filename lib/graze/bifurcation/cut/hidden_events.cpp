#include "graze/bifurcation/cut/detail/hidden_events.hpp"

#include <cmath>

#include "graze/continuation/branch/detail/locate.hpp"

namespace graze {
namespace {

// The margin of another solution that corresponds to this one.
const SegmentMargin* partner(const SegmentMargin& margin,
                             const std::vector<SegmentMargin>& others) {
  const SegmentMargin* nearest = nullptr;
  for (const SegmentMargin& other : others) {
    if (other.is_speed != margin.is_speed || other.place != margin.place ||
        other.stop != margin.stop)
      continue;
    if (!nearest || std::abs(other.after - margin.after) < std::abs(nearest->after - margin.after))
      nearest = &other;
  }
  return nearest;
}

}  // namespace

std::optional<std::vector<SegmentMargin>> HiddenEvents::margins(const SolutionPoint& solution) {
  return margins_.answer({solution.u, solution.parameter, solution.tangent},
                         [&] { return equations_.margins(solution, corrector_.range()); });
}

// Interpolants of the quantities that must stay positive between a and b and are known at both.
std::vector<MarginInterpolant> HiddenEvents::interpolants(const SolutionPoint& a,
                                                          const SolutionPoint& b) {
  const std::optional<std::vector<SegmentMargin>> at_a = margins(a), at_b = margins(b);
  if (!at_a || !at_b) return {};
  const Vector chord = corrector_.chord(a, b);
  const double length = chord.norm();
  const double step_a = std::copysign(length, chord.dot(a.tangent)),
               step_b = std::copysign(length, chord.dot(b.tangent));
  const double narrow = still_gap(*equations_.system_at(a.parameter));
  const double still = still_speed(*equations_.system_at(a.parameter));
  std::vector<MarginInterpolant> list;
  for (const SegmentMargin& start : *at_a) {
    const SegmentMargin* end = partner(start, *at_b);
    if (!end || partner(*end, *at_a) != &start) continue;
    double from = start.value, from_rate = start.rate, to = end->value, to_rate = end->rate;
    // Where the map does not depend on the impact, its speed grows as the root of the distance.
    const bool squared = start.is_speed && !equations_.see_impacts();
    if (squared) {
      from_rate *= 2.0 * from;
      to_rate *= 2.0 * to;
      from *= from;
      to *= to;
    }
    list.push_back(MarginInterpolant::between(from, step_a * from_rate, to, step_b * to_rate));
    list.back().rounding = squared ? still * still : start.is_speed ? still : narrow;
  }
  return list;
}

std::optional<SolutionPoint> HiddenEvents::between(const SolutionPoint& a, const SolutionPoint& b,
                                                   const ReleaseReturn& at_a, int& looks) {
  const std::vector<MarginInterpolant> all = interpolants(a, b);
  if (all.empty() || looks-- <= 0 || !all_positive(all, 0.0) || !all_positive(all, 1.0)) return {};
  std::optional<double> part = suspected_sign_change(all);
  // The ends may be on two branches with the same events.
  if (!part && !is_shown(all)) part = 0.5;
  if (!part) return {};
  const Vector predicted = cubic_between(corrector_, a, *part * corrector_.ahead(a, b), a, b);
  std::optional<SolutionPoint> point = corrector_.on_hyperplane(predicted, a.tangent);
  const bool solved = point.has_value();
  if (!solved) {
    const Eigen::Index n = a.u.size();
    point = SolutionPoint{predicted.head(n), predicted[n] * corrector_.range(), {}, 0.0, 0, {}};
  }
  const std::optional<ReleaseReturn> there = equations_.follow(*point);
  if (!there) return {};
  if (!has_same_events(*there, at_a, true)) return point;
  if (!solved) return {};
  if (auto before = between(a, *point, at_a, looks)) return before;
  return between(*point, b, at_a, looks);
}

}  // namespace graze
