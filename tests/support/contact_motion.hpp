// The motion between two events of contact_reference.hpp: forces by the laws alone, steps by
// Gragg's and Bulirsch's extrapolation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "graze/system/system.hpp"

namespace graze::support {

class ContactMotion {
 public:
  ContactMotion(const System& system, const State& start)
      : system_(system), held_(system.stops.size(), false), springs_(system.stops.size(), kOpen) {
    y_.resize(2 * system.modes());
    y_ << start.q, start.qdot;
    for (int i = 0; i < stops(); ++i)
      if (stop(i).is_compliant() && depth(i, y_) > 0.0)
        springs_[at(i)] = holds(i, y_) ? kLoaded : kParted;
  }

 protected:
  enum Spring { kOpen, kLoaded, kParted };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int stops() const { return static_cast<int>(system_.stops.size()); }
  const Stop& stop(int i) const { return system_.stops[at(i)]; }
  int n() const { return system_.modes(); }
  double depth(int i, const Vector& y) const { return stop(i).row.dot(y.head(n())) - stop(i).gap; }
  double speed(int i, const Vector& y) const { return stop(i).row.dot(y.tail(n())); }

  static double damping_over_power(const ContactForce& law, double x, double v) {
    switch (law.damping) {
      case ContactDamping::kStep: {
        const double s = std::min(x / law.onset_depth, 1.0);
        return law.coefficient * s * s * (3.0 - 2.0 * s);
      }
      case ContactDamping::kApproach:
        return v > 0.0 ? law.coefficient * std::pow(x, 0.5 * (law.exponent - 1.0)) : 0.0;
      case ContactDamping::kCapped:
        return std::min(law.coefficient, law.stiffness * std::pow(x, law.exponent) / std::fabs(v));
      case ContactDamping::kConstant:
        return law.coefficient;
      case ContactDamping::kOnset:
        return law.coefficient *
               std::exp(std::min(2.0 * law.onset_sharpness * (x / law.onset_depth - 1.0), 0.0));
      case ContactDamping::kDepth:
      case ContactDamping::kPower:
        return law.coefficient;
      case ContactDamping::kNone:
        break;
    }
    return 0.0;
  }
  // F over the power of x that all terms hold.
  double grip(int i, const Vector& y) const {
    const ContactForce& law = stop(i).force();
    const double x = std::fmax(depth(i, y), 0.0), v = speed(i, y);
    const double damped = damping_over_power(law, x, v) * v;
    if (law.damping == ContactDamping::kDepth)
      return law.stiffness * std::pow(x, law.exponent - 1.0) + damped;
    if (law.damping == ContactDamping::kPower) return law.stiffness + damped;
    return law.stiffness * std::pow(x, law.exponent) + damped;
  }
  double force(int i, const Vector& y) const {
    const ContactForce& law = stop(i).force();
    const double x = std::fmax(depth(i, y), 0.0);
    if (law.damping == ContactDamping::kDepth) return x * grip(i, y);
    if (law.damping == ContactDamping::kPower) return std::pow(x, law.exponent) * grip(i, y);
    return grip(i, y);
  }
  bool lets_go(int i) const {
    const ContactForce& law = stop(i).force();
    return law.separation == Separation::kAtZeroForce && law.damping != ContactDamping::kNone;
  }
  bool holds(int i, const Vector& y) const { return !lets_go(i) || grip(i, y) >= 0.0; }

