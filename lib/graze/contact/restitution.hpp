// The coefficient of restitution of a rigid stop, constant or falling with the approach speed v:
//
//   r(v) = a0 - a1 v - a2 v^2 - ..,   clamped to [0, 1]
//
// (Yigit, Ulsoy & Scott, J. Sound Vib. 137, 1990, for the linear one).
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace graze {

class Restitution {
 public:
  // Constant r. Not explicit: a number is a restitution.
  Restitution(double constant) : coefficients_{constant} {}  // NOLINT(google-explicit-constructor)
  // a0, a1, ..; at least one, a_i in (s/m)^i.
  explicit Restitution(std::vector<double> coefficients) : coefficients_(std::move(coefficients)) {}

  const std::vector<double>& coefficients() const { return coefficients_; }
  bool is_constant() const { return coefficients_.size() == 1; }
  // The limit v -> 0, which decides whether a chatter can complete (a0 < 1).
  double at_rest() const { return coefficients_.front(); }

  // The polynomial before it is clamped.
  template <class Real>
  Real unclamped(const Real& v) const {
    Real sum = 0;
    for (std::size_t i = coefficients_.size(); i-- > 1;) sum = (sum + coefficients_[i]) * v;
    return coefficients_.front() - sum;
  }
  template <class Real>
  Real at(const Real& v) const {
    const Real r = unclamped(v);
    return r < 0 ? Real(0) : r > 1 ? Real(1) : r;
  }
  // Whether r(v) had to be clamped.
  bool clamps_at(double v) const {
    const double r = unclamped(v);
    return r < 0.0 || r > 1.0;
  }

  // The jump of velocity at an impact of approach speed v, (1 + r(v)) v in m/s, with its first two
  // derivatives by v; and the derivatives of the jump and of its slope, at fixed v, when the
  // coefficients move along `rates`.
  double jump(double v) const { return (1.0 + at(v)) * v; }
  double jump_slope(double v) const { return 1.0 + at(v) + v * slope_at(v); }
  double jump_bend(double v) const { return 2.0 * slope_at(v) + v * curvature_at(v); }
  double jump_rate(double v, const Restitution& rates) const {
    return clamps_at(v) ? 0.0 : rates.unclamped(v) * v;
  }
  double jump_slope_rate(double v, const Restitution& rates) const {
    return clamps_at(v) ? 0.0 : rates.unclamped(v) + v * rates.unclamped_slope(v);
  }

 private:
  // dr/dv and d^2 r/dv^2; zero where r is clamped.
  double slope_at(double v) const { return clamps_at(v) ? 0.0 : unclamped_slope(v); }
  double curvature_at(double v) const {
    if (clamps_at(v)) return 0.0;
    double sum = 0.0;
    for (std::size_t i = coefficients_.size(); i-- > 2;)
      sum = sum * v + static_cast<double>(i * (i - 1)) * coefficients_[i];
    return -sum;
  }
  double unclamped_slope(double v) const {
    double sum = 0.0;
    for (std::size_t i = coefficients_.size(); i-- > 1;)
      sum = sum * v + static_cast<double>(i) * coefficients_[i];
    return -sum;
  }

  std::vector<double> coefficients_;
};

}  // namespace graze
