#include "graze/bifurcation/bounds/orbits_over_gap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/continuation/branch.hpp"
#include "graze/continuation/branch/detail/locate.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/closed_form/response.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/orbit_identity.hpp"
#include "graze/orbit/search/finder.hpp"

namespace graze {
namespace {

// In lengths of the forced motion: how far the gaps are widened beyond where the response touches,
// and narrowed beyond the system's own gaps. Structures that a stop stiffens have no resonances of
// that many times the linear response.
constexpr double kWidest = 20.0, kNarrowest = 0.1;
// How far clear of the stops the branch starts, and its longest steps.
constexpr double kClear = 0.05, kLongestStep = 0.5;
// A map with its derivatives costs as N^3: with this many modes a branch takes some seconds.
constexpr int kMostGapModes = 24;
// Only the branch is needed, not its special points.
constexpr double kMaxDistance = 0.2;
constexpr int kMostGapPoints = 400;

System rate_of_gaps(const System& system, double length) {
  System rate = system;
  rate.omega.setZero();
  rate.modal().delta.setZero();
  rate.modal().forcing->frequency = rate.modal().forcing->phase = 0.0;
  rate.modal().forcing->amplitude.setZero();
  for (Harmonic& one : rate.modal().forcing->harmonics) {
    one.cosine.setZero();
    one.sine.setZero();
  }
  if (rate.modal().load) rate.modal().load->setZero();
  for (Stop& stop : rate.stops) {
    stop.row.setZero();
    stop.gap = length;
    stop.law = ImpactLaw{Vector::Zero(stop.row.size())};
  }
  return rate;
}

class GapBranch {
 public:
  GapBranch(const System& system, const FinderOptions& options, const SegmentOptions& segment)
      : system_(system),
        widened_(system),
        length_(motion_scale(system).length),
        rate_(rate_of_gaps(system, length_)),
        shooting_(system, SegmentLayout::fixed_phase(1), segment) {
    problem_.evaluate = [this](const Vector& x, Parameters at) { return evaluate(x, at[0]); };
    range_.stop = options.stop;
    range_.max_step = kLongestStep;
    range_.max_distance = kMaxDistance;
    range_.max_points = kMostGapPoints;
  }

  // Solutions at the system's own gaps.
  std::vector<Vector> solutions() {
    const std::optional<Response> response = response_of(system_);
    if (!response || system_.stops.empty() || !(length_ > 0.0)) return {};
    // The widening of all gaps at which the response just reaches the first stop.
    const double touches = -*response->clearance(system_.stops) / length_;
    if (!std::isfinite(touches)) return {};
    range_.from = std::min(touches, 0.0) - kNarrowest;
    range_.to = std::max(touches, 0.0) + kWidest;
    const Vector clear = shooting_.pack(system_, {response->at(0.0, system_.forcing()->frequency)});
    std::optional<SolutionPoint> start = solve_at(problem_, range_, clear, touches + kClear);
    if (!start) return {};
    start->turn_round();
    const Branch branch = trace_branch(problem_, range_, *start, Directions::kForward);
    std::vector<Vector> list;
    auto critical = branch.critical.begin();
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
      const SolutionPoint* from = &branch.points[i];
      for (; critical != branch.critical.end() && critical->after == i; ++critical) {
        pass(*from, critical->point, list);
        from = &critical->point;
      }
      pass(*from, branch.points[i + 1], list);
    }
    return list;
  }

 private:
  std::optional<ZeroEvaluation> evaluate(const Vector& x, double wider) {
    for (std::size_t i = 0; i < system_.stops.size(); ++i)
      widened_.stops[i].gap = system_.stops[i].gap + wider * length_;
    const System* const rate = &rate_;
    auto sum = shooting_.linearise(widened_, x, std::span(&rate, 1));
    if (!sum) return {};
    return ZeroEvaluation{std::move(sum->residual), std::move(sum->jacobian),
                          std::move(sum->by_parameters), std::move(sum->closing)};
  }

  void pass(const SolutionPoint& a, const SolutionPoint& b, std::vector<Vector>& list) const {
    if (a.parameter == 0.0 || a.parameter * b.parameter < 0.0) {
      const std::optional<SolutionPoint> at = locate(
          problem_, range_, a, b, [](const SolutionPoint& point) { return point.parameter; });
      const double part = a.parameter / (a.parameter - b.parameter);
      list.push_back(at ? at->u : Vector(a.u + part * (b.u - a.u)));
    }
  }

  const System& system_;
  System widened_;
  double length_;  // of the forced motion, m
  System rate_;    // by the widening, in lengths
  SegmentShooting shooting_;
  ZeroProblem problem_;
  ContinuationOptions range_;
};

void add_orbits_over_gap(const System& system, const SegmentOptions& segment,
                         const FinderOptions& options, FoundOrbits& found) {
  const double speed_scale = motion_scale(system).speed;
  const SegmentShooting shooting(system, SegmentLayout::fixed_phase(1), segment);
  int joined = 0;
  for (const Vector& u : GapBranch(system, options, segment).solutions()) {
    const FollowedAnswer answer = followed_orbit(system, shooting.unpack(system, u), segment);
    ++joined;
    if (!answer.orbit) continue;
    const Orbit& orbit = *answer.orbit;
    const bool known = std::any_of(found.orbits.begin(), found.orbits.end(), [&](const Orbit& o) {
      return same_orbit(o, orbit, speed_scale);
    });
    if (options.asks_for(orbit.period, orbit.impacts.size()) && !known)
      found.orbits.push_back(orbit);
  }
  std::sort(found.orbits.begin(), found.orbits.end(), comes_before);
  found.tried += fmt::format(", {} solutions joined to the response without contacts", joined);
}

}  // namespace

FoundOrbits search_orbits(const System& system, const std::optional<State>& start,
                          const FinderOptions& options) {
  FoundOrbits found = find_orbits(system, start, options);
  if (!system.has_compliant_stop() || !options.from_closed_form || options.period != 1)
    return found;
  if (system.modes() > kMostGapModes) {
    found.notes.push_back(fmt::format(
        "with more than {} modes no orbits are sought over the gaps of the stops", kMostGapModes));
    return found;
  }
  SegmentOptions segment;
  segment.max_impacts = options.max_impacts;
  segment.stop = options.stop;
  const State at_rest{Vector::Zero(system.modes()), Vector::Zero(system.modes())};
  segment.closure_speed =
      options.closure_speed.value_or(default_closure_speed(system, start.value_or(at_rest)));
  add_orbits_over_gap(system, segment, options, found);
  return found;
}

}  // namespace graze
