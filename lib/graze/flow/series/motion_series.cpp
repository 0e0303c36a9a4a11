#include "graze/flow/series/detail/motion_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/detail/bracketed_zero.hpp"

namespace graze {
namespace {

// Number of roundings in forming an acceleration.
constexpr double kSeriesRoundings = 8.0;

}  // namespace

MotionSeries::MotionSeries(const LinearSystem<double>& modes, Matrix rows, int order)
    : order_(order), omega_(modes.omega), delta_(modes.delta), rows_(std::move(rows)) {
  double quickest = modes.forced ? modes.frequency : 0.0;
  for (Eigen::Index j = 0; j < omega_.size(); ++j)
    quickest = std::max({quickest, omega_[j], 2.0 * delta_[j]});
  unit_ = quickest > 0.0 ? 1.0 / quickest : 1.0;
  stiffness_ = (omega_ * unit_).cwiseAbs2();
  damping_ = 2.0 * unit_ * delta_;
  if (modes.load.size() > 0) load_ = unit_ * unit_ * modes.load;
  if (modes.forced) {
    amplitude_ = unit_ * unit_ * modes.amplitude;
    frequency_ = modes.frequency;
    turn_ = modes.frequency * unit_;
  }
  const Eigen::Index m = rows_.cols();
  shares_.resize(rows_.rows(), m);
  force_weight_.resize(m);
  if (m > 0) shares_ = rows_ * PivotedLu<double>(rows_.transpose() * rows_).inverse();
  for (Eigen::Index i = 0; i < m; ++i)
    force_weight_[i] = std::hypot((2.0 * delta_).cwiseProduct(shares_.col(i)).norm(),
                                  omega_.cwiseProduct(shares_.col(i)).norm());
  c_.resize(omega_.size(), order_ + 2);
  mu_.resize(m, order_);
}

// u^2 times the acceleration's coefficient k without stops.
void MotionSeries::free_terms(int k, Vector& terms) const {
  terms = -stiffness_.cwiseProduct(c_.col(k)) - (k + 1.0) * damping_.cwiseProduct(c_.col(k + 1));
  if (k == 0 && load_.size() > 0) terms += load_;
  if (amplitude_.size() == 0) return;
  double part = 1.0;  // (W u)^k/k!
  for (int i = 1; i <= k; ++i) part *= turn_ / i;
  const double quarter[] = {std::cos(theta_), -std::sin(theta_), -std::cos(theta_),
                            std::sin(theta_)};
  terms += part * quarter[k % 4] * amplitude_;
}

void MotionSeries::expand(double theta, const Vector& q, const Vector& qdot) {
  theta_ = theta;
  c_.col(0) = q;
  c_.col(1) = unit_ * qdot;
  Vector terms(q.size());
  for (int k = 0; k < order_; ++k) {
    free_terms(k, terms);
    if (rows_.cols() > 0) {
      mu_.col(k) = shares_.transpose() * terms;
      terms.noalias() -= rows_ * mu_.col(k);
      mu_.col(k) /= unit_ * unit_;
    }
    c_.col(k + 2) = terms / ((k + 2.0) * (k + 1.0));
  }
  double push = 0.0;  // |f| W^P u^P/P! over the longest step
  if (amplitude_.size() > 0) {
    push = amplitude_.norm() / (unit_ * unit_) * kLongest * unit_;
    for (int i = 1; i <= order_; ++i) push *= turn_ / i;
  }
  last_size_ = size(order_) + push;
}

double MotionSeries::size(int k) const {
  return std::hypot((k + 1.0) / unit_ * c_.col(k + 1).norm(),
                    omega_.cwiseProduct(c_.col(k)).norm());
}

double MotionSeries::step(double part) const {
  const double whole = size(0);
  if (!(last_size_ > 0.0) || !(whole > 0.0)) return kLongest;
  return std::min(std::pow(part * whole / last_size_, 1.0 / order_), kLongest);
}

double MotionSeries::force_push(int i) const {
  if (amplitude_.size() == 0) return 0.0;
  return std::abs(shares_.col(i).dot(amplitude_)) / (unit_ * unit_);
}

double MotionSeries::force_remainder(int i) const {
  double pushed = force_push(i);  // times W^P u^P/P!
  for (int k = 1; k <= order_; ++k) pushed *= turn_ / k;
  return force_weight_[i] * last_size_ + pushed;
}

double MotionSeries::force_noise(int i) const {
  Vector terms =
      stiffness_.cwiseProduct(c_.col(0).cwiseAbs()) + damping_.cwiseProduct(c_.col(1).cwiseAbs());
  if (load_.size() > 0) terms += load_.cwiseAbs();
  if (amplitude_.size() > 0) terms += amplitude_.cwiseAbs();
  return kSeriesRoundings * std::numeric_limits<double>::epsilon() *
         shares_.col(i).cwiseAbs().dot(terms) / (unit_ * unit_);
}

void MotionSeries::state(double tau, Vector& q, Vector& qdot) const {
  q = c_.col(order_ + 1);
  qdot = (order_ + 1.0) * c_.col(order_ + 1);
  for (int k = order_; k >= 0; --k) {
    q = q * tau + c_.col(k);
    if (k > 0) qdot = qdot * tau + k * c_.col(k);
  }
  qdot /= unit_;
}

Matrix MotionSeries::velocities(std::span<const double> taus) const {
  const auto count = static_cast<Eigen::Index>(taus.size());
  Matrix powers(order_ + 1, count);
  for (Eigen::Index a = 0; a < count; ++a) {
    double power = 1.0 / unit_;
    for (int k = 0; k <= order_; ++k, power *= taus[static_cast<std::size_t>(a)])
      powers(k, a) = (k + 1.0) * power;
  }
  return c_.rightCols(order_ + 1) * powers;
}

// A gap is a sum of N products, as in GapValue; each higher coefficient has a few more roundings.
BoundedSeries MotionSeries::gap(const Eigen::Ref<const Vector>& row, double norm, double gap,
                                int multiplicity, double tau, std::vector<double>& storage) const {
  storage.resize(static_cast<std::size_t>(order_ + 1));
  Eigen::Map<Vector>(storage.data(), order_ + 1).noalias() =
      -(c_.leftCols(order_ + 1).transpose() * row);
  storage[0] += gap;
  const double unit_rounding =
      (kSeriesRoundings + static_cast<double>(row.size())) * std::numeric_limits<double>::epsilon();
  BoundedSeries series;
  series.coefficients =
      std::span<const double>(storage).subspan(static_cast<std::size_t>(multiplicity));
  series.remainder = norm * remainder();
  double power = 1.0, moved = 0.0;
  for (int k = multiplicity + 1; k <= order_; ++k, power *= tau)
    moved += power * (k == 1 ? row.cwiseAbs().dot(c_.col(1).cwiseAbs()) : norm * c_.col(k).norm());
  series.noise_rate = unit_rounding * moved;
  if (multiplicity == 0)
    series.noise = unit_rounding * (std::abs(gap) + row.cwiseAbs().dot(c_.col(0).cwiseAbs()));
  return series;
}

BoundedSeries MotionSeries::force(int i, std::vector<double>& storage) const {
  storage.resize(static_cast<std::size_t>(order_));
  for (int k = 0; k < order_; ++k) storage[static_cast<std::size_t>(k)] = mu_(i, k);
  storage[0] += 2.0 * force_noise(i);
  return {storage, force_remainder(i)};
}

Vector MotionSeries::forces_at(double theta, const Vector& q, const Vector& qdot) const {
  Vector terms = -omega_.cwiseAbs2().cwiseProduct(q) - 2.0 * delta_.cwiseProduct(qdot);
  if (load_.size() > 0) terms += load_ / (unit_ * unit_);
  if (amplitude_.size() > 0) terms += std::cos(theta) / (unit_ * unit_) * amplitude_;
  return shares_.transpose() * terms;
}

void MotionSeries::settle(const Vector& gaps, Vector& q, Vector& qdot) const {
  if (rows_.cols() == 0) return;
  q -= shares_ * (rows_.transpose() * q - gaps);
  qdot -= shares_ * (rows_.transpose() * qdot);
}

namespace {

constexpr std::size_t kMostCoefficients = 32;

// Bernstein's coefficients over a stretch: the curve lies between the smallest and the largest.
struct Stretch {
  std::array<double, kMostCoefficients> b{};
  std::size_t count = 0;
  double from = 0.0, to = 0.0;

