#include "graze/bifurcation/cut/detail/contact_boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "graze/bifurcation/cut/detail/grazing_search.hpp"
#include "graze/bifurcation/cut/detail/sliding_order.hpp"
#include "graze/continuation/branch/detail/locate.hpp"

namespace graze {
namespace {

// How far the end of a trace may lie from its grazing, in lengths of the range: as near as it has
// to come in speed.
constexpr double kBeside = 1e-5;
// How far beyond a last solution another order is looked for, in parts of the unknowns.
constexpr double kLeastBeyond = 1e-12, kMostBeyond = 1e-6;

// The stop of a contact that only one of two orbits has; nullopt when they have the same contacts.
std::optional<int> stop_of_difference(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> difference;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                std::back_inserter(difference));
  return difference.empty() ? std::nullopt : std::optional(difference.front());
}

// The stops of the contacts of a place, in rising order; none where it is no orbit.
std::vector<int> stops_of(const BranchPlace& place) {
  std::vector<int> stops = place.at.orbit.pattern().stops;
  std::sort(stops.begin(), stops.end());
  return stops;
}

BranchTip jump(OrbitBranchPoint at, SpecialKind kind, const SolutionPoint& last) {
  BranchPlace place;
  place.end = OrbitBranchEnd::kSliding;
  place.at = std::move(at);
  place.special = SpecialPoint{kind, "", place.at, {}, false, last};
  return {OrbitBranchEnd::kSliding, std::move(place)};
}

}  // namespace

bool ContactBoundaries::lie_across(const SolutionPoint& a, const SolutionPoint& b) const {
  const System* system = equations_.system_at(a.parameters());
  if (!system || system->frictions.empty()) return false;
  const std::optional<OrbitBranchPoint> of_a = equations_.judge(a), of_b = equations_.judge(b);
  return of_a && of_b && !has_same_sliding(of_a->orbit, of_b->orbit);
}

bool ContactBoundaries::resolves(const SolutionPoint& from, const SolutionPoint& to) {
  const std::optional<int> stop =
      stop_of_difference(equations_.stops_met(from), equations_.stops_met(to));
  // Across a corner the tangents are unrelated.
  if (!stop || !equations_.sets_in_smoothly(from, *stop)) return true;
  // A step this short hides nothing.
  if ((to.u - from.u).norm() <= kOnePoint * (1.0 + from.u.norm())) return true;
  const std::optional<FoundGrazing> grazing =
      find_grazing_between(equations_, options_, from, to, *stop);
  return grazing && grazing->at.tangent.dot(from.tangent) >= std::cos(options_.max_turn);
}

// `approach`: an approach touches there, else the speed of a contact vanishes.
BranchPlace ContactBoundaries::boundary(const SolutionPoint& at,
                                        std::optional<OrbitBranchPoint> orbit,
                                        bool approach) const {
  BranchPlace place;
  place.end = OrbitBranchEnd::kGrazing;
  place.listed = orbit.has_value();
  if (!orbit) return place;
  place.at = std::move(*orbit);
  place.special = SpecialPoint{SpecialKind::kGrazing, "", place.at, {}, !approach, at};
  return place;
}

// Decided by the contacts of the orbits on both sides, in any order.
void ContactBoundaries::pass(const JudgedPoint& a, const JudgedPoint& b,
                             std::vector<BranchPlace>& places) {
  const std::vector<int> before = stops_of(a.place), after = stops_of(b.place);
  const std::optional<int> stop = stop_of_difference(before, after);
  if (!stop) return pass_sliding(a, b, places);
  const bool born = before.size() < after.size();
  if (auto grazing = find_grazing_between(equations_, options_, a.point, b.point, *stop)) {
    grazing->at.bracket =
        bracket_around({a.point.parameter, b.point.parameter, grazing->at.parameter}, true);
    for (const bool approach : {born, !born})
      places.push_back(boundary(grazing->at,
                                approach ? equations_.judge_without(grazing->at, grazing->contact)
                                         : equations_.judge_grazing(grazing->at, grazing->contact),
                                approach));
  } else {
    const std::optional<SolutionPoint> at =
        grazing_between(a.point, b.point, before.size(), after.size());
    const bool met = std::min(before.size(), after.size()) > 0;
    for (const bool approach : {born, !born})
      places.push_back(at && (met || !approach) ? boundary(*at, equations_.judge(*at), approach)
                                                : boundary(a.point, {}, approach));
  }
  places.back().begins = true;
}

