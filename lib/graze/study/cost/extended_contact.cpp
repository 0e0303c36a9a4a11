#include "graze/study/cost/detail/extended_contact.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace graze {
namespace {

using Numbers = RealVector<Extended>;

// Extrapolations within a step: order 2 more for each.
constexpr int kColumns = 14;
// Relative to the expected duration of the contact: the first step, and the remaining time below
// which the contact is a straight line to second order.
constexpr double kFirstStep = 1e-10, kLastStep = 1e-12;
constexpr double kGrowth = 1.6;
// A contact takes some hundred steps; with many modes more, as these oscillate.
constexpr int kMostContactSteps = 200000;

Extended power(const Extended& x, double exponent) {
  if (exponent == 0.0) return 1;
  if (exponent == 1.0) return x;
  if (exponent == 2.0) return x * x;
  const Extended size = abs(x);
  const Extended whole = exponent == 0.5   ? Extended(sqrt(size))
                         : exponent == 1.5 ? Extended(size * sqrt(size))
                         : size == 0       ? Extended(0)
                                           : Extended(pow(size, Extended(exponent)));
  return x < 0 ? Extended(-whole) : whole;
}

// A quantity that ends the contact when it falls through zero.
struct Falling {
  Extended value, rate;
};

// The law, at depth x and rate v, one of one piece.
class Law {
 public:
  explicit Law(const ContactForce& law) : law_(law) {}

  Extended force(const Extended& x, const Extended& v) const {
    return elastic(x) + law_.coefficient * shape(x) * v;
  }
  Extended elastic(const Extended& x) const { return law_.stiffness * power(x, law_.exponent); }
  bool parts_early() const { return law_.parts_early(); }
  // The force divided by the power of x that all its terms share, which falls through zero with the
  // force, and its rate at the acceleration a.
  Falling grip(const Extended& x, const Extended& v, const Extended& a) const {
    const double n = law_.exponent, c = law_.coefficient, k = law_.stiffness;
    switch (law_.damping) {
      case ContactDamping::kNone:
      case ContactDamping::kStep:
      case ContactDamping::kApproach:
      case ContactDamping::kCapped:
        break;
      case ContactDamping::kConstant:
      case ContactDamping::kOnset:
        return {force(x, v),
                k * n * power(x, n - 1.0) * v + c * (shape_slope(x) * v * v + shape(x) * a)};
      case ContactDamping::kDepth:
        return {k * power(x, n - 1.0) + c * v,
                (n == 1.0 ? Extended(0) : Extended(k * (n - 1.0) * power(x, n - 2.0) * v)) + c * a};
      case ContactDamping::kPower:
        return {k + c * v, c * a};
    }
    return {k, 0};
  }

 private:
  // T(x)
  Extended shape(const Extended& x) const {
    switch (law_.damping) {
      case ContactDamping::kNone:
      case ContactDamping::kStep:
      case ContactDamping::kApproach:
      case ContactDamping::kCapped:
        return 0;
      case ContactDamping::kConstant:
        return 1;
      case ContactDamping::kDepth:
        return x;
      case ContactDamping::kOnset:
        return x < law_.onset_depth ? Extended(exp(2.0 * law_.onset_sharpness *
                                                   (x - law_.onset_depth) / law_.onset_depth))
                                    : Extended(1);
      case ContactDamping::kPower:
        return power(x, law_.exponent);
    }
    return 0;
  }
  // Derivative of T where the damping sets in.
  Extended shape_slope(const Extended& x) const {
    if (law_.damping != ContactDamping::kOnset || !(x < law_.onset_depth)) return 0;
    return 2.0 * law_.onset_sharpness / law_.onset_depth * shape(x);
  }

  const ContactForce& law_;
};

// x = (q, q', cos, sin of the forcing): with the last two the equations are autonomous.
class Equations {
 public:
  Equations(const System& system, int stop)
      : system_(system),
        stop_(system.stops[static_cast<std::size_t>(stop)]),
        law_(stop_.force()),
        row_(stop_.row.cast<Extended>()),
        stiffness_(system.omega.cast<Extended>().cwiseAbs2()),
        damping_(2 * system.delta().cast<Extended>()),
        n_(system.omega.size()) {}

