#include "graze/continuation/special/detail/critical.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/base/stop_scope.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/branch/detail/locate.hpp"
#include "graze/continuation/special/detail/circle_crossings.hpp"
#include "graze/continuation/special/detail/crossing_samples.hpp"

namespace graze {
namespace {

// Branch points as regular solutions of a larger system.
//
// At a branch point dF/dx (n x (n + 1)) has rank n - 1, and next to it the branch itself is badly
// determined along the one that crosses. With borders b (n) and C (2 x (n + 1)) that span the
// missing directions,
//
//   [dF/dx, b; C, 0] [V; g] = [0; I],      F + m b = 0,   g(x) = 0
//
// has the branch point as a regular solution (x, m), m = 0, known to the rounding of F and dF/dx.
//
// Griewank and Reddien, SIAM J. Numer. Anal. 21 (1984) 176-185; Govaerts, Numerical Methods for
// Bifurcations of Dynamical Equilibria, 2000.

constexpr int kMostCriticalIterations = 8;
// A step this small leaves an error of its square, and of its product with the error of the
// differences (1e-10): below rounding.
constexpr double kCriticalSettled = 1e-8;

struct Singularity {
  Vector value;  // g, 2
  Matrix slope;  // dg/dx, 2 x (n + 1)
};

// g at x and its derivative. With [w^T, h^T] [dF/dx, b; C, 0] = (0, 1) the latter is -w^T F_xx V.
// Its second derivatives are differences: they only lead to the solution, which does not depend on
// them. Their step balances the rounding of dF/dx against its third derivative.
std::optional<Singularity> singularity(Corrector& corrector, const Vector& x, const Matrix& slope,
                                       const NullSpaces& borders) {
  const Eigen::Index n = slope.rows();
  Matrix bordered = Matrix::Zero(n + 2, n + 2);
  bordered.topLeftCorner(n, n + 1) = slope;
  bordered.col(n + 1).head(n) = borders.left.col(0);
  bordered.bottomLeftCorner(2, n + 1) = borders.right.transpose();
  const LuFactors lu(bordered);
  Matrix identity = Matrix::Zero(n + 2, 2);
  identity.bottomRows(2).setIdentity();
  const Matrix solution = lu.solve_columns(identity);
  Vector left = lu.solve_transposed(Vector::Unit(n + 2, n + 1));
  left.conservativeResize(n);
  const double step = std::cbrt(std::numeric_limits<double>::epsilon()) * (1.0 + x.norm());
  Singularity result{solution.row(n + 1).transpose(), Matrix(2, n + 1)};
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Vector direction = solution.col(k).head(n + 1);
    const std::optional<Matrix> ahead = corrector.slope_at(x + step * direction),
                                behind = corrector.slope_at(x - step * direction);
    if (!ahead || !behind) return {};
    result.slope.row(k) = -left.transpose() * (*ahead - *behind) / (2.0 * step);
  }
  return result;
}

// The branch point near a guess, as x = (u, parameter/range). Returns nullopt when Newton's method
// does not converge.
std::optional<Vector> crossing_near(Corrector& corrector, const Vector& guess) {
  const Eigen::Index n = guess.size() - 1;
  Vector x = guess;
  double unfolding = 0.0, last = std::numeric_limits<double>::infinity();
  std::optional<NullSpaces> borders;
  for (int i = 0; i < kMostCriticalIterations; ++i) {
    const auto at = corrector.linearise(x, Vector::Zero(n + 1));
    if (!at) return {};
    const Matrix slope = at->bordered.topRows(n);
    if (!borders) borders = null_spaces(slope, 2);
    const std::optional<Singularity> singular = singularity(corrector, x, slope, *borders);
    if (!singular) return {};
    Matrix jacobian = Matrix::Zero(n + 2, n + 2);
    jacobian.topLeftCorner(n, n + 1) = slope;
    jacobian.col(n + 1).head(n) = borders->left.col(0);
    jacobian.bottomLeftCorner(2, n + 1) = singular->slope;
    Vector target(n + 2);
    target << -at->residual - unfolding * borders->left.col(0), -singular->value;
    const Vector step = LuFactors(jacobian).solve(target);
    // The unfolding, in units of F, enters linearly: it is accurate when x is.
    const double size = step.head(n + 1).norm();
    if (!step.allFinite() || (size > 0.5 * last && size > kCriticalSettled)) return {};
    x += step.head(n + 1);
    unfolding += step[n + 1];
    if (size <= kCriticalSettled) return x;
    last = size;
  }
  return {};
}

// Halvings of a piece between samples that contains a branch point, down to the step with which the
// tracer passes one.
constexpr int kMostCriticalHalvings = 30;

// Next to a pole samples are this part of a step away from it, 2^-n: a multiplier with a smaller
// residue passes the circle within less.
constexpr int kPoleHalvings = 20;

std::optional<Eigenvalue> nearest_to_one(const std::vector<Eigenvalue>& multipliers) {
  std::optional<Eigenvalue> nearest;
  for (const Eigenvalue& m : multipliers)
    if (!nearest || std::abs(m.value - 1.0) < std::abs(nearest->value - 1.0)) nearest = m;
  return nearest;
}

class CriticalSearch {
 public:
  CriticalSearch(Branch& branch, const ZeroProblem& problem, Corrector& corrector,
                 const StopSignal& stop)
      : branch_(branch), problem_(problem), corrector_(corrector), stop_(stop) {}

