#include "graze/continuation/locus/locus.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "graze/continuation/branch.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/branch/detail/known_branch.hpp"
#include "graze/continuation/branch/detail/locate.hpp"
#include "graze/continuation/locus/detail/known_loci.hpp"
#include "graze/continuation/locus/detail/locus_equations.hpp"
#include "graze/continuation/locus/detail/plane_curve.hpp"
#include "graze/continuation/special/detail/crossing_tests.hpp"

namespace graze {
namespace {

constexpr double kPi = std::numbers::pi;
// Largest turn of the critical vectors in a step, rad. At a right angle borders fail, and the
// change of the parameters meanwhile may be too small beside that of the unknowns to show as
// curvature.
constexpr double kMostBorderTurn = 0.5;

class EquationLocusTracer {
 public:
  EquationLocusTracer(const ZeroProblem& problem, const LocusOptions& options, LocusKind kind)
      : problem_(problem),
        options_(options),
        kind_(kind),
        equations_(problem, kind, first_range(options), second_range(options)) {}

  // Returns nullopt when the start leads to no point of the locus. Sets n to that of the start.
  std::optional<SolutionPoint> solve(const LocusStart& start) {
    n_ = start.u.size();
    make_curve();
    const double angle = std::abs(std::arg(start.multiplier));
    const Vector y = equations_.pack(start.u, start.first, angle);
    if (!equations_.start_at(y, start.second)) return {};
    std::optional<SolutionPoint> point = point_on_curve(curve_, options_, y, start.second);
    if (!point) return {};
    equations_.start_at(*point);
    if (problem_.multipliers)
      point->multipliers =
          equations_.other_multipliers(point->u, point->parameter, ErrorBounds::kGiven);
    return point;
  }

  Locus trace(const SolutionPoint& start) {
    const PlaneCurve traced = trace_curve(curve_, options_, start);
    Locus locus;
    locus.kind = kind_;
    for (const SolutionPoint& point : traced.branch.points) locus.points.push_back(unpack(point));
    for (const std::size_t side : {0u, 1u})
      locus.ends[side] =
          as_locus_end(traced.branch.ends[side], traced.left_range[side] == curve_.first);
    if (locus.ends[0] == LocusEnd::kFirstLimit) put_on_limit(locus.points.front());
    if (locus.ends[1] == LocusEnd::kFirstLimit) put_on_limit(locus.points.back());
    add_special_points(locus, traced);
    locus.evaluations = equations_.evaluations();
    locus.rejected = traced.branch.rejected;
    return locus;
  }

  LocusPoint unpack(const SolutionPoint& point) const {
    LocusPoint result;
    result.u = point.u.head(n_);
    result.first = equations_.first_of(point.u);
    result.second = point.parameter;
    result.angle = equations_.angle_of(point.u);
    result.residual = point.residual;
    result.tangent = point.tangent;
    result.orientation = point.orientation;
    if (!problem_.multipliers) return result;
    result.multipliers = point.multipliers;
    const Complex mu = equations_.multiplier_of(point.u);
    result.multipliers.push_back({mu, 0.0});
    if (kind_ == LocusKind::kTorus) result.multipliers.push_back({std::conj(mu), 0.0});
    sort_eigenvalues(result.multipliers);
    return result;
  }

  SolutionPoint pack(const LocusPoint& point) const {
    return {equations_.pack(point.u, point.first, point.angle),
            point.second,
            point.tangent,
            point.residual,
            point.orientation,
            {}};
  }

  // The locus as a branch of the equations with the number of unknowns of a start.
  KnownBranch as_known(const Locus& locus) {
    n_ = locus.points.empty() ? 0 : locus.points.front().u.size();
    make_curve();
    std::vector<SolutionPoint> points;
    for (const LocusPoint& point : locus.points) points.push_back(pack(point));
    const ContinuationOptions options = branch_options(curve_, options_);
    return KnownBranch(Corrector(curve_.problem, options), std::move(points), curve_.problem.wrap,
                       options.max_turn);
  }

  bool lies_on(const KnownBranch& known, const SolutionPoint& point) const {
    const ContinuationOptions options = branch_options(curve_, options_);
    Corrector corrector(curve_.problem, options);
    return known.has(corrector, point);
  }

 private:
  void make_curve() {
    ZeroProblem& zero = curve_.problem;
    zero.evaluate = [this](const Vector& y, Parameters at) {
      return equations_.evaluate(y, at[0]);
    };
    if (problem_.multipliers)
      zero.multipliers = [this](const Vector& y, Parameters at, ErrorBounds errors) {
        return equations_.other_multipliers(y, at[0], errors);
      };
    if (problem_.wrap.size() > 0) zero.wrap = equations_.pack(problem_.wrap, 0.0, 0.0);
    curve_.first = n_;
    if (kind_ == LocusKind::kTorus) curve_.ranges = {{n_ + 1, 0.0, kPi, 0.0}};
    curve_.tests.all = [this](const SolutionPoint& from, const SolutionPoint& at) {
      return tests(from, at);
    };
    curve_.tests.one = [this](const SolutionPoint& from, const SolutionPoint& at, Eigen::Index k) {
      return test(from, at, k);
    };
    curve_.resolves = [this](const SolutionPoint& from, const SolutionPoint& to) {
      return equations_.turn(from, to) <= kMostBorderTurn &&
             (!options_.resolves || options_.resolves(unpack(from), unpack(to)));
    };
    curve_.proceed = [this](const SolutionPoint& previous, const SolutionPoint& here) {
      equations_.add(here);
      return !options_.proceed || options_.proceed(unpack(previous), unpack(here));
    };
  }

