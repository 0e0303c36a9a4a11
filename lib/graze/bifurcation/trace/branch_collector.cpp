#include "graze/bifurcation/trace/detail/branch_collector.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/bifurcation/problem/detail/response_equations.hpp"
#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/bifurcation/problem/grazing_orbit.hpp"
#include "graze/bifurcation/trace/detail/level_points.hpp"
#include "graze/bifurcation/trace/detail/orbit_kinds.hpp"
#include "graze/bifurcation/trace/detail/shown_curve.hpp"
#include "graze/continuation/switching.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"

namespace graze {
namespace {

// The orbit of a special point; without its grazing contact where that was found on a locus of
// grazing, unless it is the motion's only contact.
GrazingOrbit orbit_at(const System& system, const SpecialOrbit& special) {
  GrazingOrbit orbit{special.pattern, special.impacts, 0};
  if (special.locus != OrbitLocusKind::kGrazing || orbit.impacts.size() == 1) return orbit;
  orbit.grazing = admissibility(system, orbit.pattern, orbit.impacts).slowest;
  return without_grazing(std::move(orbit));
}

ContinuationOptions range_of(const BranchOptions& options) {
  ContinuationOptions range;
  range.from = options.from;
  range.to = options.to;
  range.max_step = options.max_step;
  range.stop = options.stop;
  return range;
}

SegmentOptions segment_options(const BranchOptions& options) {
  SegmentOptions result;
  result.max_impacts = options.finder.max_impacts;
  result.stop = options.stop;
  return result;
}

// Whether two branches cross there, of which one is known.
bool crosses(SpecialKind kind) {
  return kind == SpecialKind::kPeriodDoubling || kind == SpecialKind::kBranchPoint;
}

}  // namespace

BranchCollector::BranchCollector(const SystemFamily& family, const BranchOptions& options,
                                 const OrbitNumber& shown, OrbitBranches& result)
    : family_(family),
      options_(options),
      shown_(shown),
      result_(result),
      continuation_(range_of(options)),
      problems_(family.scene(), {family.parameter()},
                {options.from != options.to ? std::abs(options.to - options.from) : 1.0},
                motion_scale(*family.at(family.value())), segment_options(options)) {
  problems_.set_boundaries([this](const OrbitProblem& problem) {
    return with_level_ends(boundaries_of(problem, continuation_, options_), problem, continuation_,
                           options_.levels);
  });
  result_.scale = motion_scale(*family.at(family.value()));
  result_.range = std::abs(options.to - options.from);
}

bool BranchCollector::trace_from(const ImpactPattern& pattern,
                                 const std::vector<ImpactPoint>& impacts, double value) {
  ++result_.starts;
  const std::vector<Written> ways = problems_.written(pattern, impacts, std::span(&value, 1));
  return !ways.empty() && trace_written(ways.front(), value, {});
}

bool BranchCollector::trace_from(const Orbit& orbit, double value) {
  ++result_.starts;
  const std::vector<Written> ways = problems_.written(orbit, std::span(&value, 1));
  if (ways.empty())
    notes_.insert("an orbit that is never released from its stops is not continued");
  return !ways.empty() && trace_written(ways.front(), value, {});
}

void BranchCollector::trace_response(double value) {
  LaidOrbits& orbits = problems_.response();
  const auto& equations = dynamic_cast<const ResponseEquations&>(*orbits.problem);
  const std::optional<Vector> u = equations.unknowns_at({&value, 1});
  if (!u) return;
  const std::optional<SolutionPoint> point = solve_at(orbits->problem(), continuation_, *u, value);
  if (point && !knows(orbits, *point)) add(trace(orbits, *point, Directions::kBoth), {});
}

bool BranchCollector::trace_written(const Written& start, double value, Origin origin) {
  LaidOrbits& orbits = *start.orbits;
  std::optional<SolutionPoint> point = solve_at(orbits->problem(), continuation_, start.u, value);
  // At a fold the value does not determine a solution.
  if (!point) point = solve_near(orbits->problem(), continuation_, start.u, value);
  if (!point) return false;
  const std::string why = orbits->why_not_continued(*point);
  if (!why.empty()) {
    notes_.insert(why);
    // At a grazing that was switched at, rounding decides whether it is listed.
  } else if (!origin.at_grazing && !orbits.boundaries->lists(*point)) {
    result_.virtual_starts += origin.branch < 0 ? 1 : 0;
  } else if (!knows(orbits, *point)) {
    add(trace(orbits, *point, Directions::kBoth), origin);
  }
  return true;
}

void BranchCollector::trace_from_special(const BranchStart& start) {
  ++result_.starts;
  if (!start.at.followed && start.at.pattern.stops.empty()) return trace_response(family_.value());
  for (const Written& one : written(start.at))
    if (const std::optional<SolutionPoint> point = solution_at(one, start)) {
      trace_restarted(*one.orbits, *point, start);
      break;
    }
  if (found_.empty() && result_.notes.empty() && notes_.empty() && !options_.stop.requested())
    result_.notes.push_back(start.switched ? "no other branch was found there"
                                           : "the orbit there was not found again, or is none of "
                                             "the system beyond that point on either side");
}

std::vector<BranchCollector::Written> BranchCollector::written(const SpecialOrbit& at) {
  const double value = family_.value();
  const std::optional<System> system = family_.at(value);
  if (!system) return {};
  const auto gives_way = [&](int stop) {
    return system->stops[static_cast<std::size_t>(stop)].is_compliant();
  };
  const std::vector<int> closed =
      at.followed ? closed_stops(at.followed->states.front()) : std::vector<int>();
  if (at.followed ? std::any_of(closed.begin(), closed.end(), gives_way)
                  : system->has_compliant_stop()) {
    notes_.insert(
        "the special point belongs to orbits on rigid stops, but these stops are compliant");
    return {};
  }
  if (!at.followed) {
    const GrazingOrbit orbit = orbit_at(*system, at);
    return problems_.written(orbit.pattern, orbit.impacts, std::span(&value, 1));
  }
  const FollowedAnswer answer = orbit_again(*system, at, segment_options(options_));
  if (!answer.orbit) notes_.insert(answer.why_not);
  return answer.orbit ? problems_.written(*answer.orbit, std::span(&value, 1))
                      : std::vector<Written>();
}

std::optional<SolutionPoint> BranchCollector::solution_at(const Written& written,
                                                          const BranchStart& start) const {
  const double value = family_.value();
  Vector along;
  if (start.same_parameter && start.at.along) {
    const Vector rate =
        ShootingProblem(start.at.pattern, result_.scale)
            .pack(*(*written.orbits)->system_at(std::span(&value, 1)), start.at.along->impacts);
    along.resize(rate.size() + 1);
    along << rate, start.at.along->value / std::abs(options_.to - options_.from);
    along.normalize();
  }
  // A branch point is taken as it is: its equations are not regular.
  if (start.at.kind == SpecialKind::kBranchPoint && along.size() > 0) {
    SolutionPoint point;
    point.u = written.u;
    point.parameter = value;
    point.tangent = along;
    return point;
  }
  return solve_near((*written.orbits)->problem(), continuation_, written.u, value, along);
}

void BranchCollector::trace_restarted(LaidOrbits& orbits, const SolutionPoint& point,
                                      const BranchStart& start) {
  // At a grazing rounding decides whether it is listed.
  if (start.at.label != label_of(SpecialKind::kGrazing) && !orbits.boundaries->lists(point)) {
    ++result_.virtual_starts;
    result_.notes.push_back(
        "the solution there is inadmissible (it penetrates a stop, or impacts at negative speed); "
        "--virtual continues from it");
    return;
  }
  if (!start.switched) {
    std::vector<BranchPiece> pieces = trace(orbits, point, Directions::kBoth);
    if (start.at.kind == SpecialKind::kBranchPoint) list_crossing(pieces.front().branch);
    return add(std::move(pieces), {});
  }
  SpecialPoint special;
  special.kind = start.at.kind.value_or(SpecialKind::kFold);
  special.by_speed = start.at.by_speed;
  special.by_push = start.at.by_push;
  special.solution = point;
  switch_from(special, {&orbits, {}}, {-1, 0, special.kind == SpecialKind::kGrazing});
}

bool BranchCollector::knows(const LaidOrbits& orbits, const SolutionPoint& solution) const {
  return std::any_of(traced_.begin(), traced_.end(), [&](const Traced& traced) {
    const OrbitProblem& problem = *traced.orbits->problem;
    Corrector corrector(problem.problem(), continuation_);
    for (const SolutionPoint& same : problem.rewritings(*orbits.problem, continuation_, solution))
      if (traced.branch.has(corrector, same)) return true;
    return false;
  });
}

// The special point itself lies on every branch through it.
bool BranchCollector::knows_beyond(const LaidOrbits& orbits, const SolutionPoint& start) const {
  ContinuationOptions some = continuation_;
  some.max_points = 2;
  ZeroProblem bare = orbits->problem();
  bare.multipliers = nullptr;
  const Branch away = trace_branch(bare, some, start, Directions::kForward);
  return away.points.size() > 1 && knows(orbits, away.points.back());
}

std::vector<BranchPiece> BranchCollector::trace(LaidOrbits& orbits, const SolutionPoint& start,
                                                Directions directions) {
  const Clearer clearer = [this](const LaidOrbits& known, const SolutionPoint& solution) {
    return problems_.clearer(known, solution);
  };
  std::vector<BranchPiece> pieces = trace_pieces(clearer, orbits, continuation_, start, directions);
  for (BranchPiece& piece : pieces) {
    if (shown_) resolve_shown(*piece.orbits, continuation_, shown_, piece.branch);
    mark_levels(*piece.orbits, continuation_, options_.levels, piece.branch);
  }
  return pieces;
}

void BranchCollector::add(std::vector<BranchPiece> pieces, Origin origin) {
  const auto cuts = [](OrbitBranchEnd end) {
    return end == OrbitBranchEnd::kNotConverged || end == OrbitBranchEnd::kStepLimit;
  };
  bool cut = false;
  for (FoundBranch& found : branches_of(pieces)) {
    for (const OrbitBranchEnd end : found.branch.ends) {
      cut = cut || cuts(end);
      result_.meetings += end == OrbitBranchEnd::kImpactsMeet ? 1 : 0;
    }
    found.trace = result_.traced;
    found.origin_branch = origin.branch;
    found.origin_special = origin.special;
    found_.push_back(std::move(found));
  }
  for (BranchPiece& piece : pieces) {
    result_.shooting_evaluations += piece.branch.evaluations;
    result_.rejected_steps += piece.branch.rejected;
    const ZeroProblem& problem = (*piece.orbits)->problem();
    traced_.push_back({piece.orbits, KnownBranch(Corrector(problem, continuation_),
                                                 std::move(piece.branch.points), problem.wrap,
                                                 continuation_.max_turn)});
  }
  ++result_.traced;
  if (cut) ++result_.cut_short;
  if (origin.branch >= 0) ++result_.switched;
}

void BranchCollector::follow() {
  std::size_t first = 0;
  for (int depth = 0; depth < options_.follow_depth; ++depth) {
    const std::size_t last = found_.size();
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = 0; k < found_[i].branch.special.size(); ++k) {
        if (options_.stop.requested()) return;
        const SpecialPoint special = found_[i].branch.special[k];
        const SpecialContinuation continuation = found_[i].continuations[k];
        switch_from(special, continuation,
                    {static_cast<int>(i), k, special.kind == SpecialKind::kGrazing});
      }
    first = last;
  }
  for (std::size_t i = first; i < found_.size() && options_.follow_depth > 0; ++i)
    for (std::size_t k = 0; k < found_[i].branch.special.size(); ++k) {
      const SpecialPoint& special = found_[i].branch.special[k];
      const SpecialContinuation& continuation = found_[i].continuations[k];
      const bool leads_on = crosses(special.kind) || !continuation.others.empty() ||
                            continuation.orbits->boundaries->across(special).has_value();
      result_.left_open += leads_on ? 1 : 0;
    }
}

