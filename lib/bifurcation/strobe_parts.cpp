#include "graze/bifurcation/strobe_parts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "graze/bifurcation/strobe_touch.hpp"
#include "graze/continuation/locate.hpp"

namespace graze {
namespace {

// The stop of a contact that only one of two orbits has; nothing where they have the same.
std::optional<int> stop_of_difference(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> difference;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                std::back_inserter(difference));
  return difference.empty() ? std::nullopt : std::optional(difference.front());
}

std::optional<StrobeBorder> border_between(const PassageEquations& equations,
                                           const ContinuationOptions& options, const BranchPoint& a,
                                           const BranchPoint& b) {
  const std::optional<int> stop =
      stop_of_difference(equations.stops_met(a), equations.stops_met(b));
  return stop ? touch_between(equations, options, a, b, *stop) : std::nullopt;
}

class Parting {
 public:
  Parting(const PassageEquations& equations, const ContinuationOptions& options,
          const Branch& trace)
      : equations_(equations), options_(options), trace_(trace) {}

  std::vector<StrobePart> cut() {
    const std::size_t last = trace_.points.size() - 1;
    const bool joins_first = last > 0 && joins(0, 0, 1),
               joins_last = last > 0 && joins(1, last - 1, last);
    const std::size_t first = joins_first && !equations_.is_half(trace_.points[0]) ? 1 : 0;
    const std::size_t end =
        joins_last && !equations_.is_half(trace_.points[last]) ? last - 1 : last;
    begin(joins_first ? OrbitBranchEnd::kPeriodDoubling : as_orbit_end(trace_.ends[0]));
    add_corner(0);
    if (first > 0) add(half_between(trace_.points[1], trace_.points[0]));
    auto critical = trace_.critical.begin();
    while (critical != trace_.critical.end() && critical->after < first) ++critical;
    for (std::size_t i = first; i <= end; ++i) {
      add(trace_.points[i]);
      if (i == end) break;
      const BranchPoint* from = &trace_.points[i];
      for (; critical != trace_.critical.end() && critical->after == i; ++critical) {
        pass(*from, critical->point);
        // Where the branch joins orbits of half the period, the doubling is a special point of
        // those.
        if (!equations_.is_half(critical->point)) add_critical(*critical);
        from = &critical->point;
      }
      pass(*from, trace_.points[i + 1]);
    }
    if (end < last) add(half_between(trace_.points[end], trace_.points[last]));
    close(joins_last ? OrbitBranchEnd::kPeriodDoubling : as_orbit_end(trace_.ends[1]));
    add_corner(1);
    std::erase_if(parts_, [](const StrobePart& part) {
      return part.branch.points.empty() || part.branch.pattern.stops.empty();
    });
    return std::move(parts_);
  }

 private:
  void begin(OrbitBranchEnd end) {
    parts_.emplace_back();
    parts_.back().branch.ends = {end, end};
    parts_.back().branch.pattern.period = equations_.period();
  }
  void close(OrbitBranchEnd end) { parts_.back().branch.ends[1] = end; }

  // Whether a side of the trace ends at an orbit of half the period: `outer` beyond it or at it.
  bool joins(std::size_t side, std::size_t a, std::size_t b) const {
    const BranchPoint& outer = trace_.points[side == 0 ? a : b];
    return equations_.is_half(outer) ||
           (trace_.ends[side] == BranchEnd::kHalted &&
            equations_.passes_half(trace_.points[a], trace_.points[b]));
  }

  // The equations are singular there and passed in a step so short that the branch is straight over
  // it.
  BranchPoint half_between(const BranchPoint& inner, const BranchPoint& outer) const {
    const double before = equations_.halves_differ(inner).norm();
    const double part = before / (before + equations_.halves_differ(outer).norm());
    BranchPoint at = inner;
    at.u += part * (outer.u - inner.u);
    at.parameter += part * (outer.parameter - inner.parameter);
    return at;
  }

  std::vector<int> stops_of(const BranchPoint& point) const {
    const std::optional<OrbitBranchPoint> at = equations_.judge(point);
    return at ? at->orbit.pattern().stops : std::vector<int>();
  }

  void add(const BranchPoint& point) {
    const std::optional<OrbitBranchPoint> at = equations_.judge(point);
    if (!at) return;
    OrbitBranch& part = parts_.back().branch;
    if (part.pattern.stops.empty()) part.pattern = at->orbit.pattern();
    part.points.push_back(*at);
  }

