#include "graze/bifurcation/orbit_parts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <list>
#include <utility>

#include "graze/bifurcation/grazing_stations.hpp"

namespace graze {
namespace {

// Halves nearer than this, in the units of the unknowns, are one: solutions are known to about the
// square root of eps where they are least well determined.
constexpr double kOneOrbit = 1e-7;

// No stop is penetrated by more, of the length scale.
constexpr double kPenetration = 1e-12;

// A point or special point met along a component.
struct Place {
  OrbitBranchPoint at;
  std::optional<SpecialPoint> special;
  bool joins_half = false;  // has half the period: orbits of that period end the branch here
  bool meets = false;       // two impacts come together here

  bool is_grazing() const { return special && special->kind == SpecialKind::kGrazing; }
  bool is_orbit() const { return at.orbit.admissible || is_grazing() || meets; }
  // What ends a branch here: a grazing, unless none could be located.
  OrbitBranchEnd end() const {
    if (joins_half) return OrbitBranchEnd::kPeriodDoubling;
    if (meets) return OrbitBranchEnd::kImpactsMeet;
    return is_grazing() ? OrbitBranchEnd::kGrazing : OrbitBranchEnd::kNotConverged;
  }
};

// Puts the border between the places from `first` on where their verdict changes.
void insert_border(std::vector<Place>& places, std::size_t first, const Place& border) {
  const bool verdict = places[first].at.orbit.admissible;
  const auto changed =
      std::find_if(places.begin() + static_cast<std::ptrdiff_t>(first), places.end(),
                   [&](const Place& s) { return s.at.orbit.admissible != verdict; });
  places.insert(changed, border);
}

// Starts a closed sequence where it is no orbit, so that no part is cut in two by the start.
void open_outside(std::vector<Place>& places) {
  const auto outside =
      std::find_if(places.begin(), places.end(), [](const Place& s) { return !s.is_orbit(); });
  if (outside == places.begin() || outside == places.end()) return;
  const auto offset = outside - places.begin();
  places.pop_back();  // repeats the first
  std::rotate(places.begin(), places.begin() + offset, places.end());
  places.push_back(places.front());
}

class Parts {
 public:
  Parts(const OrbitEquations& equations, const ContinuationOptions& options, const Branch& branch,
        bool keep_virtual)
      : equations_(equations),
        options_(options),
        branch_(branch),
        keep_virtual_(keep_virtual),
        corrector_(equations.problem(), options),
        grazings_(equations, options) {}

  std::vector<OrbitBranch> divide() {
    visit();
    drop_beyond_halves();
    if (branch_.closed() && !keep_virtual_) open_outside(places_);
    std::vector<OrbitBranch> parts;
    bool inside = false;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& here = places_[i];
      const bool kept = keep_virtual_ || here.is_orbit();
      if (kept && !inside) {
        parts.emplace_back();
        parts.back().pattern = equations_.pattern();
        parts.back().ends[0] =
            i == 0 && !here.joins_half ? as_orbit_end(branch_.ends[0]) : here.end();
      }
      if (kept) {
        parts.back().points.push_back(here.at);
        if (here.special) parts.back().special.push_back(*here.special);
        parts.back().ends[1] = i + 1 == places_.size() && !here.joins_half
                                   ? as_orbit_end(branch_.ends[1])
                                   : here.end();
      }
      inside = kept;
    }
    return parts;
  }

 private:
  void visit() {
    auto critical = branch_.critical.begin();
    Place first{equations_.judge(branch_.points[0]), {}};
    // A branch that was switched onto starts at the orbit of half the period.
    const Vector halves = equations_.halves_differ(branch_.points[0]);
    first.joins_half = halves.size() > 0 && halves.norm() < kOneOrbit;
    SeenSolution before = grazings_.seen(branch_.points[0], first.at);
    places_.push_back(std::move(first));
    for (std::size_t i = 1; i < branch_.points.size(); ++i) {
      std::vector<Along> special_points;
      for (; critical != branch_.critical.end() && critical->after == i - 1; ++critical)
        // Between allowed values may be none.
        if (equations_.system_at(critical->point.parameter) &&
            (is_of_orbits(*critical) ||
             equations_.passes_half(branch_.points[i - 1], branch_.points[i])))
          special_points.push_back(
              {corrector_.ahead(branch_.points[i - 1], critical->point), special(*critical)});
      OrbitBranchPoint at = equations_.judge(branch_.points[i]);
      SeenSolution here = grazings_.seen(branch_.points[i], at);
      visit_step(before, here, std::move(at), special_points);
      before = std::move(here);
    }
  }

  // A special point within a step, by its distance from the start of that.
  struct Along {
    double at = 0.0;
    Place place;
  };

  // A step, piece by piece: its special points, the grazings where its verdict changes, and the
  // solutions between those.
  void visit_step(const SeenSolution& from, const SeenSolution& to, OrbitBranchPoint at_end,
                  const std::vector<Along>& special_points) {
    std::list<GrazingStation> looked_at = grazings_.between(from, to);
    auto special = special_points.begin();
    const SeenSolution* before = &from;
    for (auto piece = looked_at.begin();; ++piece) {
      const bool last = piece == looked_at.end();
      const SeenSolution& here = last ? to : piece->seen;
      const std::size_t first = places_.size() - 1;
      for (; special != special_points.end() &&
             (last || special->at <= corrector_.ahead(*from.point, *here.point));
           ++special)
        places_.push_back(special->place);
      const bool changes = before->admissible != here.admissible;
      const auto next = last ? piece : std::next(piece);
      const bool changes_next =
          !last && (next == looked_at.end() ? to : next->seen).admissible != here.admissible;
      // Of the solutions that were only looked at those are listed that tell two grazings apart.
      if (last || changes || changes_next)
        places_.push_back({std::move(last ? at_end : piece->at), {}});
      if (changes)
        if (const auto edge = border(*before, here)) insert_border(places_, first, *edge);
      if (last) return;
      before = &here;
    }
  }

