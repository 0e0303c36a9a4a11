#include "graze/bifurcation/release_grazing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "graze/bifurcation/grazing_value.hpp"

namespace graze {
namespace {

// An approach nearer than this part of a length touches: a trace that comes to its end there is
// within its shortest step, some 1e-12, of the grazing.
constexpr double kTouches = 1e-9;
// An impact this slow, of a speed, at a point that was bisected to is one that vanishes there.
constexpr double kStill = 1e-5;
// Where an impact is this slow, of a speed, the trace ends: its square is a thousand times what
// residuals are solved to.
constexpr double kSlow = 1e-4;
// Newton's method still finds solutions with an impact at this speed, a speed known to some 1e-12
// of its own. The five of `grazing_value` with up to twenty times that, at some 1e-1 of where
// speeds begin to bend, miss their zero by some 1e-5 of the nearest one's distance from it.
constexpr double kReliable = 7e-5;
// Speeds of the solutions asked for, of kReliable: each doubles where speeds go with the distance
// from the grazing; where they go with its root more of them are needed.
constexpr std::array<double, 9> kAsked = {1.05, 2.2, 4.7, 10.0, 21.0, 47.0, 100.0, 210.0, 470.0};
// Two steps from a residual of 1e-11 leave rounding.
constexpr int kPolishingSteps = 2;
// Where on the other side an orbit without the impact is looked for, of the range.
constexpr double kBeside = 1e-5;

double length_unit(const PassageEquations& equations, const BranchPoint& at) {
  return motion_scale(*equations.system_at(at.parameter)).length;
}

double speed_unit(const PassageEquations& equations, const BranchPoint& at) {
  return length_unit(equations, at) * equations.system_at(at.parameter)->forcing()->frequency;
}

// The orbit that is left where the impact vanishes: it may lie on either side.
std::optional<BranchPoint> without_impact(const PassageEquations& equations,
                                          const ContinuationOptions& options, const BranchPoint& at,
                                          double grazing) {
  const std::optional<ReleaseReturn> here = equations.follow(at);
  if (!here) return {};
  const double beside = kBeside * std::abs(options.to - options.from);
  for (const double side : {1.0, -1.0}) {
    std::optional<BranchPoint> other =
        solve_at(equations.problem(), options, at.u, grazing + side * beside);
    if (!other) continue;
    const std::optional<ReleaseReturn> there = equations.follow(*other);
    if (there && there->returns && there->holds == here->holds &&
        there->itinerary.events.size() < here->itinerary.events.size())
      return other;
  }
  return {};
}

// The same solution to the last digits: what is left of its residual shifts an approach, and the
// slower an impact the more of its speed that is.
BranchPoint polished(Corrector& corrector, const BranchPoint& point) {
  BranchPoint result = point;
  const Eigen::Index n = point.u.size();
  for (int step = 0; step < kPolishingSteps; ++step) {
    const std::optional<Vector> x = corrector.newton_step(corrector.pack(result), point.tangent);
    if (!x) return point;
    result.u = x->head(n);
    result.parameter = (*x)[n] * corrector.range();
  }
  return result;
}

struct SlowImpact {
  const BranchPoint& solution;
  double speed = 0.0;  // m/s
};

// Solutions at the speeds asked for, beside `near`, in which the impact is slower than in `far`;
// the branch runs along `direction` there.
std::vector<NearGrazing> impacts_near(const PassageEquations& equations, Corrector& corrector,
                                      const SlowImpact& far, const SlowImpact& near,
                                      const Vector& direction) {
  const std::optional<ReleaseReturn> now = equations.follow(near.solution);
  if (!now) return {};
  const double unit = kReliable * speed_unit(equations, near.solution);
  const double length = corrector.chord(near.solution, far.solution).dot(direction);
  const double rate = length / (far.speed - near.speed);
  std::vector<NearGrazing> list;
  BranchPoint last = near.solution;
  last.tangent = direction * (length < 0.0 ? -1.0 : 1.0);
  double reached = near.speed;  // as if speeds went linearly
  for (const double asked : kAsked) {
    const double ahead = std::abs(rate) * (asked * unit - reached);
    std::optional<BranchPoint> point =
        corrector.on_hyperplane(corrector.pack(last) + ahead * last.tangent, last.tangent);
    if (!point) break;
    *point = polished(corrector, *point);
    const std::optional<ReleaseReturn> back = equations.follow(*point);
    if (!back || back->itinerary.events != now->itinerary.events) break;
    list.insert(list.begin(), {point->parameter, back->itinerary.slowest});
    last = std::move(*point);
    reached = asked * unit;
  }
  return list;
}

}  // namespace

bool touches(const PassageEquations& equations, const BranchPoint& at) {
  const std::optional<ReleaseReturn> here = equations.follow(at, true);
  return here && here->passage.clearance() &&
         *here->passage.clearance() <= kTouches * length_unit(equations, at);
}

ReleaseTip grazing_at(const PassageEquations& equations, Corrector& corrector,
                      const std::vector<BranchPoint>& reached, bool is_lost) {
  const BranchPoint& at = reached.back();
  const std::optional<ReleaseReturn> here = equations.follow(at);
  if (!here) return {};
  const double unit = speed_unit(equations, at);
  const bool by_speed = is_lost || here->itinerary.slowest <= kStill * unit;
  if (!by_speed && !touches(equations, at)) return {};
  ReleaseTip tip{OrbitBranchEnd::kGrazing, at, by_speed, false, at.parameter, {}};
  // Where the motion does not feel the impact its speed goes as the root of the distance: what is
  // left of that is nothing.
  if (by_speed && !equations.see_impacts()) return tip;
  std::vector<NearGrazing> near, solved;
  for (auto point = reached.rbegin(); point != reached.rend(); ++point) {
    const std::optional<ReleaseReturn> back = equations.follow(*point, !by_speed);
    if (!back) return {};
    if (by_speed || back->passage.clearance())
      near.insert(near.begin(), {point->parameter,
                                 by_speed ? back->itinerary.slowest : *back->passage.clearance()});
    if (!by_speed ||
        !(back->itinerary.slowest > std::max(kReliable * unit, 2.0 * here->itinerary.slowest)))
      continue;
    solved = impacts_near(equations, corrector, {*point, back->itinerary.slowest},
                          {at, here->itinerary.slowest}, corrector.chord(at, *point).normalized());
    break;
  }
  std::optional<double> value;
  if (by_speed) value = grazing_value(solved, kReliable * unit);
  // As near as solutions were met, if others are not to be had.
  if (!value) value = grazing_value(near, by_speed ? 0.0 : kTouches * length_unit(equations, at));
  tip.value = value.value_or(at.parameter);
  return tip;
}

ReleaseTip grazing_ahead(const PassageEquations& equations, Corrector& corrector,
                         const ContinuationOptions& options, const BranchPoint& a,
                         const BranchPoint& b) {
  const std::optional<ReleaseReturn> before = equations.follow(a), now = equations.follow(b);
  if (!before || !now || !now->returns || now->holds != before->holds) return {};
  const double unit = speed_unit(equations, b);
  if (!(now->itinerary.slowest <= kSlow * unit &&
        now->itinerary.slowest < before->itinerary.slowest))
    return {};
  const std::vector<NearGrazing> near = impacts_near(
      equations, corrector, {a, before->itinerary.slowest}, {b, now->itinerary.slowest}, b.tangent);
  const std::optional<double> value = grazing_value(near, kReliable * unit);
  if (!value) return {};
  ReleaseTip tip{OrbitBranchEnd::kGrazing, b, true, false, *value, {}};
  tip.beyond = without_impact(equations, options, b, *value);
  return tip;
}

}  // namespace graze