  void run() {
    if (problem_.multipliers)
      for (CriticalPoint& fold : branch_.critical) {
        fold.point.multipliers = multipliers_of(fold.point);
        fold.multiplier = nearest_to_one(fold.point.multipliers);
      }
    find_samples();
    for (std::size_t i = 0; i + 1 < branch_.points.size(); ++i)
      for_each_piece(i, [&](const SolutionPoint& a, const SolutionPoint& b) {
        if (a.orientation * b.orientation < 0) add_branch_point(a, b, i);
      });
    drop_folds_at_branch_points();
    if (!samples_.empty())
      for (std::size_t i = 0; i + 1 < branch_.points.size(); ++i) add_crossings(i);
    std::stable_sort(branch_.critical.begin(), branch_.critical.end(),
                     [this](const CriticalPoint& a, const CriticalPoint& b) {
                       return a.after != b.after ? a.after < b.after : along(a) < along(b);
                     });
  }

 private:
  std::vector<Eigenvalue> multipliers_of(const SolutionPoint& point) const {
    return problem_.multipliers(point.u, point.parameters(), ErrorBounds::kGiven);
  }

  // A branch that was stopped is kept with the crossings that its points show: after the stop one
  // location each, for a limited time.
  void add_crossings(std::size_t i) {
    constexpr std::chrono::milliseconds kGrace{500};
    const std::size_t known = branch_.critical.size();
    if (!stop_.requested()) {
      CircleCrossings crossings(problem_, corrector_, stop_, i, branch_.critical);
      for_each_piece(i,
                     [&](const SolutionPoint& a, const SolutionPoint& b) { crossings.add(a, b); });
      if (!stop_.requested()) return;
    }
    if (!last_) last_ = std::chrono::steady_clock::now() + kGrace;
    branch_.critical.resize(known);
    const StopSignal grace{nullptr, last_};
    const StopScope scope(grace, std::chrono::milliseconds{0});
    CircleCrossings crossings(problem_, corrector_, grace, i, branch_.critical);
    crossings.add_undivided(branch_.points[i], branch_.points[i + 1]);
  }

  double along(const CriticalPoint& critical) const {
    return corrector_.ahead(branch_.points[critical.after], critical.point);
  }

  // Where all points have the same number of multipliers, finds points between them that show how
  // these move.
  void find_samples() {
    const std::vector<SolutionPoint>& points = branch_.points;
    const std::size_t count = points.front().multipliers.size();
    const bool complete =
        std::all_of(points.begin(), points.end(),
                    [&](const SolutionPoint& point) { return point.multipliers.size() == count; });
    if (problem_.multipliers && complete)
      samples_ = crossing_samples(branch_, problem_, corrector_, stop_);
    if (problem_.poles && !samples_.empty())
      for (std::size_t i = 0; i + 1 < points.size() && !stop_.requested(); ++i) add_beside_poles(i);
  }

  // Adds samples on either side of poles of a multiplier within step i.
  void add_beside_poles(std::size_t i) {
    const SolutionPoint &a = branch_.points[i], &b = branch_.points[i + 1];
    const auto poles_at = [this](const SolutionPoint& p) {
      return problem_.poles(p.u, p.parameters());
    };
    const Vector from = poles_at(a), to = poles_at(b);
    if (from.size() != to.size()) return;
    const double length = corrector_.ahead(a, b);
    for (Eigen::Index k = 0; k < from.size(); ++k) {
      if (!(from[k] * to[k] < 0.0)) continue;
      const std::optional<SolutionPoint> pole =
          locate(corrector_, a, b, [&](const SolutionPoint& p) { return poles_at(p)[k]; });
      if (!pole) continue;
      const double at = corrector_.ahead(a, *pole), aside = std::ldexp(length, -kPoleHalvings);
      for (const double s : {at - aside, at + aside}) {
        if (!(s > 0.0 && s < length)) continue;
        std::optional<SolutionPoint> sample = point_between(corrector_, a, s, a, b);
        if (!sample) continue;
        sample->multipliers =
            problem_.multipliers(sample->u, sample->parameters(), ErrorBounds::kLeftOut);
        if (sample->multipliers.size() != a.multipliers.size()) continue;
        auto& own = samples_[i];
        const auto behind = std::find_if(own.begin(), own.end(), [&](const SolutionPoint& other) {
          return corrector_.ahead(a, other) > s;
        });
        own.insert(behind, std::move(*sample));
      }
    }
  }