  Place special(const CriticalPoint& critical) const {
    Place place{equations_.judge(critical.point), {}};
    if (critical.kind == CriticalKind::kBranchPoint &&
        equations_.passes_half(branch_.points[critical.after],
                               branch_.points[critical.after + 1])) {
      // The doubling is a special point of the orbits of half the period; here it is an end.
      place.joins_half = true;
      return place;
    }
    place.special = as_special(critical, place.at);
    return place;
  }

  // Beyond a joint the trace went on by one point, at either end.
  void drop_beyond_halves() {
    if (places_.size() > 2 && places_[1].joins_half) places_.erase(places_.begin());
    if (places_.size() > 2 && places_[places_.size() - 2].joins_half) places_.pop_back();
  }

  // Where between a and b the solutions stop being orbits.
  std::optional<Place> border(const SeenSolution& a, const SeenSolution& b) const {
    const auto flight = [&](const BranchPoint& p) {
      return equations_.admissibility_of(p).shortest_flight;
    };
    if ((flight(*a.point) > 0.0) != (flight(*b.point) > 0.0))
      if (const auto point = locate(equations_.problem(), options_, *a.point, *b.point, flight)) {
        Place place{equations_.judge(*point), {}};
        place.meets = true;
        return place;
      }
    const std::optional<SpecialPoint> touch = grazing(a, b);
    if (!touch) return {};
    return Place{touch->at, touch};
  }

  bool penetrates(const BranchPoint& at) const {
    const double length = shooting_scale(*equations_.system_at(at.parameter)).length;
    return equations_.admissibility_of(at).clearance().value_or(0.0) < -kPenetration * length;
  }

  // Where an interior approach touches.
  std::optional<BranchPoint> touch(const BranchPoint& a, const BranchPoint& b) const {
    // Without an interior minimum the motion is as clear as its gap is wide.
    const auto clearance = [&](const BranchPoint& p) {
      return equations_.admissibility_of(p).clearance();
    };
    const double clear = std::max(clearance(a).value_or(0.0), clearance(b).value_or(0.0)) + 1.0;
    return locate(equations_.problem(), options_, a, b,
                  [&](const BranchPoint& p) { return clearance(p).value_or(clear); });
  }

  // Where an impact speed vanishes.
  std::optional<BranchPoint> standstill(const SeenSolution& a, const SeenSolution& b) const {
    // One of them is on the grazing within rounding.
    const double at_a = a.smallest_speed(), at_b = b.smallest_speed();
    if (at_a > 0.0 && at_b > 0.0) return at_a < at_b ? *a.point : *b.point;
    return locate(equations_.problem(), options_, *a.point, *b.point, [&](const BranchPoint& p) {
      return equations_.admissibility_of(p).smallest_speed;
    });
  }

  // Where an impact that leaves its stop at rest is pushed back.
  std::optional<BranchPoint> pushed_back(const BranchPoint& a, const BranchPoint& b) const {
    const auto pull = [&](const BranchPoint& p) {
      return -equations_.admissibility_of(p).push.value_or(-1.0);
    };
    if ((pull(a) < 0.0) == (pull(b) < 0.0)) return {};
    return locate(equations_.problem(), options_, a, b, pull);
  }

  std::optional<SpecialPoint> grazing(const SeenSolution& a, const SeenSolution& b) const {
    const double still = still_speed(*equations_.system_at(a.point->parameter));
    bool by_speed = (a.smallest_speed() > still) != (b.smallest_speed() > still);
    std::optional<BranchPoint> point =
        by_speed ? standstill(a, b) : pushed_back(*a.point, *b.point);
    bool by_push = point && !by_speed;
    if (by_speed && !point) return {};
    // An approach may have touched before.
    const bool at_end = by_speed && a.smallest_speed() > 0.0 && b.smallest_speed() > 0.0;
    if (!point || (!at_end && penetrates(*point))) {
      const bool before = point && a.admissible, behind = point && !before;
      by_speed = by_push = false;
      point = touch(behind ? *point : *a.point, before ? *point : *b.point);
    }
    if (!point) return {};
    SpecialPoint special{SpecialKind::kGrazing, "", equations_.judge(*point), {}, by_speed, *point};
    special.by_push = by_push;
    // It touches and does not cross; which side of that the last bit falls on says nothing.
    special.at.orbit.admissible = true;
    return special;
  }

  const OrbitEquations& equations_;
  const ContinuationOptions& options_;
  const Branch& branch_;
  bool keep_virtual_;
  Corrector corrector_;
  GrazingStations grazings_;
  std::vector<Place> places_;
};

}  // namespace

std::vector<OrbitBranch> orbit_parts(const OrbitEquations& equations,
                                     const ContinuationOptions& options, const Branch& branch,
                                     bool keep_virtual) {
  return Parts(equations, options, branch, keep_virtual).divide();
}

}  // namespace graze