  // The values in the order of test_kinds(), followed by the caller's.
  std::optional<Vector> tests(const SolutionPoint& from, const SolutionPoint& at) {
    std::optional<Vector> own = own_tests(from, at, true);
    if (!own || !options_.tests) return own;
    const std::optional<Vector> further = options_.tests(unpack(at));
    if (!further) return own;
    Vector all(own->size() + further->size());
    all << *own, *further;
    return all;
  }

  std::optional<double> test(const SolutionPoint& from, const SolutionPoint& at, Eigen::Index k) {
    const auto own = static_cast<Eigen::Index>(test_kinds().size());
    const std::optional<Vector> values =
        k < own ? own_tests(from, at, k + 1 == own) : options_.tests(unpack(at));
    if (!values) return {};
    return (*values)[k < own ? k : k - own];
  }

  // The last value, a coefficient, takes most of the work, and is computed where it is asked for.
  // The coefficient of a normal form has poles where another of the values vanishes, and is
  // multiplied by it. (At R3 only its imaginary part has one.)
  std::optional<Vector> own_tests(const SolutionPoint& from, const SolutionPoint& at,
                                  bool with_coefficient) {
    const bool is_fold = kind_ == LocusKind::kFold;
    const double fold = is_fold ? 0.0 : fold_test(at);
    const double factor = is_fold || !with_coefficient ? std::nan("") : coefficient(at);
    if (kind_ == LocusKind::kTorus) {
      const double third = at.u[n_ + 1] - 2.0 * kPi / 3.0, fourth = at.u[n_ + 1] - kPi / 2.0;
      return Vector{{third, fourth, fold, factor * fold}};
    }
    const std::optional<std::array<double, 2>> degenerate = equations_.degeneracies(from, at);
    if (!degenerate) return {};
    const auto& [bend, pairing] = *degenerate;
    if (is_fold) return Vector{{bend, pairing}};
    return Vector{{pairing, fold, factor * pairing * fold}};
  }

  std::vector<LocusPointKind> test_kinds() const {
    if (kind_ == LocusKind::kFold) return {LocusPointKind::kCusp, LocusPointKind::kResonance1};
    if (kind_ == LocusKind::kPeriodDoubling)
      return {LocusPointKind::kResonance2, LocusPointKind::kFoldDoubling,
              LocusPointKind::kDegenerateDoubling};
    return {LocusPointKind::kResonance3, LocusPointKind::kResonance4, LocusPointKind::kFoldTorus,
            LocusPointKind::kDegenerateTorus};
  }

  // NaN where it is not asked for.
  double coefficient(const SolutionPoint& at) const {
    return options_.coefficient ? options_.coefficient(unpack(at)).value_or(std::nan(""))
                                : std::nan("");
  }

  // Changes sign where one of the other multipliers passes 1; NaN where they are not known.
  double fold_test(const SolutionPoint& at) const {
    if (!problem_.multipliers) return std::nan("");
    if (n_ == (kind_ == LocusKind::kTorus ? 2 : 1)) return 1.0;  // there are no others
    const std::vector<Eigenvalue> list =
        at.multipliers.empty()
            ? equations_.other_multipliers(at.u, at.parameter, ErrorBounds::kLeftOut)
            : at.multipliers;
    if (list.empty()) return std::nan("");
    return crossing_tests(list)[kFoldTest].value();
  }

  // The unknown is on its limit to the last bit; so shall be the first parameter.
  void put_on_limit(LocusPoint& end) const {
    const bool nearer_to =
        std::abs(end.first - options_.first_to) < std::abs(end.first - options_.first_from);
    end.first = nearer_to ? options_.first_to : options_.first_from;
  }

