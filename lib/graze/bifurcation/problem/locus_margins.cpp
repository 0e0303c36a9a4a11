#include "graze/bifurcation/problem/detail/locus_margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/flow/variation/detail/transition.hpp"
#include "graze/motion/detail/clearance.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

Eigen::Index at(LocusMargin margin) { return static_cast<Eigen::Index>(margin); }

// A flight between impacts with nonzero speed, or a whole period where there are none.
struct RealFlight {
  std::size_t impact = 0;  // the impact before it; where there are none the grazing contact
  State start;
  double theta = 0.0, duration = 0.0;  // rad, s
  int leaves = -1;                     // the stop, where it leaves one
  std::optional<double> grazing;       // when it touches, s
};

std::vector<RealFlight> real_flights(const System& system, const ExactFlow<double>& flow,
                                     const ImpactPattern& pattern,
                                     const std::vector<ImpactPoint>& impacts, std::size_t grazing) {
  const double frequency = system.forcing()->frequency;
  if (impacts.size() == 1) {
    // Starts half a period after the grazing contact.
    const double half = 0.5 * pattern.period * system.period();
    const State start = transition(system, flow, impacts[0].before, impacts[0].theta, half).end;
    return {{0, start, impacts[0].theta + frequency * half, 2.0 * half, -1, half}};
  }
  std::vector<RealFlight> flights;
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    if (i == grazing) continue;
    RealFlight next{i,
                    after_impact(stop_of(system, pattern, i), impacts[i].before),
                    impacts[i].theta,
                    flight_time(system, pattern, impacts, i),
                    pattern.stops[i],
                    {}};
    if ((i + 1) % impacts.size() == grazing) {
      next.grazing = next.duration;
      next.duration += flight_time(system, pattern, impacts, grazing);
    }
    flights.push_back(std::move(next));
  }
  return flights;
}

}  // namespace

std::optional<ApproachBeside> approach_beside(const System& system, const ImpactPattern& pattern,
                                              const std::vector<ImpactPoint>& impacts,
                                              std::size_t grazing) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  std::optional<ApproachBeside> lowest;
  for (const RealFlight& flight : real_flights(system, flow, pattern, impacts, grazing)) {
    if (!(flight.duration > 0.0)) continue;
    arc.start(flight.theta, flight.start.q, flight.start.qdot);
    for (int k = 0; k < static_cast<int>(system.stops.size()); ++k) {
      const Stop& stop = system.stops[static_cast<std::size_t>(k)];
      const ArcCurve<double> curve(arc, gap_observable<double>(stop.row, stop.gap), flight.duration,
                                   k == flight.leaves);
      const bool grazes = flight.grazing && k == pattern.stops[grazing];
      std::vector<GapMinimum> minima =
          minima_below(curve, 0, grazes || !lowest ? kFar : lowest->gap);
      if (grazes && !minima.empty())
        minima.erase(std::min_element(
            minima.begin(), minima.end(), [&](const GapMinimum& a, const GapMinimum& b) {
              return std::abs(a.s - *flight.grazing) < std::abs(b.s - *flight.grazing);
            }));
      for (const GapMinimum& minimum : minima)
        if (!lowest || minimum.gap < lowest->gap)
          lowest =
              ApproachBeside{flight.impact, k, flight.start, flight.theta, minimum.s, minimum.gap};
    }
  }
  return lowest;
}

Vector approach_speeds(const System& system, const ImpactPattern& pattern,
                       const std::vector<ImpactPoint>& impacts) {
  Vector speeds(static_cast<Eigen::Index>(impacts.size()));
  for (std::size_t i = 0; i < impacts.size(); ++i)
    speeds[static_cast<Eigen::Index>(i)] =
        stop_of(system, pattern, i).row.dot(impacts[i].before.qdot);
  return speeds;
}

Vector locus_margins(const System& system, const ImpactPattern& pattern,
                     const std::vector<ImpactPoint>& impacts, std::optional<std::size_t> grazing) {
  const Admissibility classification = admissibility(system, pattern, impacts);
  Vector margins = Vector::Ones(kLocusMargins);
  std::optional<double> clearance = classification.clearance();
  if (grazing) {
    const auto beside = approach_beside(system, pattern, impacts, *grazing);
    clearance = beside ? std::optional(beside->gap) : std::nullopt;
  }
  if (clearance) margins[at(LocusMargin::kClearance)] = *clearance;
  margins[at(LocusMargin::kFlight)] = classification.shortest_flight;
  if (classification.push) margins[at(LocusMargin::kPull)] = -*classification.push;
  if (!grazing) {
    margins[at(LocusMargin::kSpeed)] = classification.smallest_speed;
    return margins;
  }
  double slowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const Stop& stop = stop_of(system, pattern, i);
    if (i != *grazing) {
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
