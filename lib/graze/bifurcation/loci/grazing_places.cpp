#include "graze/bifurcation/loci/detail/grazing_places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/continuation/locus/detail/plane_curve.hpp"

namespace graze {
namespace {

// Where an impact speed vanishes while the flow over a period has a singular block, multipliers of
// every size meet: LP, PD and NS loci end on the grazing there, their equations singular, and creep
// up to it. Speeds below this part of the forced motion's count as on it; multipliers are not
// reported there.
constexpr double kOnGrazing = 1e-9;

// Grazings nearer than this, in ranges of the parameters, are the same.
constexpr double kOneGrazing = 1e-9;

// An approach beside the impact that vanishes touches to v^2/2a, which is zero within the error of
// gaps (still_gap, 1e-12 of the motion's length) up to this part of its speed.
constexpr double kTouching = 1.5e-6;

// Whether an approach touches because an impact beside it has nearly vanished: then the zero of its
// gap is rounding.
bool is_one_grazing(const LocusPlace& a, const LocusPlace& b, double unit) {
  const auto has = [](const LocusPlace& place, LocusMargin margin) {
    return place.boundary == margin;
  };
  const auto slow = [unit](const LocusPlace& place) {
    return place.margins[static_cast<Eigen::Index>(LocusMargin::kSpeed)] <= kTouching * unit;
  };
  return (has(a, LocusMargin::kSpeed) && has(b, LocusMargin::kClearance) && slow(b)) ||
         (has(b, LocusMargin::kSpeed) && has(a, LocusMargin::kClearance) && slow(a));
}

}  // namespace

double distance(const OrbitLocusPoint& a, const OrbitLocusPoint& b, const LocusOptions& options) {
  return std::hypot((a.value - b.value) / first_range(options),
                    (a.second - b.second) / second_range(options));
}

void end_on_grazing(std::vector<LocusPlace>& places, std::array<OrbitLocusEnd, 2> ends,
                    double unit) {
  const auto is_on_it = [&](const LocusPlace& place) {
    return place.margins.size() > 0 &&
           std::any_of(place.at.impacts.begin(), place.at.impacts.end(),
                       [&](const OrbitImpact& impact) {
                         return std::abs(impact.speed) <= kOnGrazing * unit;
                       });
  };
  std::erase_if(places,
                [&](const LocusPlace& place) { return !place.label.empty() && is_on_it(place); });
  for (const std::size_t end : {0u, 1u}) {
    LocusPlace& last = end == 0 ? places.front() : places.back();
    if (ends[end] == OrbitLocusEnd::kNotConverged && is_on_it(last))
      last.boundary = LocusMargin::kSpeed;
  }
}

void merge_boundaries(std::vector<LocusPlace>& places, const LocusOptions& options, double unit) {
  std::vector<LocusPlace> merged;
  for (LocusPlace& place : places) {
    const bool same = !merged.empty() && (merged.back().boundary || place.boundary) &&
                      (distance(merged.back().at, place.at, options) <= kOneGrazing ||
                       is_one_grazing(merged.back(), place, unit));
    if (!same)
      merged.push_back(std::move(place));
    else if (!merged.back().boundary || place.boundary == LocusMargin::kSpeed)
      merged.back() = std::move(place);
  }
  places = std::move(merged);
}

}  // namespace graze
