// The force of a compliant stop,
//
//   F(x, v) = k x^n + C T(x) v,   x the depth (> 0) by which the gap is overrun, v = x',
//
// with n = 1 (linear), 3/2 (Hertz) or any other, and a damping that is
//
//   constant     T = 1                                    Kelvin-Voigt
//   depth        T = x                                    Lee & Wang's first
//   onset        T = e^{2 Q (x - h)/h} up to x = h, then 1   Lee & Wang's second: it sets in over
//                                                         the depth h, from e^{-2Q} on
//   step         T = 3 (x/h)^2 - 2 (x/h)^3 up to x = h, then 1   IMPACT and BISTOP of Adams
//   power        T = x^n                                  Hunt & Crossley, Lankarani & Nikravesh,
//                                                         Flores et al.
//   approach     T = x^((n-1)/2) while v > 0, then 0      Jankowski
//   capped       C v, but no more than k x^n either way   ElastoGap of Modelica
//
// A contact ends where F falls through zero, or where x does (then F pulls at last).
//   A. S. Yigit, A. G. Ulsoy, R. A. Scott, J. Sound Vib. 137 (1990) 183-203, eqs. 26 to 33.
//   K. H. Hunt, F. R. E. Crossley, J. Appl. Mech. 42 (1975) 440-445.
//   R. Jankowski, Earthquake Engng Struct. Dyn. 34 (2005) 595-611.
#pragma once

#include <cmath>

namespace graze {

enum class ContactDamping {
  kNone,
  kConstant,
  kDepth,
  kOnset,
  kPower,
  kStep,
  kApproach,
  kCapped
};
enum class Separation { kAtZeroForce, kAtZeroDepth };

struct ContactForce {
  double stiffness = 0.0;  // k, N/m^n
  double exponent = 1.0;   // n, >= 1
  ContactDamping damping = ContactDamping::kNone;
  // C: N s/m, but N s/m^2 (depth), N s/m^(n+1) (power), N s/m^((n+1)/2) (approach)
  double coefficient = 0.0;
  double onset_depth = 0.0;      // h, m
  double onset_sharpness = 0.0;  // Q
  Separation separation = Separation::kAtZeroForce;
  bool operator==(const ContactForce&) const = default;

  // x^n; below the surface of the stop its odd continuation, as a time step may end there.
  double power(double x) const {
    if (exponent == 1.0) return x;
    if (exponent == 1.5) return x * std::sqrt(std::abs(x));
    return std::copysign(std::pow(std::abs(x), exponent), x);
  }
  // dx^n/dx
  double power_slope(double x) const {
    if (exponent == 1.0) return 1.0;
    if (exponent == 1.5) return 1.5 * std::sqrt(std::abs(x));
    return exponent * std::pow(std::abs(x), exponent - 1.0);
  }
  // C T(x)
  double resistance(double x) const {
    switch (damping) {
      case ContactDamping::kNone:
        return 0.0;
      case ContactDamping::kConstant:
      case ContactDamping::kCapped:
        return coefficient;
      case ContactDamping::kStep:
        return coefficient * step(x);
      case ContactDamping::kApproach:
        return coefficient * std::pow(std::abs(x), 0.5 * (exponent - 1.0));
      case ContactDamping::kDepth:
        return coefficient * x;
      case ContactDamping::kOnset:
        return coefficient * onset(x);
      case ContactDamping::kPower:
        return coefficient * power(x);
    }
    return 0.0;
  }
  // C dT/dx
  double resistance_slope(double x) const {
    switch (damping) {
      case ContactDamping::kNone:
      case ContactDamping::kConstant:
      case ContactDamping::kCapped:
        return 0.0;
      case ContactDamping::kDepth:
        return coefficient;
      case ContactDamping::kStep:
        return 0.0 < x && x < onset_depth
                   ? 6.0 * coefficient * x * (onset_depth - x) / std::pow(onset_depth, 3.0)
                   : 0.0;
      case ContactDamping::kApproach:
        return exponent == 1.0 || x == 0.0 ? 0.0 : 0.5 * (exponent - 1.0) * resistance(x) / x;
      case ContactDamping::kOnset:
        return x < onset_depth ? 2.0 * onset_sharpness / onset_depth * resistance(x) : 0.0;
      case ContactDamping::kPower:
        return coefficient * power_slope(x);
    }
    return 0.0;
  }

