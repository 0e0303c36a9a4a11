#include "graze/continuation/branch/detail/locate.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <utility>

namespace graze {
namespace {

// Rates this small at both ends of a step are rounding: the parameter is constant along the branch,
// which does not turn back whatever their signs.
constexpr double kUprightRate = 1e-12;

// Whether the branch through `near` leads to near + offset.
bool meets(Corrector& corrector, const SolutionPoint& near, const Vector& offset) {
  const Vector x = corrector.pack(near);
  const auto there =
      corrector.on_hyperplane(x + offset.dot(near.tangent) * near.tangent, near.tangent);
  return there && corrector.difference(corrector.pack(*there), x + offset).norm() < kOnePoint;
}

}  // namespace

double arclength(const Corrector& corrector, const SolutionPoint& a, const SolutionPoint& b) {
  return corrector.chord(a, b).norm() * (1.0 + (b.tangent - a.tangent).squaredNorm() / 24.0);
}

Vector cubic_between(const Corrector& corrector, const SolutionPoint& from, double s,
                     const SolutionPoint& a, const SolutionPoint& b) {
  const Vector x = corrector.pack(from), x_a = corrector.pack(a);
  const Vector chord = corrector.chord(a, b);
  // Components along the normal: from a to b, and from a to the hyperplane.
  const double length = chord.dot(from.tangent);
  const double ahead = s - corrector.difference(x_a, x).dot(from.tangent);
  const double rate_a = a.tangent.dot(from.tangent), rate_b = b.tangent.dot(from.tangent);
  const double part = ahead / length, rest = 1.0 - part;
  const Vector start = x + corrector.difference(x_a, x);
  if (!(rate_a > 0.0 && rate_b > 0.0)) return start + part * chord;
  return start + part * part * (3.0 - 2.0 * part) * chord +
         part * rest * length * (rest / rate_a * a.tangent - part / rate_b * b.tangent);
}

std::optional<SolutionPoint> point_between(Corrector& corrector, const SolutionPoint& from,
                                           double s, const SolutionPoint& a,
                                           const SolutionPoint& b) {
  return corrector.on_hyperplane(cubic_between(corrector, from, s, a, b), from.tangent);
}

std::optional<SolutionPoint> locate(Corrector& corrector, const SolutionPoint& a,
                                    const SolutionPoint& b,
                                    const std::function<double(const SolutionPoint&)>& test) {
  const Vector x = corrector.pack(a);
  const Vector chord = corrector.chord(a, b);
  const double length = chord.dot(a.tangent);
  const double at_a = test(a), at_b = test(b);
  if (at_a == 0.0 || at_b == 0.0) {
    SolutionPoint there = at_a == 0.0 ? a : b;
    there.bracket = bracket_around({there.parameter}, true);
    return there;
  }
  if (!(at_a * at_b < 0.0) || !(length > 0.0)) return {};
  // Of the two neighbouring numbers that enclose the zero, the one where the test is positive.
  std::optional<SolutionPoint> best = at_a > 0.0 ? a : b;
  double smallest = std::max(at_a, at_b);
  // The nearest points known on either side of the zero.
  SolutionPoint low = a, high = b;
  bool failed = false;
  const auto value = [&](double s) {
    auto point = point_between(corrector, a, s, low, high);
    if (!point) point = corrector.on_hyperplane(x + s * a.tangent, a.tangent);
    if (!point) point = corrector.on_hyperplane(x + s / length * chord, a.tangent);
    if (!point) {
      failed = true;
      return 0.0;  // ends the search
    }
    const double v = test(*point);
    if (v >= 0.0 && v <= smallest) {
      smallest = v;
      best = point;
    }
    (v * at_a > 0.0 ? low : high) = std::move(*point);
    return v;
  };
  // To the last bits of x; 100 halvings exhaust them even from afar.
  const double resolution = std::numeric_limits<double>::epsilon() * (1.0 + x.norm());
  const auto settled = [&](double from, double to) { return to - from <= resolution; };
  std::uintmax_t iterations = 100;
  const auto last =
      boost::math::tools::toms748_solve(value, 0.0, length, at_a, at_b, settled, iterations);
  if (failed) return {};
  best->bracket = bracket_around({low.parameter, high.parameter, best->parameter},
                                 smallest == 0.0 || settled(last.first, last.second));
  return best;
}

std::optional<SolutionPoint> fold_between(Corrector& corrector, const SolutionPoint& a,
                                          const SolutionPoint& b) {
  // Where a branch leaves another one its parameter may be stationary, but it does not turn back.
  if (a.orientation * b.orientation == 0 || a.rate() * b.rate() >= 0.0) return {};
  if (std::max(std::abs(a.rate()), std::abs(b.rate())) <= kUprightRate) return {};
  return locate(corrector, a, b, [](const SolutionPoint& p) { return p.rate(); });
}

bool lies_between(Corrector& corrector, const SolutionPoint& a, const SolutionPoint& b,
                  const SolutionPoint& point, double max_turn) {
  const Vector chord = corrector.pack(b) - corrector.pack(a);
  const double length = chord.norm();
  const Vector offset = corrector.chord(a, point);
  // At the ends themselves no correction is needed, and at a limit evaluation may be impossible.
  if (offset.norm() < kOnePoint || (offset - chord).norm() < kOnePoint) return true;
  const double along = offset.dot(chord) / length;
  if (!(along >= 0.0 && along <= length)) return false;
  if ((offset - along * chord / length).norm() > 0.5 * max_turn * length) return false;
  return meets(corrector, a, offset) || meets(corrector, b, offset - chord);
}

}  // namespace graze
