#include "graze/bifurcation/locus_margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/flow/transition.hpp"
#include "graze/hybrid/clearance.hpp"

namespace graze {
namespace {

Eigen::Index at(LocusMargin margin) { return static_cast<Eigen::Index>(margin); }

// The smallest interior minimum of any stop's gap but for the one that is the touch: at either end
// of the flights that it parts, where rounding may put it a little within.
std::optional<double> clearance_beside(const System& system, const ImpactPattern& pattern,
                                       const std::vector<ImpactPoint>& impacts, std::size_t touch) {
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  const double still = still_gap(system);
  const int touched = pattern.stops[touch];
  std::optional<double> lowest;
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const double flight = flight_time(system, pattern, impacts, i);
    if (!(flight > 0.0)) continue;
    const State after = after_impact(stop_of(system, pattern, i), impacts[i].before);
    arc.start(impacts[i].theta, after.q, after.qdot);
    const bool leaves = i == touch, reaches = (i + 1) % impacts.size() == touch;
    for (int k = 0; k < static_cast<int>(system.stops.size()); ++k) {
      const RigidStop& stop = system.stops[static_cast<std::size_t>(k)];
      const ArcCurve<double> curve(arc, gap_observable<double>(stop.row, stop.gap), flight,
                                   k == pattern.stops[i]);
      for (const GapMinimum& minimum :
           minima_below(curve, 0, lowest.value_or(std::numeric_limits<double>::infinity()))) {
        const bool at_touch = k == touched && std::abs(minimum.gap) <= still &&
                              (minimum.s < 0.5 * flight ? leaves : reaches);
        if (!at_touch && (!lowest || minimum.gap < *lowest)) lowest = minimum.gap;
      }
    }
  }
  return lowest;
}

}  // namespace

Vector approach_speeds(const System& system, const ImpactPattern& pattern,
                       const std::vector<ImpactPoint>& impacts) {
  Vector speeds(static_cast<Eigen::Index>(impacts.size()));
  for (std::size_t i = 0; i < impacts.size(); ++i)
    speeds[static_cast<Eigen::Index>(i)] =
        stop_of(system, pattern, i).row.dot(impacts[i].before.qdot);
  return speeds;
}

Vector locus_margins(const System& system, const ImpactPattern& pattern,
                     const std::vector<ImpactPoint>& impacts, std::optional<std::size_t> touch) {
  const Admissibility verdict = admissibility(system, pattern, impacts);
  Vector margins = Vector::Ones(kLocusMargins);
  const std::optional<double> clearance =
      touch ? clearance_beside(system, pattern, impacts, *touch) : verdict.clearance();
  if (clearance) margins[at(LocusMargin::kClearance)] = *clearance;
  margins[at(LocusMargin::kFlight)] = verdict.shortest_flight;
  if (verdict.push) margins[at(LocusMargin::kPull)] = -*verdict.push;
  if (!touch) {
    margins[at(LocusMargin::kSpeed)] = verdict.smallest_speed;
    return margins;
  }
  double slowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const RigidStop& stop = stop_of(system, pattern, i);
    if (i != *touch) {
      slowest = std::min(slowest, stop.row.dot(impacts[i].before.qdot));
      continue;
    }
    margins[at(LocusMargin::kBend)] =
        -stop.row.dot(vector_field(system, impacts[i].before, impacts[i].theta).qdot);
  }
  if (impacts.size() > 1) margins[at(LocusMargin::kSpeed)] = slowest;
  return margins;
}

bool is_admissible(const System& system, const Vector& margins) {
  return margins.minCoeff() > 0.0 && margins[at(LocusMargin::kSpeed)] > still_speed(system);
}

bool are_others_positive(const System& system, const Vector& margins, LocusMargin but_for) {
  Vector least = Vector::Zero(kLocusMargins);
  least[at(LocusMargin::kClearance)] = -still_gap(system);
  least[at(LocusMargin::kSpeed)] = -still_speed(system);
  for (Eigen::Index k = 0; k < kLocusMargins; ++k)
    if (k != at(but_for) && !(margins[k] >= least[k])) return false;
  return true;
}

}  // namespace graze
