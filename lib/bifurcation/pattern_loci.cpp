#include "graze/bifurcation/pattern_loci.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/continuation/branch.hpp"
#include "graze/continuation/crossing_tests.hpp"

namespace graze {
namespace {

// Beside a grazing multipliers go with the impact speed, and turn where it does nothing more than
// halve or change its sign; from here on, a part of the forced motion's speed, no longer.
constexpr double kSlowest = 1e-5;

bool resolves_speeds(const Vector& from, const Vector& to, double unit) {
  if (from.size() != to.size()) return true;
  for (Eigen::Index i = 0; i < from.size(); ++i) {
    const double larger = std::max(std::abs(from[i]), std::abs(to[i]));
    if (std::abs(to[i] - from[i]) > std::max(0.5 * larger, kSlowest * unit)) return false;
  }
  return true;
}

// Where an impact speed vanishes as the flow over a period has a singular block, multipliers of
// every size meet: LP, PD and NS loci end on the grazing there, their equations singular, and creep
// up to it. Speeds below this part of the forced motion's are on it; nothing is said there of
// multipliers.
constexpr double kOnGrazing = 1e-9;

void end_on_grazing(std::vector<LocusPlace>& places, std::array<OrbitLocusEnd, 2> ends,
                    double unit) {
  const auto is_on_it = [&](const LocusPlace& place) {
    return std::any_of(
        place.at.impacts.begin(), place.at.impacts.end(),
        [&](const OrbitImpact& impact) { return std::abs(impact.speed) <= kOnGrazing * unit; });
  };
  std::erase_if(places,
                [&](const LocusPlace& place) { return !place.label.empty() && is_on_it(place); });
  for (const std::size_t end : {0u, 1u}) {
    LocusPlace& last = end == 0 ? places.front() : places.back();
    if (ends[end] == OrbitLocusEnd::kNotConverged && is_on_it(last))
      last.border = LocusMargin::kSpeed;
  }
}

// Grazings nearer than this, in ranges of the parameters, are one.
constexpr double kOneGrazing = 1e-9;

// Of the pair nearest to the unit circle but for the critical one; nothing where there is no pair.
std::optional<double> other_angle(const std::vector<Eigenvalue>& multipliers, double critical) {
  constexpr double kSame = 1e-6;  // rad; the critical multiplier is exact
  std::optional<double> angle;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigenvalue& m : multipliers) {
    const double at = std::abs(std::arg(m.value)), off = std::abs(std::abs(m.value) - 1.0);
    if (m.value.imag() == 0.0 || std::abs(at - critical) <= kSame || !(off < least)) continue;
    least = off;
    angle = at;
  }
  return angle;
}

// A place within the step after a point.
struct Within {
  std::size_t after = 0;
  LocusPlace place;
};

// `zero`: the margin that vanishes there, where one does.
LocusPlace place_of(const System& system, const ImpactPattern& pattern,
                    const std::vector<ImpactPoint>& impacts, std::optional<std::size_t> touch,
                    OrbitLocusPoint at, std::optional<LocusMargin> zero) {
  at.impacts = ordered_impacts(system, pattern, impacts);
  LocusPlace place{std::move(at), locus_margins(system, pattern, impacts, touch), "", {}};
  place.at.admissible = is_admissible(system, place.margins);
  if (zero && are_others_positive(system, place.margins, *zero)) place.border = zero;
  return place;
}

// An approach beside the impact that vanishes touches to v^2/2a, which is zero within what gaps are
// known to (still_gap, 1e-12 of the motion's length) up to this part of its speed.
constexpr double kTouching = 1.5e-6;

// Whether an approach touches because an impact beside it has all but vanished: then where its gap
// passes zero is rounding.
bool is_one_touch(const LocusPlace& a, const LocusPlace& b, double unit) {
  const auto has = [](const LocusPlace& place, LocusMargin margin) {
    return place.border == margin;
  };
  const auto slow = [unit](const LocusPlace& place) {
    return place.margins[static_cast<Eigen::Index>(LocusMargin::kSpeed)] <= kTouching * unit;
  };
  return (has(a, LocusMargin::kSpeed) && has(b, LocusMargin::kClearance) && slow(b)) ||
         (has(b, LocusMargin::kSpeed) && has(a, LocusMargin::kClearance) && slow(a));
}

// As an impact speed vanishes an approach touches too: one grazing, not two. A locus that was
// started there has it among its points as well, on whatever side the last bit puts it. `unit`: of
// speeds, m/s.
void merge_borders(std::vector<LocusPlace>& places, const LocusOptions& options, double unit) {
  std::vector<LocusPlace> merged;
  for (LocusPlace& place : places) {
    const bool same = !merged.empty() && (merged.back().border || place.border) &&
                      (distance(merged.back().at, place.at, options) <= kOneGrazing ||
                       is_one_touch(merged.back(), place, unit));
    if (!same)
      merged.push_back(std::move(place));
    else if (!merged.back().border || place.border == LocusMargin::kSpeed)
      merged.back() = std::move(place);
  }
  places = std::move(merged);
}

// The points of a locus, and between them what lies within its steps, in order.
std::vector<LocusPlace> in_order(std::vector<LocusPlace> points, std::vector<Within> within,
                                 const LocusOptions& options) {
  const auto along = [&](const Within& item) {
    return distance(points[item.after].at, item.place.at, options);
  };
  std::stable_sort(within.begin(), within.end(), [&](const Within& a, const Within& b) {
    return a.after != b.after ? a.after < b.after : along(a) < along(b);
  });
  std::vector<LocusPlace> all;
  auto next = within.begin();
  for (std::size_t i = 0; i < points.size(); ++i) {
    all.push_back(std::move(points[i]));
    for (; next != within.end() && next->after == i; ++next) all.push_back(std::move(next->place));
  }
  return all;
}

}  // namespace