  Numbers pack(const Numbers& q, const Numbers& qdot, const Extended& theta) const {
    Numbers x(2 * n_ + 2);
    x << q, qdot, cos(theta), sin(theta);
    return x;
  }
  Numbers q(const Numbers& x) const { return x.head(n_); }
  Numbers qdot(const Numbers& x) const { return x.segment(n_, n_); }
  Extended depth(const Numbers& x) const { return row_.dot(x.head(n_)) - Extended(stop_.gap); }
  Extended rate(const Numbers& x) const { return row_.dot(x.segment(n_, n_)); }

  Numbers slope(const Numbers& x) const {
    Numbers slope(x.size());
    slope.head(n_) = x.segment(n_, n_);
    auto acceleration = slope.segment(n_, n_);
    acceleration = -damping_.cwiseProduct(x.segment(n_, n_)) - stiffness_.cwiseProduct(x.head(n_));
    if (system_.load()) acceleration += system_.load()->cast<Extended>();
    slope.tail(2).setZero();
    if (system_.forcing()) {
      acceleration += x[2 * n_] * system_.forcing()->amplitude.cast<Extended>();
      slope[2 * n_] = -system_.forcing()->frequency * x[2 * n_ + 1];
      slope[2 * n_ + 1] = system_.forcing()->frequency * x[2 * n_];
    }
    if (loaded) acceleration -= law_.force(depth(x), rate(x)) * row_;
    return slope;
  }
  // A contact ends where its depth does, or its force before that.
  std::vector<Falling> ends(const Numbers& x) const {
    std::vector<Falling> ends = {{depth(x), rate(x)}};
    if (loaded && law_.parts_early())
      ends.push_back(law_.grip(depth(x), rate(x), row_.dot(slope(x).segment(n_, n_))));
    return ends;
  }
  bool ended(const Numbers& x) const {
    for (const Falling& end : ends(x))
      if (!(end.value > 0)) return true;
    return false;
  }
  // Whether the force exceeds what is left of it at the end of the contact.
  bool pushes(const Numbers& x) const {
    const Extended deep = depth(x);
    return law_.force(deep, rate(x)) > 1e-9 * law_.elastic(deep);
  }
  // Whether this error of a step h from x is allowed.
  bool allows(const Numbers& off, const Numbers& x, const Extended& h) const {
    const Extended speed = x.segment(n_, n_).norm();
    return off.head(n_).norm() <= kReferenceTolerance * (x.head(n_).norm() + h * speed) &&
           off.segment(n_, n_).norm() <= kReferenceTolerance * speed;
  }

  bool loaded = true;

 private:
  const System& system_;
  const Stop& stop_;
  Law law_;
  Numbers row_, stiffness_, damping_;
  Eigen::Index n_;
};

// A step of the modified midpoint rule in `parts`.
Numbers midpoint(const Equations& equations, const Numbers& x, const Numbers& first,
                 const Extended& step, int parts) {
  const Extended h = step / parts;
  Numbers before = x, at = x + h * first;
  for (int i = 1; i < parts; ++i) {
    Numbers next = before + 2 * h * equations.slope(at);
    before = std::move(at);
    at = std::move(next);
  }
  return (before + at + h * equations.slope(at)) / 2;
}

struct Extrapolated {
  Numbers x;
  int columns = 0;
};

// Returns nullopt when the extrapolations do not agree, or it was asked to stop.
std::optional<Extrapolated> extrapolate(const Equations& equations, const Numbers& x,
                                        const Extended& step, const StopSignal& stop) {
  const Numbers first = equations.slope(x);
  std::vector<Numbers> last, row;
  for (int j = 0; j < kColumns; ++j) {
    // A column of 400 modes takes some ten milliseconds.
    if (stop.requested()) return {};
    row = {midpoint(equations, x, first, step, 2 * (j + 1))};
    for (int k = 1; k <= j; ++k) {
      const Extended ratio = Extended(j + 1) / (j + 1 - k);
      const Numbers& finer = row[static_cast<std::size_t>(k - 1)];
      row.push_back(finer + (finer - last[static_cast<std::size_t>(k - 1)]) / (ratio * ratio - 1));
    }
    if (j >= 2 &&
        equations.allows(row[static_cast<std::size_t>(j)] - row[static_cast<std::size_t>(j - 1)], x,
                         step))
      return Extrapolated{row.back(), j + 1};
    last = std::move(row);
  }
  return {};
}

class Follower {
 public:
  Follower(const System& system, int stop, const ExtendedContactOptions& options)
      : system_(system), stop_(stop), options_(options), equations_(system, stop) {}