  Vector free_acceleration(double t, const Vector& y) const {
    Vector a = -system_.omega.cwiseAbs2().cwiseProduct(y.head(n())) -
               2.0 * system_.delta().cwiseProduct(y.tail(n()));
    if (system_.load()) a += *system_.load();
    if (const HarmonicForcing* f = system_.forcing())
      a += f->amplitude * std::cos(f->frequency * t + f->phase);
    for (int i = 0; i < stops(); ++i)
      if (springs_[at(i)] == kLoaded) a -= force(i, y) * stop(i).row;
    return a;
  }
  std::vector<int> held() const {
    std::vector<int> list;
    for (int i = 0; i < stops(); ++i)
      if (held_[at(i)]) list.push_back(i);
    return list;
  }
  // That bring what these stops see of the vector to the targets: D p = seen - target.
  Vector impulses(const std::vector<int>& on, const Vector& of, const Vector& target) const {
    const auto k = static_cast<Eigen::Index>(on.size());
    Matrix d(k, k);
    Vector seen(k);
    for (Eigen::Index a = 0; a < k; ++a) {
      seen[a] = stop(on[static_cast<std::size_t>(a)]).row.dot(of) - target[a];
      for (Eigen::Index b = 0; b < k; ++b)
        d(a, b) = stop(on[static_cast<std::size_t>(a)])
                      .row.dot(stop(on[static_cast<std::size_t>(b)]).row);
    }
    if (k == 1) return seen / d(0, 0);
    const double det = d(0, 0) * d(1, 1) - d(0, 1) * d(1, 0);
    return Vector{{(d(1, 1) * seen[0] - d(0, 1) * seen[1]) / det,
                   (d(0, 0) * seen[1] - d(1, 0) * seen[0]) / det}};
  }
  Vector forces(double t, const Vector& y, const std::vector<int>& on) const {
    return impulses(on, free_acceleration(t, y),
                    Vector::Zero(static_cast<Eigen::Index>(on.size())));
  }
  Vector rate(double t, const Vector& y) const {
    Vector a = free_acceleration(t, y);
    const std::vector<int> on = held();
    if (!on.empty()) {
      const Vector f = forces(t, y, on);
      for (std::size_t k = 0; k < on.size(); ++k)
        a -= f[static_cast<Eigen::Index>(k)] * stop(on[k]).row;
    }
    Vector out(2 * n());
    out << y.tail(n()), a;
    return out;
  }

  // One step of h by Gragg's midpoint rule with 2, 4 .. 12 parts, extrapolated; its error.
  Vector moved(double h, double* error = nullptr) const {
    constexpr int kRows = 6;
    std::array<Vector, kRows> table;
    Vector before;
    const Vector first = rate(time_, y_);
    for (int row = 0; row < kRows; ++row) {
      const int parts = 2 * (row + 1);
      const double part = h / parts;
      Vector a = y_, b = y_ + part * first;
      for (int k = 1; k < parts; ++k) {
        const Vector c = a + 2.0 * part * rate(time_ + k * part, b);
        a = b;
        b = c;
      }
      Vector value = 0.5 * (a + b + part * rate(time_ + h, b));
      for (int column = 1; column <= row; ++column) {
        const double ratio = (row + 1.0) / (row + 1.0 - column);
        const Vector next =
            value + (value - table[static_cast<std::size_t>(column - 1)]) / (ratio * ratio - 1.0);
        table[static_cast<std::size_t>(column - 1)] = value;
        value = next;
      }
      if (row == kRows - 1) before = table[kRows - 2];
      table[static_cast<std::size_t>(row)] = value;
    }
    const Vector& end = table[kRows - 1];
    if (error) *error = (end - before).norm() / (1.0 + end.norm());
    return end;
  }

  double longest_step() const {
    double quickest = system_.omega.maxCoeff();
    if (system_.forcing()) quickest = std::fmax(quickest, system_.forcing()->frequency);
    for (int i = 0; i < stops(); ++i)
      if (springs_[at(i)] != kOpen) {
        const ContactForce& law = stop(i).force();
        const double mobility = stop(i).row.squaredNorm();
        // Where a damping sets in it changes within h/(2 Q).
        if (law.damping == ContactDamping::kOnset)
          quickest += 2.0 * law.onset_sharpness / law.onset_depth * std::abs(speed(i, y_));
        quickest += std::sqrt(law.exponent * law.stiffness * mobility) + law.coefficient * mobility;
      }
    return 1.0 / quickest;
  }

  const System& system_;
  double time_ = 0.0;
  Vector y_;  // displacements and velocities
  std::vector<bool> held_;
  std::vector<Spring> springs_;
};

}  // namespace graze::support
