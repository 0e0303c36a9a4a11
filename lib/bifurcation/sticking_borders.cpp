#include "graze/bifurcation/sticking_borders.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace graze {
namespace {

// A stuck phase that lasts less than this part of a forcing period has shrunk to nothing: what
// 1e-10 of the parameter leaves of it beside CH, (1e-10)^(3/5).
constexpr double kGone = 1e-6;

// Where the contact force touches zero the stop is open for a time that goes as the square root of
// the distance: what 1e-10 of the parameter leaves of it, of a forcing period.
constexpr double kInterrupted = 1e-5;

// Points before a border that may be flown once more instead of it, each at least half as far from
// it as the one before.
constexpr int kMostBack = 8;
constexpr int kMostSteps = 400;  // of a bisection that may need two for each of some 100 halvings

// Changes of the itinerary within one step that are looked through.
constexpr int kMostChanges = 16;

// An approach nearer than this part of a length touches: a trace that comes to its end there is
// within its shortest step, some 1e-12, of the grazing. From the side on which it impacts the map's
// derivative grows like 1/v, and solutions are found down to speeds of about the square root of
// that.
constexpr double kTouches = 1e-9;
constexpr double kStill = 1e-5;

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

// Whether a stop is let go and closed again at once.
bool StickingBorders::is_interrupted(const ReleaseReturn& back, const BranchPoint& at) const {
  const double period = equations_.system_at(at.parameter)->period();
  for (const PassedHold& first : back.passage.holds)
    for (const PassedHold& next : back.passage.holds) {
      if (next.from_start || next.stop != first.stop) continue;
      const double open = static_cast<double>(next.from.period - first.to.period) * period +
                          next.from.local - first.to.local;
      if (open >= 0.0 && open <= kInterrupted * period) return true;
    }
  return false;
}

// Whether the structure is let go once a round and held again at once.
bool StickingBorders::is_at_rest(const ReleaseReturn& back, const BranchPoint& at) const {
  const double period = equations_.system_at(at.parameter)->period();
  const int periods = equations_.section().release().period;
  return back.holds.size() == 1 && back.shortest_hold >= (periods - kInterrupted) * period;
}

// Whether both return through the same events. With N = m the equations do not see the impacts.
bool StickingBorders::is_like(const ReleaseReturn& back, const ReleaseReturn& other) const {
  const bool sees_impacts = equations_.section().size() > 1;
  return back.returns && back.holds == other.holds &&
         (!sees_impacts || back.itinerary == other.itinerary);
}

// Whether an impact or an approach touches at the last of these points.
StickingTip StickingBorders::grazing(const std::vector<BranchPoint>& reached) const {
  const BranchPoint& at = reached.back();
  const std::optional<ReleaseReturn> here = equations_.follow(at, true);
  if (!here) return {};
  const System& system = *equations_.system_at(at.parameter);
  const double length = shooting_scale(system).length;
  const double frequency = system.forcing->frequency;
  const std::optional<double>& clearance = here->passage.clearance;
  if (clearance && *clearance <= kTouches * length)
    return {OrbitBranchEnd::kGrazing, at, false, false, at.parameter, {}};
  if (!(here->slowest <= kStill * length * frequency)) return {};
  // The speed goes linearly with the parameter. Neighbours of the last point may be as near as
  // its rounding; one at twice its speed tells where it vanishes.
  for (auto point = reached.rbegin(); point != reached.rend(); ++point) {
    const std::optional<ReleaseReturn> back = equations_.follow(*point);
    if (!back) return {};
    if (!(back->slowest > 2.0 * here->slowest)) continue;
    const double rate = (point->parameter - at.parameter) / (back->slowest - here->slowest);
    return {OrbitBranchEnd::kGrazing, at, true, false, at.parameter - here->slowest * rate, {}};
  }
  return {};
}

StickingTip StickingBorders::at_last(const std::vector<BranchPoint>& reached) const {
  const BranchPoint& at = reached.back();
  const std::optional<ReleaseReturn> here = equations_.follow(at);
  // Where the equations are solved no further the trace has come as near as it gets.
  if (here && has_shrunk(*here, at))
    return {OrbitBranchEnd::kChatterCompletes, at, false, false, at.parameter, {}};
  return grazing(reached);
}

// From `a` towards `b` as far as the events stay what they are at `a`.
StickingBorders::Approach StickingBorders::approach(const BranchPoint& a, const BranchPoint& b,
                                                    const ReleaseReturn& at_a) {
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
  int steps = 0;
  for (double h = 0.5 * chord.norm(); h > least && steps < kMostSteps; ++steps) {
    std::optional<BranchPoint> next =
        corrector_.on_hyperplane(corrector_.pack(inside) + h * inside.tangent, inside.tangent);
    const std::optional<ReleaseReturn> back =
        next ? equations_.follow(*next) : std::optional<ReleaseReturn>();
    if (back && is_like(*back, at_a)) {
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
  result.settled = steps < kMostSteps;
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
              inside.parameter,
              other};
  return {};
}

StickingTip StickingBorders::between(const BranchPoint& a, const BranchPoint& b) {
  BranchPoint from = a;
  std::optional<ReleaseReturn> here = equations_.follow(a);
  const std::optional<ReleaseReturn> at_b = equations_.follow(b);
  for (int change = 0; here && change < kMostChanges; ++change) {
    // Changes that end nothing may be all there is up to `b`.
    if (at_b && is_like(*at_b, *here)) return {};
    Approach there = approach(from, b, *here);
    const bool same_holds =
        there.beyond && there.beyond->returns && there.beyond->holds == here->holds;
    if (!same_holds) return completion(there, *here);
    StickingTip touch = grazing(there.reached);
    if (touch.border) {
      touch.beyond = there.at_beyond;
      return touch;
    }
    // Nothing ends here; go on from the other side.
    from = there.at_beyond;
    here = there.beyond;
  }
  return {};
}

bool StickingBorders::passes(const BranchPoint& a, const BranchPoint& b) {
  const std::optional<ReleaseReturn> before = equations_.follow(a), now = equations_.follow(b);
  if (!before || !now || !now->returns || now->holds != before->holds) return true;
  return !is_like(*now, *before) && between(a, b).border;
}

}  // namespace graze