// By the parameter alone, where the branch has a corner that steps along it do not pass. The side
// on which the test is positive is told.
std::optional<SolutionPoint> ContactBoundaries::halved(
    SolutionPoint low, SolutionPoint high,
    const std::function<double(const SolutionPoint&)>& test) const {
  const bool rises = test(high) > 0.0;
  if (rises == (test(low) > 0.0)) return {};
  while (true) {
    const double middle = low.parameter + 0.5 * (high.parameter - low.parameter);
    if (middle == low.parameter || middle == high.parameter) break;
    const std::optional<SolutionPoint> there =
        solve_at(equations_.problem(), options_, 0.5 * (low.u + high.u), middle);
    if (!there) break;
    ((test(*there) > 0.0) == rises ? high : low) = *there;
  }
  SolutionPoint found = rises ? high : low;
  found.bracket = bracket_around({low.parameter, high.parameter}, true);
  return found;
}

// Only the order of events tells the sides apart, so that the place is found by halving.
void ContactBoundaries::pass_sliding(const JudgedPoint& a, const JudgedPoint& b,
                                     std::vector<BranchPlace>& places) const {
  const Orbit &before = a.place.at.orbit, &after = b.place.at.orbit;
  if (!a.place.listed || !b.place.listed || has_same_sliding(before, after)) return;
  const bool gains = after.rubbing.size() >= before.rubbing.size();
  const auto test = [&](const SolutionPoint& point) {
    const std::optional<OrbitBranchPoint> at = equations_.judge(point);
    return at && has_same_sliding(at->orbit, before) == gains ? -1.0 : 1.0;
  };
  std::optional<SolutionPoint> at = locate(equations_.problem(), options_, a.point, b.point, test);
  if (!at) at = halved(a.point, b.point, test);
  std::optional<OrbitBranchPoint> orbit = at ? equations_.judge(*at) : std::nullopt;
  if (!orbit) return;
  BranchPlace place;
  place.at = std::move(*orbit);
  place.special = SpecialPoint{kind_of_change(place.at.orbit), "", place.at, {}, false, *at};
  places.push_back(std::move(place));
}

// Distance of an orbit from a grazing: proportional to the distance along the branch is its
// clearance, m, the speed of an impact on a rigid stop, m/s, and the square of that on a spring.
std::optional<double> ContactBoundaries::margin_of(const SolutionPoint& point, bool speed,
                                                   std::size_t impacts) const {
  const std::optional<OrbitBranchPoint> at = equations_.judge(point);
  if (!at || at->orbit.impacts.size() != impacts) return {};
  if (!speed) return at->orbit.clearance;
  return speed_margin(point, at->smallest_speed);
}

bool ContactBoundaries::meets_springs(const SolutionPoint& point) const {
  return equations_.system_at(point.parameter)->has_compliant_stop();
}

double ContactBoundaries::speed_margin(const SolutionPoint& point, double speed) const {
  return speed * (meets_springs(point) ? speed : 1.0);
}

// Margin at which a trace without a further step is near enough: 1e-5 of the speed of the forced
// motion, or 1e-10 of its length.
double ContactBoundaries::near_enough(const SolutionPoint& point, bool speed) const {
  constexpr double kPart = 1e-5;
  if (!speed) return kPart * kPart * equations_.length();
  return speed_margin(point, kPart * equations_.speed_unit());
}

// Where the force of a stop sets in with a jump the map has a corner at a grazing, around which the
// trace cannot turn. The grazing is approached from the trace's last points, where they lead to
// one.
std::optional<BranchTip> ContactBoundaries::close(Branch& trace, std::size_t side) {
  const std::size_t count = trace.points.size();
  if (trace.ends[side] != BranchEnd::kNotConverged || count < 2) return {};
  const SolutionPoint& before = trace.points[side == 0 ? 1 : count - 2];
  const SolutionPoint& last = trace.points[side == 0 ? 0 : count - 1];
  const std::size_t impacts = equations_.stops_met(last).size();
  for (const bool speed : {false, true}) {
    std::optional<SolutionPoint> corner = corner_beyond(before, last, speed, impacts);
    if (!corner) continue;
    std::optional<OrbitBranchPoint> orbit = equations_.judge(*corner);
    // Near it a speed is known to the square root of what displacements are; its own equation has
    // no such loss.
    std::optional<FoundGrazing> grazing;
    if (!meets_springs(*corner)) grazing = find_grazing_from(equations_, options_, *corner);
    if (grazing && std::abs(grazing->at.parameter - corner->parameter) <=
                       kBeside * std::abs(options_.to - options_.from)) {
      grazing->at.bracket = bracket_around({corner->parameter, grazing->at.parameter}, true);
      corner = grazing->at;
      if (orbit) orbit->value = corner->parameter;
    }
    if (side == 0) {
      trace.points.insert(trace.points.begin(), *corner);
      for (CriticalPoint& critical : trace.critical) ++critical.after;
    } else {
      trace.points.push_back(*corner);
    }
    return BranchTip{OrbitBranchEnd::kGrazing, boundary(*corner, std::move(orbit), !speed)};
  }
  return jump_beyond(last, side);
}

