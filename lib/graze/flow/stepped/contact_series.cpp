#include "graze/flow/stepped/detail/contact_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/flow/stepped/detail/sprung_rates_turning_impl.hpp"

namespace graze::step_walk {
namespace {

// Coefficients that decide the length: those of a motion with a symmetry vanish in between.
constexpr int kTelling = 6;
// A contact takes 2.6 of t on a Hertz spring; without forces a series has no end.
constexpr double kLongest = 1e3;

// The zero of a function that is not negative at `low` and not positive at `high`, or the reverse,
// by Newton's method between them; f returns the value, of the sign that it has at `high`, and the
// slope.
template <class Function>
double newton_between(const Function& f, double low, double high, double at) {
  for (int i = 0; i < 100; ++i) {
    const auto [value, slope] = f(at);
    if (value == 0.0) return at;
    (value > 0.0 ? high : low) = at;
    double next = at - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - at) <= std::numeric_limits<double>::epsilon() * next) return next;
    at = next;
  }
  return at;
}

// A matrix may come as the column of its diagonal.
void multiply(const Matrix& matrix, const Eigen::Map<const Vector>& by, Eigen::Map<Vector>& out) {
  if (matrix.cols() == 1)
    out = matrix.col(0).cwiseProduct(by);
  else
    out.noalias() = matrix * by;
}

bool is_loaded(const SprungSystem::Spring& spring) { return spring.loaded; }

std::size_t loaded_spring(const SprungSystem& system) {
  const auto& springs = system.springs;
  return static_cast<std::size_t>(std::find_if(springs.begin(), springs.end(), is_loaded) -
                                  springs.begin());
}

}  // namespace

bool ContactSeries::suits(const SprungSystem& system) {
  if (system.turning || system.powers || system.load.size() == 0) return false;
  if (std::any_of(system.springs.begin(), system.springs.end(),
                  [](const SprungSystem::Spring& spring) { return spring.resting; }))
    return false;
  if (std::count_if(system.springs.begin(), system.springs.end(), is_loaded) != 1) return false;
  const SprungSystem::Spring& spring = system.springs[loaded_spring(system)];
  if (!(spring.row.dot(spring.acting) > 0.0)) return false;  // its depth is held
  const ContactForce& law = spring.law;
  const double power = 2.0 * law.exponent;
  return power == std::floor(power) && power <= kMostPower && law.is_of_one_piece() &&
         law.damping != ContactDamping::kOnset;
}

ContactSeries::ContactSeries(const SprungSystem& system, double tolerance)
    : modes_(system.load.size()),
      spring_(loaded_spring(system)),
      law_(system.springs[spring_].law),
      power_(static_cast<int>(2.0 * law_.exponent)),
      tolerance_(tolerance),
      motion_(2 * modes_ + kRows),
      slopes_(2 * modes_ + kRows),
      left_(factor(kResisted) + modes_),
      right_(factor(kResisted) + modes_),
      products_(Vector::Zero(left_.rows)),
      resisted_(modes_),
      pulled_(modes_),
      sizes_(Vector::Zero(motion_.rows)),
      values_(motion_.rows) {}

void ContactSeries::set_units(const Sprung& rates) {
  const SprungSystem::Spring& spring = rates.system().springs[spring_];
  frequency_ = rates.contact_frequency();
  depth_ = rates.unit() * std::sqrt(spring.row.dot(spring.acting)) / frequency_;
  unit_power_ = std::pow(depth_, law_.exponent);
  places_[kForcing] = rates.place(Sprung::kForcing);
  places_[kDissipation] = rates.place(Sprung::kDissipation);
  places_[kLost] = rates.place(Sprung::kSprings + spring_);
}

double ContactSeries::value(const Series& series, double t) {
  double sum = series[kOrder];
  for (int k = kOrder - 1; k >= 0; --k) sum = sum * t + series[static_cast<std::size_t>(k)];
  return sum;
}

double ContactSeries::root_rate(double t) const {
  double sum = 0.0;
  for (int k = kOrder; k >= 1; --k) sum = sum * t + k * root_[static_cast<std::size_t>(k)];
  return sum;
}

double ContactSeries::time(double t) const {
  const Eigen::Index own = row(kTime);
  double sum = motion_.numbers(own, kOrder);
  for (int k = kOrder - 1; k >= 0; --k) sum = sum * t + motion_.numbers(own, k);
  return sum;
}

