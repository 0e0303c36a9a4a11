#include "graze/bifurcation/orbit_component.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

OrbitBranchEnd as_orbit_end(BranchEnd end) {
  switch (end) {
    case BranchEnd::kParameterLimit:
      return OrbitBranchEnd::kParameterLimit;
    case BranchEnd::kClosed:
      return OrbitBranchEnd::kClosed;
    case BranchEnd::kStepLimit:
    case BranchEnd::kStopped:
      return OrbitBranchEnd::kStepLimit;
    case BranchEnd::kHalted:
    case BranchEnd::kNotConverged:
      break;
  }
  return OrbitBranchEnd::kNotConverged;
}

// The multiplier nearest to +1: the critical one at a fold.
std::optional<Complex> nearest_to_one(const std::vector<Eigenvalue>& multipliers) {
  std::optional<Complex> nearest;
  for (const Eigenvalue& m : multipliers)
    if (!nearest || std::abs(m.value - 1.0) < std::abs(*nearest - 1.0)) nearest = m.value;
  return nearest;
}

// A point or special point met along a component.
struct Station {
  OrbitBranchPoint at;
  std::optional<SpecialPoint> special;

  bool is_grazing() const { return special && special->kind == SpecialKind::kGrazing; }
  bool is_orbit() const { return at.orbit.admissible || is_grazing(); }
  // What ends a branch here: a grazing, unless none could be located.
  OrbitBranchEnd end() const {
    return is_grazing() ? OrbitBranchEnd::kGrazing : OrbitBranchEnd::kNotConverged;
  }
};

// Puts the grazing between the stations from `first` on where their verdict changes.
void insert_grazing(std::vector<Station>& stations, std::size_t first,
                    const SpecialPoint& grazing) {
  const bool verdict = stations[first].at.orbit.admissible;
  const auto changed =
      std::find_if(stations.begin() + static_cast<std::ptrdiff_t>(first), stations.end(),
                   [&](const Station& s) { return s.at.orbit.admissible != verdict; });
  stations.insert(changed, {grazing.at, grazing});
}

// Starts a closed sequence where it is no orbit, so that no part is cut in two by the start.
void open_outside(std::vector<Station>& stations) {
  const auto outside = std::find_if(stations.begin(), stations.end(),
                                    [](const Station& s) { return !s.is_orbit(); });
  if (outside == stations.begin() || outside == stations.end()) return;
  const auto offset = outside - stations.begin();
  stations.pop_back();  // repeats the first
  std::rotate(stations.begin(), stations.begin() + offset, stations.end());
  stations.push_back(stations.front());
}

}  // namespace

OrbitComponents::OrbitComponents(const SystemFamily& family, const ShootingProblem& shooting,
                                 const ContinuationOptions& continuation)
    : family_(family),
      shooting_(shooting),
      continuation_(continuation),
      problem_(orbit_problem(family, shooting)) {}

OrbitBranchPoint OrbitComponents::judge(const BranchPoint& point) const {
  const std::optional<System> system = family_.at(point.parameter);
  OrbitBranchPoint result{point.parameter, make_orbit(*system, shooting_, point.u), 0, 0.0};
  result.unstable_multipliers = count_multipliers(result.orbit.multipliers).outside;
  result.smallest_speed = std::numeric_limits<double>::infinity();
  for (const OrbitImpact& impact : result.orbit.impacts)
    result.smallest_speed = std::min(result.smallest_speed, impact.speed);
  return result;
}

Admissibility OrbitComponents::admissibility_at(const BranchPoint& point) const {
  const std::optional<System> system = family_.at(point.parameter);
  return admissibility(*system, shooting_.pattern(), shooting_.unpack(*system, point.u));
}

SpecialPoint OrbitComponents::fold(const Fold& at) const {
  SpecialPoint special{SpecialKind::kFold, "", judge(at.point), {}, false};
  special.multiplier = nearest_to_one(special.at.orbit.multipliers);
  return special;
}

std::optional<SpecialPoint> OrbitComponents::grazing(const BranchPoint& a, const BranchPoint& b,
                                                     const OrbitBranchPoint& at_a,
                                                     const OrbitBranchPoint& at_b) const {
  if (at_a.orbit.admissible == at_b.orbit.admissible) return {};
  const bool by_speed = (at_a.smallest_speed > 0.0) != (at_b.smallest_speed > 0.0);
  std::optional<BranchPoint> point;
  if (by_speed) {
    point = locate(problem_, continuation_, a, b,
                   [&](const BranchPoint& p) { return admissibility_at(p).smallest_speed; });
  } else {
    // Without an interior minimum the motion is as clear as its gap is wide.
    const double clear =
        std::max(at_a.orbit.clearance.value_or(0.0), at_b.orbit.clearance.value_or(0.0)) + 1.0;
    point = locate(problem_, continuation_, a, b, [&](const BranchPoint& p) {
      return admissibility_at(p).clearance.value_or(clear);
    });
  }
  if (!point) return {};
  SpecialPoint special{SpecialKind::kGrazing, "", judge(*point), {}, by_speed};
  // It touches and does not cross; which side of that the last bit falls on says nothing.
  special.at.orbit.admissible = true;
  return special;
}

std::vector<OrbitBranch> OrbitComponents::parts(const Branch& branch, bool keep_virtual) const {
  std::vector<Station> stations;
  auto next_fold = branch.folds.begin();
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    const Station here{judge(branch.points[i]), {}};
    if (i > 0) {
      const std::size_t first = stations.size() - 1;
      const OrbitBranchPoint before = stations[first].at;
      for (; next_fold != branch.folds.end() && next_fold->after == i - 1; ++next_fold) {
        const SpecialPoint special = fold(*next_fold);
        stations.push_back({special.at, special});
      }
      stations.push_back(here);
      if (const auto special = grazing(branch.points[i - 1], branch.points[i], before, here.at))
        insert_grazing(stations, first, *special);
    } else {
      stations.push_back(here);
    }
  }
  if (branch.closed() && !keep_virtual) open_outside(stations);

  std::vector<OrbitBranch> parts;
  bool inside = false;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const bool kept = keep_virtual || stations[i].is_orbit();
    if (kept && !inside) {
      parts.emplace_back();
      parts.back().ends[0] = i == 0 ? as_orbit_end(branch.ends[0]) : stations[i].end();
    }
    if (kept) {
      parts.back().points.push_back(stations[i].at);
      if (stations[i].special) parts.back().special.push_back(*stations[i].special);
      parts.back().ends[1] =
          i + 1 == stations.size() ? as_orbit_end(branch.ends[1]) : stations[i].end();
    }
    inside = kept;
  }
  return parts;
}

}  // namespace graze
