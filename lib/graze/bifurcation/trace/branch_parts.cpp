#include "graze/bifurcation/trace/detail/branch_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "graze/bifurcation/cut/detail/open_sequence.hpp"

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

  std::vector<BranchPart> cut() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) visit(i);
    if (pieces_.front().branch.closed())
      open_outside(places_, [](const Met& met) { return !met.place.listed; });
    std::vector<BranchPart> parts;
    bool inside = false;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      BranchPlace& here = places_[i].place;
      if (here.listed && (!inside || here.begins)) {
        parts.emplace_back();
        parts.back().branch.ends[0] = i == 0 ? ends_[0] : here.end;
      }
      inside = here.listed;
      if (inside) add(parts.back(), places_[i], i + 1 == places_.size() ? ends_[1] : here.end);
    }
    for (BranchPart& part : parts) (*pieces_.front().orbits)->name(part.branch);
    return parts;
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

  static void add(BranchPart& part, Met& met, OrbitBranchEnd end) {
    part.branch.points.push_back(met.place.at);
    part.branch.ends[1] = end;
    if (!met.place.special) return;
    part.branch.special.push_back(std::move(*met.place.special));
    part.continuations.push_back({met.orbits, std::move(met.place.others)});
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
    if (here.kept && !here.place.at.orbit.impacts.empty()) {
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

}  // namespace

std::vector<BranchPart> parts_of(std::vector<BranchPiece>& pieces) { return Parting(pieces).cut(); }

}  // namespace graze