  double least() const { return *std::min_element(b.begin(), b.begin() + count); }
  bool falls() const {
    for (std::size_t i = 1; i < count; ++i)
      if (!(b[i] < b[i - 1])) return false;
    return true;
  }
};

Stretch whole_stretch(std::span<const double> coefficients, double tau) {
  Stretch stretch;
  stretch.count = coefficients.size();
  stretch.to = tau;
  // Of t^k/C(n, k) the forward differences are the coefficients themselves.
  const auto n = static_cast<double>(stretch.count - 1);
  double power = 1.0, choose = 1.0;
  for (std::size_t k = 0; k < stretch.count; ++k) {
    stretch.b[k] = coefficients[k] * power / choose;
    power *= tau;
    choose *= (n - static_cast<double>(k)) / (static_cast<double>(k) + 1.0);
  }
  for (std::size_t level = 1; level < stretch.count; ++level)
    for (std::size_t k = stretch.count - 1; k >= level; --k) stretch.b[k] += stretch.b[k - 1];
  return stretch;
}

// De Casteljau's halves.
std::pair<Stretch, Stretch> halves(const Stretch& whole) {
  Stretch left = whole, right = whole;
  left.to = right.from = 0.5 * (whole.from + whole.to);
  std::size_t last = whole.count - 1;
  left.b[0] = right.b[0];
  for (std::size_t level = 1; level <= last; ++level) {
    for (std::size_t k = 0; k + level <= last; ++k)
      right.b[k] = 0.5 * (right.b[k] + right.b[k + 1]);
    left.b[level] = right.b[0];
  }
  return {left, right};
}

double value_at(std::span<const double> coefficients, double t) {
  double sum = 0.0;
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * t + coefficients[k];
  return sum;
}

class ZeroSearch {
 public:
  ZeroSearch(const BoundedSeries& series, double tau, double resolved)
      : series_(series), least_(resolved * tau) {}

