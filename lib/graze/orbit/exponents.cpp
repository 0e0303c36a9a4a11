#include "graze/orbit/exponents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <utility>

#include "graze/base/linalg/detail/growing_directions.hpp"
#include "graze/base/linalg/detail/product_eigenvalues.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/detail/trajectory_segment.hpp"

namespace graze {
namespace {

// The motion as a sequence of forcing periods, each a factor of the exponents' product.
class StroboscopicMotion {
 public:
  StroboscopicMotion(const System& system, const State& start, const ExponentOptions& options)
      : system_(system), unit_(2 * system.modes()), motion_(system, {}, start.q, start.qdot) {
    const MotionScale scale = motion_scale(system);
    unit_ << Vector::Constant(system.modes(), scale.displacement), scale.velocity;
    segment_options_.closure_speed = options.closure_speed;
    segment_options_.max_impacts = options.max_impacts;
    segment_options_.stop = options.stop;
  }

  // Images of directions (2N x k) after the next forcing period; nullopt when they cannot be
  // computed; failure() then gives the reason.
  std::optional<Matrix> carry(const Matrix& directions) {
    const Eigen::Index n = system_.modes();
    const Matrix moved = unit_.asDiagonal() * directions;
    Deviations deviations{moved.topRows(n), moved.bottomRows(n),
                          Eigen::RowVectorXd::Zero(directions.cols())};
    MotionState<double> at = motion_.state();
    at.instant = {};
    motion_.go_on_from(at);
    const TrajectorySegment passed =
        pass(system_, motion_, {1, 0.0}, segment_options_, &deviations);
    failure_ = passed.failure;
    if (!failure_.empty()) return {};
    impacts_ = static_cast<long long>(passed.impacts.size());
    const bool stays =
        std::any_of(passed.impacts.begin(), passed.impacts.end(), [&](const SegmentImpact& impact) {
          const auto stop = static_cast<std::size_t>(impact.stop);
          return system_.stops[stop].restitution().at(impact.speed) == 0.0;
        });
    rank_ = 2 * n - (!passed.sticking.empty() ? 2 : stays ? 1 : 0);
    Matrix image(2 * n, directions.cols());
    image << deviations.q, deviations.qdot;
    image = unit_.cwiseInverse().asDiagonal() * image;
    if (!image.allFinite()) {
      failure_ = "small deviations left the range of double precision";
      return {};
    }
    return image;
  }

  // Impacts of the last period.
  long long impacts() const { return impacts_; }
  // Upper bound on the rank of the factor: a held stop has b.dq = b.dq' = 0, and after an impact
  // with r = 0 one of them is zero.
  Eigen::Index rank() const { return rank_; }
  const std::string& failure() const { return failure_; }
  State state() const { return {motion_.q(), motion_.qdot()}; }
  // The state divided by the units of displacement and velocity.
  Vector scaled_state() const {
    Vector state(unit_.size());
    state << motion_.q(), motion_.qdot();
    return state.cwiseQuotient(unit_);
  }

 private:
  const System& system_;
  Vector unit_;            // of (q, q')
  Motion<double> motion_;  // at the start of the period to be carried next
  SegmentOptions segment_options_;
  long long impacts_ = 0;
  Eigen::Index rank_ = 0;
  std::string failure_;
};

void finish(const StroboscopicMotion& motion, Exponents& result) {
  result.lost = static_cast<int>(std::count_if(result.values.begin(), result.values.end(),
                                               [](double value) { return std::isinf(value); }));
  result.failure = motion.failure();
  if (result.failure.empty()) result.end = motion.state();
}

// Largest first; the average may leave them in another order where they are close.
void sort(Exponents& result) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(result.values.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return result.values[a] > result.values[b];
  });
  result.values = Vector(result.values(order));
  result.errors = Vector(result.errors(order));
}

