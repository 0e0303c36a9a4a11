#include "graze/bifurcation/loci/locus_continuations.hpp"

#include <cmath>
#include <utility>

#include "graze/bifurcation/problem/detail/canonical_pattern.hpp"
#include "graze/bifurcation/problem/detail/locus_margins.hpp"
#include "graze/flow/variation/detail/transition.hpp"

namespace graze {
namespace {

// An impact slower than this part of the forced motion's speed counts as vanishing, a gap below
// this part of the length scale as touched. Located points have them to rounding.
constexpr double kVanishing = 1e-9;

GrazingOrbit orbit_at(const OrbitLocus& locus, const OrbitLocusPoint& at) {
  Orbit orbit;
  orbit.period = locus.pattern.period;
  orbit.impacts = at.impacts;
  return {orbit.pattern(), orbit.points(), 0};
}

// Absolute values of the speeds of all impacts, m/s.
Vector sizes_of_speeds(const System& system, const GrazingOrbit& orbit) {
  return approach_speeds(system, orbit.pattern, orbit.impacts).cwiseAbs();
}

std::size_t slowest(const System& system, const GrazingOrbit& orbit) {
  Eigen::Index least = 0;
  sizes_of_speeds(system, orbit).minCoeff(&least);
  return static_cast<std::size_t>(least);
}

bool vanishes(const System& system, const GrazingOrbit& orbit, double speed_unit) {
  return sizes_of_speeds(system, orbit).minCoeff() <= kVanishing * speed_unit;
}

// The same orbit, relabelled to start with its grazing contact.
GrazingOrbit from_its_grazing(GrazingOrbit orbit) {
  const int period = orbit.pattern.period;
  return {turned(std::move(orbit.pattern), orbit.grazing),
          turned(std::move(orbit.impacts), orbit.grazing, period), 0};
}

bool touches(const System& system, const GrazingOrbit& orbit) {
  const std::optional<double> clearance =
      admissibility(system, orbit.pattern, orbit.impacts).clearance();
  return clearance && std::abs(*clearance) <= kVanishing * motion_scale(system).length;
}

// The kinds that meet a locus of one kind at a point with this label.
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

// The orbit from its grazing contact on: an impact whose speed vanishes (`by_speed`) or the nearest
// approach. Returns nullopt when there is no approach.
std::optional<GrazingOrbit> from_grazing(const System& system, const GrazingOrbit& orbit,
                                         bool by_speed) {
  std::optional<GrazingOrbit> grazing = orbit;
  if (by_speed)
    grazing->grazing = slowest(system, orbit);
  else
    grazing = with_grazing(system, orbit.pattern, orbit.impacts);
  if (!grazing) return {};
  // An orbit that only touches is the motion without impacts, which repeats every period.
  if (grazing->pattern.impacts() == 1) grazing->pattern.period = 1;
  return from_its_grazing(std::move(*grazing));
}

// The order in which loci of folds, doublings and tori start from it.
GrazingOrbit in_canonical_order(const GrazingOrbit& orbit) {
  return {canonical(orbit.pattern), in_canonical_order(orbit.pattern, orbit.impacts), 0};
}

// Where an orbit touches twice, the orbit with the grazing contact that the locus is not of.
std::optional<GrazingOrbit> other_grazing(const System& system, GrazingOrbit orbit,
                                          double speed_unit) {
  orbit.grazing = slowest(system, orbit);
  GrazingOrbit without = without_grazing(orbit);
  if (!without.impacts.empty() && vanishes(system, without, speed_unit))
    return from_grazing(system, without, true);
  const auto beside = approach_beside(system, orbit.pattern, orbit.impacts, orbit.grazing);
  if (!beside) return {};
  const ExactFlow<double> flow(system);
  const ImpactPoint grazing{
      beside->theta + beside->after * system.forcing()->frequency,
      transition(system, flow, beside->start, beside->theta, beside->after).end};
  if (without.impacts.empty()) return GrazingOrbit{{1, {beside->stop}}, {grazing}, 0};
  // Its place among the remaining impacts, after the one that its flight starts from.
  const std::size_t place = beside->impact - (orbit.grazing < beside->impact ? 1 : 0) + 1;
  const auto at = static_cast<std::ptrdiff_t>(place);
  without.impacts.insert(without.impacts.begin() + at, grazing);
  without.pattern.stops.insert(without.pattern.stops.begin() + at, beside->stop);
  without.grazing = place;
  return from_its_grazing(std::move(without));
}

Complex multiplier_at(const OrbitLocusSpecial& special) {
  if (special.label == "R1") return 1.0;
  if (special.label == "R2") return -1.0;
  return std::polar(1.0, special.other_angle.value_or(0.0));
}

}  // namespace

std::optional<OrbitLocusStart> locus_start(const System& system, OrbitLocusKind kind,
                                           const GrazingOrbit& orbit, bool by_speed,
                                           const LocusStartPlace& place) {
  OrbitLocusStart start{kind, {}, place.first, place.second, place.multiplier};
  if (kind != OrbitLocusKind::kGrazing) {
    start.orbit = in_canonical_order(orbit);
    return start;
  }
  std::optional<GrazingOrbit> grazing = from_grazing(system, orbit, by_speed);
  if (!grazing) return {};
  start.orbit = std::move(*grazing);
  return start;
}

std::vector<OrbitLocusStart> continuations_from(const System& system, const OrbitLocus& locus,
                                                const OrbitLocusSpecial& special,
                                                double speed_unit) {
  const GrazingOrbit here = orbit_at(locus, special.at);
  const bool of_grazing = locus.kind == OrbitLocusKind::kGrazing;
  std::vector<OrbitLocusStart> starts;
  const auto add = [&](OrbitLocusKind kind, GrazingOrbit orbit) {
    starts.push_back({kind, std::move(orbit), special.at.value, special.at.second,
                      kind == OrbitLocusKind::kTorus ? multiplier_at(special) : 1.0});
  };
  if (special.label == "GRGR") {
    if (auto orbit = other_grazing(system, here, speed_unit))
      add(OrbitLocusKind::kGrazing, std::move(*orbit));
    return starts;
  }
  for (const OrbitLocusKind kind : others_at(locus.kind, special.label)) {
    if (kind == OrbitLocusKind::kGrazing) {
      const bool by_speed = vanishes(system, here, speed_unit);
      // Where an impact begins to stick (r = 0) nothing touches.
      if (!by_speed && !touches(system, here)) continue;
      if (auto orbit = from_grazing(system, here, by_speed)) add(kind, std::move(*orbit));
      continue;
    }
    GrazingOrbit orbit = here;
    if (of_grazing) {
      orbit.grazing = slowest(system, orbit);
      orbit = without_grazing(std::move(orbit));
      if (orbit.impacts.empty()) continue;
    }
    add(kind, in_canonical_order(orbit));
  }
  return starts;
}

}  // namespace graze
