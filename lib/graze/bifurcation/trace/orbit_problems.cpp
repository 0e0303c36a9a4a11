#include "graze/bifurcation/trace/detail/orbit_problems.hpp"

#include <utility>

#include "graze/bifurcation/problem/detail/canonical_pattern.hpp"
#include "graze/bifurcation/problem/detail/flight_equations.hpp"
#include "graze/bifurcation/problem/detail/response_equations.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"
#include "graze/orbit/problem/detail/laid_orbit.hpp"

namespace graze {

OrbitProblems::OrbitProblems(const Scene& scene, std::vector<std::string> parameters,
                             std::vector<double> units, const MotionScale& scale,
                             const SegmentOptions& segment)
    : scene_(scene),
      parameters_(std::move(parameters)),
      units_(std::move(units)),
      scale_(scale),
      segment_(segment),
      systems_(scene, parameters_) {}

LaidOrbits& OrbitProblems::keep(const OrbitLayout& layout, double closure_speed,
                                const std::function<std::unique_ptr<OrbitProblem>()>& make) {
  for (LaidOrbits& known : orbits_)
    if (known.closure_speed == closure_speed && known->orbit_layout() == layout) return known;
  orbits_.push_back({make(), {}, closure_speed});
  if (make_boundaries_) orbits_.back().boundaries = make_boundaries_(*orbits_.back().problem);
  return orbits_.back();
}

LaidOrbits& OrbitProblems::flights(const ImpactPattern& pattern) {
  return keep(pattern, 0.0, [&] {
    return std::make_unique<FlightEquations>(scene_, parameters_, pattern, scale_);
  });
}

LaidOrbits& OrbitProblems::response() {
  return keep(ImpactPattern{}, 0.0,
              [&] { return std::make_unique<ResponseEquations>(scene_, parameters_, scale_); });
}

std::vector<OrbitProblems::Written> OrbitProblems::written(const ImpactPattern& pattern,
                                                           const std::vector<ImpactPoint>& impacts,
                                                           Parameters at) {
  std::vector<Written> list = rewritings(pattern, impacts, at);
  if (!list.empty()) list.resize(1);
  return list;
}

std::vector<OrbitProblems::Written> OrbitProblems::rewritings(
    const ImpactPattern& pattern, const std::vector<ImpactPoint>& impacts, Parameters at) {
  const System* system = systems_.at(at);
  if (!system) return {};
  const ImpactPattern order = canonical(pattern);
  LaidOrbits& orbits = flights(order);
  std::vector<Written> list;
  for (const std::vector<ImpactPoint>& same :
       graze::rewritings(order, in_canonical_order(pattern, impacts)))
    list.push_back({&orbits, ShootingProblem(order, scale_).pack(*system, same)});
  return list;
}

std::vector<OrbitProblems::Written> OrbitProblems::written(const Orbit& orbit, Parameters at) {
  if (!orbit.section) return written(orbit.pattern(), orbit.points(), at);
  const System* system = systems_.at(at);
  if (!system) return {};
  SegmentOptions segment = segment_;
  segment.closure_speed = orbit.section->closure_speed;
  std::vector<Written> list;
  for (const LaidOrbit& laid : layouts_of(*system, orbit, segment)) {
    LaidOrbits& orbits = keep(laid.layout, segment.closure_speed, [&] {
      return std::make_unique<SegmentEquations>(scene_, parameters_, units_, *system, laid.layout,
                                                segment);
    });
    const auto& equations = dynamic_cast<const SegmentEquations&>(*orbits.problem);
    list.push_back({&orbits,
                    equations.shooting().pack(orbit.timed(*system), laid.theta, laid.states),
                    laid.held});
  }
  return list;
}

LaidOrbits& OrbitProblems::doubled(const LaidOrbits& orbits) {
  std::unique_ptr<OrbitProblem> twice = orbits->doubled();
  const OrbitLayout layout = twice->orbit_layout();
  return keep(layout, orbits.closure_speed, [&] { return std::move(twice); });
}

LaidOrbits& OrbitProblems::fixed_phase_once(const LaidOrbits& orbits) {
  const auto& segments = dynamic_cast<const SegmentEquations&>(*orbits.problem);
  const SegmentLayout once = SegmentLayout::fixed_phase(1, segments.layout().theta);
  return keep(once, orbits.closure_speed, [&] { return segments.laid(once); });
}

OrbitProblems::Written OrbitProblems::clear_of_contacts(const Written& one, Parameters at) {
  const auto* segments = dynamic_cast<const SegmentEquations*>(one.orbits->problem.get());
  std::unique_ptr<OrbitProblem> other = segments ? segments->clear_of_contacts(one.u, at) : nullptr;
  if (!other) return one;
  const OrbitLayout layout = other->orbit_layout();
  const auto u = segments->carried(one.u, at, std::get<SegmentLayout>(layout).theta);
  if (!u) return one;
  return {&keep(layout, one.orbits->closure_speed, [&] { return std::move(other); }), *u};
}

std::vector<OrbitProblems::Written> OrbitProblems::on_every_section(const Written& one,
                                                                    Parameters at) {
  std::vector<Written> list{one};
  const auto* segments = dynamic_cast<const SegmentEquations*>(one.orbits->problem.get());
  if (!segments || segments->layout().released) return list;
  for (LaidOrbits& known : orbits_) {
    const auto* other = dynamic_cast<const SegmentEquations*>(known.problem.get());
    if (!other || other == segments || known.closure_speed != one.orbits->closure_speed) continue;
    SegmentLayout layout = segments->layout();
    layout.theta = other->layout().theta;
    if (!(layout == other->layout())) continue;
    if (const auto u = segments->carried(one.u, at, layout.theta)) list.push_back({&known, *u});
  }
  return list;
}

LaidOrbits* OrbitProblems::clearer(const LaidOrbits& orbits, const SolutionPoint& solution) {
  std::unique_ptr<OrbitProblem> other = orbits->clearer(solution);
  if (!other) return nullptr;
  const OrbitLayout layout = other->orbit_layout();
  return &keep(layout, orbits.closure_speed, [&] { return std::move(other); });
}

}  // namespace graze