void BranchCollector::add_normal_forms() {
  for (FoundBranch& found : found_)
    for (std::size_t k = 0; k < found.branch.special.size(); ++k) {
      if (options_.stop.requested()) return;
      SpecialPoint& special = found.branch.special[k];
      const LaidOrbits& orbits = *found.continuations[k].orbits;
      if (special.kind == SpecialKind::kFold)
        special.normal = fold_form(orbits->problem(), continuation_, special.solution);
      if (special.kind != SpecialKind::kPeriodDoubling && special.kind != SpecialKind::kTorus)
        continue;
      const ZeroProblem& doubled = problems_.doubled(orbits)->problem();
      const SolutionPoint twice = orbits->twice_round(special.solution);
      special.normal =
          special.kind == SpecialKind::kTorus
              ? torus_form(orbits->problem(), continuation_, special.solution, *special.multiplier,
                           doubled, twice)
              : doubling_form(orbits->problem(), continuation_, special.solution, doubled, twice);
    }
}

bool BranchCollector::switch_from(const SpecialPoint& special,
                                  const SpecialContinuation& continuation, Origin origin) {
  if (crosses(special.kind)) return switch_across(*continuation.orbits, special, origin);
  const std::size_t known = found_.size();
  std::vector<OrbitBranchPoint> others = continuation.others;
  if (const auto across = continuation.orbits->boundaries->across(special))
    others.push_back(point_of_branch(special.solution.parameter, *across));
  for (const OrbitBranchPoint& other : others)
    for (const Written& one : problems_.written(other.orbit, std::span(&other.value, 1)))
      if (trace_written(one, other.value, origin)) break;
  if (special.kind == SpecialKind::kChatterCompletes && !others.empty() &&
      !others.front().orbit.sticks())
    notes_.insert(
        "beyond a CH no single branch continues: infinitely many windows of the parameter "
        "accumulate at it, each with one more impact; the orbits of the first ones were searched "
        "for");
  return found_.size() > known;
}

bool BranchCollector::switch_across(LaidOrbits& known, const SpecialPoint& special, Origin origin) {
  const bool doubles = special.kind == SpecialKind::kPeriodDoubling;
  LaidOrbits& orbits = doubles ? problems_.doubled(known) : known;
  SolutionPoint at = doubles ? known->twice_round(special.solution) : special.solution;
  at.multipliers.clear();
  const std::optional<SolutionPoint> start = other_branch(orbits->problem(), continuation_, at);
  if (!start || knows_beyond(orbits, *start)) return false;
  // Both directions from a doubling give the same orbits, half a period apart.
  std::vector<BranchPiece> pieces =
      trace(orbits, *start, doubles ? Directions::kForward : Directions::kBoth);
  // A given start has no known branch; its own branch has it among its points.
  if (!doubles && origin.branch < 0) list_crossing(pieces.front().branch);
  add(std::move(pieces), origin);
  return true;
}

}  // namespace graze