  void add_special_points(Locus& locus, const PlaneCurve& traced) {
    const std::vector<LocusPointKind> kinds = test_kinds();
    for (const TestZero& zero : traced.zeros) {
      if (zero.test < kinds.size())
        locus.special.push_back({kinds[zero.test], unpack(zero.point), zero.after});
      else
        locus.zeros.push_back({zero.test - kinds.size(), unpack(zero.point), zero.after});
    }
    const std::vector<LocusSpecialPoint> resonances = locus.special_of(LocusPointKind::kResonance2);
    for (const CriticalPoint& critical : traced.branch.critical)
      if (const auto kind = kind_of(critical.kind)) {
        LocusPoint point = unpack(critical.point);
        // Borders that fail within a step reverse the orientation twice.
        if (*kind == LocusPointKind::kCrossing && !equations_.is_on_locus(critical.point)) continue;
        if (*kind != LocusPointKind::kTwoDoublings || !is_at_one(point, resonances))
          locus.special.push_back({*kind, std::move(point), critical.after});
      }
    // Where both doublings have vectors of their own their loci cross; that is listed already.
    const std::vector<LocusSpecialPoint> both = locus.special_of(LocusPointKind::kTwoDoublings);
    std::erase_if(locus.special, [&](const LocusSpecialPoint& special) {
      return special.kind == LocusPointKind::kCrossing && is_at_one(special.point, both);
    });
    for (const bool at_end : {false, true}) {
      if (locus.ends[at_end ? 1 : 0] != LocusEnd::kResonance) continue;
      const LocusPoint& end = at_end ? locus.points.back() : locus.points.front();
      locus.special.push_back(
          {end.angle > 0.5 * kPi ? LocusPointKind::kResonance2 : LocusPointKind::kResonance1, end,
           at_end && locus.points.size() > 1 ? locus.points.size() - 2 : 0});
    }
    const auto along = [&](const LocusSpecialPoint& special) {
      const LocusPoint& from = locus.points[special.after];
      return metric(special.point, from).dot(from.tangent);
    };
    std::stable_sort(locus.special.begin(), locus.special.end(),
                     [&](const LocusSpecialPoint& a, const LocusSpecialPoint& b) {
                       return a.after != b.after ? a.after < b.after : along(a) < along(b);
                     });
  }

  // The kind of a branch's special point on this locus; nullopt for a fold, which is not special
  // here.
  std::optional<LocusPointKind> kind_of(CriticalKind kind) const {
    switch (kind) {
      case CriticalKind::kFold:
        return {};
      case CriticalKind::kPeriodDoubling:
        if (kind_ == LocusKind::kFold) return LocusPointKind::kFoldDoubling;
        return kind_ == LocusKind::kTorus ? LocusPointKind::kDoublingTorus
                                          : LocusPointKind::kTwoDoublings;
      case CriticalKind::kTorus:
        if (kind_ == LocusKind::kFold) return LocusPointKind::kFoldTorus;
        return kind_ == LocusKind::kTorus ? LocusPointKind::kTwoTori
                                          : LocusPointKind::kDoublingTorus;
      case CriticalKind::kLevel:
      case CriticalKind::kExtreme:
      case CriticalKind::kBranchPoint:
        return LocusPointKind::kCrossing;
    }
    return {};
  }

  // At R2 the second multiplier, which is -1 too, passes -1 by the rounding of the pair.
  bool is_at_one(const LocusPoint& point, const std::vector<LocusSpecialPoint>& resonances) const {
    const double size = 1.0 + pack(point).u.norm();
    return std::any_of(resonances.begin(), resonances.end(), [&](const LocusSpecialPoint& other) {
      return metric(point, other.point).norm() <= kOneCrossing * size;
    });
  }

  // The vector from b to a, in the metric of the locus.
  Vector metric(const LocusPoint& a, const LocusPoint& b) const {
    return Corrector(curve_.problem, branch_options(curve_, options_)).chord(pack(b), pack(a));
  }

  const ZeroProblem& problem_;
  const LocusOptions& options_;
  LocusKind kind_;
  LocusEquations equations_;
  PlaneCurveProblem curve_;
  Eigen::Index n_ = 0;
};

}  // namespace

std::optional<LocusPoint> solve_locus(const ZeroProblem& problem, const LocusOptions& options,
                                      const LocusStart& start) {
  EquationLocusTracer tracer(problem, options, start.kind);
  const std::optional<SolutionPoint> point = tracer.solve(start);
  if (!point) return {};
  return tracer.unpack(*point);
}

std::optional<Locus> trace_locus(const ZeroProblem& problem, const LocusOptions& options,
                                 const LocusStart& start) {
  EquationLocusTracer tracer(problem, options, start.kind);
  const std::optional<SolutionPoint> point = tracer.solve(start);
  if (!point) return {};
  return tracer.trace(*point);
}

std::optional<std::size_t> find_locus(const ZeroProblem& problem, const LocusOptions& options,
                                      const std::vector<Locus>& loci, const LocusStart& start) {
  KnownLoci known;
  for (const Locus& locus : loci) known.add(problem, options, locus);
  return known.find(problem, options, start);
}

void KnownLoci::add(const ZeroProblem& problem, const LocusOptions& options, const Locus& locus) {
  known_.push_back({locus.kind, EquationLocusTracer(problem, options, locus.kind).as_known(locus)});
}

std::optional<std::size_t> KnownLoci::find(const ZeroProblem& problem, const LocusOptions& options,
                                           const LocusStart& start) const {
  EquationLocusTracer tracer(problem, options, start.kind);
  const std::optional<SolutionPoint> point = tracer.solve(start);
  if (!point) return {};
  for (std::size_t i = 0; i < known_.size(); ++i)
    if (known_[i].kind == start.kind && tracer.lies_on(known_[i].branch, *point)) return i;
  return {};
}

}  // namespace graze
