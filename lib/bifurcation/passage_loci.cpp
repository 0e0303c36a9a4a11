#include "graze/bifurcation/passage_loci.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "graze/bifurcation/locus_border.hpp"
#include "graze/continuation/branch.hpp"
#include "graze/continuation/plane_curve.hpp"
#include "graze/orbit/laid_orbit.hpp"

namespace graze {
namespace {

// Contacts may be born and lost along it: those of its first point name it.
void name_pattern(OrbitLocus& locus) {
  if (locus.points.empty()) return;
  const OrbitLocusPoint& first = locus.points.front();
  for (const OrbitHold& hold : first.holds) locus.pattern.stops.push_back(hold.stop);
  if (locus.sticks()) return;
  for (const OrbitImpact& impact : first.impacts) locus.pattern.stops.push_back(impact.stop);
}

OrbitLocusPoint as_point(double first, double second, double angle, const Orbit& orbit) {
  return {first, second, angle, orbit.impacts, true, orbit.holds, orbit.section};
}

// What happens from its release on at a point of a locus of orbits that stick.
std::optional<Itinerary> itinerary_at(const PassageEquations& equations, const LocusPoint& at) {
  const System* system = equations.system_at(std::array{at.first, at.second});
  const auto back =
      system ? return_of(*system, equations.shooting(), at.u) : std::optional<ReleaseReturn>();
  if (!back || !back->returns) return {};
  return back->itinerary;
}

bool grazes_at(const PassageEquations& equations, const LocusPoint& at) {
  const System* system = equations.system_at(std::array{at.first, at.second});
  const auto back = system ? return_of(*system, equations.shooting(), at.u, true)
                           : std::optional<ReleaseReturn>();
  return back && grazes_at(back->passage, back->itinerary, motion_scale(*system));
}

// How the locus ends between neighbours; nothing where it goes on.
std::optional<OrbitLocusEnd> end_between(const PassageEquations& equations, const LocusPoint& a,
                                         const LocusPoint& b) {
  const auto before = itinerary_at(equations, a), now = itinerary_at(equations, b);
  if (!before || !now) return OrbitLocusEnd::kChatterCompletes;
  return locus_end_between(*before, *now, equations.speed_unit());
}

}  // namespace

PassageLoci::PassageLoci(const Scene& scene, const std::string& first, const std::string& second,
                         const LocusOptions& options, const PassageOptions& passage)
    : scene_(scene),
      parameters_{first, second},
      options_(options),
      passage_(passage),
      systems_(scene, parameters_),
      own_(*SystemFamily(scene, first).at(SystemFamily(scene, first).value())) {}

PassageLoci::Orbits& PassageLoci::orbits_of(const PassageLayout& layout, double closure_speed) {
  for (Orbits& known : orbits_)
    if (known.equations->layout() == layout) return known;
  PassageOptions passage = passage_;
  passage.closure_speed = closure_speed;
  const std::vector<double> units{first_range(options_), second_range(options_)};
  orbits_.push_back(
      {std::make_unique<PassageEquations>(scene_, parameters_, units, own_, layout, passage)});
  return orbits_.back();
}

std::vector<LaidOrbit> PassageLoci::layouts(const OrbitLocusStart& start) {
  const System* system = systems_.at(std::array{start.first, start.second});
  if (!system) return {};
  PassageOptions passage = passage_;
  passage.closure_speed = start.followed->section->closure_speed;
  return layouts_of(*system, *start.followed, passage);
}

PassageLoci::Written PassageLoci::written_in(const LaidOrbit& laid, double closure_speed) {
  Orbits& orbits = orbits_of(laid.layout, closure_speed);
  return {&orbits, orbits.equations->shooting().pack(laid.theta, laid.states)};
}

std::vector<PassageLoci::Written> PassageLoci::written(const OrbitLocusStart& start) {
  std::vector<Written> list;
  for (const LaidOrbit& laid : layouts(start))
    list.push_back(written_in(laid, start.followed->section->closure_speed));
  return list;
}

LocusOptions PassageLoci::options_for(const Orbits& orbits) const {
  LocusOptions options = options_;
  options.residual_tolerance = PassageEquations::critical_tolerance();
  if (!orbits.equations->layout().released) {
    options.proceed = [this, &orbits](const LocusPoint&, const LocusPoint& here) {
      return point_of(orbits, here).has_value();
    };
    return options;
  }
  options.max_points = std::min(options.max_points, kMostLocusPoints);
  const PassageEquations& equations = *orbits.equations;
  options.proceed = [&equations](const LocusPoint& previous, const LocusPoint& here) {
    return !end_between(equations, previous, here);
  };
  options.resolves = [&equations, this](const LocusPoint& from, const LocusPoint& to) {
    const double first = (to.first - from.first) / first_range(options_),
                 second = (to.second - from.second) / second_range(options_);
    if ((to.u - from.u).norm() + std::hypot(first, second) <= kLocusBracket) return true;
    const auto before = itinerary_at(equations, from), now = itinerary_at(equations, to);
    return before && now && before->events == now->events;
  };
  return options;
}

std::optional<OrbitLocusPoint> PassageLoci::point_of(const Orbits& orbits,
                                                     const LocusPoint& at) const {
  const System* system = orbits.equations->system_at(std::array{at.first, at.second});
  if (!system) return {};
  const std::optional<Orbit> orbit = orbit_of(*system, orbits.equations->shooting(), at.u, {});
  if (!orbit) return {};
  return as_point(at.first, at.second, at.angle, *orbit);
}

// In order along it, special points among the others.
OrbitLocus PassageLoci::as_orbits(const Orbits& orbits, OrbitLocusKind kind,
                                  const Locus& locus) const {
  OrbitLocus result;
  result.kind = kind;
  result.pattern.period = orbits.equations->period();
  std::size_t begin = 0, end = locus.points.size();
  for (const std::size_t side : {0u, 1u}) {
    result.ends[side] = as_orbit_end(locus.ends[side]);
    if (!orbits.equations->layout().released) continue;
    if (locus.ends[side] == LocusEnd::kNotConverged &&
        grazes_at(*orbits.equations, side == 0 ? locus.points.front() : locus.points.back()))
      result.ends[side] = OrbitLocusEnd::kGrazing;
    if (locus.ends[side] != LocusEnd::kHalted) continue;
    // The last point is beyond the end.
    const std::size_t outer = side == 0 ? 0 : end - 1, inner = side == 0 ? 1 : end - 2;
    result.ends[side] = end_between(*orbits.equations, locus.points[inner], locus.points[outer])
                            .value_or(OrbitLocusEnd::kNotConverged);
    (side == 0 ? begin : end) = side == 0 ? 1 : end - 1;
  }
  auto special = locus.special.begin();
  for (std::size_t i = 0; i < end; ++i) {
    if (i >= begin)
      if (auto at = point_of(orbits, locus.points[i])) result.points.push_back(std::move(*at));
    for (; special != locus.special.end() && special->after == i; ++special) {
      const auto at = point_of(orbits, special->point);
      if (!at || i < begin || i + 1 >= end) continue;
      result.points.push_back(*at);
      result.special.push_back({label_of(special->kind), "", *at});
    }
  }
  name_pattern(result);
  return result;
}

PassageLocusAnswer PassageLoci::trace(const OrbitLocusStart& start) {
  if (start.kind == OrbitLocusKind::kGrazing) return trace_grazing(start);
  if (start.kind == OrbitLocusKind::kChatterCompletes) return trace_completion(start);
  PassageLocusAnswer answer;
  const std::vector<Written> list = written(start);
  const auto start_at = [&](const Written& one) {
    return LocusStart{as_locus_kind(start.kind), one.u, start.first, start.second,
                      start.multiplier};
  };
  for (const Written& one : list)
    answer.known =
        answer.known || find_locus(one.orbits->equations->problem(), options_for(*one.orbits),
                                   one.orbits->traced[start.kind], start_at(one))
                            .has_value();
  // While as many stops are closed as there are modes all multipliers are zero.
  if (answer.known || list.empty() || !list.front().orbits->equations->see_impacts()) return answer;
  Orbits& orbits = *list.front().orbits;
  std::optional<Locus> locus =
      trace_locus(orbits.equations->problem(), options_for(orbits), start_at(list.front()));
  if (!locus) return answer;
  answer.evaluations = locus->evaluations;
  OrbitLocus found = as_orbits(orbits, start.kind, *locus);
  if (found.points.size() > 1) answer.locus = std::move(found);
  orbits.traced[start.kind].push_back(std::move(*locus));
  return answer;
}

// A touch alone is that of the motion without contacts, which repeats every period.
std::optional<PassageLoci::Touching> PassageLoci::touching(const OrbitLocusStart& start) {
  const std::vector<Written> list = written(start);
  if (list.empty() || list.front().orbits->equations->layout().released) return {};
  const Written& at = list.front();
  const PassageShooting& shooting = at.orbits->equations->shooting();
  const System* system = at.orbits->equations->system_at(std::array{start.first, start.second});
  if (!system) return {};
  const std::optional<Touch> touch = nearest_touch(*system, shooting, at.u);
  if (!touch) return {};
  if (shooting.layout().sections > 1) {
    const std::optional<Orbit> orbit = orbit_of(*system, shooting, at.u, {});
    if (!orbit || orbit->impacts.size() <= 1)
      return Touching{{&orbits_of(PassageLayout::strobe(1), shooting.map().options().closure_speed),
                       shooting.at_section(at.u, static_cast<int>(touch->turn))},
                      {touch->stop, 0, touch->angle, 0.0}};
  }
  return Touching{at, *touch};
}

template <class Curve>
PassageLocusAnswer PassageLoci::trace_curve_near(
    const Orbits& orbits, Curves<Curve>& curves, const OrbitLocusStart& start,
    const Vector& unknown,
    const std::function<std::vector<BranchPoint>(const BranchPoint&)>& same) const {
  PassageLocusAnswer answer;
  const PlaneCurveProblem& problem = curves.curve->problem();
  LocusOptions options = options_;
  options.residual_tolerance = Curve::kTolerance;
  options.max_points = std::min(options.max_points, Curve::kMostPoints);
  const std::optional<BranchPoint> point = point_on_curve(problem, options, unknown, start.second);
  if (!point) return answer;
  const ContinuationOptions along = branch_options(problem, options);
  for (const BranchPoint& one : same(*point))
    for (const Branch& branch : curves.traced)
      answer.known = answer.known || lies_on(problem.problem, along, branch, one);
  if (answer.known) return answer;
  PlaneCurve traced = trace_curve(problem, options, *point);
  answer.evaluations = traced.branch.evaluations;
  OrbitLocus locus;
  locus.kind = start.kind;
  locus.pattern.period = orbits.equations->period();
  const std::vector<BranchPoint>& points = traced.branch.points;
  for (const std::size_t side : {0u, 1u}) {
    const BranchEnd end = traced.branch.ends[side];
    locus.ends[side] = as_orbit_end(as_locus_end(end, true));
    if (end == BranchEnd::kNotConverged)
      locus.ends[side] = curves.curve->end_at(side == 0 ? points.front() : points.back());
    if (end == BranchEnd::kHalted && points.size() > 1)
      locus.ends[side] = side == 0
                             ? curves.curve->end_between(points[1], points[0])
                             : curves.curve->end_between(points[points.size() - 2], points.back());
  }
  for (const BranchPoint& here : traced.branch.points)
    if (const std::optional<Orbit> orbit = curves.curve->orbit_at(here))
      locus.points.push_back(as_point(curves.curve->first_of(here), here.parameter, 0.0, *orbit));
  name_pattern(locus);
  if (locus.points.size() > 1) answer.locus = std::move(locus);
  curves.traced.push_back(std::move(traced.branch));
  return answer;
}

PassageLocusAnswer PassageLoci::trace_grazing(const OrbitLocusStart& start) {
  const std::optional<Touching> at = touching(start);
  if (!at) return {};
  Orbits& orbits = *at->at.orbits;
  Curves<StrobeGrazing>& curves = orbits.grazings[at->touch.stop];
  if (!curves.curve)
    curves.curve = std::make_unique<StrobeGrazing>(*orbits.equations, at->touch.stop);
  const StrobeGrazing& curve = *curves.curve;
  return trace_curve_near(orbits, curves, start, curve.pack(at->at.u, at->touch, start.first),
                          [&](const BranchPoint& point) { return curve.rewritings(point); });
}

// At the release of the stuck phase that shrinks to nothing.
PassageLocusAnswer PassageLoci::trace_completion(const OrbitLocusStart& start) {
  const std::vector<LaidOrbit> list = layouts(start);
  const auto shortest =
      std::min_element(list.begin(), list.end(),
                       [](const LaidOrbit& a, const LaidOrbit& b) { return a.held < b.held; });
  if (shortest == list.end() || !shortest->layout.released) return {};
  const Written at = written_in(*shortest, start.followed->section->closure_speed);
  Curves<CompletionCurve>& curves = at.orbits->completions;
  if (!curves.curve) curves.curve = std::make_unique<CompletionCurve>(*at.orbits->equations);
  return trace_curve_near(*at.orbits, curves, start, curves.curve->pack(at.u, start.first),
                          [](const BranchPoint& point) { return std::vector{point}; });
}

}  // namespace graze