  // Visits the pieces of step i between samples.
  template <class Visit>
  void for_each_piece(std::size_t i, const Visit& visit) const {
    const SolutionPoint* last = &branch_.points[i];
    if (!samples_.empty())
      for (const SolutionPoint& sample : samples_[i]) {
        visit(*last, sample);
        last = &sample;
      }
    visit(*last, branch_.points[i + 1]);
  }

  // The tracer passes a branch point with a step so short (1e-6) that the determinant is linear
  // over it; between samples the piece is halved until it is as short. The branch point itself is
  // searched for there: the ends of the step are badly determined along the branch that crosses.
  void add_branch_point(SolutionPoint a, SolutionPoint b, std::size_t i) {
    for (int halving = 0;
         halving < kMostCriticalHalvings && !stop_.requested() &&
         corrector_.chord(a, b).norm() > kShortest * (1.0 + corrector_.pack(a).norm());
         ++halving) {
      std::optional<SolutionPoint> middle =
          point_between(corrector_, a, 0.5 * corrector_.ahead(a, b), a, b);
      if (!middle) break;
      (middle->orientation * a.orientation < 0 ? b : a) = std::move(*middle);
    }
    const double ratio = corrector_.determinant_ratio(a, b);
    if (!std::isfinite(ratio)) return;
    const double part = 1.0 / (1.0 + ratio), rest = 1.0 - part;
    Vector at = cubic_between(corrector_, a, part * corrector_.ahead(a, b), a, b);
    const std::optional<Vector> crossing = crossing_near(corrector_, at);
    const bool solved = crossing && (*crossing - at).norm() <= kOneCrossing * (1.0 + at.norm());
    if (solved) at = *crossing;
    const Eigen::Index n = a.u.size();
    CriticalPoint found{CriticalKind::kBranchPoint, {}, i, {}};
    found.point = {at.head(n),
                   at[n] * corrector_.range(),
                   (rest * a.tangent + part * b.tangent).normalized(),
                   corrector_.residual_at(at).value_or(std::max(a.residual, b.residual)),
                   0,
                   {},
                   bracket_around({a.parameter, b.parameter, at[n] * corrector_.range()}, solved)};
    if (problem_.multipliers) {
      found.point.multipliers = multipliers_of(found.point);
      found.multiplier = nearest_to_one(found.point.multipliers);
    }
    branch_.critical.push_back(std::move(found));
  }

  // Where a branch meets another one at its own turning point (a pitchfork seen from the branch
  // that bifurcates), the fold is that branch point; tangents near it are lost in rounding and show
  // several folds.
  void drop_folds_at_branch_points() {
    std::vector<Vector> crossings;
    for (const SolutionPoint& point : branch_.points)
      if (point.orientation == 0) crossings.push_back(corrector_.pack(point));
    for (const CriticalPoint& critical : branch_.critical)
      if (critical.kind == CriticalKind::kBranchPoint)
        crossings.push_back(corrector_.pack(critical.point));
    const auto is_at_one = [&](const CriticalPoint& critical) {
      if (critical.kind != CriticalKind::kFold) return false;
      const Vector x = corrector_.pack(critical.point);
      return std::any_of(crossings.begin(), crossings.end(), [&](const Vector& crossing) {
        return corrector_.difference(x, crossing).norm() <= kOneCrossing * (1.0 + x.norm());
      });
    };
    branch_.critical.erase(
        std::remove_if(branch_.critical.begin(), branch_.critical.end(), is_at_one),
        branch_.critical.end());
  }

  Branch& branch_;
  const ZeroProblem& problem_;
  Corrector& corrector_;
  StopSignal stop_;
  std::optional<std::chrono::steady_clock::time_point> last_;  // that work goes on to after a stop
  std::vector<std::vector<SolutionPoint>> samples_;  // of each step; empty: none are known
};

}  // namespace

void add_critical_points(Branch& branch, const ZeroProblem& problem, Corrector& corrector,
                         const StopSignal& stop) {
  CriticalSearch(branch, problem, corrector, stop).run();
}

}  // namespace graze
