#include "graze/fit/detail/difference_jacobian.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

// A derivative whose two steps agree to this part is good enough for a Gauss-Newton step and an
// uncertainty. Where the model has kinks finer than the noise no step is better.
constexpr double kGood = 0.05;
// Adjustments of a step, and then reductions, at most.
constexpr int kAdjustments = 4, kReductions = 3;
constexpr double kReduction = 8.0;

struct Slope {
  Vector column;
  double error = 0.0;  // relative
};

class Column {
 public:
  Column(const Residuals& residuals, const Vector& at, Eigen::Index j, double low, double high)
      : residuals_(residuals), at_(at), j_(j), low_(low), high_(high) {
    const double size = std::max(std::abs(at[j]), std::isfinite(high - low) ? high - low : 0.0);
    // A smaller step would be lost in the parameter's own rounding.
    least_ = std::sqrt(std::numeric_limits<double>::epsilon()) *
             (size > 0.0 ? std::abs(at[j]) + 1e-3 * size : 1.0);
  }

  // The largest step that has room for three points.
  double limited(double step) const {
    const double room = std::max(high_ - at_[j_], at_[j_] - low_) / 2.0;
    return std::min(std::max(step, std::min(least_, room)), room);
  }

  // The slope by this step; of second order, one-sided where the other side is out of bounds.
  std::optional<Vector> slope(double h) const {
    if (at_[j_] + h <= high_ && at_[j_] - h >= low_) {
      const auto more = value(h), less = value(-h);
      if (!more || !less) return {};
      return Vector((*more - *less) / (2.0 * h));
    }
    if (at_[j_] + 2.0 * h > high_) h = -h;
    const auto here = value(0.0), near = value(h), far = value(2.0 * h);
    if (!here || !near || !far) return {};
    return Vector((4.0 * *near - *far - 3.0 * *here) / (2.0 * h));
  }

 private:
  std::optional<Vector> value(double more) const {
    Vector moved = at_;
    moved[j_] += more;
    return residuals_(moved);
  }

  const Residuals& residuals_;
  const Vector& at_;
  Eigen::Index j_;
  double low_, high_, least_;
};

// The step that makes the requested change, and the slope with it.
std::optional<Vector> fitting_slope(const Column& column, double change, double& step) {
  std::optional<Vector> slope;
  for (int i = 0; i < kAdjustments; ++i) {
    step = column.limited(step);
    slope = column.slope(step);
    if (!slope) {
      step /= kReduction;
      continue;
    }
    const double made = slope->norm() * step;
    const double wanted = made > 0.0 ? step * change / made : 2.0 * kReduction * step;
    // Within a factor of two is close enough.
    if (column.limited(wanted) == step || (wanted < 2.0 * step && wanted > 0.5 * step)) break;
    step = wanted;
  }
  return slope;
}

std::optional<Slope> extrapolated(const Column& column, const Vector& slope, double step) {
  const std::optional<Vector> half = column.slope(0.5 * step);
  if (!half) return {};
  const double length = half->norm();
  // The finer slope has an error of a third of the difference, the extrapolated one less.
  return Slope{(4.0 * *half - slope) / 3.0,
               length > 0.0 ? (*half - slope).norm() / (3.0 * length) : 0.0};
}

std::optional<Slope> best_slope(const Column& column, double change, double& step) {
  std::optional<Vector> slope = fitting_slope(column, change, step);
  std::optional<Slope> best;
  double best_step = step;
  for (int i = 0; i <= kReductions; ++i) {
    if (slope) {
      const std::optional<Slope> found = extrapolated(column, *slope, step);
      if (found && (!best || found->error < best->error)) {
        best = found;
        best_step = step;
      }
      if (best && best->error <= kGood) break;
    }
    const double smaller = column.limited(step / kReduction);
    if (smaller == step) break;
    step = smaller;
    slope = column.slope(step);
  }
  step = best_step;
  return best;
}

}  // namespace

std::optional<DifferenceJacobian> difference_jacobian(const Residuals& residuals, const Vector& at,
                                                      const Vector& low, const Vector& high,
                                                      const Vector& steps, double change) {
  // At least the rounding with the smallest allowed step.
  DifferenceJacobian jacobian{
      {}, steps, std::pow(std::numeric_limits<double>::epsilon(), 2.0 / 3.0)};
  for (Eigen::Index j = 0; j < at.size(); ++j) {
    const Column column(residuals, at, j, low[j], high[j]);
    const std::optional<Slope> slope = best_slope(column, change, jacobian.steps[j]);
    if (!slope) return {};
    if (j == 0) jacobian.matrix.resize(slope->column.size(), at.size());
    jacobian.matrix.col(j) = slope->column;
    jacobian.error = std::max(jacobian.error, slope->error);
  }
  return jacobian;
}

}  // namespace graze