  ExtendedContact follow(const Numbers& q, const Numbers& qdot) {
    x_ = equations_.pack(q, qdot, options_.theta);
    unit_ = expected_duration();
    run_to_end();
    result_.separation = result_.end = s_;
    // After a contact that ended at zero depth only a remainder of the depth is left.
    if (result_.message.empty() &&
        equations_.depth(x_) > kLastStep * unit_ * abs(equations_.rate(x_))) {
      equations_.loaded = false;
      run_to_end();
      result_.end = s_;
    }
    result_.q = equations_.q(x_);
    result_.qdot = equations_.qdot(x_);
    return result_;
  }

 private:
  // Duration of an elastic contact of a body with the effective mass of the structure there.
  Extended expected_duration() const {
    const Stop& stop = system_.stops[static_cast<std::size_t>(stop_)];
    const double n = stop.force().exponent + 1.0;
    const double speed = static_cast<double>(equations_.rate(x_));
    const double stiffness = stop.force().stiffness * stop.row.squaredNorm();
    return 3.0 * std::pow(0.5 * n * speed * speed / stiffness, 1.0 / n) / speed;
  }

  void run_to_end() {
    Extended h = kFirstStep * unit_;
    for (int i = 0; i < kMostContactSteps; ++i) {
      if (!goes_on()) return;
      const std::optional<Extended> left = time_left();
      const bool last = left && *left < kLastStep * unit_;
      const Extended step = last ? *left : left && *left < 2 * h ? Extended(*left / 2) : h;
      const auto next = extrapolate(equations_, x_, step, options_.stop);
      // Beyond the end the equations are others.
      if (!next || (!last && equations_.ended(next->x))) {
        h = step / 2;
        continue;
      }
      x_ = next->x;
      s_ += step;
      if (last) return;
      h = next->columns + 3 <= kColumns ? Extended(kGrowth * step) : step;
    }
    result_.message = "a contact took too many steps";
  }

  // Time to the end, along straight lines; nullopt when no end is approached.
  std::optional<Extended> time_left() const {
    std::optional<Extended> left;
    for (const Falling& end : equations_.ends(x_))
      if (end.rate < 0 && (!left || -end.value / end.rate < *left)) left = -end.value / end.rate;
    return left;
  }

  bool goes_on() {
    if (options_.stop.requested())
      result_.message = "stopped during a contact";
    else if (s_ > options_.longest)
      result_.message = "a contact lasts longer than that";
    else if (!equations_.loaded && equations_.pushes(x_))
      result_.message = "a spring whose force was gone takes hold again";
    for (std::size_t i = 0; i < system_.stops.size(); ++i) {
      const Stop& other = system_.stops[i];
      if (static_cast<int>(i) != stop_ &&
          other.row.cast<Extended>().dot(equations_.q(x_)) >= other.gap)
        result_.message = "another stop is reached during a contact";
    }
    return result_.message.empty();
  }

  const System& system_;
  int stop_;
  const ExtendedContactOptions& options_;
  Equations equations_;
  Numbers x_;
  Extended s_ = 0, unit_ = 1;
  ExtendedContact result_;
};

}  // namespace

ExtendedContact follow_contact(const System& system, int stop, RealVector<Extended> q,
                               RealVector<Extended> qdot, const ExtendedContactOptions& options) {
  return Follower(system, stop, options).follow(q, qdot);
}

}  // namespace graze
