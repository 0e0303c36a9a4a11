#include "graze/bifurcation/sticking_borders.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/bifurcation/grazing_value.hpp"
#include "graze/bifurcation/sticking_grazing.hpp"
#include "graze/continuation/locate.hpp"

namespace graze {
namespace {

// A stuck phase that lasts less than this part of a forcing period has shrunk to nothing: what
// 1e-10 of the parameter leaves of it beside CH, (1e-10)^(3/5).
constexpr double kGone = 1e-6;

// Where the contact force touches zero the stop is open for a time that goes as the square root of
// the distance: what 1e-10 of the parameter leaves of it, of a forcing period.
constexpr double kInterrupted = 1e-5;
// An opening as long as this is known to some 1e-6 of its own, of a forcing period.
constexpr double kOpened = 1e-4;

// Points before a border that may be flown once more instead of it, each at least half as far from
// it as the one before.
constexpr int kMostBack = 8;
constexpr int kMostSteps = 400;  // of a bisection that may need two for each of some 100 halvings

// Changes of the itinerary within one step that are looked through. Beside CH the impacts of the
// chatter that does not complete any more vanish one after the other, some thirty in double
// precision.
constexpr int kMostChanges = 64;

// Solutions looked at between two with the same events.
constexpr int kMostLooks = 40;

// Whether both return through the same events.
bool is_like(const ReleaseReturn& back, const ReleaseReturn& other, bool see_impacts) {
  return back.returns && back.holds == other.holds &&
         (!see_impacts || back.itinerary == other.itinerary);
}

// The margin of another solution that this one has become.
const PassageMargin* partner(const PassageMargin& margin,
                             const std::vector<PassageMargin>& others) {
  const PassageMargin* nearest = nullptr;
  for (const PassageMargin& other : others) {
    if (other.is_speed != margin.is_speed || other.place != margin.place ||
        other.stop != margin.stop)
      continue;
    if (!nearest || std::abs(other.after - margin.after) < std::abs(nearest->after - margin.after))
      nearest = &other;
  }
  return nearest;
}

}  // namespace

// As far as the events stay what they are.
struct StickingBorders::Approach {
  std::vector<BranchPoint> reached;  // never empty
  ReleaseReturn last;                // of the last of these
  // Of the nearest solution met beyond, if any.
  std::optional<ReleaseReturn> beyond;
  BranchPoint at_beyond;
  // Orbits beyond, those nearest to the border last.
  std::vector<std::pair<BranchPoint, std::vector<int>>> others;
  bool settled = false;  // to the last digits
};

StickingBorders::StickingBorders(const StickingEquations& equations,
                                 const ContinuationOptions& options)
    : equations_(equations), options_(options), corrector_(equations.problem(), options_) {}

bool StickingBorders::has_shrunk(const ReleaseReturn& back, const BranchPoint& at) const {
  return back.shortest_hold <= kGone * equations_.system_at(at.parameter)->period();
}

// The shortest time for which a stop is let go, s; infinite where none is closed again.
double StickingBorders::shortest_opening(const ReleaseReturn& back, const BranchPoint& at) const {
  const double period = equations_.system_at(at.parameter)->period();
  double shortest = std::numeric_limits<double>::infinity();
  for (const PassedHold& first : back.passage.holds)
    for (const PassedHold& next : back.passage.holds) {
      if (next.from_start || next.stop != first.stop) continue;
      const double open = static_cast<double>(next.from.period - first.to.period) * period +
                          next.from.local - first.to.local;
      if (open >= 0.0) shortest = std::min(shortest, open);
    }
  return shortest;
}

// Whether a stop is let go and closed again at once.
bool StickingBorders::is_interrupted(const ReleaseReturn& back, const BranchPoint& at) const {
  return shortest_opening(back, at) <= kInterrupted * equations_.system_at(at.parameter)->period();
}

// Where the stop is not let go any more, by orbits before that: bisection comes as near as an
// opening that can be told from none.
double StickingBorders::last_opening(const std::vector<BranchPoint>& reached) const {
  std::vector<NearGrazing> near;
  for (const BranchPoint& point : reached)
    if (const auto back = equations_.follow(point))
      near.push_back({point.parameter, shortest_opening(*back, point)});
  const double period = equations_.system_at(reached.back().parameter)->period();
  return grazing_value(near, kOpened * period).value_or(reached.back().parameter);
}

// Whether the structure is let go once a round and held again at once.
bool StickingBorders::is_at_rest(const ReleaseReturn& back, const BranchPoint& at) const {
  const double period = equations_.system_at(at.parameter)->period();
  const int periods = equations_.section().release().period;
  return back.holds.size() == 1 && back.shortest_hold >= (periods - kInterrupted) * period;
}

StickingTip StickingBorders::at_last(const std::vector<BranchPoint>& reached) {
  const BranchPoint& at = reached.back();
  const std::optional<ReleaseReturn> here = equations_.follow(at);
  // Where the equations are solved no further the trace has come as near as it gets.
  if (here && has_shrunk(*here, at))
    return {OrbitBranchEnd::kChatterCompletes, at, false, false, at.parameter, {}};
  return grazing_at(equations_, corrector_, reached, false);
}

// From `a` towards `b` as far as the events stay what they are at `a`.
StickingBorders::Approach StickingBorders::approach(const BranchPoint& a, const BranchPoint& b,
                                                    const ReleaseReturn& at_a, bool see_impacts) {
  const Vector chord = corrector_.difference(corrector_.pack(b), corrector_.pack(a));
  Approach result;
  BranchPoint inside = a;
  if (inside.tangent.dot(chord) < 0.0) inside.tangent *= -1.0;
  result.reached = {inside};
  result.last = at_a;
  result.beyond = equations_.follow(b);
  result.at_beyond = b;
  // Two points nearer than this are one in double precision.
  const double least =
      4.0 * std::numeric_limits<double>::epsilon() * (1.0 + corrector_.pack(a).norm());
  if (result.beyond && result.beyond->returns) result.others.emplace_back(b, result.beyond->holds);
  // Some two steps to a bit; more of them would lead past `b`.
  double h = 0.5 * chord.norm();
  for (int step = 0; h > least && step < kMostSteps && !options_.stop.requested(); ++step) {
    std::optional<BranchPoint> next =
        corrector_.on_hyperplane(corrector_.pack(inside) + h * inside.tangent, inside.tangent);
    const std::optional<ReleaseReturn> back =
        next ? equations_.follow(*next) : std::optional<ReleaseReturn>();
    if (back && is_like(*back, at_a, see_impacts)) {
      inside = *next;
      result.last = *back;
      result.reached.push_back(inside);
      continue;
    }
    if (back) {
      result.beyond = back;
      result.at_beyond = *next;
      if (back->returns) result.others.emplace_back(*next, back->holds);
    }
    h *= 0.5;
  }
  result.settled = h <= least;
  return result;
}

// CH or LO, where the border is one.
StickingTip StickingBorders::completion(Approach& approach, const ReleaseReturn& at_a) const {
  const BranchPoint inside = approach.reached.back();
  const std::optional<ReleaseReturn>& beyond = approach.beyond;
  const bool one_less = has_shrunk(approach.last, inside);
  const bool one_more = beyond && beyond->returns && beyond->holds.size() > at_a.holds.size() &&
                        has_shrunk(*beyond, approach.at_beyond);
  const bool interrupted = is_interrupted(approach.last, inside) ||
                           (beyond && is_interrupted(*beyond, approach.at_beyond));
  if ((!one_less && !one_more && !interrupted) || !approach.settled) return {};
  const bool closes = !one_less && !one_more && is_interrupted(approach.last, inside);
  const double value = closes ? last_opening(approach.reached) : inside.parameter;
  std::optional<BranchPoint> other;
  const auto& others = approach.others;
  for (auto known = others.rbegin(); known != others.rend(); ++known) {
    if (known->second.size() == at_a.holds.size() || known->second != others.back().second) break;
    other = known->first;
  }
  // On the border itself rounding may decide otherwise when the orbit is flown once more.
  std::vector<BranchPoint>& reached = approach.reached;
  for (int back = 0; back < kMostBack && !reached.empty(); ++back, reached.pop_back())
    if (equations_.judge(reached.back()))
      return {is_at_rest(approach.last, inside) ? OrbitBranchEnd::kAtRest
                                                : OrbitBranchEnd::kChatterCompletes,
              reached.back(),
              false,
              !one_less && !one_more,
              value,
              other};
  return {};
}

// From a to b along the changes of the events, and what is there at each, until that is enough.
void StickingBorders::walk(const BranchPoint& a, const BranchPoint& b, bool see_impacts,
                           const std::function<bool(const StickingTip&)>& is_enough) {
  BranchPoint from = a;
  std::optional<ReleaseReturn> here = equations_.follow(a);
  const std::optional<ReleaseReturn> at_b = equations_.follow(b);
  int looks = kMostLooks;
  for (int change = 0; here && change < kMostChanges && !options_.stop.requested(); ++change) {
    BranchPoint target = b;
    // Changes that end nothing may be all there is up to `b`.
    if (at_b && is_like(*at_b, *here, see_impacts)) {
      const std::optional<BranchPoint> other = unlike_between(from, b, *here, looks);
      if (!other) return;
      target = *other;
    }
    Approach there = approach(from, target, *here, see_impacts);
    // A prediction is no solution, and does not return.
    const bool solved = there.at_beyond.tangent.size() > 0;
    const bool same_holds =
        there.beyond && (there.beyond->returns || !solved) && there.beyond->holds == here->holds;
    if (!same_holds) {
      is_enough(completion(there, *here));
      return;
    }
    // The impact of a grazing is felt down to some speed; what it was before it impacted touches.
    const bool is_lost = solved && here->itinerary.size() > there.beyond->itinerary.size() &&
                         touches(equations_, there.at_beyond);
    StickingTip touch = grazing_at(equations_, corrector_, there.reached, is_lost);
    if (touch.border && solved) touch.beyond = there.at_beyond;
    if (touch.border && is_enough(touch)) return;
    if (!solved) return;
    // Nothing ends here; go on from the other side.
    from = there.at_beyond;
    here = there.beyond;
  }
}

StickingTip StickingBorders::between(const BranchPoint& a, const BranchPoint& b) {
  StickingTip first;
  if (equations_.see_impacts()) first = grazing_ahead(equations_, corrector_, options_, a, b);
  if (first.border) return first;
  walk(a, b, equations_.see_impacts(), [&](const StickingTip& tip) {
    first = tip;
    return true;
  });
  return first;
}

std::vector<StickingTip> StickingBorders::passed(const BranchPoint& a, const BranchPoint& b) {
  std::vector<StickingTip> list;
  if (equations_.see_impacts()) return list;
  walk(a, b, true, [&](const StickingTip& tip) {
    if (tip.border && tip.end == OrbitBranchEnd::kGrazing) list.push_back(tip);
    return false;
  });
  return list;
}

std::optional<std::vector<PassageMargin>> StickingBorders::margins(const BranchPoint& solution) {
  for (const Known& known : known_)
    if (known.solution.parameter == solution.parameter && known.solution.u == solution.u &&
        known.solution.tangent == solution.tangent)
      return known.margins;
  // Both ends of a piece, and a solution between.
  if (known_.size() == 3) known_.pop_front();
  known_.push_back({solution, equations_.margins(solution, corrector_.range())});
  return known_.back().margins;
}

// Of what must stay positive between a and b, as far as it is known at both.
std::vector<MarginCourse> StickingBorders::courses(const BranchPoint& a, const BranchPoint& b) {
  const std::optional<std::vector<PassageMargin>> at_a = margins(a), at_b = margins(b);
  if (!at_a || !at_b) return {};
  const Vector chord = corrector_.difference(corrector_.pack(b), corrector_.pack(a));
  const double length = chord.norm();
  const double step_a = std::copysign(length, chord.dot(a.tangent)),
               step_b = std::copysign(length, chord.dot(b.tangent));
  const double narrow = still_gap(*equations_.system_at(a.parameter));
  const double still = still_speed(*equations_.system_at(a.parameter));
  std::vector<MarginCourse> list;
  for (const PassageMargin& start : *at_a) {
    const PassageMargin* end = partner(start, *at_b);
    if (!end || partner(*end, *at_a) != &start) continue;
    double from = start.value, from_rate = start.rate, to = end->value, to_rate = end->rate;
    // Where the map does not feel the impact its speed is born as the root of the distance.
    const bool squared = start.is_speed && !equations_.see_impacts();
    if (squared) {
      from_rate *= 2.0 * from;
      to_rate *= 2.0 * to;
      from *= from;
      to *= to;
    }
    list.push_back(MarginCourse::between(from, step_a * from_rate, to, step_b * to_rate));
    list.back().rounding = squared ? still * still : start.is_speed ? still : narrow;
  }
  return list;
}

// A solution between a and b, whose events are the same, at which they are not; or a prediction,
// without a tangent, where none can be solved for.
std::optional<BranchPoint> StickingBorders::unlike_between(const BranchPoint& a,
                                                           const BranchPoint& b,
                                                           const ReleaseReturn& at_a, int& looks) {
  const std::vector<MarginCourse> all = courses(a, b);
  if (all.empty() || looks-- <= 0 || !all_positive(all, 0.0) || !all_positive(all, 1.0)) return {};
  std::optional<double> part = doubt_within(all);
  // The ends may be of two branches with the same events.
  if (!part && !is_shown(all)) part = 0.5;
  if (!part) return {};
  const double ahead =
      *part * corrector_.difference(corrector_.pack(b), corrector_.pack(a)).dot(a.tangent);
  const Vector predicted = cubic_between(corrector_, a, ahead, a, b);
  std::optional<BranchPoint> point = corrector_.on_hyperplane(predicted, a.tangent);
  const bool solved = point.has_value();
  if (!solved) {
    const Eigen::Index n = a.u.size();
    point = BranchPoint{predicted.head(n), predicted[n] * corrector_.range(), {}, 0.0, 0, {}};
  }
  const std::optional<ReleaseReturn> there = equations_.follow(*point);
  if (!there) return {};
  if (!is_like(*there, at_a, true)) return point;
  if (!solved) return {};
  if (auto before = unlike_between(a, *point, at_a, looks)) return before;
  return unlike_between(*point, b, at_a, looks);
}

bool StickingBorders::passes(const BranchPoint& a, const BranchPoint& b) {
  const std::optional<ReleaseReturn> before = equations_.follow(a), now = equations_.follow(b);
  if (!before || !now || !now->returns || now->holds != before->holds) return true;
  // Where the impacts are felt, between() knows.
  return equations_.see_impacts() && between(a, b).border;
}

}  // namespace graze