void ContactSeries::begin(const Sprung& rates, const State& z, double s, double r) {
  const double roundings = 4.0 * std::numeric_limits<double>::epsilon();
  start_ = z;
  root_[0] = r;
  auto first = motion_.at(0);
  first.head(2 * modes_) = Eigen::Map<const Vector>(z.data(), 2 * modes_);
  for (const Row work : {kForcing, kDissipation, kLost}) first[row(work)] = z[places_[work]];
  const double phase = rates.start_phase() + rates.frequency() * s;
  first[row(kTime)] = 0.0;
  first[row(kCosine)] = std::cos(phase);
  first[row(kSine)] = std::sin(phase);
  sizes_.head(row(kTime)) =
      (tolerance_ + roundings * first.head(row(kTime)).array().abs()).inverse();
  sizes_[row(kTime)] = frequency_ / tolerance_;
  sizes_[row(kCosine)] = sizes_[row(kSine)] = 1.0 / (tolerance_ + roundings);
}

// Adds the known coefficients to those of t^k of the products, all but the last left factor times
// the first right one.
void ContactSeries::begin_products(int k) {
  for (Eigen::Index first = 0; first < left_.rows; first += kGroup) {
    Group sum = Group::Zero();
    for (int i = 0; i < k; ++i) sum += left_.group(first, i) * right_.group(first, k - i);
    products_.segment<kGroup>(first) = sum;
  }
}

double ContactSeries::square_of_root(int k) const {
  double sum = 0.0;
  for (int i = 0; 2 * i < k; ++i)
    sum += root_[static_cast<std::size_t>(i)] * root_[static_cast<std::size_t>(k - i)];
  const double middle = k % 2 == 0 ? root_[static_cast<std::size_t>(k / 2)] : 0.0;
  return 2.0 * sum + middle * middle;
}

// Takes the next coefficient of a left factor; returns that of the product.
double ContactSeries::product(Eigen::Index factor, int k, double left) {
  left_.numbers(factor, k) = left;
  return products_[factor] + left * right_.numbers(factor, 0);
}

// Coefficient k of the force, N; in `lost` that of the power of its damping, over the unit squared.
double ContactSeries::force(int k, double* lost) {
  double powers[kMostPower + 1] = {};
  powers[1] = root_[static_cast<std::size_t>(k)];
  powers[2] = square_of_root(k);
  for (int p = 2; p < power_; ++p) powers[p + 1] = product(p - 2, k, powers[p]);
  const double elastic = unit_power_ * powers[power_];
  double resistance = 0.0;
  if (law_.damping == ContactDamping::kConstant && k == 0) resistance = law_.coefficient;
  if (law_.damping == ContactDamping::kDepth) resistance = law_.coefficient * depth_ * powers[2];
  if (law_.damping == ContactDamping::kPower) resistance = law_.coefficient * elastic;
  const double drag = product(factor(kResistance), k, resistance);
  *lost = product(factor(kDrag), k, drag);
  return law_.stiffness * elastic + drag;
}

// The rates in s, and the powers as Sprung has them.
void ContactSeries::add_slopes(const Sprung& rates, int k) {
  const SprungSystem& system = rates.system();
  const double* const moved = &motion_.numbers(0, k);
  const double* const velocity = moved + modes_;
  const double* const forcing = moved + row(kForcing);
  double* const slope = &slopes_.numbers(0, k);
  double* const acceleration = slope + modes_;
  const double cosine = rates.frequency() > 0.0 ? forcing[kCosine] : 0.0;
  const double unit = rates.unit(), work = unit * unit / rates.work_unit();
  const Vector& row_rate = rates.contact(spring_).rate;
  double* const right = &right_.numbers(0, k);
  double speed = 0.0, power = 0.0;
  for (Eigen::Index j = 0; j < modes_; ++j) {
    slope[j] = rates.scale()[j] * velocity[j];
    speed += row_rate[j] * velocity[j];
    power += rates.harmonic()[j] * velocity[j];
    right[factor(kResisted) + j] = work * velocity[j];
  }
  speed_[static_cast<std::size_t>(k)] = speed;
  for (int p = 2; p < power_; ++p) right[p - 2] = root_[static_cast<std::size_t>(k)];
  right[factor(kResistance)] = speed;
  right[factor(kDrag)] = speed / (unit * unit);
  right[factor(kHarmonic)] = work * power;
  begin_products(k);
  const double force = this->force(k, &slope[row(kLost)]) / unit;
  Eigen::Map<Vector> resisted(resisted_.data(), modes_), pulled(pulled_.data(), modes_);
  multiply(system.damping, Eigen::Map<const Vector>(velocity, modes_), resisted);
  multiply(rates.stiffness(), Eigen::Map<const Vector>(moved, modes_), pulled);
  double dissipation = 0.0;
  const Vector& acting = system.springs[spring_].acting;
  for (Eigen::Index j = 0; j < modes_; ++j) {
    dissipation += product(factor(kResisted) + j, k, resisted[j]);
    acceleration[j] = cosine * rates.harmonic()[j] - pulled[j] - resisted[j] - force * acting[j];
    if (k == 0) acceleration[j] += rates.push()[j];
  }
  slope[row(kForcing)] = product(factor(kHarmonic), k, cosine);
  slope[row(kDissipation)] = dissipation;
  slope[row(kTime)] = k == 0 ? 1.0 : 0.0;
  slope[row(kCosine)] = -rates.frequency() * forcing[kSine];
  slope[row(kSine)] = rates.frequency() * forcing[kCosine];
}

