#include "graze/bifurcation/strobe_loci.hpp"

#include <array>
#include <utility>

#include "graze/continuation/branch.hpp"
#include "graze/continuation/plane_curve.hpp"

namespace graze {
namespace {

// Contacts may be born and lost along it: those of its first point name it.
void name_pattern(OrbitLocus& locus) {
  if (locus.points.empty()) return;
  for (const OrbitImpact& impact : locus.points.front().impacts)
    locus.pattern.stops.push_back(impact.stop);
}

}  // namespace

StrobeLoci::StrobeLoci(const Scene& scene, const std::string& first, const std::string& second,
                       const LocusOptions& options, const PassageOptions& strobe)
    : options_(options),
      scene_(scene),
      parameters_{first, second},
      strobe_(strobe),
      own_(*SystemFamily(scene, first).at(SystemFamily(scene, first).value())),
      state_size_(equations(1).map().size()) {
  options_.proceed = [this](const LocusPoint&, const LocusPoint& here) {
    return point_of(here).has_value();
  };
}

const PassageEquations& StrobeLoci::equations(int period) {
  const std::vector<double> units{first_range(options_), second_range(options_)};
  return equations_
      .try_emplace(period, scene_, parameters_, units, own_, PassageLayout::strobe(period), strobe_)
      .first->second;
}

const PassageEquations& StrobeLoci::equations_of(const Vector& u) {
  return equations(static_cast<int>(u.size() / state_size_));
}

OrbitLocus StrobeLoci::frame_of(OrbitLocusKind kind, int period) const {
  OrbitLocus frame;
  frame.kind = kind;
  frame.compliant = true;
  frame.closure_speed = strobe_.closure_speed;
  frame.pattern.period = period;
  return frame;
}

OrbitLocusPoint StrobeLoci::as_point(double first, double second, double angle,
                                     const Orbit& orbit) const {
  return {first, second, angle, orbit.impacts, true, turns_of(orbit)};
}

std::optional<OrbitLocusPoint> StrobeLoci::point_of(const LocusPoint& at) {
  const PassageEquations& of = equations_of(at.u);
  const System* system = of.system_at(std::array{at.first, at.second});
  if (!system) return {};
  const std::optional<Orbit> orbit = orbit_of(*system, of.shooting(), at.u, {});
  if (!orbit) return {};
  return as_point(at.first, at.second, at.angle, *orbit);
}

std::optional<OrbitLocusPoint> StrobeLoci::point_of(const StrobeGrazing& curve,
                                                    const BranchPoint& at) {
  const double first = curve.first_of(at);
  const PassageEquations& of = equations_of(curve.turns_of(at));
  const System* system = of.system_at(std::array{first, at.parameter});
  if (!system) return {};
  const std::optional<Orbit> orbit =
      orbit_of(*system, of.shooting(), curve.turns_of(at), {}, curve.touch_of(at));
  if (!orbit) return {};
  return as_point(first, at.parameter, 0.0, *orbit);
}

// In order along it, special points among the others.
OrbitLocus StrobeLoci::as_orbits(OrbitLocusKind kind, int period, const Locus& locus) {
  OrbitLocus result = frame_of(kind, period);
  result.ends = {as_orbit_end(locus.ends[0]), as_orbit_end(locus.ends[1])};
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
  name_pattern(result);
  return result;
}

StrobeLocusAnswer StrobeLoci::trace(const OrbitLocusStart& start) {
  if (start.kind == OrbitLocusKind::kGrazing) return trace_grazing(start);
  StrobeLocusAnswer answer;
  const int period = static_cast<int>(start.strobe->turns.size());
  LocusOptions options = options_;
  options.residual_tolerance = PassageEquations::critical_tolerance();
  const PassageEquations& of = equations(period);
  const LocusStart at{as_locus_kind(start.kind), of.shooting().pack(start.strobe->turns),
                      start.first, start.second, start.multiplier};
  std::vector<Locus>& traced = traced_[{period, start.kind}];
  answer.known = find_locus(of.problem(), options, traced, at).has_value();
  if (answer.known) return answer;
  std::optional<Locus> locus = trace_locus(of.problem(), options, at);
  if (!locus) return answer;
  answer.evaluations = locus->evaluations;
  OrbitLocus orbits = as_orbits(start.kind, period, *locus);
  if (!orbits.points.empty()) answer.locus = std::move(orbits);
  traced.push_back(std::move(*locus));
  return answer;
}

// A touch alone is that of the motion without contacts, which repeats every period.
std::optional<StrobeLoci::Touching> StrobeLoci::touching(const OrbitLocusStart& start) {
  const PassageEquations& of = equations(static_cast<int>(start.strobe->turns.size()));
  const System* system = of.system_at(std::array{start.first, start.second});
  if (!system) return {};
  const Vector u = of.shooting().pack(start.strobe->turns);
  const std::optional<Touch> touch = nearest_touch(*system, of.shooting(), u);
  if (!touch) return {};
  const Eigen::Index n = state_size_;
  if (start.strobe->turns.size() > 1) {
    const std::optional<Orbit> orbit = orbit_of(*system, of.shooting(), u, {});
    if (!orbit || orbit->impacts.size() <= 1)
      return Touching{u.segment(static_cast<Eigen::Index>(touch->turn) * n, n),
                      {touch->stop, 0, touch->angle, 0.0}};
  }
  return Touching{u, *touch};
}

StrobeLocusAnswer StrobeLoci::trace_grazing(const OrbitLocusStart& start) {
  StrobeLocusAnswer answer;
  const std::optional<Touching> at = touching(start);
  if (!at) return answer;
  const int period = static_cast<int>(at->u.size() / state_size_);
  Grazing& grazing = grazings_[{period, at->touch.stop}];
  if (!grazing.curve)
    grazing.curve = std::make_unique<StrobeGrazing>(equations(period), at->touch.stop);
  const StrobeGrazing& curve = *grazing.curve;
  const std::optional<BranchPoint> point = point_on_curve(
      curve.problem(), options_, curve.pack(at->u, at->touch, start.first), start.second);
  if (!point) return answer;
  const ContinuationOptions along = branch_options(curve.problem(), options_);
  for (const BranchPoint& written : curve.rewritings(*point))
    for (const Branch& branch : grazing.traced)
      answer.known = answer.known || lies_on(curve.problem().problem, along, branch, written);
  if (answer.known) return answer;
  PlaneCurve traced = trace_curve(curve.problem(), options_, *point);
  answer.evaluations = traced.branch.evaluations;
  OrbitLocus locus = frame_of(OrbitLocusKind::kGrazing, period);
  for (const std::size_t side : {0u, 1u})
    locus.ends[side] = as_orbit_end(as_locus_end(traced.branch.ends[side], true));
  for (const BranchPoint& here : traced.branch.points)
    if (auto orbit = point_of(curve, here)) locus.points.push_back(std::move(*orbit));
  name_pattern(locus);
  if (!locus.points.empty()) answer.locus = std::move(locus);
  grazing.traced.push_back(std::move(traced.branch));
  return answer;
}

}  // namespace graze