  // Next to a grazing a multiplier can run through the circle within less than the branch resolves:
  // where it was looked for it has passed it by far.
  static bool passes_unseen(const CriticalPoint& critical) {
    constexpr double kFar = 1e-3;  // of the modulus; located crossings keep eight digits
    const bool crosses =
        critical.kind == CriticalKind::kPeriodDoubling || critical.kind == CriticalKind::kTorus;
    return crosses && critical.multiplier &&
           std::abs(std::abs(critical.multiplier->value) - 1.0) > kFar;
  }

  void add_critical(const CriticalPoint& critical) {
    const std::optional<OrbitBranchPoint> at = equations_.judge(critical.point);
    if (!at || !is_of_orbits(critical) || passes_unseen(critical)) return;
    const OrbitBranchPoint there = with_critical(*at, critical);
    StrobePart& part = parts_.back();
    if (part.branch.pattern.stops.empty()) part.branch.pattern = there.orbit.pattern();
    part.branch.points.push_back(there);
    part.branch.special.push_back(as_special(critical, there));
    part.critical.push_back(critical);
  }

  // The grazings between neighbours: their contacts tell them, in whatever order.
  void pass(const BranchPoint& a, const BranchPoint& b) {
    const std::vector<int> before = stops_of(a), after = stops_of(b);
    const auto sorted = [](std::vector<int> stops) {
      std::sort(stops.begin(), stops.end());
      return stops;
    };
    if (sorted(before) == sorted(after)) return;
    const std::optional<StrobeBorder> border = border_between(equations_, options_, a, b);
    if (border) {
      add_touching(*border, before.size() < after.size());
      close(OrbitBranchEnd::kGrazing);
      begin(OrbitBranchEnd::kGrazing);
      parts_.back().branch.pattern.stops = after;
      return add_touching(*border, before.size() > after.size());
    }
    const std::optional<BranchPoint> at = grazing_between(a, b, before.size(), after.size());
    if (at) add_grazing(*at, before.size() < after.size());
    close(OrbitBranchEnd::kGrazing);
    begin(OrbitBranchEnd::kGrazing);
    parts_.back().branch.pattern.stops = after;
    if (at && !after.empty()) add_grazing(*at, before.size() > after.size());
  }

  // `approach`: the orbits of this part have no contact there yet, or no more.
  void add_touching(const StrobeBorder& border, bool approach) {
    add_border(border.at,
               approach ? equations_.judge_without(border.at, border.touch)
                        : equations_.judge_touching(border.at, border.touch),
               approach);
  }

  // `approach`: an approach touches there, else a contact loses its speed.
  void add_grazing(const BranchPoint& at, bool approach) {
    add_border(at, equations_.judge(at), approach);
  }

  void add_border(const BranchPoint& at, const std::optional<OrbitBranchPoint>& orbit,
                  bool approach) {
    if (!orbit) return;
    StrobePart& part = parts_.back();
    part.branch.points.push_back(*orbit);
    part.branch.special.push_back({SpecialKind::kGrazing, "", *orbit, {}, !approach, at});
    part.critical.emplace_back();
  }

  // How far an orbit is from a grazing, m or m^2/s^2: in proportion to the distance along the
  // branch.
  std::optional<double> margin_of(const BranchPoint& point, bool speed, std::size_t impacts) const {
    const std::optional<OrbitBranchPoint> at = equations_.judge(point);
    if (!at || at->orbit.impacts.size() != impacts) return {};
    if (speed) return at->smallest_speed * at->smallest_speed;
    return at->orbit.clearance;
  }

  // A margin that a trace which no step leads on from has come near enough to: 1e-5 of the speed of
  // the forced motion, or 1e-10 of its length.
  double near_enough(bool speed) const {
    constexpr double kPart = 1e-10;
    const double size = speed ? equations_.speed_unit() : 1.0;
    return kPart * (speed ? size * size : equations_.length());
  }

  // Where the force of a stop sets in with a jump the map has a corner at a grazing and the trace
  // cannot turn it. It is gone up to from its last points, where they lead onto one.
  void add_corner(std::size_t side) {
    const std::size_t count = trace_.points.size();
    if (trace_.ends[side] != BranchEnd::kNotConverged || count < 2) return;
    BranchPoint before = trace_.points[side == 0 ? 1 : count - 2];
    BranchPoint last = trace_.points[side == 0 ? 0 : count - 1];
    const std::size_t impacts = stops_of(last).size();
    for (const bool speed : {false, true}) {
      const std::optional<BranchPoint> corner = corner_beyond(before, last, speed, impacts);
      if (!corner) continue;
      if (side == 1)
        close(OrbitBranchEnd::kGrazing);
      else
        parts_.back().branch.ends[0] = OrbitBranchEnd::kGrazing;
      parts_.back().branch.pattern = equations_.judge(last)->orbit.pattern();
      return add_grazing(*corner, !speed);
    }
  }

