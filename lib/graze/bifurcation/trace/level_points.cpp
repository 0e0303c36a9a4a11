#include "graze/bifurcation/trace/detail/level_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/continuation/branch/detail/locate.hpp"
#include "graze/continuation/branch/detail/slope.hpp"
#include "graze/continuation/special/detail/test_zeros.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// A number that jumps changes its sign, too: where it does not, it is at most this part of its
// larger value at the ends of the step.
constexpr double kVanishes = 1e-6;
// What numbers of neighbours differ by where they are the same but for rounding, relative.
constexpr double kRounded = 1e-11;
// A gap or a speed this small, in units of the motion, is that of a grazing.
constexpr double kTouches = 1e-9;
// Step of the differences that give the slope of a number along a branch, of the length of the step
// from point to point: their error is of its fourth power.
constexpr double kSlopeStep = 0.02;

// One level along the branches of a problem.
class LevelTest {
 public:
  LevelTest(const OrbitProblem& problem, const ContinuationOptions& options,
            const OrbitLevel& level)
      : problem_(problem), level_(level), corrector_(problem.problem(), options) {}

  std::optional<double> excess(const SolutionPoint& at) const {
    const std::optional<OrbitBranchPoint> orbit = problem_.judge(at);
    const System* system = orbit ? problem_.system_at(at.parameters()) : nullptr;
    if (!system) return {};
    const std::optional<double> number =
        level_.number(problem_.scene_at(at.parameters()), *system, orbit->orbit);
    return number ? std::optional(level_.excess(*number)) : std::nullopt;
  }

  // By arclength; `length`: that of a step of the branch there.
  std::optional<double> slope(const SolutionPoint& at, double length) {
    const std::optional<double> here = excess(at);
    return slope_at_zero(kSlopeStep * length, [&](double s) -> std::optional<double> {
      const auto there = corrector_.on_hyperplane(corrector_.pack(at) + s * at.tangent, at.tangent);
      const std::optional<double> number = there ? excess(*there) : std::nullopt;
      return number && here ? std::optional(level_.change(*here, *number)) : std::nullopt;
    });
  }

  // Where it passes a value between neighbours; nullopt where it does not, or jumps.
  std::optional<SolutionPoint> passes(const SolutionPoint& a, const SolutionPoint& b) {
    const std::optional<double> before = excess(a), behind = excess(b);
    if (!before || !behind || !((*before < 0.0) != (*behind < 0.0))) return {};
    auto point = locate(corrector_, a, b, [this](const SolutionPoint& at) {
      return excess(at).value_or(std::nan(""));
    });
    if (!point || !vanishes(*point, *before, *behind)) return {};
    return point;
  }
  bool vanishes(const SolutionPoint& at, double before, double behind) const {
    const std::optional<double> there = excess(at);
    return there && std::abs(*there) <= kVanishes * std::max(std::abs(before), std::abs(behind));
  }

  // Whether the number is another one at the ends of the step than at an extreme, beyond rounding.
  bool differs(const SolutionPoint& at, double before, double behind) const {
    const std::optional<double> there = excess(at);
    return there && std::max(std::abs(level_.change(*there, before)),
                             std::abs(level_.change(*there, behind))) > kRounded * std::abs(*there);
  }
  // Whether it lies on the end of the branch at a grazing, which has a name of its own.
  bool is_boundary(const SolutionPoint& at) const {
    const std::optional<OrbitBranchPoint> orbit = problem_.judge(at);
    const System* system = orbit ? problem_.system_at(at.parameters()) : nullptr;
    if (!system) return true;
    const MotionScale scale = motion_scale(*system);
    return std::abs(orbit->smallest_speed) <= kTouches * scale.speed ||
           std::abs(orbit->orbit.clearance.value_or(scale.length)) <= kTouches * scale.length;
  }

  Corrector& corrector() { return corrector_; }

 private:
  const OrbitProblem& problem_;
  const OrbitLevel& level_;
  Corrector corrector_;
};

CriticalPoint as_critical(const OrbitLevel& level, std::size_t index, SolutionPoint point,
                          std::size_t after) {
  CriticalPoint critical{
      level.value ? CriticalKind::kLevel : CriticalKind::kExtreme, std::move(point), after, {}};
  critical.level = index;
  return critical;
}

// In order along the branch.
void insert(Branch& branch, CriticalPoint critical, const Corrector& corrector) {
  const SolutionPoint& from = branch.points[critical.after];
  const double ahead = corrector.ahead(from, critical.point);
  const auto behind =
      std::find_if(branch.critical.begin(), branch.critical.end(), [&](const CriticalPoint& other) {
        return other.after > critical.after ||
               (other.after == critical.after && corrector.ahead(from, other.point) > ahead);
      });
  branch.critical.insert(behind, std::move(critical));
}

// Branches end where one of the levels is passed.
class LevelEnds : public BranchBoundaries {
 public:
  LevelEnds(std::unique_ptr<BranchBoundaries> inner, const OrbitProblem& problem,
            const ContinuationOptions& options, const std::vector<OrbitLevel>& levels)
      : inner_(std::move(inner)), problem_(problem), options_(options), levels_(levels) {}

