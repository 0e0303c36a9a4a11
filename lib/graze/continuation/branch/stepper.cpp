#include "graze/continuation/branch/detail/stepper.hpp"

#include <algorithm>
#include <cmath>

#include "graze/continuation/branch/detail/locate.hpp"

namespace graze {
namespace {

// Steps up to this many times the last one are predicted from the last two points.
constexpr double kFarthest = 2.0;
// Required contraction of Newton's method in a step, and of the first step on the way back from its
// end. If the step has crossed to a parallel branch, the way back contracts by 1/2 at best: its
// prediction lies beyond that branch, and Newton's step leads to it.
constexpr double kContraction = 0.25;

// A pair of folds that moves the parameter by less than this part of its range is rounding, as
// where the parameter is constant along the branch, or is negligible.
constexpr double kSmallestReturn = 1e-12;

double angle(const Vector& a, const Vector& b) {
  return std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0));
}

// Whether the cubic through both ends' parameters and rates turns back between them although the
// rates agree in sign: a pair of folds within one step.
bool hides_folds(double rate_a, double rate_b, double rise, double length) {
  if (rate_a * rate_b <= 0.0) return false;
  // Derivative of the Hermite cubic on [0, 1]: p0 + 2 p1 t + 3 p2 t^2.
  const double m0 = rate_a * length, m1 = rate_b * length;
  if (std::abs(rise) + std::abs(m0) + std::abs(m1) <= kSmallestReturn) return false;
  const double p1 = 3.0 * rise - 2.0 * m0 - m1, p2 = m0 + m1 - 2.0 * rise;
  if (p2 == 0.0) return false;
  const double lowest = -p1 / (3.0 * p2);
  if (!(lowest > 0.0 && lowest < 1.0)) return false;
  const double value = m0 + 2.0 * p1 * lowest + 3.0 * p2 * lowest * lowest;
  return value * rate_a < 0.0;
}

}  // namespace

double Stepper::longest(const SolutionPoint& here) const {
  const Eigen::Index n = here.u.size();
  const double max_step = options_.max_step > 0.0 ? options_.max_step : corrector_.range() / 50.0;
  const double along = std::abs(here.tangent[n]) * corrector_.range();
  const double moved = here.tangent.head(n).norm();
  const double max_distance = options_.max_distance * (1.0 + here.u.norm());
  return std::min({max_step / std::max(along, 1e-3 * max_step),
                   max_distance / std::max(moved, 1e-3 * max_distance), unknowns_.longest(here)});
}

// The expected deviation from the tangent over a step of length h, orthogonal to the tangent.
Vector Stepper::bend(const SolutionPoint* before, const SolutionPoint& here, double h) const {
  const Vector x = corrector_.pack(here);
  Vector bent = Vector::Zero(x.size());
  if (before == nullptr) return bent;
  const Vector chord = x - corrector_.pack(*before);
  const double length = chord.norm(), part = h / length;
  // Far beyond the two points their cubic is meaningless.
  if (!(part <= kFarthest)) return bent;
  bent = part * part * (length * (before->tangent + 2.0 * here.tangent) - 3.0 * chord) +
         part * part * part * (length * (before->tangent + here.tangent) - 2.0 * chord);
  return bent - bent.dot(here.tangent) * here.tangent;
}

Vector Stepper::prediction(const SolutionPoint* before, const SolutionPoint& here, double h) const {
  return corrector_.pack(here) + h * here.tangent + bend(before, here, h);
}

// Beyond a limit the equations may not exist: a step that would pass one ends on the first.
std::optional<SolutionPoint> Stepper::point_ahead(const SolutionPoint* before,
                                                  const SolutionPoint& here, double h) {
  const double predicted =
      (here.parameter / corrector_.range() + h * here.rate()) * corrector_.range();
  const bool outside = limits_.outside(predicted);
  const double limit = limits_.towards(predicted - here.parameter);
  const double within = outside ? (limit - here.parameter) / (here.rate() * corrector_.range()) : h;
  if (const auto unknown = unknowns_.ahead(here, within))
    return point_on_limit(corrector_, here, *unknown);
  if (outside) return point_on_limit(corrector_, here, limit);
  return corrector_.on_hyperplane(prediction(before, here, h), here.tangent, kContraction);
}

std::optional<SolutionPoint> Stepper::step(const SolutionPoint* before, const SolutionPoint& here,
                                           double h, double& turn, double passing,
                                           WayBack way_back) {
  const Vector x = corrector_.pack(here);
  std::optional<SolutionPoint> next = point_ahead(before, here, h);
  if (!next) return {};
  const Vector chord = corrector_.pack(*next) - x;
  turn = angle(next->tangent, here.tangent);
  if (turn > options_.max_turn) return {};
  if (way_back == WayBack::kJudged && !leads_back(x, *next, chord)) return {};
  // The two sides of one fold have opposite directions. At a branch point the orientation does
  // change; a step this short cannot jump to another branch.
  if (next->orientation * here.orientation < 0 &&
      chord.norm() > std::max(passing, kShortest * (1.0 + x.norm())))
    return {};
  if (hides_folds(here.rate(), next->rate(), chord[chord.size() - 1], chord.norm())) return {};
  if (options_.resolves && !options_.resolves(here, *next)) return {};
  return next;
}

// Whether the tangent at a step's end predicts the start of the step.
bool Stepper::leads_back(const Vector& x, const SolutionPoint& next, const Vector& chord) {
  const Vector guess = x + chord - chord.dot(next.tangent) * next.tangent;
  const double error = (guess - x).norm();
  // A prediction this good needs no correction.
  if (error <= kOnePoint) return true;
  const std::optional<Vector> back = corrector_.newton_step(guess, next.tangent);
  return back && (*back - x).norm() <= kContraction * error;
}

}  // namespace graze
