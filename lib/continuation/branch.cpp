#include "graze/continuation/branch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/continuation/critical.hpp"
#include "graze/continuation/locate.hpp"

namespace graze {
namespace {

// Growth of the step after an easy one, and the turn (as a part of the largest) it aims at.
constexpr double kGrowth = 1.5;
constexpr double kAimedTurn = 0.5;
// Steps up to this many times the last one are predicted from the last two points; they grow by
// kGrowth at most.
constexpr double kFarthest = 2.0;
// A branch closes only after it has been this far from its start, well beyond kOnePoint.
constexpr double kAway = 1e-5;
// Newton's contraction asked of a step, and of the first step on the way back from its end. Where
// the step crossed to a parallel branch, the way back contracts by 1/2 at best: its prediction lies
// beyond the branch it is on, and Newton's step leads to that one.
constexpr double kContraction = 0.25;

void turn_round(BranchPoint& point) {
  point.tangent *= -1.0;
  point.orientation *= -1;
}

double angle(const Vector& a, const Vector& b) {
  return std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0));
}

// Whether the cubic through both ends' parameters and rates turns back between them although the
// rates agree in sign: a pair of folds within one step.
bool hides_folds(double rate_a, double rate_b, double rise, double length) {
  if (rate_a * rate_b <= 0.0) return false;
  // Derivative of the Hermite cubic on [0, 1]: p0 + 2 p1 t + 3 p2 t^2.
  const double m0 = rate_a * length, m1 = rate_b * length;
  const double p1 = 3.0 * rise - 2.0 * m0 - m1, p2 = m0 + m1 - 2.0 * rise;
  if (p2 == 0.0) return false;
  const double lowest = -p1 / (3.0 * p2);
  if (!(lowest > 0.0 && lowest < 1.0)) return false;
  const double value = m0 + 2.0 * p1 * lowest + 3.0 * p2 * lowest * lowest;
  return value * rate_a < 0.0;
}

class Tracer {
 public:
  Tracer(const ZeroProblem& problem, const ContinuationOptions& options)
      : problem_(problem), options_(options), corrector_(problem, options) {}

  Branch trace(const BranchPoint& from, Directions directions) {
    BranchPoint start = from;
    if (problem_.multipliers && start.multipliers.empty())
      start.multipliers = problem_.multipliers(start.u, start.parameter, ErrorBounds::kGiven);
    Branch branch = follow(start, 1.0);
    if (branch.closed())
      branch.ends[0] = BranchEnd::kClosed;
    else if (directions == Directions::kBoth)
      branch = join(follow(start, -1.0), branch);
    add_critical_points(branch, problem_, corrector_, options_.stop);
    branch.evaluations = corrector_.evaluations();
    return branch;
  }

 private:
  Branch follow(const BranchPoint& start, double sign) {
    Branch branch;
    branch.points.push_back(start);
    if (sign < 0.0) turn_round(branch.points.back());
    left_start_ = false;
    double h = 0.1 * longest_step(branch.points.back());
    while (true) {
      const StopReason stop = options_.stop.reason();
      if (stop != StopReason::kNone)
        return ended(std::move(branch),
                     stop == StopReason::kOutOfTime ? BranchEnd::kOutOfTime : BranchEnd::kStopped);
      if (static_cast<int>(branch.points.size()) > options_.max_points)
        return ended(std::move(branch), BranchEnd::kStepLimit);
      const BranchPoint here = branch.points.back();
      if (leaves(here)) return ended(std::move(branch), BranchEnd::kParameterLimit);
      h = std::min(h, longest_step(here));
      std::optional<BranchPoint> next;
      double turn = 0.0;
      const BranchPoint* before =
          branch.points.size() > 1 ? &branch.points[branch.points.size() - 2] : nullptr;
      while (!(next = step(before, here, h, &turn))) {
        ++branch.rejected;
        h *= 0.5;
        // Below this the two ends of a step are one point in double precision.
        if (h >=
            1e3 * std::numeric_limits<double>::epsilon() * (1.0 + corrector_.pack(here).norm()))
          continue;
        for (const double part : {1.0, 3.0, 10.0, 30.0, 100.0}) {
          if (next) break;
          h = part * kShortest * (1.0 + corrector_.pack(here).norm());
          next = beyond_crossing(branch, h);
        }
        stuck_ = corrector_.pack(here);
        if (!next) return ended(std::move(branch), BranchEnd::kNotConverged);
        break;
      }
      const BranchPoint from = branch.points.back();
      if (advance(branch, *next)) return branch;
      if (options_.proceed && !options_.proceed(from, branch.points.back()))
        return ended(std::move(branch), BranchEnd::kHalted);
      h *= std::clamp(kAimedTurn * options_.max_turn / std::max(turn, 1e-12), 0.5, kGrowth);
    }
  }

