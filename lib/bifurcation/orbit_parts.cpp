#include "graze/bifurcation/orbit_parts.hpp"

#include <algorithm>
#include <iterator>
#include <list>
#include <utility>

#include "graze/bifurcation/grazing_stations.hpp"
#include "graze/bifurcation/open_sequence.hpp"
#include "graze/bifurcation/orbit_borders.hpp"

namespace graze {
namespace {

// Halves nearer than this, in the units of the unknowns, are one: solutions are known to about the
// square root of eps where they are least well determined.
constexpr double kOneOrbit = 1e-7;

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
    if (branch_.closed() && !keep_virtual_)
      open_outside(places_, [](const Place& s) { return !s.is_orbit(); });
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
        if (equations_.system_at(critical->point.parameters()) &&
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
        if (const auto border = border_between(equations_, options_, *before, here))
          insert_border(places_, first, {border->at, border->grazing, false, !border->grazing});
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
    place.at = with_critical(std::move(place.at), critical);
    place.special = as_special(critical, place.at);
    return place;
  }

  // Beyond a joint the trace went on by one point, at either end.
  void drop_beyond_halves() {
    if (places_.size() > 2 && places_[1].joins_half) places_.erase(places_.begin());
    if (places_.size() > 2 && places_[places_.size() - 2].joins_half) places_.pop_back();
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
