// The exponential terms of a curve, Re(k (e^{l s} - 1)) with l = -decay + i frequency: their
// values, derivatives and bounds at one s, as sums and term by term.
//
// In double precision several terms go through the processor's vector unit at a time, chosen at run
// time (term_kernels.hpp); an extended scalar takes them one by one.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include "graze/flow/exact/detail/mode_flow.hpp"
#include "graze/flow/exact/detail/term_kernels.hpp"

namespace graze {

// A derivative of a curve at one s: what a certified search needs.
template <class Real>
struct CurvePoint {
  Real value = 0;                                      // derivative m of the curve
  Real slope = 0;                                      // derivative m + 1
  Real bound = 0;                                      // |derivative m + 2| from s over `reach`
  Real noise = 0;                                      // rounding error of value
  Real reach = std::numeric_limits<Real>::infinity();  // s; infinite: to the end of the window
  Real curvature = 0;                                  // derivative m + 2
  Real third = std::numeric_limits<Real>::infinity();  // |derivative m + 3|, bounded like `bound`
  // The same for the slow terms alone. The fast ones together fall by at most `fall` from here on;
  // infinite where slow and fast terms are not separated.
  struct Slow {
    Real slope = 0, curvature = 0, third = 0;
    Real fall = std::numeric_limits<Real>::infinity();
  };
  Slow slow{};

  // Becomes the point of the negative curve.
  void turn_round() {
    value = -value;
    slope = -slope;
    curvature = -curvature;
    slow = {};
  }
};

// How far a bound has to hold: to the end of the window, or only as far as the next step of a
// search needs it, where that makes the step longer.
enum class Reach { kWindow, kStep };

// Up to so many terms are separated into slow and fast ones.
inline constexpr std::size_t kMostShares = 64;

// The contribution of each term to a point.
template <class Real>
struct TermShares {
  std::array<Real, kMostShares> slope, curvature, third;
  std::array<Real, kMostShares> fall;  // largest possible fall from here on
};

// Rounding of one term k (e^{l s} - 1): the argument, sine, exponential, two products and the sum
// add at most about one eps each of |k| |l| s.
inline constexpr int kTermRoundings = 8;

template <class Real>
class CurveTerms {
 public:
  void clear() { terms_.clear(); }
  void reserve(std::size_t count) { terms_.reserve(count); }
  std::size_t size() const { return terms_.size(); }
  void add(const Real& decay, const Real& frequency);
  // The coefficient of a term. `formed_from`: size of the numbers whose difference k is.
  void set(std::size_t term, const PlanarNumber<Real>& k, const Real& formed_from);
  // Derivative m of the sum from its start on: adds value, slope, curvature, bounds and noise to
  // the point; fills the shares where there are no more than kMostShares terms.
  void add_to(const Real& s, int m, CurvePoint<Real>& point, TermShares<Real>& shares) const;

 private:
  struct Term {
    Real decay = 0, frequency = 0;
    PlanarNumber<Real> coefficient;  // k
    Real size = 0, rate_size = 0;    // |k|, |l|
    Real rounded = 0;                // size of the numbers that k was rounded at
  };
  std::vector<Term> terms_;
};

// In columns, as the vector unit reads them.
template <>
class CurveTerms<double> {
 public:
  void clear() { count_ = 0; }
  void reserve(std::size_t count);
  std::size_t size() const { return count_; }
  void add(double decay, double frequency);
  void set(std::size_t term, const PlanarNumber<double>& k, double formed_from);
  void add_to(double s, int m, CurvePoint<double>& point, TermShares<double>& shares) const;

 private:
  enum Column { kDecay, kHalfFrequency, kRateSize, kRe, kIm, kSize, kRounded, kColumns };
  double* column(Column c) { return columns_.data() + c * stride_; }
  const double* column(Column c) const { return columns_.data() + c * stride_; }

  std::size_t count_ = 0, stride_ = 0;
  double quickest_ = 0.0;        // largest half frequency
  std::vector<double> columns_;  // each `stride_` long; zeros behind its end
};

}  // namespace graze