double distance(const OrbitLocusPoint& a, const OrbitLocusPoint& b, const LocusOptions& options) {
  return std::hypot((a.value - b.value) / first_range(options),
                    (a.second - b.second) / second_range(options));
}

CriticalLoci::CriticalLoci(const LocusPlane& plane, OrbitLocusKind kind,
                           const ImpactPattern& pattern)
    : kind_(kind),
      orbits_(*plane.scene, {plane.first, plane.second}, pattern, plane.scale),
      options_(plane.options),
      speed_unit_(plane.speed_unit()) {
  options_.tests = [this](const LocusPoint& at) { return margins(at); };
  options_.resolves = [this](const LocusPoint& from, const LocusPoint& to) {
    return resolves_speeds(speeds(from), speeds(to), speed_unit_);
  };
}

Vector CriticalLoci::speeds(const LocusPoint& at) const {
  const System* system = orbits_.system_at(std::array{at.first, at.second});
  if (!system) return {};
  return approach_speeds(*system, orbits_.pattern(), orbits_.shooting().unpack(*system, at.u));
}

std::optional<Vector> CriticalLoci::margins(const LocusPoint& at) const {
  const System* system = orbits_.system_at(std::array{at.first, at.second});
  if (!system) return {};
  return locus_margins(*system, orbits_.pattern(), orbits_.shooting().unpack(*system, at.u), {});
}

LocusPlace CriticalLoci::place(const LocusPoint& at, std::optional<LocusMargin> zero) const {
  const System& system = *orbits_.system_at(std::array{at.first, at.second});
  return place_of(system, orbits_.pattern(), orbits_.shooting().unpack(system, at.u), {},
                  {at.first, at.second, at.angle, {}, false}, zero);
}

bool CriticalLoci::knows(const OrbitLocusStart& start) const {
  if (traced_.empty()) return false;
  for (const std::vector<ImpactPoint>& same : rewritings(orbits_.pattern(), start.orbit.impacts))
    if (find_locus(orbits_.problem(), options_, traced_,
                   {as_locus_kind(kind_), orbits_.shooting().pack(same), start.first, start.second,
                    start.multiplier}))
      return true;
  return false;
}

LocusAnswer CriticalLoci::trace(const OrbitLocusStart& start) {
  LocusAnswer answer;
  answer.known = knows(start);
  if (answer.known) return answer;
  std::optional<Locus> locus =
      trace_locus(orbits_.problem(), options_,
                  {as_locus_kind(kind_), orbits_.shooting().pack(start.orbit.impacts), start.first,
                   start.second, start.multiplier});
  if (!locus) return answer;
  answer.evaluations = locus->evaluations;
  std::vector<LocusPlace> points;
  for (const LocusPoint& point : locus->points) points.push_back(place(point));
  std::vector<Within> within;
  for (const LocusSpecialPoint& special : locus->special) {
    within.push_back({special.after, place(special.point)});
    within.back().place.label = label_of(special.kind);
    within.back().place.other_angle = other_angle(special.point.multipliers, special.point.angle);
  }
  for (const LocusZero& zero : locus->zeros)
    within.push_back({zero.after, place(zero.point, static_cast<LocusMargin>(zero.test))});
  OrbitLocus frame;
  frame.kind = kind_;
  frame.pattern = orbits_.pattern();
  frame.ends = {as_orbit_end(locus->ends[0]), as_orbit_end(locus->ends[1])};
  answer.trace =
      LocusTrace{std::move(frame), in_order(std::move(points), std::move(within), options_)};
  end_on_grazing(answer.trace->places, answer.trace->frame.ends, speed_unit_);
  merge_borders(answer.trace->places, options_, speed_unit_);
  traced_.push_back(std::move(*locus));
  return answer;
}