  // The part of the force that the damping makes, N; F.
  double resisting(double x, double v) const {
    if (!acts(x, v))
      return is_capped(x, v) ? std::copysign(stiffness * power(std::abs(x)), v) : 0.0;
    return resistance(x) * v;
  }
  double at(double x, double v) const { return stiffness * power(x) + resisting(x, v); }
  // dF/dx, N/m, and dF/dv, N s/m.
  double by_depth(double x, double v) const {
    const double elastic = stiffness * power_slope(x);
    if (!acts(x, v)) return is_capped(x, v) ? elastic + std::copysign(elastic, v) : elastic;
    return elastic + resistance_slope(x) * v;
  }
  double by_rate(double x, double v) const { return acts(x, v) ? resistance(x) : 0.0; }
  // Derivative of F at fixed x and v when the numbers of the law move along `rates`.
  double rate_at(double x, double v, const ContactForce& rates) const;
  // F divided by the power of x that all its terms share: it has the sign of F for x > 0, but not
  // the zero of F at x = 0. N, or N/m^n (power), N/m (depth).
  double grip(double x, double v) const {
    switch (damping) {
      case ContactDamping::kNone:
      case ContactDamping::kApproach:
      case ContactDamping::kCapped:
        return stiffness;
      case ContactDamping::kConstant:
      case ContactDamping::kOnset:
        return at(x, v);
      case ContactDamping::kDepth:
        return stiffness * std::pow(std::abs(x), exponent - 1.0) + coefficient * v;
      case ContactDamping::kStep:
        return stiffness * std::pow(std::abs(x), exponent - 1.0) + coefficient * step_share(x) * v;
      case ContactDamping::kPower:
        return stiffness + coefficient * v;
    }
    return 0.0;
  }
  // The sum of the absolute values of the terms of grip().
  double grip_size(double x, double v) const {
    const double speed = std::abs(v);
    switch (damping) {
      case ContactDamping::kNone:
      case ContactDamping::kApproach:
      case ContactDamping::kCapped:
        return stiffness;
      case ContactDamping::kStep:
        return grip(x, speed);
      case ContactDamping::kConstant:
      case ContactDamping::kOnset:
        return stiffness * std::abs(power(x)) + std::abs(resistance(x)) * speed;
      case ContactDamping::kDepth:
        return stiffness * std::pow(std::abs(x), exponent - 1.0) + coefficient * speed;
      case ContactDamping::kPower:
        return stiffness + coefficient * speed;
    }
    return 0.0;
  }
  // Rate of change of grip() where the depth has the acceleration a.
  double grip_rate(double x, double v, double a) const {
    const auto elastic_slope = [&] {
      return exponent == 1.0 || x == 0.0
                 ? 0.0
                 : stiffness * (exponent - 1.0) * std::pow(std::abs(x), exponent - 2.0) *
                       std::copysign(1.0, x);
    };
    switch (damping) {
      case ContactDamping::kNone:
      case ContactDamping::kApproach:
      case ContactDamping::kCapped:
        return 0.0;
      case ContactDamping::kConstant:
      case ContactDamping::kOnset:
        return by_depth(x, v) * v + resistance(x) * a;
      case ContactDamping::kDepth:
        return elastic_slope() * v + coefficient * a;
      case ContactDamping::kStep: {
        const double h = onset_depth;
        const double slope = x < h ? (3.0 - 4.0 * x / h) / (h * h) : -1.0 / (x * x);
        return elastic_slope() * v + coefficient * (slope * v * v + step_share(x) * a);
      }
      case ContactDamping::kPower:
        return coefficient * a;
    }
    return 0.0;
  }
  // Whether F can fall to zero before x does.
  bool parts_early() const {
    return separation == Separation::kAtZeroForce && damping != ContactDamping::kNone &&
           damping != ContactDamping::kApproach && damping != ContactDamping::kCapped;
  }
  // Energy stored in the spring, J.
  double stored(double x) const { return stiffness * power(x) * x / (exponent + 1.0); }
  // The depth that stores as much, m: an impact with that kinetic energy presses no deeper.
  double depth_storing(double energy) const {
    return std::pow((exponent + 1.0) * energy / stiffness, 1.0 / (exponent + 1.0));
  }
  // Whether F is zero at the onset of a contact at speed v > 0: else the force jumps there.
  bool sets_in_smoothly() const {
    return damping != ContactDamping::kConstant && damping != ContactDamping::kOnset &&
           !(damping == ContactDamping::kApproach && exponent == 1.0);
  }
  // N s/m: by this times the speed the force jumps where a contact begins at the surface, or ends.
  double jump_at_surface(bool begins) const {
    if (damping == ContactDamping::kApproach && !begins) return 0.0;
    return damping == ContactDamping::kNone || damping == ContactDamping::kCapped ? 0.0
                                                                                  : resistance(0.0);
  }
  // Whether one formula holds from the beginning of a contact to its end, but for an onset.
  bool is_of_one_piece() const {
    return damping != ContactDamping::kStep && damping != ContactDamping::kApproach &&
           damping != ContactDamping::kCapped;
  }

 private:
  bool is_capped(double x, double v) const {
    return damping == ContactDamping::kCapped &&
           coefficient * std::abs(v) >= stiffness * power(std::abs(x));
  }
  // Whether the damping is C T(x) v there.
  bool acts(double x, double v) const {
    if (damping == ContactDamping::kApproach) return v > 0.0;
    return damping != ContactDamping::kNone && !is_capped(x, v);
  }
  // T of a step, and T/x.
  double step(double x) const { return x * step_share(x); }
  double step_share(double x) const {
    if (!(x > 0.0)) return 0.0;
    const double part = x / onset_depth;
    return part < 1.0 ? part * (3.0 - 2.0 * part) / onset_depth : 1.0 / x;
  }
  double onset(double x) const {
    return x < onset_depth ? std::exp(2.0 * onset_sharpness * (x - onset_depth) / onset_depth)
                           : 1.0;
  }
};

}  // namespace graze
