#include "graze/motion/detail/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/stop_scope.hpp"
#include "graze/flow/exact/detail/first_zero.hpp"

namespace graze {
namespace {

// Whether the gap rises at s; where its rate is lost in rounding, its acceleration decides.
bool rises(const ArcCurve<double>& curve, double s) {
  const CurvePoint<double> rate = curve.at(s, 1);
  return std::abs(rate.value) > rate.noise ? rate.value > 0.0 : rate.slope > 0.0;
}

// Until when, from s on, the gap is certain to stay above a level: steps as in first_zero.hpp,
// while they are as long as one that would pass an extremum.
double stays_above(const ArcCurve<double>& curve, double level, double s, int& evaluations) {
  double longest = 0.0;
  while (s <= curve.window() && evaluations < kMostSearchEvaluations) {
    if (StopScope::is_over()) break;
    const CurvePoint<double> point = curve.at(s, 0, Reach::kStep);
    ++evaluations;
    const double clear = point.value - point.noise - level;
    if (!(clear > 0.0)) break;
    const double step = first_zero_detail::clear_step(point, clear);
    // Steps shrink where the gap comes down to the level.
    if (!(s + step > s) || 4.0 * step < longest) break;
    s += step;
    longest = std::max(longest, step);
  }
  return s;
}

// The next extremum of the gap after s: a maximum where the gap rises at s, else a minimum. Its
// exact place is computed only for a minimum that may lie below the level.
struct Extremum {
  FirstZero<double> place;
  bool exact = false;
  double beyond = 0.0;  // past the extremum, and before the next
};

Extremum next_extremum(const ArcCurve<double>& curve, double s, bool rising, double level) {
  using namespace first_zero_detail;
  const auto sample = [&](double at) {
    CurvePoint<double> point = curve.at(at, 1, Reach::kStep);
    if (!rising) point.turn_round();
    return point;
  };
  const Descent<double> near = approach_descent(sample, s, curve.window(), StopScope::current());
  Extremum found{near.zero, false, 0.0};
  if (near.zero.kind != ZeroKind::kCrossing) return found;
  // The rate falls up to here, and passes zero on the way.
  const double rate = std::max(near.point.value, 0.0);
  found.beyond = near.zero.s + 2.0 * (rate / -near.point.slope);
  if (found.beyond <= curve.window() && found.beyond > s) {
    if (rising) return found;
    const CurvePoint<double> gap = curve.at(near.zero.s, 0);
    ++found.place.evaluations;
    if (gap.value - gap.noise - rate * (found.beyond - near.zero.s) > level) return found;
  }
  found.place = finish_descent(sample, near, curve.window());
  found.exact = true;
  // The rate leaves its zero at least as fast as a parabola.
  found.beyond = found.place.s + 2.0 * (-found.place.slope / near.point.bound);
  return found;
}

// Where the search for extrema begins, after a departure of this multiplicity; nullopt when the gap
// rises for ever.
struct SearchStart {
  double s = 0.0;
  bool rising = false;
};

std::optional<SearchStart> search_start(const ArcCurve<double>& curve, int multiplicity) {
  if (multiplicity > 0) {
    const CurvePoint<double> start = curve.at(0.0, multiplicity - 1);
    if (start.slope > 0.0) {
      if (start.bound == 0.0) return {};
      return SearchStart{multiplicity * (start.slope / start.bound), true};
    }
  }
  return SearchStart{0.0, rises(curve, 0.0)};
}

// Visits the interior minima below a level, one after the other; `visit` returns the level from
// there on. Returns how far along the window the search came, or nullopt when it reached the end.
template <class Visit>
std::optional<double> visit_minima(const ArcCurve<double>& curve, int multiplicity, double below,
                                   const Visit& visit) {
  const std::optional<SearchStart> start = search_start(curve, multiplicity);
  if (!start) return {};
  double s = start->s;
  bool rising = start->rising;
  int evaluations = 0;
  while (evaluations < kMostSearchEvaluations) {
    if (std::isfinite(below)) {
      const double clear = stays_above(curve, below, s, evaluations);
      if (!(clear <= curve.window())) return {};
      if (clear > s) rising = rises(curve, clear);
      s = clear;
    }
    const Extremum extremum = next_extremum(curve, s, rising, below);
    const FirstZero<double>& place = extremum.place;
    evaluations += place.evaluations;
    if (StopScope::is_over()) break;
    if (place.kind == ZeroKind::kCrossing) {
      if (!rising && extremum.exact) {
        const double gap = curve.at(place.s, 0).value;
        if (gap < below) below = visit(GapMinimum{place.s, gap});
      }
      s = extremum.beyond;
      rising = !rising;
    } else if (place.kind == ZeroKind::kTouch) {
      // An inflection within rounding: skip the width over which the rate stays within its
      // rounding.
      const CurvePoint<double> point = curve.at(place.s, 1);
      if (point.bound == 0.0) return {};  // the gap does not change
      const double width = std::sqrt(2.0 * point.noise / point.bound);
      if (!(place.s + width > s)) break;
      s = place.s + width;
      rising = rises(curve, s);
    } else if (place.kind == ZeroKind::kNone) {
      return {};
    } else {
      break;
    }
  }
  return s;
}

}  // namespace

std::optional<GapMinimum> lowest_minimum(const ArcCurve<double>& curve, int multiplicity,
                                         double below) {
  std::optional<GapMinimum> lowest;
  const std::optional<double> reached =
      visit_minima(curve, multiplicity, below, [&](const GapMinimum& minimum) {
        lowest = minimum;
        return minimum.gap;
      });
  // Unfinished: nothing is known of the rest of the window.
  if (reached) return GapMinimum{*reached, -std::numeric_limits<double>::infinity()};
  return lowest;
}

std::vector<GapMinimum> minima_below(const ArcCurve<double>& curve, int multiplicity,
                                     double level) {
  std::vector<GapMinimum> minima;
  const std::optional<double> reached =
      visit_minima(curve, multiplicity, level, [&](const GapMinimum& found) {
        minima.push_back(found);
        return level;
      });
  if (reached) minima.push_back({*reached, -std::numeric_limits<double>::infinity()});
  return minima;
}

std::optional<double> smallest_minimum(const ArcCurve<double>& curve, int multiplicity) {
  const std::optional<GapMinimum> lowest = lowest_minimum(curve, multiplicity);
  if (!lowest) return {};
  return lowest->gap;
}

LastingClearance::LastingClearance(const System& system, const ExactFlow<double>& flow)
    : omega_(system.omega), steady_{Vector(system.modes()), Vector(system.modes())} {
  if (!flow.forced() || !system.has_closed_forms() || !system.frictions.empty()) return;
  const double theta = flow.phase({});
  const double c = std::cos(theta), n = std::sin(theta), frequency = flow.frequency();
  for (int j = 0; j < system.modes(); ++j) {
    const ModeFlow<double>& mode = flow.mode(j);
    if (mode.kind == ModeKind::kFromRest || !(mode.omega > 0.0) || !(mode.delta > 0.0) ||
        mode.load != 0.0)
      return;
    steady_.q[j] = mode.offset + mode.forced.re * c - mode.forced.im * n;
    steady_.qdot[j] = -frequency * (mode.forced.re * n + mode.forced.im * c);
  }
  for (const Stop& stop : system.stops) {
    double re = 0.0, im = 0.0, rest = 0.0, size = std::abs(stop.gap);
    for (int j = 0; j < system.modes(); ++j) {
      const ModeFlow<double>& mode = flow.mode(j);
      const double b = stop.row[j];
      re += b * mode.forced.re;
      im += b * mode.forced.im;
      rest += b * mode.offset;
      size += std::abs(b) *
              (std::abs(mode.forced.re) + std::abs(mode.forced.im) + std::abs(mode.offset));
    }
    rooms_.push_back({stop.row.cwiseAbs(), stop.gap - rest - std::hypot(re, im), size});
  }
  may_be_ = true;
}

bool LastingClearance::is_sure(const Vector& q, const Vector& qdot) const {
  if (!may_be_) return false;
  const Eigen::Index n = omega_.size();
  // The sums round once a term.
  const double roundings =
      4.0 * static_cast<double>(n + 2) * std::numeric_limits<double>::epsilon();
  return std::all_of(rooms_.begin(), rooms_.end(), [&](const Room& room) {
    double swing = 0.0, size = room.size;
    for (Eigen::Index j = 0; j < n && swing < room.left; ++j) {
      const double free = q[j] - steady_.q[j], rate = (qdot[j] - steady_.qdot[j]) / omega_[j];
      swing += room.weights[j] * std::sqrt(free * free + rate * rate);
      size += room.weights[j] * std::abs(q[j]);
    }
    return swing + roundings * size < room.left;
  });
}

}  // namespace graze
