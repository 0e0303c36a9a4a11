#include "graze/bifurcation/strobe_loci.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "graze/orbit/strobe_orbit.hpp"

namespace graze {
namespace {

// Slopes of the map are known to about this, in its units: ten times what a contact is followed to.
constexpr double kMapAccuracy = 10.0 * kContactTolerance;
// So differences of slopes err least over steps of its cube root, in units of the map and in ranges
// of the parameters.
const double kStep = std::cbrt(kMapAccuracy);
// The test for a multiplier is formed from slopes: it vanishes to what these are known to, times
// what solving with them costs.
constexpr double kResidual = 1e3 * kMapAccuracy;

LocusKind as_locus_kind(OrbitLocusKind kind) {
  return kind == OrbitLocusKind::kPeriodDoubling ? LocusKind::kPeriodDoubling
         : kind == OrbitLocusKind::kTorus        ? LocusKind::kTorus
                                                 : LocusKind::kFold;
}

OrbitLocusEnd as_end(LocusEnd end) {
  switch (end) {
    case LocusEnd::kFirstLimit:
      return OrbitLocusEnd::kFirstLimit;
    case LocusEnd::kSecondLimit:
      return OrbitLocusEnd::kSecondLimit;
    case LocusEnd::kClosed:
      return OrbitLocusEnd::kClosed;
    case LocusEnd::kResonance:
      return OrbitLocusEnd::kResonance;
    case LocusEnd::kStepLimit:
      return OrbitLocusEnd::kStepLimit;
    case LocusEnd::kOutOfTime:
      return OrbitLocusEnd::kOutOfTime;
    case LocusEnd::kStopped:
      return OrbitLocusEnd::kStopped;
    case LocusEnd::kHalted:  // the orbits meet no stop any more
      return OrbitLocusEnd::kGrazing;
    case LocusEnd::kNotConverged:
      break;
  }
  return OrbitLocusEnd::kNotConverged;
}

System own_system(const Scene& scene, const std::string& parameter) {
  const SystemFamily family(scene, parameter);
  return *family.at(family.value());
}

}  // namespace

StrobeLoci::StrobeLoci(const Scene& scene, const std::string& first, const std::string& second,
                       const LocusOptions& options, const StrobeOptions& strobe)
    : systems_(scene, {first, second}), options_(options), map_(own_system(scene, first), strobe) {
  options_.residual_tolerance = kResidual;
  options_.proceed = [this](const LocusPoint&, const LocusPoint& here) {
    return point_of(here).has_value();
  };
}

std::optional<PlaneMapEvaluation> StrobeLoci::evaluate(const Vector& x, double p, double q) const {
  const std::array values{p, q};
  const System* system = systems_.at(values);
  const System* by_first = system ? systems_.tangent_at(values, 0) : nullptr;
  const System* by_second = by_first ? systems_.tangent_at(values, 1) : nullptr;
  if (!by_second) return {};
  std::optional<StrobeMap::Image> image = map_.image(*system, x, by_first);
  std::optional<Vector> second = image ? map_.rate(*system, x, *by_second) : std::nullopt;
  if (!second) return {};
  return PlaneMapEvaluation{std::move(image->image), std::move(image->jacobian),
                            std::move(image->by_parameter), std::move(*second)};
}

std::optional<double> StrobeLoci::product(const Vector& x, double p, double q, const Vector& left,
                                          const Vector& right) const {
  const System* system = systems_.at(std::array{p, q});
  const auto image = system ? map_.image(*system, x) : std::nullopt;
  return image ? std::optional(left.dot(image->jacobian * right)) : std::nullopt;
}

std::optional<Vector> StrobeLoci::curvature(const Vector& x, double p, double q, const Vector& left,
                                            const Vector& right) const {
  const double first = std::abs(options_.first_to - options_.first_from),
               second = std::abs(options_.second_to - options_.second_from);
  Vector slopes(x.size() + 2);
  for (Eigen::Index j = 0; j < slopes.size(); ++j) {
    const bool of_state = j < x.size();
    const Vector shift =
        of_state ? Vector(kStep * Vector::Unit(x.size(), j)) : Vector(Vector::Zero(x.size()));
    const double dp = j == x.size() ? kStep * first : 0.0,
                 dq = j == x.size() + 1 ? kStep * second : 0.0;
    const auto ahead = product(x + shift, p + dp, q + dq, left, right),
               behind = product(x - shift, p - dp, q - dq, left, right);
    if (!ahead || !behind) return {};
    slopes[j] = (*ahead - *behind) / (2.0 * (of_state ? kStep : dp + dq));
  }
  return slopes;
}

const PlaneProblem& StrobeLoci::problem(int period) {
  const auto known = problems_.find(period);
  if (known != problems_.end()) return known->second;
  PlaneMap map;
  map.evaluate = [this](const Vector& x, double p, double q) { return evaluate(x, p, q); };
  map.curvature = [this](const Vector& x, double p, double q, const Vector& left,
                         const Vector& right) { return curvature(x, p, q, left, right); };
  return problems_.emplace(period, periodic_points(map, period)).first->second;
}

std::optional<OrbitLocusPoint> StrobeLoci::point_of(const LocusPoint& at) const {
  const System* system = systems_.at(std::array{at.first, at.second});
  if (!system) return {};
  std::optional<Orbit> orbit = orbit_of(*system, map_, at.u, {}, at.residual);
  if (!orbit) return {};
  return OrbitLocusPoint{at.first, at.second, at.angle, std::move(orbit->impacts), true};
}

// In order along it, special points among the others.
OrbitLocus StrobeLoci::as_orbits(OrbitLocusKind kind, int period, const Locus& locus) const {
  OrbitLocus result;
  result.kind = kind;
  result.compliant = true;
  result.pattern.period = period;
  result.ends = {as_end(locus.ends[0]), as_end(locus.ends[1])};
  auto special = locus.special.begin();
  for (std::size_t i = 0; i < locus.points.size(); ++i) {
    if (auto at = point_of(locus.points[i])) result.points.push_back(std::move(*at));
    for (; special != locus.special.end() && special->after == i; ++special) {
      const auto at = point_of(special->point);
      if (!at) continue;
      result.points.push_back(*at);
      result.special.push_back({label_of(special->kind), "", *at});
    }
  }
  if (!result.points.empty())
    for (const OrbitImpact& impact : result.points.front().impacts)
      result.pattern.stops.push_back(impact.stop);
  return result;
}

StrobeLocusAnswer StrobeLoci::trace(const StrobeLocusStart& start) {
  StrobeLocusAnswer answer;
  const int period = static_cast<int>(start.turns.size());
  const Eigen::Index n = map_.size();
  LocusStart at{as_locus_kind(start.kind), Vector(period * n), start.first, start.second,
                start.multiplier};
  for (int i = 0; i < period; ++i)
    at.u.segment(i * n, n) = map_.pack(start.turns[static_cast<std::size_t>(i)]);
  std::vector<Locus>& traced = traced_[{period, start.kind}];
  answer.known = find_locus(problem(period), options_, traced, at).has_value();
  if (answer.known) return answer;
  std::optional<Locus> locus = trace_locus(problem(period), options_, at);
  if (!locus) return answer;
  answer.evaluations = locus->evaluations;
  OrbitLocus orbits = as_orbits(start.kind, period, *locus);
  if (!orbits.points.empty()) answer.locus = std::move(orbits);
  traced.push_back(std::move(*locus));
  return answer;
}

}  // namespace graze