Exponents of_multipliers(const System& system, StroboscopicMotion& motion, int turns) {
  const Eigen::Index size = 2 * system.modes();
  Exponents result;
  std::vector<Matrix> factors;
  std::vector<Eigen::Index> ranks;
  for (; result.periods < turns; ++result.periods) {
    std::optional<Matrix> factor = motion.carry(Matrix::Identity(size, size));
    if (!factor) break;
    factors.push_back(std::move(*factor));
    ranks.push_back(motion.rank());
    result.impacts += motion.impacts();
  }
  result.values = Vector::Constant(size, std::numeric_limits<double>::quiet_NaN());
  result.errors = Vector::Zero(size);
  if (result.periods == turns) {
    const std::vector<Eigenvalue> multipliers = product_eigenvalues(factors);
    // Directions that the orbit loses in passing twice are lost for good.
    GrowingDirections directions(size);
    for (std::size_t i = 0; i < 2 * factors.size(); ++i)
      directions.carry(factors[i % factors.size()] * directions.now(), ranks[i % factors.size()]);
    const Eigen::Index kept = size - directions.lost();
    for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(multipliers.size()); ++j) {
      const Eigenvalue& multiplier = multipliers[static_cast<std::size_t>(j)];
      const double size_of = std::abs(multiplier.value);
      // A multiplier that is zero to its rounding is lost, too.
      result.values[j] = std::log(j < kept && size_of > multiplier.error ? size_of : 0.0) /
                         (static_cast<double>(turns) * system.period());
    }
  }
  finish(motion, result);
  return result;
}

// Whether states at the starts of periods come nearer to repeating. A motion that approaches an
// orbit slowly, as next to a period doubling, has exponents as small as on a torus; but its
// distance from the state up to 32 periods before shrinks, and does not on a torus.
class Returns {
 public:
  explicit Returns(long long periods) : half_(periods / 2) {}

  void add(Vector state) {
    std::array<double, kTurns>& most = most_[count_ < half_ ? 0 : 1];
    for (std::size_t turn = 0; turn < before_.size(); ++turn)
      most[turn] = std::max(most[turn], (state - before_[turn]).lpNorm<Eigen::Infinity>());
    before_.push_front(std::move(state));
    if (before_.size() > kTurns) before_.pop_back();
    ++count_;
  }
  bool come_nearer() const {
    for (std::size_t turn = 0; turn < before_.size(); ++turn)
      if (most_[1][turn] < kAlike * most_[0][turn]) return true;
    return false;
  }

 private:
  static constexpr std::size_t kTurns = 32;
  // The largest distances on either half of fifty returns to a torus agree to some thousandths; at
  // a period doubling, where the approach is slowest, with the time to the power -3/2, they shrink
  // by more.
  static constexpr double kAlike = 0.95;
  long long half_, count_ = 0;
  std::deque<Vector> before_;                         // the latest first
  std::array<std::array<double, kTurns>, 2> most_{};  // of either half
};

// The growth of the leading direction, period by period, as its logarithm.
class GrowthWatch {
 public:
  void add(double growth) {
    grown_ += growth;
    least_ = std::min(least_, grown_);
    most_ = std::max(most_, grown_);
  }
  // `largest` and `error`: the exponent and its standard error, 1/s.
  Wandering verdict(long long periods, double largest, double error, const Returns& returns) const {
    const double factor = std::log(static_cast<double>(periods));
    if (most_ - least_ <= factor)
      return returns.come_nearer() ? Wandering::kOpen : Wandering::kTorus;
    return grown_ > factor && largest > 3.0 * error ? Wandering::kChaos : Wandering::kOpen;
  }

 private:
  double grown_ = 0.0, least_ = 0.0, most_ = 0.0;
};

Exponents of_average(const System& system, StroboscopicMotion& motion,
                     const ExponentOptions& options) {
  const Eigen::Index size = 2 * system.modes();
  Exponents result;
  GrowingDirections directions(size);
  BlockMean mean(options.periods);
  GrowthWatch watch;
  Returns returns(options.periods);
  for (long long k = 0; k < options.turning + options.periods; ++k) {
    const std::optional<Matrix> image = motion.carry(directions.now());
    if (!image) break;
    const Vector growth = directions.carry(*image, motion.rank());
    if (k < options.turning) continue;
    mean.add(growth / system.period());
    watch.add(growth[0]);
    returns.add(motion.scaled_state());
    result.impacts += motion.impacts();
  }
  result.periods = mean.count();
  result.values = result.errors = Vector::Constant(size, std::numeric_limits<double>::quiet_NaN());
  if (result.periods > 0) {
    result.values = mean.mean();
    result.errors = mean.standard_error();
    // A direction once lost stays lost, also when that was before the average began.
    result.values.tail(directions.lost()).setConstant(-std::numeric_limits<double>::infinity());
    sort(result);
    if (result.periods == options.periods)
      result.wandering = watch.verdict(result.periods, result.values[0], result.errors[0], returns);
  }
  finish(motion, result);
  return result;
}

}  // namespace

Exponents lyapunov_exponents(const System& system, const State& start,
                             const ExponentOptions& options) {
  StroboscopicMotion motion(system, start, options);
  return options.repeats > 0 ? of_multipliers(system, motion, options.repeats)
                             : of_average(system, motion, options);
}

}  // namespace graze
