#include "graze/continuation/special/detail/circle_crossings.hpp"

#include <algorithm>
#include <cmath>

#include "graze/continuation/branch/detail/locate.hpp"
#include "graze/continuation/special/detail/crossing_tests.hpp"

namespace graze {
namespace {

// The modulus of the j-th multiplier less 1.
double excess(const std::vector<Eigenvalue>& multipliers, std::size_t j) {
  return std::abs(multipliers[j].value) - 1.0;
}

// Numbers of multipliers outside the unit circle by kind.
struct OutsideCount {
  int flipped = 0;  // real, below -1
  int grown = 0;    // real, above 1
  int pairs = 0;    // complex
  bool operator==(const OutsideCount&) const = default;
};

OutsideCount count_outside(const std::vector<Eigenvalue>& multipliers) {
  OutsideCount count;
  for (const Eigenvalue& m : multipliers) {
    if (!(std::abs(m.value) > 1.0)) continue;
    if (m.value.imag() > 0.0) ++count.pairs;
    if (m.value.imag() == 0.0) ++(m.value.real() < 0.0 ? count.flipped : count.grown);
  }
  return count;
}

// Whether these changes are those of one crossing, or of a pair that meets outside the circle and
// separates on the real axis, or the reverse.
bool is_single(int flipped, int grown, int pairs) {
  if (std::abs(flipped) + std::abs(grown) + std::abs(pairs) == 1) return true;
  return (flipped == -2 * pairs && grown == 0 && std::abs(pairs) == 1) ||
         (grown == -2 * pairs && flipped == 0 && std::abs(pairs) == 1);
}

// Crossings in one step are separated down to 2^-30 of it; nearer than that each is still found by
// its own modulus.
constexpr int kMostCrossingHalvings = 30;
// Limit on the divisions of a step: where multipliers jump every part of it would be divided. A
// jump takes two parts a halving, and a dozen crossings as many each; more is noise.
constexpr int kMostDivisions = 1000;
// Next to grazing one large multiplier passes through the whole real line within a step, and all
// others exchange their places in the order where it passes the unit circle, in a very small part
// of the step. The trace is smooth and follows it: on the scale asinh(trace), which counts factors
// of e far out and units near zero, a piece without unseen crossings changes by less than this.
constexpr double kLargestChange = 0.5;
// While the large multiplier is this many times as far out as the sum of all others if on the
// circle, the others do not move, to a part of the inverse: its motion there hides no crossing.
constexpr double kFarOut = 16.0;

double trace_scale(const std::vector<Eigenvalue>& multipliers) {
  double trace = 0.0;
  for (const Eigenvalue& m : multipliers) trace += m.value.real();
  const double most = kFarOut * static_cast<double>(multipliers.size());
  return std::asinh(std::clamp(trace, -most, most));
}

// The part of a piece, whose ends have these values of the scale, after which half of the change
// has happened for a trace with constant rate; not too near to either end.
double halfway(double from, double to) {
  const double start = std::sinh(from), change = std::sinh(to) - start;
  return std::clamp((std::sinh(0.5 * (from + to)) - start) / change, 1.0 / 64.0, 63.0 / 64.0);
}

}  // namespace

void CircleCrossings::add(const SolutionPoint& a, const SolutionPoint& b) {
  divide(a, b, kMostCrossingHalvings);
}

void CircleCrossings::add_undivided(const SolutionPoint& a, const SolutionPoint& b) {
  divide(a, b, 0);
}

std::vector<Eigenvalue> CircleCrossings::multipliers_of(const SolutionPoint& point,
                                                        ErrorBounds errors) const {
  return problem_.multipliers(point.u, point.parameters(), errors);
}

// Divides the piece from a to b until each part holds at most one crossing, and locates that.
// Several crossings may add up to the changes of a single one: the pieces on either side of a
// located crossing are checked again.
void CircleCrossings::divide(const SolutionPoint& a, const SolutionPoint& b, int halvings) {
  if (stop_.requested() || ++divisions_ > kMostDivisions) return;
  const OutsideCount at_a = count_outside(a.multipliers), at_b = count_outside(b.multipliers);
  const double from = trace_scale(a.multipliers), to = trace_scale(b.multipliers);
  const bool runs = std::abs(to - from) > kLargestChange && halvings > 0;
  if (at_a == at_b && !runs) return;
  const double length = corrector_.ahead(a, b);
  const bool single =
      is_single(at_b.flipped - at_a.flipped, at_b.grown - at_a.grown, at_b.pairs - at_a.pairs);
  if (runs || (!single && halvings > 0)) {
    const double part = runs ? halfway(from, to) : 0.5;
    if (const auto middle = known_between(a, part * length, a, b)) {
      divide(a, *middle, halvings - 1);
      divide(*middle, b, halvings - 1);
      return;
    }
  }
  for (std::size_t j = 0; j < a.multipliers.size(); ++j) {
    if (excess(a.multipliers, j) * excess(b.multipliers, j) > 0.0) continue;
    const std::optional<SolutionPoint> found = add_crossing(a, b, j);
    if (!found || halvings == 0) continue;
    const double at = corrector_.ahead(a, *found);
    const double aside = std::ldexp(length, -kMostCrossingHalvings / 2);
    const auto before = at > aside ? known_between(a, at - aside, a, *found) : std::nullopt;
    const auto behind =
        at + aside < length ? known_between(a, at + aside, *found, b) : std::nullopt;
    if (before) divide(a, *before, halvings - 1);
    if (behind) divide(*behind, b, halvings - 1);
    return;
  }
}

// Whether the j-th modulus is known to differ from 1: for multipliers on the circle, as those of a
// structure without damping, its crossings are rounding.
bool CircleCrossings::is_off_circle(const SolutionPoint& point, std::size_t j) const {
  const std::vector<Eigenvalue> multipliers = multipliers_of(point);
  return j < multipliers.size() && std::abs(excess(multipliers, j)) > multipliers[j].error;
}

// Where the j-th modulus passes 1 between a and b; nullopt when it cannot be located.
std::optional<SolutionPoint> CircleCrossings::add_crossing(const SolutionPoint& a,
                                                           const SolutionPoint& b, std::size_t j) {
  const bool leaves = is_off_circle(a, j), arrives = is_off_circle(b, j);
  if (!leaves && !arrives) return {};
  // Two real multipliers that meet on the circle stay on it: moduli do not locate that.
  if (leaves != arrives && (leaves ? a : b).multipliers[j].value.imag() == 0.0)
    return add_meeting(a, b);
  std::optional<SolutionPoint> point = locate(corrector_, a, b, [&](const SolutionPoint& p) {
    const std::vector<Eigenvalue> multipliers = multipliers_of(p, ErrorBounds::kLeftOut);
    return j < multipliers.size() ? excess(multipliers, j) : std::nan("");
  });
  if (!point) return {};
  point->multipliers = multipliers_of(*point);
  if (j >= point->multipliers.size()) return {};
  Eigenvalue critical = point->multipliers[j];
  const bool complex = critical.value.imag() != 0.0;
  // Of a pair the multiplier with the positive imaginary part is stored.
  if (complex && critical.value.imag() < 0.0) critical.value = std::conj(critical.value);
  if (complex || critical.value.real() < 0.0)
    found_.push_back(
        {complex ? CriticalKind::kTorus : CriticalKind::kPeriodDoubling, *point, step_, critical});
  return point;
}

// Where a multiplier is -1, by a function that passes zero there in either case.
std::optional<SolutionPoint> CircleCrossings::add_meeting(const SolutionPoint& a,
                                                          const SolutionPoint& b) {
  std::optional<SolutionPoint> point = locate(corrector_, a, b, [&](const SolutionPoint& p) {
    const CrossingTest flip = crossing_tests(multipliers_of(p, ErrorBounds::kLeftOut))[kFlip];
    return flip.sign * std::exp(flip.log_size);
  });
  if (!point) return {};
  point->multipliers = multipliers_of(*point);
  if (point->multipliers.empty()) return {};
  const auto nearest = nearest_to(point->multipliers, -1.0);
  found_.push_back({CriticalKind::kPeriodDoubling, *point, step_,
                    Eigenvalue{nearest->value.real(), nearest->error}});
  return point;
}

// The point of the branch s ahead of another one, between a and b, with its multipliers; nullopt
// when these cannot be computed.
std::optional<SolutionPoint> CircleCrossings::known_between(const SolutionPoint& from, double s,
                                                            const SolutionPoint& a,
                                                            const SolutionPoint& b) {
  std::optional<SolutionPoint> point = point_between(corrector_, from, s, a, b);
  if (!point) return {};
  point->multipliers = multipliers_of(*point, ErrorBounds::kLeftOut);
  if (point->multipliers.size() != a.multipliers.size()) return {};
  return point;
}

}  // namespace graze