  // By secants of the margin, from one side; nothing where they lead nowhere near.
  std::optional<BranchPoint> corner_beyond(BranchPoint before, BranchPoint last, bool speed,
                                           std::size_t impacts) const {
    constexpr int kMostRounds = 40;
    std::optional<double> from = margin_of(before, speed, impacts),
                          to = margin_of(last, speed, impacts);
    if (!from || !to) return {};
    if (*to <= near_enough(speed)) return last;
    if (!(*to < *from)) return {};
    const double first = *from;
    for (int round = 0; round < kMostRounds && 1e-12 * first < *to; ++round) {
      // Not quite there: beyond, the motion is another one.
      const double part = 0.9 * *to / (*from - *to);
      if (!(part > 0.0) || (round == 0 && part > 1.0)) return {};
      BranchPoint guess = last;
      guess.u += part * (last.u - before.u);
      const double value = last.parameter + part * (last.parameter - before.parameter);
      const std::optional<BranchPoint> next =
          solve_at(equations_.problem(), options_, guess.u, value);
      const std::optional<double> left = next ? margin_of(*next, speed, impacts) : std::nullopt;
      if (!left || !(*left < *to)) break;
      before = std::exchange(last, *next);
      from = std::exchange(to, left);
    }
    return *to <= 1e-3 * first ? std::optional(last) : std::nullopt;
  }

  // The gap of an approach falls through zero in proportion to the distance; beyond, the square of
  // the speed of the contact grows with it.
  std::optional<BranchPoint> grazing_between(const BranchPoint& a, const BranchPoint& b,
                                             std::size_t before, std::size_t after) const {
    const std::size_t fewer = std::min(before, after);
    const double sign = before < after ? 1.0 : -1.0;
    const auto test = [&](const BranchPoint& point) {
      const std::optional<OrbitBranchPoint> at = equations_.judge(point);
      const std::size_t here = at ? at->orbit.impacts.size() : 0;
      if (here > fewer) return -sign * at->smallest_speed * at->smallest_speed;
      return sign * (at && at->orbit.clearance ? std::abs(*at->orbit.clearance) : 1.0);
    };
    return locate(equations_.problem(), options_, a, b, test);
  }

  const PassageEquations& equations_;
  const ContinuationOptions& options_;
  const Branch& trace_;
  std::vector<StrobePart> parts_;
};

}  // namespace

std::vector<StrobePart> parts_of(PassageEquations& equations, const ContinuationOptions& options,
                                 const Branch& trace) {
  std::vector<StrobePart> parts = Parting(equations, options, trace).cut();
  for (StrobePart& part : parts) part.on.assign(part.critical.size(), &equations);
  return parts;
}

void append_parts(std::vector<StrobePart>& parts, std::vector<StrobePart> more) {
  auto from = more.begin();
  if (!parts.empty() && from != more.end()) {
    StrobePart &last = parts.back(), &next = *from++;
    last.branch.points.insert(last.branch.points.end(), next.branch.points.begin() + 1,
                              next.branch.points.end());
    for (SpecialPoint& special : next.branch.special)
      last.branch.special.push_back(std::move(special));
    for (auto& critical : next.critical) last.critical.push_back(std::move(critical));
    last.on.insert(last.on.end(), next.on.begin(), next.on.end());
    last.branch.ends[1] = next.branch.ends[1];
  }
  parts.insert(parts.end(), std::make_move_iterator(from), std::make_move_iterator(more.end()));
}

bool resolves_contacts(const PassageEquations& equations, const ContinuationOptions& options,
                       const BranchPoint& from, const BranchPoint& to) {
  const std::optional<int> stop =
      stop_of_difference(equations.stops_met(from), equations.stops_met(to));
  // Across a corner the tangents say nothing.
  if (!stop || !equations.sets_in_smoothly(from, *stop)) return true;
  // What is this short shows all there is.
  if ((to.u - from.u).norm() <= kOnePoint * (1.0 + from.u.norm())) return true;
  const std::optional<StrobeBorder> border = touch_between(equations, options, from, to, *stop);
  return border && border->at.tangent.dot(from.tangent) >= std::cos(options.max_turn);
}

}  // namespace graze
