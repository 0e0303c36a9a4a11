// A contact with one spring as a power series, also where its force is not smooth. With the depth
// x = X r^2, a variable t takes the place of time s,
//
//   ds = (2 r/w) dt,   dr/dt = x'/(X w),   dz/dt = (2 r/w) dz/ds,
//
// w the frequency of the contact. A force k x^n = k X^n r^(2n) is a power of r for n = 3/2, and so
// are the dampings but one that sets in by an exponential: in t the equations are polynomials, at
// r = 0 too, where the contact begins at a speed and where it ends (time regularised as by
// Levi-Civita). The coefficients follow from each other by products of series. At rest on the
// surface t does not move: such a start has no series.
//   E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., VIII.2.
//   A. Jorba, M. Zou, Experimental Mathematics 14 (2005) 99-117: Taylor's method, its steps.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "graze/flow/stepped/detail/sprung_rates.hpp"

namespace graze::step_walk {

class ContactSeries {
 public:
  using State = Sprung::State;
  static constexpr int kOrder = 24;
  static constexpr int kMostPower = 6;

  // Whether the equations are such polynomials: one spring is loaded, with a whole 2n of at most
  // kMostPower and no exponential damping; there is no rotating hub and no stop with an oblique
  // law.
  static bool suits(const SprungSystem& system);

  // Requires suits(system). `tolerance`: error that a step may have, per unit of z.
  ContactSeries(const SprungSystem& system, double tolerance);

  // The loaded spring.
  std::size_t spring() const { return spring_; }
  // Takes the units from the piece that `rates` has begun.
  void set_units(const Sprung& rates);
  double root_at(double depth) const { return std::sqrt(depth / depth_); }
  // Expands the motion about the state z, s seconds after the start of the piece, with r there.
  // False where the series has no length: numbers that are not finite.
  bool expand(const Sprung& rates, const State& z, double s, double r);
  // The t up to which the series keeps the tolerance.
  double length() const { return length_; }
  // r and its rate, and the seconds since the start of the series, at t.
  double root(double t) const { return value(root_, t); }
  double root_rate(double t) const;
  double time(double t) const;
  // The first t up to the length where r falls through zero; 0 when it does not.
  double surface() const;
  // The t up to `end` at which so many seconds have passed.
  double instant(double seconds, double end) const;
  // The state at t.
  void state(double t, State& z);

 private:
  static constexpr int kGroup = 8;  // rows are multiplied in groups of so many
  using Group = Eigen::Array<double, kGroup, 1>;
  using Series = std::array<double, kOrder + 1>;
  // Rows after the displacements and velocities: the works, time, and the forcing.
  enum Row { kForcing, kDissipation, kLost, kTime, kCosine, kSine, kRows };
  // Coefficients of some quantities; those of one power of t are adjacent.
  struct Table {
    explicit Table(Eigen::Index given)
        : rows((given + kGroup - 1) / kGroup * kGroup), numbers(Matrix::Zero(rows, kOrder + 1)) {}
    Eigen::Index rows;
    Matrix numbers;
    auto at(int k) { return numbers.col(k); }
    auto at(int k) const { return numbers.col(k); }
    Eigen::Map<Group> group(Eigen::Index first, int k) {
      return Eigen::Map<Group>(&numbers(first, k));
    }
    Eigen::Map<const Group> group(Eigen::Index first, int k) const {
      return Eigen::Map<const Group>(&numbers(first, k));
    }
  };

  // The products of series: the powers of r from the third on, then the force of the damping, the
  // powers, and the resistance of each coordinate.
  enum Factor { kResistance, kDrag, kHarmonic, kResisted };

  static double value(const Series& series, double t);
  Eigen::Index row(Row of) const { return 2 * modes_ + of; }
  Eigen::Index factor(Factor of) const { return std::max(power_ - 2, 0) + of; }
  void begin(const Sprung& rates, const State& z, double s, double r);
  void begin_products(int k);
  double product(Eigen::Index factor, int k, double left);
  double square_of_root(int k) const;
  double force(int k, double* lost);
  void add_slopes(const Sprung& rates, int k);
  void integrate(int k);
  double size(int k) const;
  bool measure();

  Eigen::Index modes_;
  std::size_t spring_ = 0;
  ContactForce law_;
  int power_ = 1;  // 2n
  double tolerance_;
  double depth_ = 1.0, frequency_ = 1.0;  // X, m; w, rad/s
  double unit_power_ = 1.0;               // X^n
  Table motion_, slopes_;                 // the rows, and their rates in s
  Table left_, right_;                    // the factors of the products
  Vector products_;                       // the coefficients so far, not yet whole
  Vector resisted_, pulled_;              // by damping and stiffness
  Vector sizes_;                          // what a row may err by, inverted
  Vector values_;                         // of the rows at an instant
  Series root_{}, speed_{};               // r; x', m/s
  State start_;
  std::size_t places_[3] = {};  // of the works in z
  double length_ = 0.0;
};

}  // namespace graze::step_walk