GrazingLoci::GrazingLoci(const LocusPlane& plane, const ImpactPattern& pattern)
    : options_(plane.options),
      curve_(*plane.scene, plane.first, plane.second, pattern, 0, plane.scale,
             first_range(plane.options)),
      problem_(curve_.problem()),
      speed_unit_(plane.speed_unit()) {
  problem_.tests = [this](const BranchPoint&, const BranchPoint& at) { return tests(at); };
  problem_.resolves = [this, unit = speed_unit_](const BranchPoint& from, const BranchPoint& to) {
    return resolves_speeds(speeds(from), speeds(to), unit);
  };
}

Vector GrazingLoci::speeds(const BranchPoint& at) const {
  const System* system = curve_.system_at(curve_.first_of(at), at.parameter);
  if (!system) return {};
  Vector speeds = approach_speeds(*system, curve_.shooting().pattern(), curve_.impacts_of(at));
  speeds[static_cast<Eigen::Index>(curve_.touch())] = 0.0;  // but for rounding
  return speeds;
}

// Its margins, and after them a function that changes sign where a multiplier passes 1.
std::optional<Vector> GrazingLoci::tests(const BranchPoint& at) const {
  const System* system = curve_.system_at(curve_.first_of(at), at.parameter);
  if (!system) return {};
  Vector tests = Vector::Ones(kLocusMargins + 1);
  tests.head(kLocusMargins) =
      locus_margins(*system, curve_.shooting().pattern(), curve_.impacts_of(at), curve_.touch());
  if (!problem_.problem.multipliers) return tests;
  const std::vector<Eigenvalue> list =
      problem_.problem.multipliers(at.u, at.parameters(), ErrorBounds::kLeftOut);
  if (list.empty()) return {};
  tests[kLocusMargins] = crossing_tests(list)[kFoldTest].value();
  return tests;
}

LocusPlace GrazingLoci::place(const BranchPoint& at, std::optional<LocusMargin> zero) const {
  const double first = curve_.first_of(at);
  return place_of(*curve_.system_at(first, at.parameter), curve_.shooting().pattern(),
                  curve_.impacts_of(at), curve_.touch(), {first, at.parameter, 0.0, {}, false},
                  zero);
}

LocusAnswer GrazingLoci::trace(const OrbitLocusStart& start) {
  LocusAnswer answer;
  const std::optional<BranchPoint> point = point_on_curve(
      problem_, options_, curve_.pack(start.orbit.impacts, start.first), start.second);
  if (!point) return answer;
  const ContinuationOptions along = branch_options(problem_, options_);
  answer.known = std::any_of(traced_.begin(), traced_.end(), [&](const Branch& branch) {
    return lies_on(problem_.problem, along, branch, *point);
  });
  if (answer.known) return answer;
  PlaneCurve traced = trace_curve(problem_, options_, *point);
  answer.evaluations = traced.branch.evaluations;
  std::vector<LocusPlace> points;
  for (const BranchPoint& at : traced.branch.points) points.push_back(place(at));
  std::vector<Within> within;
  for (const TestZero& zero : traced.zeros) {
    if (zero.test < kLocusMargins) {
      within.push_back({zero.after, place(zero.point, static_cast<LocusMargin>(zero.test))});
      continue;
    }
    within.push_back({zero.after, place(zero.point)});
    within.back().place.label = "LPGR";
  }
  for (const CriticalPoint& critical : traced.branch.critical) {
    const bool doubling = critical.kind == CriticalKind::kPeriodDoubling;
    if (!doubling && critical.kind != CriticalKind::kTorus) continue;
    within.push_back({critical.after, place(critical.point)});
    within.back().place.label = doubling ? "PDGR" : "NSGR";
    if (critical.multiplier)
      within.back().place.other_angle = std::abs(std::arg(critical.multiplier->value));
  }
  OrbitLocus frame;
  frame.kind = OrbitLocusKind::kGrazing;
  frame.pattern = curve_.shooting().pattern();
  for (const std::size_t side : {0u, 1u})
    frame.ends[side] = as_orbit_end(as_locus_end(traced.branch.ends[side], true));
  answer.trace =
      LocusTrace{std::move(frame), in_order(std::move(points), std::move(within), options_)};
  merge_borders(answer.trace->places, options_, speed_unit_);
  traced_.push_back(std::move(traced.branch));
  return answer;
}

}  // namespace graze
