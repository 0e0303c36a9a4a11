#include "graze/bifurcation/loci/locus_leads.hpp"

#include <cmath>
#include <utility>

#include "graze/bifurcation/problem/detail/canonical_pattern.hpp"
#include "graze/bifurcation/problem/detail/locus_margins.hpp"
#include "graze/flow/variation/detail/transition.hpp"

namespace graze {
namespace {

// An impact slower than this part of the forced motion's speed is one that vanishes, a gap below
// this part of the length scale one that is touched. Located points have them to rounding.
constexpr double kVanishing = 1e-9;

TouchingOrbit orbit_at(const OrbitLocus& locus, const OrbitLocusPoint& at) {
  Orbit orbit;
  orbit.period = locus.pattern.period;
  orbit.impacts = at.impacts;
  return {orbit.pattern(), orbit.points(), 0};
}

// Of every impact, m/s, whichever way it goes.
Vector sizes_of_speeds(const System& system, const TouchingOrbit& orbit) {
  return approach_speeds(system, orbit.pattern, orbit.impacts).cwiseAbs();
}

std::size_t slowest(const System& system, const TouchingOrbit& orbit) {
  Eigen::Index least = 0;
  sizes_of_speeds(system, orbit).minCoeff(&least);
  return static_cast<std::size_t>(least);
}

bool vanishes(const System& system, const TouchingOrbit& orbit, double speed_unit) {
  return sizes_of_speeds(system, orbit).minCoeff() <= kVanishing * speed_unit;
}

// The same, written from its touch on.
TouchingOrbit from_its_touch(TouchingOrbit orbit) {
  const int period = orbit.pattern.period;
  return {turned(std::move(orbit.pattern), orbit.touch),
          turned(std::move(orbit.impacts), orbit.touch, period), 0};
}

bool touches(const System& system, const TouchingOrbit& orbit) {
  const std::optional<double> clearance =
      admissibility(system, orbit.pattern, orbit.impacts).clearance();
  return clearance && std::abs(*clearance) <= kVanishing * motion_scale(system).length;
}

// The kinds that meet on a locus of one kind at a point of this name.
std::vector<OrbitLocusKind> others_at(OrbitLocusKind kind, const std::string& label) {
  using Kind = OrbitLocusKind;
  if (label == "R1") return {kind == Kind::kTorus ? Kind::kFold : Kind::kTorus};
  if (label == "R2") return {kind == Kind::kTorus ? Kind::kPeriodDoubling : Kind::kTorus};
  if (label == "NSNS") return {Kind::kTorus};
  std::vector<Kind> others;
  for (const Kind other : kOrbitLocusKinds)
    if (other != kind && label.size() == 4 && label.find(label_of(other)) != std::string::npos)
      others.push_back(other);
  return others;
}

// The orbit from its touch on: an impact whose speed vanishes (`by_speed`) or the nearest approach.
// Nothing where there is no approach.
std::optional<TouchingOrbit> from_touch(const System& system, const TouchingOrbit& orbit,
                                        bool by_speed) {
  std::optional<TouchingOrbit> touching = orbit;
  if (by_speed)
    touching->touch = slowest(system, orbit);
  else
    touching = with_touch(system, orbit.pattern, orbit.impacts);
  if (!touching) return {};
  // A touch alone is that of the motion without impacts, which repeats every period.
  if (touching->pattern.impacts() == 1) touching->pattern.period = 1;
  return from_its_touch(std::move(*touching));
}

// As loci of folds, doublings and tori start from it.
TouchingOrbit in_canonical_order(const TouchingOrbit& orbit) {
  return {canonical(orbit.pattern), in_canonical_order(orbit.pattern, orbit.impacts), 0};
}

// Where an orbit touches twice, with the touch that the locus is not of.
std::optional<TouchingOrbit> other_touch(const System& system, TouchingOrbit orbit,
                                         double speed_unit) {
  orbit.touch = slowest(system, orbit);
  TouchingOrbit without = without_touch(orbit);
  if (!without.impacts.empty() && vanishes(system, without, speed_unit))
    return from_touch(system, without, true);
  const auto beside = approach_beside(system, orbit.pattern, orbit.impacts, orbit.touch);
  if (!beside) return {};
  const ExactFlow<double> flow(system);
  const ImpactPoint touch{
      beside->theta + beside->after * system.forcing()->frequency,
      transition(system, flow, beside->start, beside->theta, beside->after).end};
  if (without.impacts.empty()) return TouchingOrbit{{1, {beside->stop}}, {touch}, 0};
  // Among the impacts left, after the one that its flight leaves.
  const std::size_t place = beside->impact - (orbit.touch < beside->impact ? 1 : 0) + 1;
  const auto at = static_cast<std::ptrdiff_t>(place);
  without.impacts.insert(without.impacts.begin() + at, touch);
  without.pattern.stops.insert(without.pattern.stops.begin() + at, beside->stop);
  without.touch = place;
  return from_its_touch(std::move(without));
}

Complex multiplier_at(const OrbitLocusSpecial& special) {
  if (special.label == "R1") return 1.0;
  if (special.label == "R2") return -1.0;
  return std::polar(1.0, special.other_angle.value_or(0.0));
}

}  // namespace

std::optional<OrbitLocusStart> locus_start(const System& system, OrbitLocusKind kind,
                                           const TouchingOrbit& orbit, bool by_speed,
                                           const LocusStartPlace& place) {
  OrbitLocusStart start{kind, {}, place.first, place.second, place.multiplier};
  if (kind != OrbitLocusKind::kGrazing) {
    start.orbit = in_canonical_order(orbit);
    return start;
  }
  std::optional<TouchingOrbit> touching = from_touch(system, orbit, by_speed);
  if (!touching) return {};
  start.orbit = std::move(*touching);
  return start;
}

std::vector<OrbitLocusStart> leads_from(const System& system, const OrbitLocus& locus,
                                        const OrbitLocusSpecial& special, double speed_unit) {
  const TouchingOrbit here = orbit_at(locus, special.at);
  const bool of_grazing = locus.kind == OrbitLocusKind::kGrazing;
  std::vector<OrbitLocusStart> starts;
  const auto add = [&](OrbitLocusKind kind, TouchingOrbit orbit) {
    starts.push_back({kind, std::move(orbit), special.at.value, special.at.second,
                      kind == OrbitLocusKind::kTorus ? multiplier_at(special) : 1.0});
  };
  if (special.label == "GRGR") {
    if (auto orbit = other_touch(system, here, speed_unit))
      add(OrbitLocusKind::kGrazing, std::move(*orbit));
    return starts;
  }
  for (const OrbitLocusKind kind : others_at(locus.kind, special.label)) {
    if (kind == OrbitLocusKind::kGrazing) {
      const bool by_speed = vanishes(system, here, speed_unit);
      // Where an impact begins to stick (r = 0) nothing touches.
      if (!by_speed && !touches(system, here)) continue;
      if (auto orbit = from_touch(system, here, by_speed)) add(kind, std::move(*orbit));
      continue;
    }
    TouchingOrbit orbit = here;
    if (of_grazing) {
      orbit.touch = slowest(system, orbit);
      orbit = without_touch(std::move(orbit));
      if (orbit.impacts.empty()) continue;
    }
    add(kind, in_canonical_order(orbit));
  }
  return starts;
}

}  // namespace graze