// Beyond the last solution friction slides or sticks in another order, and no branch goes on there.
std::optional<BranchTip> ContactBoundaries::jump_beyond(const SolutionPoint& last,
                                                        std::size_t side) const {
  const std::optional<OrbitBranchPoint> tip = equations_.judge(last);
  const double size = 1.0 + last.u.norm(), range = std::abs(options_.to - options_.from);
  for (double step = kLeastBeyond; tip && step <= kMostBeyond; step *= 10.0) {
    const double ahead = (side == 0 ? -step : step) * size;
    SolutionPoint there = last;
    there.u += ahead * last.tangent.head(last.u.size());
    there.parameter += ahead * range * last.tangent[last.u.size()];
    if (!lie_across(last, there)) continue;
    const Orbit beyond = equations_.judge(there)->orbit;
    const bool gains = beyond.rubbing.size() > tip->orbit.rubbing.size();
    return jump(*tip, kind_of_change(gains ? beyond : tip->orbit), last);
  }
  const std::optional<SpecialKind> ends = tip ? what_hardly_lasts(tip->orbit) : std::nullopt;
  if (!ends) return {};
  return jump(*tip, *ends, last);
}

// Approaches by secants of the margin, from one side; nullopt when they do not come near zero.
std::optional<SolutionPoint> ContactBoundaries::corner_beyond(SolutionPoint before,
                                                              SolutionPoint last, bool speed,
                                                              std::size_t impacts) const {
  constexpr int kMostRounds = 40;
  // Part of its value to which a boundary that counts as solved for is known.
  constexpr double kKnown = 1e-10;
  std::optional<double> from = margin_of(before, speed, impacts),
                        to = margin_of(last, speed, impacts);
  if (!from || !to) return {};
  const bool near = *to <= near_enough(last, speed);
  if (!near && !(*to < *from)) return {};
  const double first = *from;
  for (int round = 0; round < kMostRounds && !near && 1e-12 * first < *to; ++round) {
    // Stops short of the zero: beyond it the motion is another one.
    const double part = 0.9 * *to / (*from - *to);
    if (!(part > 0.0) || (round == 0 && part > 1.0)) return {};
    SolutionPoint guess = last;
    guess.u += part * (last.u - before.u);
    const double value = last.parameter + part * (last.parameter - before.parameter);
    const std::optional<SolutionPoint> next =
        solve_at(equations_.problem(), options_, guess.u, value);
    const std::optional<double> left = next ? margin_of(*next, speed, impacts) : std::nullopt;
    if (!left || !(*left < *to)) break;
    before = std::exchange(last, *next);
    from = std::exchange(to, left);
  }
  if (!near && !(*to <= 1e-3 * first)) return {};
  // Seen from one side only: the bracket extends by the length of the last secant.
  const double ahead =
      *to < *from ? *to / (*from - *to) * (last.parameter - before.parameter) : 0.0;
  last.bracket = bracket_around(
      {last.parameter, last.parameter + ahead},
      *to <= near_enough(last, speed) && std::abs(ahead) <= kKnown * std::abs(last.parameter));
  return last;
}

// The gap of an approach falls through zero in proportion to the distance; beyond, the speed of an
// impact grows with it, or the square of that of a contact on a spring.
std::optional<SolutionPoint> ContactBoundaries::grazing_between(const SolutionPoint& a,
                                                                const SolutionPoint& b,
                                                                std::size_t before,
                                                                std::size_t after) const {
  const std::size_t fewer = std::min(before, after);
  const double sign = before < after ? 1.0 : -1.0;
  const auto test = [&](const SolutionPoint& point) {
    const std::optional<OrbitBranchPoint> at = equations_.judge(point);
    const std::size_t here = at ? at->orbit.impacts.size() : 0;
    if (here > fewer) return -sign * speed_margin(point, at->smallest_speed);
    return sign * (at && at->orbit.clearance ? std::abs(*at->orbit.clearance) : 1.0);
  };
  return locate(equations_.problem(), options_, a, b, test);
}

}  // namespace graze