  bool lists(const SolutionPoint& solution) const override { return inner_->lists(solution); }
  bool goes_on(const SolutionPoint& previous, const SolutionPoint& here) override {
    return inner_->goes_on(previous, here) && !end_between(previous, here);
  }
  bool resolves(const SolutionPoint& from, const SolutionPoint& to) override {
    return inner_->resolves(from, to);
  }
  void pass(const JudgedPoint& a, const JudgedPoint& b, std::vector<BranchPlace>& places) override {
    inner_->pass(a, b, places);
  }
  std::optional<BranchTip> close(Branch& trace, std::size_t side) override {
    const std::size_t last = trace.points.size() - 1;
    const std::size_t step = side == 0 ? 0 : last - 1;
    if (trace.ends[side] == BranchEnd::kHalted && last > 0)
      if (auto end = end_between(trace.points[step], trace.points[step + 1], side == 0)) {
        const SolutionPoint tip = end->special->solution;
        trace.points[side == 0 ? 0 : last] = tip;
        // What else lies in the step may lie beyond the end.
        const Corrector corrector(problem_.problem(), options_);
        std::erase_if(trace.critical, [&](const CriticalPoint& critical) {
          const double ahead = corrector.ahead(tip, critical.point);
          return critical.after == step && (side == 0 ? ahead <= 0.0 : ahead >= 0.0);
        });
        return BranchTip{end->end, std::move(*end)};
      }
    return inner_->close(trace, side);
  }
  std::optional<Orbit> across(const SpecialPoint& special) const override {
    return inner_->across(special);
  }

 private:
  // The level that is passed between neighbours in order along the branch, the first one or the
  // last.
  std::optional<BranchPlace> end_between(const SolutionPoint& a, const SolutionPoint& b,
                                         bool last = false) {
    std::optional<BranchPlace> end;
    double best = 0.0;
    for (std::size_t k = 0; k < levels_.size(); ++k) {
      if (!levels_[k].ends) continue;
      auto point = LevelTest(problem_, options_, levels_[k]).passes(a, b);
      std::optional<OrbitBranchPoint> at = point ? problem_.judge(*point) : std::nullopt;
      if (!at) continue;
      const double ahead = Corrector(problem_.problem(), options_).ahead(a, *point);
      if (end && (last ? ahead < best : ahead > best)) continue;
      best = ahead;
      end = BranchPlace{*at, {}, inner_->lists(*point), OrbitBranchEnd::kLevel};
      end->special = as_special(as_critical(levels_[k], k, std::move(*point), 0), std::move(*at));
    }
    return end;
  }

  std::unique_ptr<BranchBoundaries> inner_;
  const OrbitProblem& problem_;
  const ContinuationOptions& options_;
  const std::vector<OrbitLevel>& levels_;
};

}  // namespace

void mark_levels(const LaidOrbits& orbits, const ContinuationOptions& options,
                 const std::vector<OrbitLevel>& levels, Branch& branch) {
  const std::vector<SolutionPoint>& points = branch.points;
  if (points.size() < 2) return;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const OrbitLevel& level = levels[k];
    if (level.ends) continue;
    LevelTest test(*orbits.problem, options, level);
    const auto length_at = [&](const SolutionPoint& from) {
      const auto i = static_cast<std::size_t>(&from - points.data());
      return arclength(test.corrector(), points[i], points[i + 1 < points.size() ? i + 1 : i - 1]);
    };
    BranchTests tests;
    tests.all = [&](const SolutionPoint& from, const SolutionPoint& at) -> std::optional<Vector> {
      const std::optional<double> value =
          level.value ? test.excess(at) : test.slope(at, std::abs(length_at(from)));
      return value ? std::optional<Vector>(Vector::Constant(1, *value)) : std::nullopt;
    };
    for (TestZero& zero : test_zeros(orbits->problem(), options, branch, tests)) {
      const auto before = test.excess(points[zero.after]);
      const auto behind = test.excess(points[zero.after + 1]);
      if (!before || !behind || test.is_boundary(zero.point)) continue;
      const bool is_one = level.value ? test.vanishes(zero.point, *before, *behind)
                                      : test.differs(zero.point, *before, *behind);
      if (is_one)
        insert(branch, as_critical(level, k, std::move(zero.point), zero.after), test.corrector());
    }
  }
}

std::unique_ptr<BranchBoundaries> with_level_ends(std::unique_ptr<BranchBoundaries> boundaries,
                                                  const OrbitProblem& problem,
                                                  const ContinuationOptions& options,
                                                  const std::vector<OrbitLevel>& levels) {
  if (std::none_of(levels.begin(), levels.end(), [](const OrbitLevel& one) { return one.ends; }))
    return boundaries;
  return std::make_unique<LevelEnds>(std::move(boundaries), problem, options, levels);
}

}  // namespace graze
