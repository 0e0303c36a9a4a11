#include "graze/bifurcation/loci/restart.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"

namespace graze {
namespace {

// Whether a branch that sticks ends at such a point, so that the motion started there need not
// repeat the orbit.
bool is_boundary(SpecialKind kind) {
  return kind == SpecialKind::kChatterCompletes || kind == SpecialKind::kLiftOff ||
         kind == SpecialKind::kGrazing;
}

// The point of a branch next to one of its special points.
const OrbitBranchPoint& beside(const OrbitBranch& branch, const SpecialPoint& special) {
  const auto here =
      std::find_if(branch.points.begin(), branch.points.end(),
                   [&](const OrbitBranchPoint& point) { return point.value == special.at.value; });
  if (here == branch.points.end() || branch.points.size() == 1) return special.at;
  return here == branch.points.begin() ? *std::next(here) : *std::prev(here);
}

SpecialOrbit::Followed as_followed(int period, double value, const OrbitSection& section) {
  return {period, value, section.states, section.closure_speed};
}

std::optional<SpecialOrbit::Followed> followed_part(const OrbitBranch& branch,
                                                    const SpecialPoint& special) {
  const bool beyond = branch.sticks() && is_boundary(special.kind);
  const OrbitBranchPoint& at = beyond ? beside(branch, special) : special.at;
  if (!at.orbit.section || at.orbit.sticks() != branch.sticks()) return {};
  return as_followed(at.orbit.period, at.value, *at.orbit.section);
}

std::optional<OrbitLocusKind> locus_of(const SpecialOrbit& special) {
  if (special.locus) return special.locus;
  if (special.by_push || (special.sticks() && special.kind && is_boundary(*special.kind)))
    return {};
  for (const OrbitLocusKind kind : kOrbitLocusKinds)
    if (special.label == label_of(kind)) return kind;
  for (const OrbitLocusKind kind : {OrbitLocusKind::kLevel, OrbitLocusKind::kExtreme})
    if (special.label == label_of(kind)) return kind;
  return {};
}

}  // namespace

std::vector<SpecialOrbit> special_orbits(const OrbitBranches& traced, const System& system) {
  std::vector<SpecialOrbit> list;
  for (const OrbitBranch& branch : traced.branches)
    for (const SpecialPoint& special : branch.special) {
      // The response goes on in closed form; nothing is restarted from it.
      if (!special.at.orbit.meets_stops()) continue;
      SpecialOrbit one;
      one.id = special.id;
      one.label = label_of(special.kind);
      one.kind = special.kind;
      one.values = {special.at.value};
      one.multiplier = special.multiplier;
      one.by_speed = special.by_speed;
      one.by_push = special.by_push;
      if (is_of_level(special.kind)) one.level = traced.levels[special.level];
      if (branch.sticks() || special.at.orbit.section) {
        one.followed = followed_part(branch, special);
      } else {
        one.pattern = branch.pattern;
        const ShootingProblem problem(branch.pattern, traced.scale);
        const Eigen::Index n = special.solution.u.size();
        one.impacts = problem.unpack(system, special.solution.u);
        one.along = {problem.unpack(system, special.solution.tangent.head(n)),
                     special.solution.rate() * traced.range};
      }
      list.push_back(std::move(one));
    }
  return list;
}

std::vector<SpecialOrbit> special_orbits(const OrbitLoci& traced) {
  std::vector<SpecialOrbit> list;
  for (const OrbitLocus& locus : traced.loci) {
    for (const OrbitLocusSpecial& special : locus.special) {
      SpecialOrbit one;
      one.id = special.id;
      one.label = special.label;
      one.values = {special.at.value, special.at.second};
      if (special.at.section) {
        one.followed = as_followed(locus.pattern.period, special.at.value, *special.at.section);
      } else {
        Orbit orbit;
        orbit.period = locus.pattern.period;
        orbit.impacts = special.at.impacts;
        one.pattern = orbit.pattern();
        one.impacts = orbit.points();
      }
      one.multiplier = std::polar(1.0, special.at.angle);
      one.locus = locus.kind;
      one.by_speed = locus.kind == OrbitLocusKind::kGrazing;
      if (is_of_level(locus.kind)) one.level = traced.levels[locus.level];
      list.push_back(std::move(one));
    }
  }
  return list;
}

SpecialOrbit orbit_to_start_from(const Orbit& orbit, const std::string& id,
                                 std::optional<double> value) {
  SpecialOrbit one;
  one.id = id;
  if (value) one.values = {*value};
  if (!orbit.meets_stops()) return one;  // the response, which has a closed form
  if (orbit.section) {
    one.followed = as_followed(orbit.period, value.value_or(0.0), *orbit.section);
  } else {
    one.pattern = orbit.pattern();
    one.impacts = orbit.points();
  }
  return one;
}

std::optional<OrbitLocusStart> locus_start(const System& system, const SpecialOrbit& special,
                                           double first, double second) {
  const std::optional<OrbitLocusKind> kind = locus_of(special);
  if (!kind) return {};
  if (special.followed) {
    FollowedAnswer answer = orbit_again(system, special, {});
    if (!answer.orbit) return {};
    return OrbitLocusStart{
        *kind, {}, first, second, special.multiplier.value_or(1.0), std::move(answer.orbit)};
  }
  return locus_start(system, *kind, {special.pattern, special.impacts, 0}, special.by_speed,
                     {first, second, special.multiplier.value_or(1.0)});
}

}  // namespace graze
