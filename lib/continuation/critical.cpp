#include "graze/continuation/critical.hpp"

#include <algorithm>
#include <cmath>

#include "graze/continuation/locate.hpp"

namespace graze {
namespace {

// The modulus of the j-th multiplier less 1, and what rounding leaves open of it.
struct Excess {
  double value = 0.0, error = 0.0;
  int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }
};

Excess excess(const std::vector<Eigenvalue>& multipliers, std::size_t j) {
  return {std::abs(multipliers[j].value) - 1.0, multipliers[j].error};
}

std::optional<Eigenvalue> nearest_to_one(const std::vector<Eigenvalue>& multipliers) {
  std::optional<Eigenvalue> nearest;
  for (const Eigenvalue& m : multipliers)
    if (!nearest || std::abs(m.value - 1.0) < std::abs(nearest->value - 1.0)) nearest = m;
  return nearest;
}

class CriticalSearch {
 public:
  CriticalSearch(Branch& branch, const ZeroProblem& problem, Corrector& corrector)
      : branch_(branch), problem_(problem), corrector_(corrector) {}

  void run() {
    if (problem_.multipliers)
      for (CriticalPoint& fold : branch_.critical) {
        fold.point.multipliers = multipliers_of(fold.point);
        fold.multiplier = nearest_to_one(fold.point.multipliers);
      }
    for (std::size_t i = 0; i + 1 < branch_.points.size(); ++i)
      if (branch_.points[i].orientation * branch_.points[i + 1].orientation < 0)
        add_branch_point(i);
    if (problem_.multipliers) add_crossings();
    std::stable_sort(branch_.critical.begin(), branch_.critical.end(),
                     [this](const CriticalPoint& a, const CriticalPoint& b) {
                       return a.after != b.after ? a.after < b.after : along(a) < along(b);
                     });
  }

 private:
  std::vector<Eigenvalue> multipliers_of(const BranchPoint& point) const {
    return problem_.multipliers(point.u, point.parameter);
  }

  double along(const CriticalPoint& critical) const {
    const BranchPoint& from = branch_.points[critical.after];
    return corrector_.difference(corrector_.pack(critical.point), corrector_.pack(from))
        .dot(from.tangent);
  }

  // The tracer passes a branch point with a step so short (1e-6) that the determinant is linear
  // over it, while its ends are far enough for solutions to be well determined; on the branch point
  // itself they are not.
  void add_branch_point(std::size_t i) {
    const BranchPoint &a = branch_.points[i], &b = branch_.points[i + 1];
    const double ratio = corrector_.determinant_ratio(a, b);
    if (!std::isfinite(ratio)) return;
    const double part = 1.0 / (1.0 + ratio);
    const Vector x = corrector_.pack(a);
    const Vector at = x + part * corrector_.difference(corrector_.pack(b), x);
    const Eigen::Index n = a.u.size();
    CriticalPoint found{CriticalKind::kBranchPoint, {}, i, {}};
    found.point = {at.head(n),
                   (1.0 - part) * a.parameter + part * b.parameter,
                   ((1.0 - part) * a.tangent + part * b.tangent).normalized(),
                   std::max(a.residual, b.residual),
                   0,
                   {}};
    if (problem_.multipliers) {
      found.point.multipliers = multipliers_of(found.point);
      found.multiplier = nearest_to_one(found.point.multipliers);
    }
    branch_.critical.push_back(std::move(found));
  }

  void add_crossings() {
    const std::size_t count = branch_.points.front().multipliers.size();
    for (std::size_t j = 0; j < count; ++j) {
      std::size_t last = 0;  // the last point at which the sign was certain
      int sign = 0;
      for (std::size_t i = 0; i < branch_.points.size(); ++i) {
        if (branch_.points[i].multipliers.size() != count) return;
        const int here = sign_at(i, j);
        if (here == 0) continue;
        if (here * sign < 0) add_crossing(last, i, j);
        sign = here;
        last = i;
      }
      for (std::size_t i = 1; i + 2 < branch_.points.size(); ++i)
        if (sign_at(i, j) != 0 && sign_at(i, j) == sign_at(i + 1, j)) add_hidden(i, j);
    }
  }

