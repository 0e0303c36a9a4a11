#include "graze/study/plane/region_boundaries.hpp"

#include <algorithm>

namespace graze {
namespace {

// The side of the line from a to b on which a point of the plane lies.
template <class A, class B, class Point>
bool is_left(const A& a, const B& b, const Point& point) {
  return (b.value - a.value) * (point.second - a.second) >
         (b.second - a.second) * (point.value - a.value);
}

bool passes(const OrbitLocus& locus, const RegionPlace& a, const RegionPlace& b) {
  for (std::size_t i = 1; i < locus.points.size(); ++i) {
    const OrbitLocusPoint &from = locus.points[i - 1], &to = locus.points[i];
    if ((from.admissible || to.admissible) && is_left(a, b, from) != is_left(a, b, to) &&
        is_left(from, to, a) != is_left(from, to, b))
      return true;
  }
  return false;
}

// Whether the search there was completed.
bool is_known(const RegionPlace& place) { return place.finished && place.message.empty(); }

}  // namespace

RegionBoundaries region_boundaries(const StableRegions& regions, const OrbitLoci& traced) {
  const MotionName asked{AttractorKind::kOrbit, regions.period, regions.impacts};
  const auto holds = [&](const RegionPlace& place) {
    return std::find(place.stable.begin(), place.stable.end(), asked) != place.stable.end();
  };
  RegionBoundaries boundaries;
  const auto look = [&](std::size_t i, std::size_t other) {
    const RegionPlace &a = regions.places[i], &b = regions.places[other];
    if (!is_known(a) || !is_known(b) || holds(a) == holds(b)) return;
    ++boundaries.count;
    if (std::none_of(traced.loci.begin(), traced.loci.end(), [&](const OrbitLocus& locus) {
          return !is_of_level(locus.kind) && passes(locus, a, b);
        }))
      boundaries.open.emplace_back(i, other);
  };
  const auto columns = static_cast<std::size_t>(regions.columns);
  for (std::size_t i = 0; i < regions.places.size(); ++i) {
    if (i % columns + 1 < columns) look(i, i + 1);
    if (i + columns < regions.places.size()) look(i, i + columns);
  }
  return boundaries;
}

}  // namespace graze
