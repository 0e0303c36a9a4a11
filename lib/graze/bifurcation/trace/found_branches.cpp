#include "graze/bifurcation/trace/detail/found_branches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "graze/bifurcation/cut/detail/open_sequence.hpp"
#include "graze/bifurcation/problem/detail/special_names.hpp"

namespace graze {
namespace {

// Next to a grazing a multiplier can pass the circle within less than the resolution of the branch:
// at the point found it has passed it by far.
bool passes_unseen(const CriticalPoint& critical) {
  constexpr double kFar = 1e-3;  // of the modulus; located crossings keep eight digits
  const bool crosses =
      critical.kind == CriticalKind::kPeriodDoubling || critical.kind == CriticalKind::kTorus;
  return crosses && critical.multiplier &&
         std::abs(std::abs(critical.multiplier->value) - 1.0) > kFar;
}

BranchPlace place_of(const LaidOrbits& orbits, const SolutionPoint& point) {
  BranchPlace place;
  std::optional<OrbitBranchPoint> at = orbits->judge(point);
  place.listed = at && orbits.boundaries->lists(point);
  if (at) place.at = std::move(*at);
  return place;
}

class Parting {
 public:
  explicit Parting(std::vector<BranchPiece>& pieces) : pieces_(pieces) {}

  std::vector<FoundBranch> cut() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) visit(i);
    if (pieces_.front().branch.closed())
      open_outside(places_, [](const Met& met) { return !met.place.listed; });
    std::vector<FoundBranch> branches;
    bool inside = false;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      BranchPlace& here = places_[i].place;
      if (here.listed && (!inside || here.begins)) {
        branches.emplace_back();
        branches.back().branch.ends[0] = i == 0 ? ends_[0] : here.end;
      }
      inside = here.listed;
      if (inside) add(branches.back(), places_[i], i + 1 == places_.size() ? ends_[1] : here.end);
    }
    for (FoundBranch& found : branches) (*pieces_.front().orbits)->name(found.branch);
    return branches;
  }

 private:
  struct Met {
    BranchPlace place;
    LaidOrbits* orbits;
  };
  // The point that replaces the last point of the trace at an end.
  struct Tip {
    BranchPlace place;
    SolutionPoint point;
    bool is_half = false;
  };
  using Tips = std::array<std::optional<Tip>, 2>;
  // A point of the trace, or a special point of its equations, between which boundaries are
  // searched for.
  struct Waypoint {
    const SolutionPoint* point;
    BranchPlace place;
    bool kept = true;
  };

  static void add(FoundBranch& found, Met& met, OrbitBranchEnd end) {
    found.branch.points.push_back(met.place.at);
    found.branch.ends[1] = end;
    if (!met.place.special) return;
    found.branch.special.push_back(std::move(*met.place.special));
    found.continuations.push_back({met.orbits, std::move(met.place.others)});
  }

  void visit(std::size_t index) {
    BranchPiece& piece = pieces_[index];
    Tips tips;
    if (index == 0) tips[0] = tip(piece, 0);
    if (index + 1 == pieces_.size()) tips[1] = tip(piece, 1);
    std::vector<Waypoint> way = waypoints(piece, tips);
    // A piece begins with the orbit at which the previous one ended.
    if (index > 0) way.front().kept = false;
    for (std::size_t i = 0; i < way.size(); ++i) {
      std::vector<BranchPlace> between;
      if (i + 1 < way.size())
        piece.orbits->boundaries->pass({*way[i].point, way[i].place},
                                       {*way[i + 1].point, way[i + 1].place}, between);
      if (way[i].kept) places_.push_back({std::move(way[i].place), piece.orbits});
      for (BranchPlace& place : between) places_.push_back({std::move(place), piece.orbits});
    }
  }

  static std::vector<Waypoint> waypoints(const BranchPiece& piece, const Tips& tips) {
    const std::vector<SolutionPoint>& points = piece.branch.points;
    std::vector<Waypoint> way;
    auto critical = piece.branch.critical.begin();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Tip* tip = i == 0 && tips[0]                   ? &*tips[0]
                       : i + 1 == points.size() && tips[1] ? &*tips[1]
                                                           : nullptr;
      // At orbits of half the period the equations have a special point that is none of orbits.
      const bool beside = (tip && tip->is_half) || (i == 1 && tips[0] && tips[0]->is_half);
      for (; critical != piece.branch.critical.end() && critical->after < i; ++critical)
        if (!beside) add_critical(*piece.orbits, *critical, way);
      if (tip)
        way.push_back({&tip->point, tip->place});
      else
        way.push_back({&points[i], place_of(*piece.orbits, points[i])});
    }
    return way;
  }

  static void add_critical(const LaidOrbits& orbits, const CriticalPoint& critical,
                           std::vector<Waypoint>& way) {
    // Values between allowed ones may not be allowed.
    if (!orbits->system_at(critical.point.parameters())) return;
    Waypoint here{&critical.point, place_of(orbits, critical.point)};
    here.kept = is_of_orbits(critical) && !passes_unseen(critical);
    const Orbit& orbit = here.place.at.orbit;
    if (here.kept &&
        (is_of_level(critical.kind) || !orbit.impacts.empty() || !orbit.rubbing.empty())) {
      here.place.at = with_critical(std::move(here.place.at), critical);
      here.place.special = as_special(critical, here.place.at);
    }
    way.push_back(std::move(here));
  }

  std::optional<Tip> tip(BranchPiece& piece, std::size_t side) {
    Branch& trace = piece.branch;
    ends_[side] = as_orbit_end(trace.ends[side]);
    if (std::optional<Tip> half = half_at(piece, side)) {
      ends_[side] = OrbitBranchEnd::kPeriodDoubling;
      half->place.end = ends_[side];
      return half;
    }
    std::optional<BranchTip> closed = piece.orbits->boundaries->close(trace, side);
    if (!closed) return {};
    ends_[side] = closed->end;
    if (!closed->place) return {};
    const std::vector<SolutionPoint>& points = trace.points;
    return Tip{std::move(*closed->place), side == 0 ? points.front() : points.back()};
  }

  // Where an end of the trace joins orbits of half the period: its last point is one or lies
  // beyond.
  static std::optional<Tip> half_at(const BranchPiece& piece, std::size_t side) {
    const Branch& trace = piece.branch;
    const std::size_t last = trace.points.size() - 1;
    if (last == 0) return {};
    const SolutionPoint& outer = trace.points[side == 0 ? 0 : last];
    const SolutionPoint& inner = trace.points[side == 0 ? 1 : last - 1];
    const OrbitProblem& problem = *piece.orbits->problem;
    if (problem.is_half(outer)) return Tip{place_of(*piece.orbits, outer), outer, true};
    if (trace.ends[side] != BranchEnd::kHalted || !problem.passes_half(inner, outer)) return {};
    SolutionPoint at = problem.half_between(inner, outer);
    for (const CriticalPoint& critical : trace.critical)
      if (critical.kind == CriticalKind::kBranchPoint &&
          critical.after == (side == 0 ? 0 : last - 1))
        at = critical.point;
    return Tip{place_of(*piece.orbits, at), at, true};
  }

  std::vector<BranchPiece>& pieces_;
  std::vector<Met> places_;
  std::array<OrbitBranchEnd, 2> ends_{};
};

