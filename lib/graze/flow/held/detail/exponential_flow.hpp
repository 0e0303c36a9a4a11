// Motion of a first-order linear system in an invariant subspace by its matrix exponential: for
// modes that are not well separated, are resonant with the force, too soft for the load, or grow.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/held/detail/first_order.hpp"

namespace graze {

class ExponentialFlow {
 public:
  // z' = T z + .. of the subspace x = basis z, z = coordinates x.
  ExponentialFlow(FirstOrderSystem system, Matrix basis, Matrix coordinates);

  // Longest flight without a cut, s: bounds grow with the flight.
  double longest_flight() const {
    return norm_growth_ > 0.0 ? 1.0 / norm_growth_ : std::numeric_limits<double>::infinity();
  }

 private:
  friend class ExponentialArc;
  friend class ExponentialSum;

  FirstOrderSystem system_;
  Matrix basis_, coordinates_;
  double norm_growth_ = 0.0;  // 1/s, of |z|
};

// One smooth piece of it; refers to its flow.
class ExponentialArc {
 public:
  explicit ExponentialArc(const ExponentialFlow& flow) : flow_(&flow) {}
  // `load` replaces that of the system, on x.
  void start(double theta, const Vector& x, const Vector& load);
  // The part of x(s) in the subspace.
  Vector state(double s) const { return flow_->basis_ * (z_ + change(s)); }

 private:
  friend class ExponentialSum;
  Vector change(double s) const;  // z(s) - z(0)
  // Bound on the rounding error of change(), from the size of every product.
  Vector change_size(double s) const;

  const ExponentialFlow* flow_;
  double theta_ = 0.0;
  Vector z_, formed_from_;  // z(0), and what it was summed from
  Vector load_;             // on z
};

// Weights of x along such arcs, added up as one part of a curve.
class ExponentialSum {
 public:
  explicit ExponentialSum(double window) : window_(window) {}
  // weight.(x(s) - x(0)); the arc is copied, its flow referred to.
  void add(const ExponentialArc& arc, const Vector& weight);
  void operator()(double s, int m, Reach reach, CurvePoint<double>& point) const;

 private:
  static constexpr std::size_t kMostDerivatives = 3 + 5;  // of a curve's derivative 3 or lower
  // One derivative of an observable of z.
  struct Derivative {
    Vector state;           // weight of z
    Vector size;            // of the products that it was summed from
    double constant = 0.0;  // from the load
    Complex phase;          // weight of e^{i theta}
    double bound_of_input = 0.0;
  };
  struct Term {
    ExponentialArc arc;
    std::array<Derivative, kMostDerivatives + 1> derivatives;
  };
  // Derivatives m + 2 to m + 4, and a bound on m + 5.
  struct Higher {
    std::array<double, 3> derivatives{};
    double last = 0.0;
  };
  void add_term(const Term& term, double s, std::size_t m, CurvePoint<double>& point,
                Higher& higher) const;

  double window_;
  std::vector<Term> terms_;
};

}  // namespace graze