  static Branch ended(Branch branch, BranchEnd end) {
    branch.ends[1] = end;
    return branch;
  }

  // Appends a step's end, or what comes before it: the limit, the start of a closed branch. True
  // when that ends the branch.
  bool advance(Branch& branch, const BranchPoint& next) {
    const BranchPoint here = branch.points.back();
    if (closes(branch, here, next)) {
      add(branch, here, closing_point(branch, here));
      branch.ends[1] = BranchEnd::kClosed;
      return true;
    }
    // A fold beyond the limit means that the branch left the range before it.
    const std::optional<BranchPoint> fold = fold_between(here, next);
    const bool fold_outside = fold && outside(fold->parameter);
    if (!outside(next.parameter) && !fold_outside) {
      add(branch, here, next);
      return false;
    }
    const BranchPoint& beyond = fold_outside ? *fold : next;
    const double limit = limit_towards(beyond.parameter - here.parameter);
    const auto crossing =
        between(here, beyond, [&](const BranchPoint& p) { return p.parameter - limit; });
    branch.ends[1] = crossing ? BranchEnd::kParameterLimit : BranchEnd::kNotConverged;
    if (crossing) add(branch, here, on_limit(*crossing, limit).value_or(*crossing));
    return true;
  }

  // The solution whose parameter is the limit to the last bit, near a point at or before it.
  std::optional<BranchPoint> on_limit(const BranchPoint& near, double limit) {
    Vector x = corrector_.pack(near);
    const Eigen::Index last = x.size() - 1;
    const double rate = near.tangent[last];
    if (rate != 0.0) x += (limit / corrector_.range() - x[last]) / rate * near.tangent;
    x[last] = limit / corrector_.range();
    std::optional<BranchPoint> point = corrector_.at_parameter(x);
    if (!point) return {};
    point->parameter = limit;
    if (point->tangent.dot(near.tangent) < 0.0) turn_round(*point);
    return point;
  }

  double limit_towards(double direction) const {
    return direction > 0.0 ? std::max(options_.from, options_.to)
                           : std::min(options_.from, options_.to);
  }

  // At a limit and on the way out.
  bool leaves(const BranchPoint& here) const {
    const double rate = here.tangent[here.tangent.size() - 1];
    return rate != 0.0 && here.parameter == limit_towards(rate);
  }

  void add(Branch& branch, const BranchPoint& here, const BranchPoint& next) {
    if (const auto fold = fold_between(here, next))
      branch.critical.push_back({CriticalKind::kFold, *fold, branch.points.size() - 1, {}});
    branch.points.push_back(next);
    if (problem_.multipliers)
      branch.points.back().multipliers =
          problem_.multipliers(next.u, next.parameter, ErrorBounds::kGiven);
  }

  std::optional<BranchPoint> fold_between(const BranchPoint& a, const BranchPoint& b) {
    // Where a branch leaves another one its parameter may stand still, but it does not turn back.
    if (a.orientation == 0) return {};
    const auto rate = [](const BranchPoint& p) { return p.tangent[p.tangent.size() - 1]; };
    if (rate(a) * rate(b) >= 0.0) return {};
    return between(a, b, rate);
  }

  // What the branch is expected to bend by, at right angles to the tangent, over a step of length
  // h: the cubic through the last two points and their tangents.
  Vector bend(const BranchPoint* before, const BranchPoint& here, double h) const {
    const Vector x = corrector_.pack(here);
    Vector bent = Vector::Zero(x.size());
    if (before == nullptr) return bent;
    const Vector chord = x - corrector_.pack(*before);
    const double length = chord.norm(), part = h / length;
    // Far beyond the two points their cubic says nothing.
    if (!(part <= kFarthest)) return bent;
    bent = part * part * (length * (before->tangent + 2.0 * here.tangent) - 3.0 * chord) +
           part * part * part * (length * (before->tangent + here.tangent) - 2.0 * chord);
    return bent - bent.dot(here.tangent) * here.tangent;
  }