// The next coefficients, from the rates in s times 2 r/w.
void ContactSeries::integrate(int k) {
  const auto at = static_cast<std::size_t>(k);
  const double factor = 2.0 / (frequency_ * (k + 1));
  for (Eigen::Index first = 0; first < motion_.rows; first += kGroup) {
    Group sum = Group::Zero();
    for (int i = 0; i <= k; ++i)
      sum += root_[static_cast<std::size_t>(k - i)] * slopes_.group(first, i);
    motion_.group(first, k + 1) = factor * sum;
  }
  root_[at + 1] = speed_[at] / (depth_ * frequency_ * (k + 1));
}

// The largest coefficient of t^k, each relative to the error that its row may have; NaN if one is.
double ContactSeries::size(int k) const {
  const double root = std::abs(root_[static_cast<std::size_t>(k)]) / tolerance_;
  const double rows = motion_.at(k).cwiseProduct(sizes_).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  return std::isnan(rows) || rows > root ? rows : root;
}

// The length at which the terms of the highest order, K, equal the error that a step may have; the
// remaining terms are smaller. Each of the last orders k gives the radius by which sizes fall from
// the first, (c_0/c_k)^(1/k), and with it the length at which the terms of order K are that small.
bool ContactSeries::measure() {
  length_ = kLongest;
  const double first = std::log(std::fmax(1.0, size(0)));
  for (int k = kOrder - kTelling + 1; k <= kOrder; ++k) {
    const double own = size(k);
    if (!std::isfinite(own)) return false;
    if (own > 0.0)
      length_ = std::fmin(length_, std::exp((first - std::log(own)) / k - first / kOrder));
  }
  return length_ > 0.0 && std::isfinite(root_[0]);
}

bool ContactSeries::expand(const Sprung& rates, const State& z, double s, double r) {
  begin(rates, z, s, r);
  for (int k = 0; k < kOrder; ++k) {
    add_slopes(rates, k);
    integrate(k);
  }
  return measure();
}

double ContactSeries::surface() const {
  double end = length_;
  if (!(root(end) <= 0.0)) {
    // A root that falls at the start and rises at the end may have been below zero between them.
    if (!(root_[1] < 0.0 && root_rate(end) > 0.0)) return 0.0;
    const auto rate = [&](double t) {
      double slope = 0.0;
      for (int k = kOrder; k >= 2; --k)
        slope = slope * t + k * (k - 1) * root_[static_cast<std::size_t>(k)];
      return std::pair(root_rate(t), slope);
    };
    end = newton_between(rate, 0.0, end, 0.5 * end);
    if (!(root(end) <= 0.0)) return 0.0;
  }
  return newton_between([&](double t) { return std::pair(-root(t), -root_rate(t)); }, 0.0, end,
                        end);
}

double ContactSeries::instant(double seconds, double end) const {
  // The first guess is from the first two terms of the time.
  const double passed = 0.5 * frequency_ * seconds;
  const double square = root_[0] * root_[0] + 2.0 * root_[1] * passed;
  const double guess = square > 0.0 ? 2.0 * passed / (root_[0] + std::sqrt(square)) : end;
  return newton_between(
      [&](double t) { return std::pair(time(t) - seconds, 2.0 * root(t) / frequency_); }, 0.0, end,
      guess < end ? guess : end);
}

void ContactSeries::state(double t, State& z) {
  z = start_;
  for (Eigen::Index first = 0; first < motion_.rows; first += kGroup) {
    Group sum = motion_.group(first, kOrder);
    for (int k = kOrder - 1; k >= 0; --k) sum = sum * t + motion_.group(first, k);
    values_.segment<kGroup>(first) = sum;
  }
  Eigen::Map<Vector>(z.data(), 2 * modes_) = values_.head(2 * modes_);
  for (const Row work : {kForcing, kDissipation, kLost}) z[places_[work]] = values_[row(work)];
}

}  // namespace graze::step_walk
