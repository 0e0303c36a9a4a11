#include "graze/bifurcation/sticking_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/orbit_parts.hpp"
#include "graze/continuation/corrector.hpp"
#include "graze/orbit/held_force.hpp"

namespace graze {
namespace {

// Where the contact force touches zero the stop is open for a time that goes as the square root of
// the distance: what 1e-10 of the parameter leaves of it, of a forcing period.
constexpr double kInterrupted = 1e-5;

// Points before a border that may be flown once more instead of it, each at least half as far from
// it as the one before.
constexpr int kMostBack = 8;
constexpr int kMostSteps = 400;  // of a bisection that may need two for each of some 100 halvings

// A branch point is interpolated over a step of 1e-6; its multiplier is 1 within the square root of
// that.
constexpr double kAtOne = 1e-3;

// An approach nearer than this part of a length touches: a trace that comes to its end there is
// within its shortest step, some 1e-12, of the grazing. From the side on which it impacts the map's
// derivative grows like 1/v, and solutions are found down to speeds of about the square root of
// that.
constexpr double kTouches = 1e-9;
constexpr double kStill = 1e-5;

// A flight whose excursion, as its duration to the power 4, is within rounding is none: what that
// leaves of the parameter, as its duration to the power 2, is some 1e-8 of the range.
constexpr double kTold = 1e-6;
constexpr int kMostSecants = 16;  // each doubles the digits, nearly

// One end of a traced branch: the last of its points that are orbits with the stuck phases of the
// start, and what lies beyond.
struct Tip {
  OrbitBranchEnd end = OrbitBranchEnd::kNotConverged;
  std::optional<BranchPoint> border;  // the special point that ends it
  bool by_speed = false;              // of a grazing
  bool interrupted = false;           // of CH and LO
  double value = 0.0;                 // of the parameter there
  std::optional<BranchPoint> beyond;  // an orbit on the other side of CH
};

class StickingParts {
 public:
  StickingParts(const StickingEquations& equations, const ContinuationOptions& options,
                const Branch& branch)
      : equations_(equations),
        options_(options),
        branch_(branch),
        corrector_(equations.problem(), options_) {}

  // Nothing where a point of it cannot be judged. Adds what lies beyond its ends.
  std::optional<OrbitBranch> judge(std::vector<StickingNeighbour>& neighbours) {
    const std::size_t last = branch_.points.size() - 1;
    const bool cut_front = branch_.ends[0] == BranchEnd::kHalted,
               cut_back = branch_.ends[1] == BranchEnd::kHalted;
    const std::size_t first = cut_front ? 1 : 0, end = cut_back ? last - 1 : last;
    const std::array<Tip, 2> tips = {tip(0, first, 0), tip(1, end, last)};
    OrbitBranch result;
    result.pattern.period = equations_.section().release().period;
    result.ends = {tips[0].end, tips[1].end};
    add_border(tips[0], result, neighbours);
    auto critical = branch_.critical.begin();
    while (critical != branch_.critical.end() && critical->after < first) ++critical;
    for (std::size_t i = first; i <= end; ++i) {
      const std::optional<OrbitBranchPoint> point = equations_.judge(branch_.points[i]);
      if (!point) return {};
      result.points.push_back(*point);
      for (; critical != branch_.critical.end() && critical->after == i && i < end; ++critical)
        add_critical(*critical, result);
    }
    add_border(tips[1], result, neighbours);
    const std::optional<ReleaseReturn> back = equations_.follow(branch_.points[first]);
    if (!back) return {};
    result.holds = back->holds;
    return result;
  }

 private:
  bool has_shrunk(const ReleaseReturn& back, const BranchPoint& at) const {
    return back.shortest_hold <= kGone * equations_.system_at(at.parameter)->period();
  }