  // One step of length h, accepted only where it stays on this branch. A branch point may be passed
  // by a step that is as long as `passing`.
  std::optional<BranchPoint> step(const BranchPoint* before, const BranchPoint& here, double h,
                                  double* turn, double passing = 0.0) {
    const Vector x = corrector_.pack(here);
    const Vector ahead = x + h * here.tangent, guess = ahead + bend(before, here, h);
    const double predicted = ahead[x.size() - 1] * corrector_.range();
    // Beyond the limit the equations may not exist: a step that would pass it ends there.
    std::optional<BranchPoint> next =
        outside(predicted) ? on_limit(here, limit_towards(predicted - here.parameter))
                           : corrector_.on_hyperplane(guess, here.tangent, kContraction);
    if (!next) return {};
    const Vector chord = corrector_.pack(*next) - x;
    *turn = angle(next->tangent, here.tangent);
    if (*turn > options_.max_turn) return {};
    if (!leads_back(x, *next, chord)) return {};
    // Two sheets of one fold run opposite ways. At a branch point the orientation does change; a
    // step as short as this has nowhere to jump to.
    if (next->orientation * here.orientation < 0 &&
        chord.norm() > std::max(passing, kShortest * (1.0 + x.norm())))
      return {};
    const Eigen::Index last = x.size() - 1;
    if (hides_folds(here.tangent[last], next->tangent[last], chord[last], chord.norm())) return {};
    return next;
  }

  // Points next to a branch point are badly determined along the branch that crosses, and from one
  // of them no step may lead on. Goes back half of `reach`, drops the points in between, and takes
  // a step of nearly all of it. Nothing where that does not help either.
  std::optional<BranchPoint> beyond_crossing(Branch& branch, double reach) {
    const Vector x = corrector_.pack(branch.points.back());
    if (stuck_ && (*stuck_ - x).norm() <= reach) return {};
    const auto distance = [&](const BranchPoint& p) { return (corrector_.pack(p) - x).norm(); };
    std::size_t keep = branch.points.size();
    while (keep > 0 && distance(branch.points[keep - 1]) < 0.5 * reach) --keep;
    if (keep < 2) return {};
    BranchPoint base = branch.points[keep - 1];
    const BranchPoint* before = &branch.points[keep - 2];
    const double back = (x - corrector_.pack(base)).dot(base.tangent) - 0.5 * reach;
    if (back > 0.0) {
      const std::optional<BranchPoint> nearer = corrector_.on_hyperplane(
          corrector_.pack(base) + back * base.tangent + bend(before, base, back), base.tangent);
      if (!nearer || nearer->orientation != base.orientation) return {};
      before = &branch.points[keep - 1];
      base = *nearer;
    }
    double turn = 0.0;
    std::optional<BranchPoint> next = step(before, base, 0.9 * reach, &turn, reach);
    if (!next) return {};
    branch.points.resize(keep);
    const auto is_dropped = [&](const CriticalPoint& c) { return c.after + 1 >= keep; };
    branch.critical.erase(
        std::remove_if(branch.critical.begin(), branch.critical.end(), is_dropped),
        branch.critical.end());
    if (back > 0.0) add(branch, branch.points.back(), base);
    return next;
  }

  // Whether the tangent at a step's end predicts where the step came from.
  bool leads_back(const Vector& x, const BranchPoint& next, const Vector& chord) {
    const Vector guess = x + chord - chord.dot(next.tangent) * next.tangent;
    const double error = (guess - x).norm();
    // A prediction this good cannot be told from its correction.
    if (error <= kOnePoint) return true;
    const std::optional<Vector> back = corrector_.newton_step(guess, next.tangent);
    return back && (*back - x).norm() <= kContraction * error;
  }

  double longest_step(const BranchPoint& here) const {
    const Eigen::Index n = here.u.size();
    const double max_step = options_.max_step > 0.0 ? options_.max_step : corrector_.range() / 50.0;
    const double along = std::abs(here.tangent[n]) * corrector_.range();
    const double moved = here.tangent.head(n).norm();
    const double max_distance = options_.max_distance * (1.0 + here.u.norm());
    return std::min(max_step / std::max(along, 1e-3 * max_step),
                    max_distance / std::max(moved, 1e-3 * max_distance));
  }

  bool outside(double parameter) const {
    return parameter < std::min(options_.from, options_.to) ||
           parameter > std::max(options_.from, options_.to);
  }

