#include "graze/bifurcation/loci/detail/locus_tracer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/bifurcation/loci/detail/completion_curve.hpp"
#include "graze/bifurcation/loci/detail/flight_grazing.hpp"
#include "graze/bifurcation/loci/detail/grazing_places.hpp"
#include "graze/bifurcation/loci/detail/segment_grazing.hpp"
#include "graze/bifurcation/trace/detail/orbit_kinds.hpp"
#include "graze/continuation/branch.hpp"
#include "graze/continuation/normal_form.hpp"
#include "graze/continuation/special/detail/crossing_tests.hpp"
#include "graze/orbit/problem/detail/laid_orbit.hpp"

namespace graze {
namespace {

// Angle of the non-critical pair nearest to the unit circle; nullopt when there is no pair.
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

LocusStart as_start(const OrbitLocusStart& start, const OrbitProblems::Written& one) {
  return {as_locus_kind(start.kind), one.u, start.first, start.second, start.multiplier};
}

LocusSite site_of(const LocusPoint& at) { return {at.u, at.first, at.second, at.angle}; }

MotionScale own_scale(const Scene& scene, const std::string& parameter) {
  const SystemFamily own(scene, parameter);
  return motion_scale(*own.at(own.value()));
}

}  // namespace

// A place within the step after a point.
struct LocusTracer::Within {
  std::size_t after = 0;
  LocusPlace place;
};

LocusTracer::LocusTracer(const Scene& scene, const std::string& first, const std::string& second,
                         const LocusOptions& options, const SegmentOptions& segment,
                         const BranchOptions& orbits)
    : options_(options),
      orbits_(orbits),
      scale_(own_scale(scene, first)),
      problems_(scene, {first, second}, {first_range(options), second_range(options)}, scale_,
                segment) {}

bool LocusTracer::is_along(OrbitLocusKind kind) {
  return kind == OrbitLocusKind::kGrazing || kind == OrbitLocusKind::kChatterCompletes ||
         is_of_level(kind);
}

bool LocusTracer::knows(const OrbitLocusStart& start) {
  return is_along(start.kind) ? knows_along(start) : knows_critical(start);
}

LocusAnswer LocusTracer::trace(const OrbitLocusStart& start) {
  return is_along(start.kind) ? trace_along(start) : trace_critical(start);
}

// Once the search is to end, motions cannot be followed, so that no start can be evaluated.
void LocusTracer::know(const OrbitLocusStart& start, LocusAnswer answer) {
  if (answer.critical) {
    const std::vector<Written> list = written(start);
    if (list.empty()) return;
    const Written one = problems_.clear_of_contacts(list.front(), start.place());
    Critical& critical = critical_of(*one.orbits);
    critical.traced[start.kind].add((*one.orbits)->problem(), options_for(*critical.orbits),
                                    *answer.critical);
  } else if (!answer.curve.empty()) {
    const CurveStart at = curve_at(start);
    if (!at.curves) return;
    const LocusOptions options = options_along(*at.curves->curve);
    const PlaneCurveProblem& problem = at.curves->curve->problem();
    const ContinuationOptions along = branch_options(problem, options);
    at.curves->traced.emplace_back(Corrector(problem.problem, along), std::move(answer.curve),
                                   problem.problem.wrap, along.max_turn);
  }
}

std::vector<OrbitProblems::Written> LocusTracer::written(const OrbitLocusStart& start) {
  if (start.followed) {
    Orbit orbit = *start.followed;
    // Slices have closure speeds of their own, but all loci in one plane must use the same.
    if (!closure_speed_) closure_speed_ = orbit.section->closure_speed;
    orbit.section->closure_speed = *closure_speed_;
    return problems_.written(orbit, std::array{start.first, start.second});
  }
  return problems_.rewritings(start.orbit.pattern, start.orbit.impacts, start.place());
}

LocusTracer::Critical& LocusTracer::critical_of(const LaidOrbits& orbits) {
  Critical& critical = critical_[orbits.problem.get()];
  if (!critical.orbits) critical.orbits = orbits_along(*orbits.problem);
  return critical;
}

LocusOptions LocusTracer::options_for(const LocusOrbits& orbits) const {
  LocusOptions options = options_;
  orbits.limit(options);
  options.tests = [&orbits](const LocusPoint& at) { return orbits.margins(site_of(at)); };
  options.resolves = [&orbits](const LocusPoint& from, const LocusPoint& to) {
    return orbits.resolves(site_of(from), site_of(to));
  };
  options.proceed = [&orbits](const LocusPoint& previous, const LocusPoint& here) {
    return orbits.goes_on(site_of(previous), site_of(here));
  };
  return options;
}

void LocusTracer::mark_zeros(LocusOptions& options, const LaidOrbits& orbits) {
  if (!orbits_.normal_forms) return;
  const OrbitProblem &once = *orbits.problem, &doubled = *problems_.doubled(orbits).problem;
  options.coefficient = [&](const LocusPoint& at) -> std::optional<double> {
    SolutionPoint point;
    point.u = at.u;
    point.tangent = Vector::Zero(at.u.size() + 1);
    const Vector twice = once.twice_round(point).u;
    // Sections at a release have the halves of a doubled orbit as no unknowns.
    if (twice.size() != 2 * at.u.size()) return {};
    return cubic_coefficient(doubled.problem(), twice, std::array{at.first, at.second},
                             std::polar(1.0, at.angle));
  };
}

bool LocusTracer::knows_critical(const OrbitLocusStart& start) {
  for (const Written& here : written(start))
    for (const Written& one : problems_.on_every_section(here, start.place())) {
      Critical& critical = critical_of(*one.orbits);
      const KnownLoci& traced = critical.traced[start.kind];
      if (!traced.empty() && traced.find((*one.orbits)->problem(), options_for(*critical.orbits),
                                         as_start(start, one)))
        return true;
    }
  return false;
}

LocusAnswer LocusTracer::trace_critical(const OrbitLocusStart& start) {
  LocusAnswer answer;
  const std::vector<Written> list = written(start);
  // While as many stops are closed as there are modes all multipliers are zero.
  if (list.empty() || !(*list.front().orbits)->has_multipliers()) return answer;
  const Written one = problems_.clear_of_contacts(list.front(), start.place());
  const Critical& critical = critical_of(*one.orbits);
  LocusOptions options = options_for(*critical.orbits);
  mark_zeros(options, *one.orbits);
  answer.critical = trace_locus((*one.orbits)->problem(), options, as_start(start, one));
  if (!answer.critical) return answer;
  answer.evaluations = answer.critical->evaluations;
  answer.trace = as_trace(start.kind, *critical.orbits, *answer.critical);
  return answer;
}

LocusTrace LocusTracer::as_trace(OrbitLocusKind kind, const LocusOrbits& orbits,
                                 const Locus& locus) const {
  std::vector<LocusSite> sites;
  for (const LocusPoint& point : locus.points) sites.push_back(site_of(point));
  std::vector<Within> within;
  for (const LocusSpecialPoint& special : locus.special)
    if (auto place = orbits.place(site_of(special.point), {})) {
      place->label = label_of(special.kind);
      place->other_angle = other_angle(special.point.multipliers, special.point.angle);
      within.push_back({special.after, std::move(*place)});
    }
  for (const LocusZero& zero : locus.zeros)
    if (auto place = orbits.place(site_of(zero.point), static_cast<LocusMargin>(zero.test)))
      within.push_back({zero.after, std::move(*place)});
  OrbitLocus frame;
  frame.kind = kind;
  return assembled(std::move(frame), orbits, sites, locus.ends, std::move(within));
}

// The points of a locus, with the places within its steps between them, in order.
LocusTrace LocusTracer::assembled(OrbitLocus frame, const LocusOrbits& orbits,
                                  const std::vector<LocusSite>& sites, std::array<LocusEnd, 2> ends,
                                  std::vector<Within> within) const {
  std::size_t begin = 0, end = sites.size();
  for (const std::size_t side : {0u, 1u}) {
    frame.ends[side] = as_orbit_end(ends[side]);
    if (ends[side] == LocusEnd::kNotConverged)
      frame.ends[side] = orbits.end_at(side == 0 ? sites.front() : sites.back());
    if (ends[side] != LocusEnd::kHalted || sites.size() < 2) continue;
    // The last point is beyond the end.
    const std::size_t outer = side == 0 ? 0 : sites.size() - 1;
    const std::size_t inner = side == 0 ? 1 : sites.size() - 2;
    frame.ends[side] = orbits.end_between(sites[inner], sites[outer]);
    (side == 0 ? begin : end) = side == 0 ? 1 : sites.size() - 1;
  }
  const auto from_start = [&](const Within& item) {
    const LocusSite& site = sites[item.after];
    return distance({site.first, site.second, site.angle, {}, false}, item.place.at, options_);
  };
  std::stable_sort(within.begin(), within.end(), [&](const Within& a, const Within& b) {
    return a.after != b.after ? a.after < b.after : from_start(a) < from_start(b);
  });
  std::vector<LocusPlace> all;
  auto next = within.begin();
  for (std::size_t i = 0; i < end; ++i) {
    if (i >= begin)
      if (auto place = orbits.place(sites[i], {})) all.push_back(std::move(*place));
    for (; next != within.end() && next->after == i; ++next)
      if (i >= begin && i + 1 < end) all.push_back(std::move(next->place));
  }
  frame.pattern = orbits.pattern(all);
  LocusTrace trace{std::move(frame), std::move(all)};
  if (trace.places.empty()) return trace;
  if (trace.frame.kind != OrbitLocusKind::kGrazing)
    end_on_grazing(trace.places, trace.frame.ends, scale_.speed);
  merge_boundaries(trace.places, options_, scale_.speed);
  return trace;
}

LocusTracer::CurveStart LocusTracer::curve_at(const OrbitLocusStart& start) {
  if (start.kind == OrbitLocusKind::kChatterCompletes) return completion(start);
  if (is_of_level(start.kind)) return level(start);
  return start.followed ? segment_grazing(start) : flight_grazing(start);
}

// Starts at the grazing contact.
LocusTracer::CurveStart LocusTracer::flight_grazing(const OrbitLocusStart& start) {
  LaidOrbits& orbits = problems_.flights(start.orbit.pattern);
  const auto& flights = dynamic_cast<const FlightEquations&>(*orbits.problem);
  Curves& curves = curves_[{orbits.problem.get(), 0}];
  if (!curves.curve)
    curves.curve = std::make_unique<FlightGrazing>(flights, 0, first_range(options_));
  const System* system = flights.system_at(start.place());
  if (!system) return {};
  const Vector u = flights.shooting().pack(*system, start.orbit.impacts);
  Vector y(u.size() + 1);
  y << u, start.first / first_range(options_);
  return {&curves, y};
}

// An orbit that only touches is the motion without contacts, which repeats every period.
LocusTracer::CurveStart LocusTracer::segment_grazing(const OrbitLocusStart& start) {
  const std::vector<Written> list = written(start);
  if (list.empty()) return {};
  const auto* segments = dynamic_cast<const SegmentEquations*>(list.front().orbits->problem.get());
  const System* system =
      segments ? segments->system_at(std::array{start.first, start.second}) : nullptr;
  if (!system) return {};
  Vector u = list.front().u;
  const std::vector<GrazingContact> grazings =
      grazing_contacts_near(*system, segments->shooting(), u);
  if (grazings.empty()) return {};
  GrazingContact grazing = grazings.front();
  if (!segments->layout().released) {
    if (!system->stops[static_cast<std::size_t>(grazing.stop)].is_compliant()) return {};
    const std::optional<Orbit> orbit = orbit_of(*system, segments->shooting(), u, {});
    if (segments->layout().sections > 1 && (!orbit || orbit->impacts.size() <= 1)) {
      u = segments->shooting().at_section(u, static_cast<int>(grazing.turn));
      grazing.turn = 0;
      LaidOrbits& once = problems_.fixed_phase_once(*list.front().orbits);
      segments = dynamic_cast<const SegmentEquations*>(once.problem.get());
    }
  }
  Curves& curves = curves_[{segments, grazing.stop}];
  if (!curves.curve) curves.curve = std::make_unique<SegmentGrazing>(*segments, grazing.stop);
  Vector y(u.size() + 2);
  y << u, start.first / segments->unit(0), segments->psi_of(u, grazing);
  return {&curves, y};
}

// Starts at the release of the stuck phase that shrinks to nothing.
LocusTracer::CurveStart LocusTracer::completion(const OrbitLocusStart& start) {
  if (!start.followed) return {};
  const std::vector<Written> list = written(start);
  const auto shortest = std::min_element(
      list.begin(), list.end(), [](const Written& a, const Written& b) { return a.held < b.held; });
  if (shortest == list.end()) return {};
  const auto& segments = dynamic_cast<const SegmentEquations&>(*shortest->orbits->problem);
  if (!segments.layout().released) return {};
  Curves& curves = curves_[{&segments, -1}];
  if (!curves.curve) curves.curve = std::make_unique<CompletionCurve>(segments);
  Vector y(shortest->u.size() + 1);
  y << shortest->u, start.first / segments.unit(0);
  return {&curves, y};
}

LocusOptions LocusTracer::options_along(const OrbitCurve& curve) const {
  LocusOptions options = options_;
  curve.orbits().limit(options);
  return options;
}

bool LocusTracer::knows_along(const OrbitLocusStart& start) {
  const std::vector<CurveStart> forms = forms_of(start);
  return std::any_of(forms.begin(), forms.end(),
                     [&](const CurveStart& form) { return is_known(form, start.second); });
}

bool LocusTracer::is_known(const CurveStart& at, double second) const {
  if (!at.curves || at.curves->traced.empty()) return false;
  const OrbitCurve& curve = *at.curves->curve;
  const PlaneCurveProblem& problem = curve.problem();
  const LocusOptions options = options_along(curve);
  const std::optional<SolutionPoint> point = point_on_curve(problem, options, at.unknown, second);
  if (!point) return false;
  const ContinuationOptions along = branch_options(problem, options);
  Corrector corrector(problem.problem, along);
  for (const SolutionPoint& same : curve.rewritings(*point))
    for (const KnownBranch& branch : at.curves->traced)
      if (branch.has(corrector, same)) return true;
  return false;
}

LocusAnswer LocusTracer::trace_along(const OrbitLocusStart& start) {
  LocusAnswer answer;
  const CurveStart at = curve_at(start);
  if (!at.curves) return answer;
  const OrbitCurve& curve = *at.curves->curve;
  PlaneCurveProblem problem = curve.problem();
  // The margins of its orbits, and after them a function that changes sign where a multiplier
  // passes 1.
  problem.tests.all = [&](const SolutionPoint&,
                          const SolutionPoint& here) -> std::optional<Vector> {
    std::optional<Vector> tests = curve.orbits().margins(curve.site_of(here));
    if (!tests || !problem.problem.multipliers) return tests;
    // Where the trace is halted instead no margin vanishes.
    if (tests->size() == 0) tests->setOnes(kLocusMargins);
    const std::vector<Eigenvalue> list =
        problem.problem.multipliers(here.u, here.parameters(), ErrorBounds::kLeftOut);
    if (list.empty()) return {};
    tests->conservativeResize(tests->size() + 1);
    (*tests)[tests->size() - 1] = crossing_tests(list)[kFoldTest].value();
    return tests;
  };
  const LocusOptions options = options_along(curve);
  const std::optional<SolutionPoint> point =
      point_on_curve(problem, options, at.unknown, start.second);
  if (!point) return answer;
  PlaneCurve traced = trace_curve(problem, options, *point);
  answer.evaluations = traced.branch.evaluations;
  answer.trace = as_trace(start, curve, traced);
  answer.curve = std::move(traced.branch.points);
  return answer;
}

LocusTrace LocusTracer::as_trace(const OrbitLocusStart& start, const OrbitCurve& curve,
                                 const PlaneCurve& traced) const {
  const LocusOrbits& orbits = curve.orbits();
  std::vector<LocusSite> sites;
  for (const SolutionPoint& at : traced.branch.points) sites.push_back(curve.site_of(at));
  std::vector<Within> within;
  const auto add = [&](std::size_t after, const SolutionPoint& at, std::optional<LocusMargin> zero,
                       const char* met, std::optional<double> angle) {
    std::optional<LocusPlace> place = orbits.place(curve.site_of(at), zero);
    if (!place) return;
    if (met) place->label = std::string(met) + label_of(start.kind);
    place->other_angle = angle;
    within.push_back({after, std::move(*place)});
  };
  for (const TestZero& zero : traced.zeros) {
    if (zero.test < kLocusMargins)
      add(zero.after, zero.point, static_cast<LocusMargin>(zero.test), nullptr, {});
    else
      add(zero.after, zero.point, {}, label_of(CriticalKind::kFold), {});
  }
  for (const CriticalPoint& critical : traced.branch.critical)
    if (critical.kind == CriticalKind::kPeriodDoubling || critical.kind == CriticalKind::kTorus)
      add(critical.after, critical.point, {}, label_of(critical.kind),
          critical.multiplier ? std::optional(std::abs(std::arg(critical.multiplier->value)))
                              : std::nullopt);
  OrbitLocus frame;
  frame.kind = start.kind;
  frame.level = start.level;
  std::array<LocusEnd, 2> ends;
  for (const std::size_t side : {0u, 1u}) ends[side] = as_locus_end(traced.branch.ends[side], true);
  return assembled(std::move(frame), orbits, sites, ends, std::move(within));
}

}  // namespace graze