double lowest_value(const OrbitBranch& branch) {
  const auto less = [](const OrbitBranchPoint& a, const OrbitBranchPoint& b) {
    return a.value < b.value;
  };
  return std::min_element(branch.points.begin(), branch.points.end(), less)->value;
}

bool comes_before(const OrbitBranch& a, const OrbitBranch& b) {
  const ImpactPattern &pa = a.pattern, &pb = b.pattern;
  if (pa.period != pb.period) return pa.period < pb.period;
  // Branches that stick come last.
  if (pa.stops.empty() != pb.stops.empty()) return pb.stops.empty();
  if (pa.stops.size() != pb.stops.size()) return pa.stops.size() < pb.stops.size();
  if (pa.stops != pb.stops) return pa.stops < pb.stops;
  return lowest_value(a) < lowest_value(b);
}

// A branch that was switched onto is connected to its origin. Branches that were traced separately
// may be parts of one component nevertheless.
std::pair<int, int> component_of(const std::vector<FoundBranch>& found, std::size_t index,
                                 const ConnectedSet& set_of) {
  while (found[index].origin_branch >= 0)
    index = static_cast<std::size_t>(found[index].origin_branch);
  const FoundBranch& first = found[index];
  return set_of(first.branch).value_or(std::pair(-1, first.trace));
}

}  // namespace

std::vector<FoundBranch> branches_of(std::vector<BranchPiece>& pieces) {
  return Parting(pieces).cut();
}

std::vector<OrbitBranch> put_in_order(std::vector<FoundBranch> found, Components components,
                                      const ConnectedSet& set_of) {
  std::vector<std::size_t> order(found.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return comes_before(found[a].branch, found[b].branch);
  });
  for (const std::size_t i : order) components.add(found[i].branch, component_of(found, i, set_of));
  const std::vector<int> numbers = components.numbers();
  SpecialNames names;
  for (std::size_t k = 0; k < order.size(); ++k) {
    OrbitBranch& branch = found[order[k]].branch;
    branch.id = static_cast<int>(k) + 1;
    branch.component = numbers[k];
    for (SpecialPoint& special : branch.special) special.id = names.next(special.kind);
  }
  for (FoundBranch& one : found)
    if (one.origin_branch >= 0)
      one.branch.origin =
          found[static_cast<std::size_t>(one.origin_branch)].branch.special[one.origin_special].id;
  std::vector<OrbitBranch> branches;
  for (const std::size_t i : order) branches.push_back(std::move(found[i].branch));
  return branches;
}

}  // namespace graze