  BranchPoint closing_point(const Branch& branch, const BranchPoint& here) const {
    BranchPoint start = branch.points.front();
    // The same point, with angles as the branch has counted them.
    const Vector x = corrector_.pack(here);
    start.u = (x + corrector_.difference(corrector_.pack(start), x)).head(start.u.size());
    return start;
  }

  bool closes(const Branch& branch, const BranchPoint& here, const BranchPoint& next) {
    const BranchPoint& start = branch.points.front();
    const double away = corrector_.difference(corrector_.pack(here), corrector_.pack(start)).norm();
    left_start_ = left_start_ || away > kAway;
    return left_start_ && lies_between(corrector_, here, next, start, options_.max_turn) &&
           start.tangent.dot(here.tangent) > 0.0;
  }

  std::optional<BranchPoint> between(const BranchPoint& a, const BranchPoint& b,
                                     const std::function<double(const BranchPoint&)>& test) {
    return locate(corrector_, a, b, test);
  }

  Branch join(const Branch& backward, const Branch& forward) {
    Branch branch;
    branch.ends = {backward.ends[1], forward.ends[1]};
    branch.rejected = backward.rejected + forward.rejected;
    for (auto p = backward.points.rbegin(); p != backward.points.rend(); ++p) {
      branch.points.push_back(*p);
      turn_round(branch.points.back());
    }
    for (auto c = backward.critical.rbegin(); c != backward.critical.rend(); ++c) {
      branch.critical.push_back(*c);
      branch.critical.back().after = backward.points.size() - 2 - c->after;
      turn_round(branch.critical.back().point);
    }
    for (const CriticalPoint& c : forward.critical) {
      branch.critical.push_back(c);
      branch.critical.back().after += backward.points.size() - 1;
    }
    branch.points.insert(branch.points.end(), forward.points.begin() + 1, forward.points.end());
    return branch;
  }

  const ZeroProblem& problem_;
  const ContinuationOptions& options_;
  Corrector corrector_;
  std::optional<Vector> stuck_;  // where no step led on
  bool left_start_ = false;      // the branch has been further from its start than kAway
};

}  // namespace

const char* label_of(CriticalKind kind) {
  switch (kind) {
    case CriticalKind::kFold:
      return "LP";
    case CriticalKind::kPeriodDoubling:
      return "PD";
    case CriticalKind::kTorus:
      return "NS";
    case CriticalKind::kBranchPoint:
      break;
  }
  return "BP";
}

std::vector<CriticalPoint> Branch::critical_of(CriticalKind kind) const {
  std::vector<CriticalPoint> list;
  for (const CriticalPoint& point : critical)
    if (point.kind == kind) list.push_back(point);
  return list;
}

std::optional<BranchPoint> solve_at(const ZeroProblem& problem, const ContinuationOptions& options,
                                    const Vector& u, double parameter) {
  Corrector corrector(problem, options);
  Vector x(u.size() + 1);
  x << u, parameter / corrector.range();
  std::optional<BranchPoint> point = corrector.at_parameter(x);
  if (point) point->parameter = parameter;
  return point;
}

Branch trace_branch(const ZeroProblem& problem, const ContinuationOptions& options,
                    const BranchPoint& start, Directions directions) {
  return Tracer(problem, options).trace(start, directions);
}

std::optional<BranchPoint> locate(const ZeroProblem& problem, const ContinuationOptions& options,
                                  const BranchPoint& a, const BranchPoint& b,
                                  const std::function<double(const BranchPoint&)>& test) {
  Corrector corrector(problem, options);
  return locate(corrector, a, b, test);
}

bool crosses_at(const ZeroProblem& problem, const ContinuationOptions& options,
                const Branch& branch, const BranchPoint& point) {
  const Corrector corrector(problem, options);
  const Vector x = corrector.pack(point);
  return std::any_of(branch.critical.begin(), branch.critical.end(),
                     [&](const CriticalPoint& critical) {
                       return critical.kind == CriticalKind::kBranchPoint &&
                              corrector.difference(corrector.pack(critical.point), x).norm() <=
                                  kOneCrossing * (1.0 + x.norm());
                     });
}

bool lies_on(const ZeroProblem& problem, const ContinuationOptions& options, const Branch& branch,
             const BranchPoint& point) {
  Corrector corrector(problem, options);
  for (std::size_t i = 0; i + 1 < branch.points.size(); ++i)
    if (lies_between(corrector, branch.points[i], branch.points[i + 1], point, options.max_turn))
      return true;
  return false;
}

}  // namespace graze
