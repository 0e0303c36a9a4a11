#include "graze/continuation/locate.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>

namespace graze {
namespace {

// Whether the branch through `near` leads to near + offset.
bool meets(Corrector& corrector, const BranchPoint& near, const Vector& offset) {
  const Vector x = corrector.pack(near);
  const auto there =
      corrector.on_hyperplane(x + offset.dot(near.tangent) * near.tangent, near.tangent);
  return there && corrector.difference(corrector.pack(*there), x + offset).norm() < kOnePoint;
}

}  // namespace

std::optional<BranchPoint> locate(Corrector& corrector, const BranchPoint& a, const BranchPoint& b,
                                  const std::function<double(const BranchPoint&)>& test) {
  const Vector x = corrector.pack(a);
  const Vector chord = corrector.difference(corrector.pack(b), x);
  const double length = chord.dot(a.tangent);
  const double at_a = test(a), at_b = test(b);
  if (at_a == 0.0) return a;
  if (at_b == 0.0) return b;
  if (!(at_a * at_b < 0.0) || !(length > 0.0)) return {};
  // Of the two last bits that enclose the zero, the one on the side where the test is positive.
  std::optional<BranchPoint> best = at_a > 0.0 ? a : b;
  double smallest = std::max(at_a, at_b);
  bool failed = false;
  const auto value = [&](double s) {
    auto point = corrector.on_hyperplane(x + s * a.tangent, a.tangent);
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
    return v;
  };
  // To the last bits of s; 100 halvings exhaust them even from afar.
  std::uintmax_t iterations = 100;
  boost::math::tools::toms748_solve(value, 0.0, length, at_a, at_b,
                                    boost::math::tools::eps_tolerance<double>(52), iterations);
  return failed ? std::nullopt : best;
}

bool lies_between(Corrector& corrector, const BranchPoint& a, const BranchPoint& b,
                  const BranchPoint& point, double max_turn) {
  const Vector chord = corrector.pack(b) - corrector.pack(a);
  const double length = chord.norm();
  const Vector offset = corrector.difference(corrector.pack(point), corrector.pack(a));
  // At the very ends there is nothing to correct, and at a limit perhaps nothing to evaluate.
  if (offset.norm() < kOnePoint || (offset - chord).norm() < kOnePoint) return true;
  const double along = offset.dot(chord) / length;
  if (!(along >= 0.0 && along <= length)) return false;
  if ((offset - along * chord / length).norm() > 0.5 * max_turn * length) return false;
  return meets(corrector, a, offset) || meets(corrector, b, offset - chord);
}

}  // namespace graze