  int sign_at(std::size_t i, std::size_t j) const {
    return excess(branch_.points[i].multipliers, j).sign();
  }

  // Between the points `from` and `to` the sign changes for certain; in between it is open.
  void add_crossing(std::size_t from, std::size_t to, std::size_t j) {
    for (std::size_t i = from; i < to; ++i) {
      const double a = excess(branch_.points[i].multipliers, j).value;
      const double b = excess(branch_.points[i + 1].multipliers, j).value;
      if (a * b <= 0.0) {
        add_crossing(branch_.points[i], branch_.points[i + 1], i, j);
        return;
      }
    }
  }

  void add_crossing(const BranchPoint& a, const BranchPoint& b, std::size_t after, std::size_t j) {
    std::optional<BranchPoint> point = locate(corrector_, a, b, [&](const BranchPoint& p) {
      const std::vector<Eigenvalue> multipliers = multipliers_of(p);
      return j < multipliers.size() ? excess(multipliers, j).value : std::nan("");
    });
    if (!point) return;
    point->multipliers = multipliers_of(*point);
    if (j >= point->multipliers.size()) return;
    const Eigenvalue& critical = point->multipliers[j];
    const bool complex = critical.value.imag() != 0.0;
    if (!complex && critical.value.real() > 0.0) return;
    // One of a pair is enough: that with the positive imaginary part, which comes second.
    if (complex && critical.value.imag() < 0.0) return;
    branch_.critical.push_back(
        {complex ? CriticalKind::kTorus : CriticalKind::kPeriodDoubling, *point, after, critical});
  }

  // Whether the modulus crosses the circle and comes back between points i and i + 1, as its course
  // outside of them suggests: the lines through the two points on either side meet, where two
  // multipliers change places or a smooth course bends, beyond the circle. If what is found there
  // does not cross, the parabola through it is asked once more.
  void add_hidden(std::size_t i, std::size_t j) {
    const auto value = [&](std::size_t k) {
      return excess(branch_.points[k].multipliers, j).value;
    };
    const double length = distance(i, i + 1);
    const double at = value(i), next = value(i + 1);
    const double rate_in = (at - value(i - 1)) / distance(i - 1, i);
    const double rate_out = (value(i + 2) - next) / distance(i + 1, i + 2);
    const double s = (next - at - rate_out * length) / (rate_in - rate_out);
    if (!(s > 0.0 && s < length) || (at + rate_in * s) * at > 0.0) return;
    std::optional<BranchPoint> middle = point_between(i, s);
    if (!middle || middle->multipliers.size() <= j) return;
    const double found = excess(middle->multipliers, j).value;
    if (found * at > 0.0) {
      const double left = (found - at) / s, right = (next - found) / (length - s);
      const double curvature = (right - left) / length;
      const double vertex = 0.5 * (s - left / curvature);
      if (!(vertex > 0.0 && vertex < length)) return;
      middle = point_between(i, vertex);
      if (!middle || middle->multipliers.size() <= j) return;
    }
    if (!(excess(middle->multipliers, j).value * at < 0.0)) return;
    add_crossing(branch_.points[i], *middle, i, j);
    add_crossing(*middle, branch_.points[i + 1], i, j);
  }

  double distance(std::size_t i, std::size_t k) const {
    return corrector_
        .difference(corrector_.pack(branch_.points[k]), corrector_.pack(branch_.points[i]))
        .norm();
  }

  // The point of the branch s behind point i, its multipliers with it.
  std::optional<BranchPoint> point_between(std::size_t i, double s) {
    const BranchPoint& from = branch_.points[i];
    std::optional<BranchPoint> point =
        corrector_.on_hyperplane(corrector_.pack(from) + s * from.tangent, from.tangent);
    if (point) point->multipliers = multipliers_of(*point);
    return point;
  }

  Branch& branch_;
  const ZeroProblem& problem_;
  Corrector& corrector_;
};

}  // namespace

void add_critical_points(Branch& branch, const ZeroProblem& problem, Corrector& corrector) {
  CriticalSearch(branch, problem, corrector).run();
}

}  // namespace graze
