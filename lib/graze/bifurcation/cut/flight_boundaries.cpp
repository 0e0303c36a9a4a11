#include "graze/bifurcation/cut/detail/flight_boundaries.hpp"

#include <cmath>
#include <utility>

#include "graze/bifurcation/problem/grazing_orbit.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/search/detail/contact_starts.hpp"

namespace graze {
namespace {

// Largest penetration that counts as none, in length scales.
constexpr double kPenetration = 1e-12;

bool penetrates(const FlightEquations& equations, const SolutionPoint& at) {
  const double length = motion_scale(*equations.system_at(at.parameters())).length;
  return equations.admissibility_of(at).clearance().value_or(0.0) < -kPenetration * length;
}

// Where an interior approach touches.
std::optional<SolutionPoint> grazing_approach(const FlightEquations& equations,
                                              const ContinuationOptions& options,
                                              const SolutionPoint& a, const SolutionPoint& b) {
  // Without an interior minimum the gap itself is the clearance.
  const auto clearance = [&](const SolutionPoint& p) {
    return equations.admissibility_of(p).clearance();
  };
  const double clear = std::max(clearance(a).value_or(0.0), clearance(b).value_or(0.0)) + 1.0;
  return locate(equations.problem(), options, a, b,
                [&](const SolutionPoint& p) { return clearance(p).value_or(clear); });
}

// Where an impact speed vanishes.
std::optional<SolutionPoint> vanishing_impact(const FlightEquations& equations,
                                              const ContinuationOptions& options,
                                              const SeenSolution& a, const SeenSolution& b) {
  // One of the two is on the grazing within rounding.
  const double at_a = a.smallest_speed(), at_b = b.smallest_speed();
  if (at_a > 0.0 && at_b > 0.0) {
    SolutionPoint nearer = at_a < at_b ? *a.point : *b.point;
    nearer.bracket = bracket_around({nearer.parameter}, true);
    return nearer;
  }
  return locate(equations.problem(), options, *a.point, *b.point, [&](const SolutionPoint& p) {
    return equations.admissibility_of(p).smallest_speed;
  });
}

// Where an impact that leaves its stop at rest is pushed back.
std::optional<SolutionPoint> pushed_back(const FlightEquations& equations,
                                         const ContinuationOptions& options, const SolutionPoint& a,
                                         const SolutionPoint& b) {
  const auto pull = [&](const SolutionPoint& p) {
    return -equations.admissibility_of(p).push.value_or(-1.0);
  };
  if ((pull(a) < 0.0) == (pull(b) < 0.0)) return {};
  return locate(equations.problem(), options, a, b, pull);
}

// The impacts of a grazing orbit on its other side; nullopt when there are none left.
std::optional<GrazingOrbit> impacts_across(const FlightEquations& equations,
                                           const SpecialPoint& special) {
  const ImpactPattern& pattern = equations.pattern();
  const std::vector<ImpactPoint> impacts = equations.points(special.solution);
  if (!special.by_speed)
    return with_grazing(*equations.system_at(special.solution.parameters()), pattern, impacts);
  GrazingOrbit orbit{pattern, impacts, equations.admissibility_of(special.solution).slowest};
  if (orbit.impacts.size() == 1) return {};
  return without_grazing(std::move(orbit));
}

}  // namespace

bool FlightBoundaries::lists(const SolutionPoint& solution) const {
  return branches_.keep_virtual || equations_.admissibility_of(solution).admissible;
}

const SeenSolution& FlightBoundaries::seen(const JudgedPoint& at) {
  return seen_.answer({at.point.u, at.point.parameter, at.point.tangent},
                      [&] { return samples_.seen(at.point, at.place.at); });
}

BranchPlace FlightBoundaries::place_of(const OrbitBranchPoint& at) const {
  return {at, {}, branches_.keep_virtual || at.orbit.admissible};
}

void FlightBoundaries::pass(const JudgedPoint& a, const JudgedPoint& b,
                            std::vector<BranchPlace>& places) {
  SeenSolution from = seen(a), to = seen(b);
  from.point = &a.point;
  to.point = &b.point;
  const std::list<GrazingSample> looked_at = samples_.between(from, to);
  const SeenSolution* before = &from;
  for (auto sample = looked_at.begin();; ++sample) {
    const bool last = sample == looked_at.end();
    const SeenSolution& here = last ? to : sample->seen;
    const bool changes = before->admissible != here.admissible;
    if (changes)
      if (std::optional<BranchPlace> boundary = between(*before, here))
        places.push_back(std::move(*boundary));
    if (last) return;
    const auto next = std::next(sample);
    const bool changes_next =
        (next == looked_at.end() ? to : next->seen).admissible != here.admissible;
    // Of the samples only those that separate two grazings are listed.
    if (changes || changes_next) places.push_back(place_of(sample->at));
    before = &here;
  }
}

// The boundary between two solutions, one of which is an orbit.
std::optional<BranchPlace> FlightBoundaries::between(const SeenSolution& a,
                                                     const SeenSolution& b) const {
  const auto flight = [&](const SolutionPoint& p) {
    return equations_.admissibility_of(p).shortest_flight;
  };
  if ((flight(*a.point) > 0.0) != (flight(*b.point) > 0.0))
    if (const auto point = locate(equations_.problem(), options_, *a.point, *b.point, flight)) {
      return BranchPlace{equations_.orbit_at(*point), {}, true, OrbitBranchEnd::kImpactsMeet};
    }
  return grazing(a, b);
}

std::optional<BranchPlace> FlightBoundaries::grazing(const SeenSolution& a,
                                                     const SeenSolution& b) const {
  const double still = still_speed(*equations_.system_at(a.point->parameters()));
  bool by_speed = (a.smallest_speed() > still) != (b.smallest_speed() > still);
  std::optional<SolutionPoint> point = by_speed
                                           ? vanishing_impact(equations_, options_, a, b)
                                           : pushed_back(equations_, options_, *a.point, *b.point);
  bool by_push = point && !by_speed;
  if (by_speed && !point) return {};
  // An approach may have touched before.
  const bool at_end = by_speed && a.smallest_speed() > 0.0 && b.smallest_speed() > 0.0;
  if (!point || (!at_end && penetrates(equations_, *point))) {
    const bool before = point && a.admissible, behind = point && !before;
    by_speed = by_push = false;
    point = grazing_approach(equations_, options_, behind ? *point : *a.point,
                             before ? *point : *b.point);
  }
  if (!point) return {};
  SpecialPoint special{
      SpecialKind::kGrazing, "", equations_.orbit_at(*point), {}, by_speed, *point};
  special.by_push = by_push;
  // It touches and does not cross; the side on which the last bit falls has no meaning.
  special.at.orbit.admissible = true;
  BranchPlace place{special.at, {}, true, OrbitBranchEnd::kGrazing};
  if (by_push && branches_.follow_depth > 0)
    place.others = held_beyond(*point, (a.admissible ? b : a).point->parameter);
  place.special = std::move(special);
  return place;
}

// Beyond a push the structure is held for some time, which grows with the distance. Returns the
// nearest orbit that sticks, found by the motion from the first impact; none where orbits that
// stick are not wanted.
std::vector<OrbitBranchPoint> FlightBoundaries::held_beyond(const SolutionPoint& push,
                                                            double towards) const {
  if (!branches_.sticking) return {};
  const double range = std::abs(options_.to - options_.from);
  const ImpactPoint impact = equations_.points(push).front();
  for (const double part : {1e-4, 1e-3, 1e-2}) {
    const double value = push.parameter + std::copysign(part * range, towards - push.parameter);
    const System* system = equations_.system_at(value);
    if (!system) continue;
    SegmentOptions segment;
    segment.closure_speed =
        branches_.finder.closure_speed.value_or(default_closure_speed(*system, impact.before));
    segment.max_impacts = branches_.finder.max_impacts;
    segment.stop = options_.stop;
    const auto start =
        period_end_after(*system, impact, equations_.pattern().stops.front(), segment);
    if (!start) continue;
    FollowedAnswer answer = followed_orbit(*system, *start, equations_.period(), segment);
    if (answer.orbit) return {point_of_branch(value, std::move(*answer.orbit))};
  }
  return {};
}

// The solution beyond a push is no orbit at the grazing itself.
std::optional<Orbit> FlightBoundaries::across(const SpecialPoint& special) const {
  if (special.kind != SpecialKind::kGrazing || special.by_push) return {};
  const std::optional<GrazingOrbit> impacts = impacts_across(equations_, special);
  if (!impacts) return {};
  Orbit orbit;
  orbit.period = impacts->pattern.period;
  orbit.impacts = ordered_impacts(*equations_.system_at(special.solution.parameters()),
                                  impacts->pattern, impacts->impacts);
  return orbit;
}

}  // namespace graze