  // Returns whether the stretch is clear; otherwise `zero` is set.
  bool clear(const Stretch& stretch, SeriesZero& zero) const {
    if (stretch.least() > series_.noise + series_.noise_rate * stretch.to + left_out(stretch.to)) {
      zero.clear = stretch.to;
      return true;
    }
    const double width = stretch.to - stretch.from;
    if (width <= least_ || !(stretch.from + 0.5 * width > stretch.from)) {
      const double last = stretch.b[stretch.count - 1];
      if (stretch.b[0] > 0.0 && last < 0.0 && stretch.falls()) {
        zero.crosses = true;
        const auto f = [&](double t) { return value_at(series_.coefficients, t); };
        const BracketEnd a{stretch.from, f(stretch.from)}, b{stretch.to, f(stretch.to)};
        zero.zero = a.value > 0.0 && b.value < 0.0 ? bracketed_zero(f, a, b).first : stretch.from;
      }
      return false;
    }
    const auto [left, right] = halves(stretch);
    return clear(left, zero) && clear(right, zero);
  }

 private:
  double left_out(double t) const {
    return series_.remainder * std::pow(t, static_cast<double>(series_.coefficients.size()));
  }

  const BoundedSeries& series_;
  double least_;
};

}  // namespace

SeriesZero first_zero(const BoundedSeries& series, double tau, double resolved) {
  SeriesZero zero;
  ZeroSearch(series, tau, resolved).clear(whole_stretch(series.coefficients, tau), zero);
  return zero;
}

}  // namespace graze