  // Whether a stop is let go and closed again at once.
  bool is_interrupted(const ReleaseReturn& back, const BranchPoint& at) const {
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
  bool is_at_rest(const ReleaseReturn& back, const BranchPoint& at) const {
    const double period = equations_.system_at(at.parameter)->period();
    const int periods = equations_.section().release().period;
    return back.holds.size() == 1 && back.shortest_hold >= (periods - kInterrupted) * period;
  }

  // Where the force that holds the structure at rest touches zero, and at which phase. Flights near
  // that are too short to tell from none; the force is smooth across it. `near` is a value within
  // what they tell.
  std::optional<std::pair<double, double>> lift_off(double near) const {
    const Release& release = equations_.section().release();
    const auto held_at = [&](double value) {
      const System* system = equations_.system_at(value);
      return system ? held_force(*system, release.closed, release.released)
                    : std::optional<HeldForce>();
    };
    const double range = std::abs(options_.to - options_.from);
    double before = near - kTold * range, value = near;
    for (int step = 0; step < kMostSecants; ++step) {
      const std::optional<HeldForce> a = held_at(before), b = held_at(value);
      if (!a || !b) return {};
      if (a->least() == b->least()) break;
      const double next = value - b->least() * (value - before) / (b->least() - a->least());
      if (!(std::abs(next - near) <= kTold * range)) return {};
      before = value;
      value = next;
      if (value == before) break;
    }
    const std::optional<HeldForce> there = held_at(value);
    if (!there) return {};
    return std::pair(value, there->phase_of_least());
  }

  // `inner`: the last point that is an orbit; `outer`: the first beyond, where the trace was
  // halted.
  Tip tip(std::size_t side, std::size_t inner, std::size_t outer) {
    const BranchEnd end = branch_.ends[side];
    if (end != BranchEnd::kHalted && end != BranchEnd::kNotConverged)
      return {as_orbit_end(end), {}, false, false, 0.0, {}};
    const BranchPoint& at = branch_.points[inner];
    const std::optional<ReleaseReturn> here = equations_.follow(at);
    if (end == BranchEnd::kNotConverged) {
      // Where the equations are solved no further the trace has come as near as it gets.
      if (here && has_shrunk(*here, at))
        return {OrbitBranchEnd::kChatterCompletes, at, false, false, at.parameter, {}};
      return grazing(at, inner, side == 0 ? 1 : -1);
    }
    if (!here) return {};
    return border(at, branch_.points[outer], *here);
  }

  // Whether an impact or an approach touches where the trace came to its end, at point `inner`;
  // `inward` (1 or -1) leads back along the branch.
  Tip grazing(const BranchPoint& at, std::size_t inner, int inward) const {
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
    for (std::size_t i = inner; i<branch_.points.size(); inward> 0 ? ++i : --i) {
      const std::optional<ReleaseReturn> back = equations_.follow(branch_.points[i]);
      if (!back) return {};
      if (!(back->slowest > 2.0 * here->slowest)) continue;
      const double rate =
          (branch_.points[i].parameter - at.parameter) / (back->slowest - here->slowest);
      return {OrbitBranchEnd::kGrazing, at, true, false, at.parameter - here->slowest * rate, {}};
    }
    return {};
  }

  // From `a` towards `b` as far as the stuck phases stay what they are at `a`.
  Tip border(const BranchPoint& a, const BranchPoint& b, const ReleaseReturn& at_a) {
    const Vector chord = corrector_.difference(corrector_.pack(b), corrector_.pack(a));
    BranchPoint inside = a;
    if (inside.tangent.dot(chord) < 0.0) inside.tangent *= -1.0;
    std::vector<BranchPoint> reached = {inside};
    std::optional<ReleaseReturn> last = at_a, beyond = equations_.follow(b);
    double at_beyond = b.parameter;
    // Two points nearer than this are one in double precision.
    const double least =
        4.0 * std::numeric_limits<double>::epsilon() * (1.0 + corrector_.pack(a).norm());
    // Orbits beyond the border with their stuck phases, those nearest to it last.
    std::vector<std::pair<BranchPoint, std::vector<int>>> others;
    if (beyond && beyond->returns) others.emplace_back(b, beyond->holds);
    // Some two steps to a bit; more of them would lead past `b`.
    int steps = 0;
    for (double h = 0.5 * chord.norm(); h > least && steps < kMostSteps; ++steps) {
      std::optional<BranchPoint> next =
          corrector_.on_hyperplane(corrector_.pack(inside) + h * inside.tangent, inside.tangent);
      const std::optional<ReleaseReturn> back =
          next ? equations_.follow(*next) : std::optional<ReleaseReturn>();
      if (back && back->returns && back->holds == at_a.holds) {
        inside = *next;
        last = back;
        reached.push_back(inside);
        continue;
      }
      if (back) {
        beyond = back;
        at_beyond = next->parameter;
        if (back->returns) others.emplace_back(*next, back->holds);
      }
      h *= 0.5;
    }
    BranchPoint there = inside;
    there.parameter = at_beyond;
    const bool one_less = has_shrunk(*last, inside);
    const bool one_more = beyond && beyond->returns && beyond->holds.size() > at_a.holds.size() &&
                          has_shrunk(*beyond, there);
    const bool interrupted =
        is_interrupted(*last, inside) || (beyond && is_interrupted(*beyond, there));
    if ((!one_less && !one_more && !interrupted) || steps == kMostSteps) return {};
    std::optional<BranchPoint> other;
    for (auto known = others.rbegin(); known != others.rend(); ++known) {
      if (known->second.size() == at_a.holds.size() || known->second != others.back().second) break;
      other = known->first;
    }
    // On the border itself rounding may decide otherwise when the orbit is flown once more.
    for (int back = 0; back < kMostBack && !reached.empty(); ++back, reached.pop_back())
      if (equations_.judge(reached.back()))
        return {
            is_at_rest(*last, inside) ? OrbitBranchEnd::kAtRest : OrbitBranchEnd::kChatterCompletes,
            reached.back(),
            false,
            !one_less && !one_more,
            inside.parameter,
            other};
    return {};
  }

  void add_border(const Tip& tip, OrbitBranch& result,
                  std::vector<StickingNeighbour>& neighbours) const {
    if (!tip.border) return;
    std::optional<OrbitBranchPoint> at = equations_.judge(*tip.border);
    if (!at) return;
    at->value = tip.value;
    BranchPoint solution = *tip.border;
    if (tip.end == OrbitBranchEnd::kAtRest)
      if (const auto there = lift_off(tip.value)) {
        at->value = solution.parameter = there->first;
        solution.u[0] = there->second;
      }
    // A trace that came to its end there has the point already.
    if (result.points.empty() || result.points.back().value != at->value)
      result.points.push_back(*at);
    const SpecialKind kind = tip.end == OrbitBranchEnd::kGrazing  ? SpecialKind::kGrazing
                             : tip.end == OrbitBranchEnd::kAtRest ? SpecialKind::kLiftOff
                                                                  : SpecialKind::kChatterCompletes;
    result.special.push_back({kind, "", *at, {}, tip.by_speed, solution, tip.interrupted});
    if (!tip.beyond) return;
    if (std::optional<OrbitBranchPoint> other = equations_.judge(*tip.beyond))
      neighbours.push_back({result.special.size() - 1, std::move(other->orbit), other->value});
  }

  void add_critical(const CriticalPoint& critical, OrbitBranch& result) const {
    // Beside a grazing the map's derivative jumps, and the orientation with it; where another
    // branch crosses a multiplier is 1.
    if (critical.kind == CriticalKind::kBranchPoint &&
        !(critical.multiplier && std::abs(critical.multiplier->value - 1.0) <= kAtOne))
      return;
    const std::optional<OrbitBranchPoint> at = equations_.judge(critical.point);
    if (!at) return;
    SpecialPoint special{as_special(critical.kind), "", *at, {}, false, critical.point};
    if (critical.multiplier) special.multiplier = critical.multiplier->value;
    result.points.push_back(*at);
    result.special.push_back(special);
  }

  const StickingEquations& equations_;
  const ContinuationOptions& options_;
  const Branch& branch_;
  Corrector corrector_;
};

}  // namespace

std::optional<OrbitBranch> judge_sticking(const StickingEquations& equations,
                                          const ContinuationOptions& options, const Branch& branch,
                                          std::vector<StickingNeighbour>& neighbours) {
  return StickingParts(equations, options, branch).judge(neighbours);
}

}  // namespace graze
