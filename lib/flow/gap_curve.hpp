// The gap at one stop along an arc, g(s) = gap - row.q(s), as a known sum of exponentials: values,
// derivatives, bounds that hold from s to the end of the arc's window, and the rounding error of
// each value. The free part of an oscillatory mode and the harmonic forcing are the same kind of
// term, Re(c e^{l s}).
//
// Values are formed as g(0) - sum Re(c (e^{l s} - 1)): an arc that starts on the stop starts with
// g(0) = 0 as an identity, and its departure carries a relative error of eps * speed, however slow.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "graze/flow/exact_flow.hpp"

namespace graze {

// A derivative of the gap at one s: what a certified search needs.
template <class Real>
struct CurvePoint {
  Real value = 0;  // derivative m of the gap
  Real slope = 0;  // derivative m + 1
  Real bound = 0;  // |derivative m + 2| from s to the end of the window
  Real noise = 0;  // rounding error of value
};

template <class Real>
class GapCurve {
 public:
  // `window`: the arc is used for 0 <= s <= window. `on_stop`: g(0) = 0 as an identity.
  GapCurve(const Arc<Real>& arc, const RealVector<Real>& row, const Real& gap, const Real& window,
           bool on_stop);

  // Derivative m = 0, 1, 2 of the gap and its slope and bound.
  CurvePoint<Real> at(const Real& s, int m) const;
  // Derivative m = 0..3 at the start.
  Real start_derivative(int m) const;
  // |derivative m|, m = 2..4, from the start on.
  Real start_bound(int m) const;
  const Real& window() const { return window_; }

 private:
  struct Exponential {
    Real decay = 0, frequency = 0;
    std::array<PlanarNumber<Real>, 4> coefficient;  // c l^m
    std::array<Real, 5> size;                       // |c l^m|
    std::array<Real, 5> rounded;  // what c l^m was rounded at: its size and what it was formed from
  };
  // A mode that has no exponential form: near critical or resonant.
  struct Special {
    const ModeFlow<Real>* mode;
    Real row;
    Real q, qdot;  // free part at the start
    Real forced;   // |P_j|, from which the free part was told apart
  };

  // `formed_from`: size of the numbers whose difference c is.
  void add_exponential(const PlanarNumber<Real>& c, const Real& decay, const Real& frequency,
                       const Real& formed_from);
  void add_special(const Special& special, const Real& s, int m, CurvePoint<Real>& point) const;

  Real frequency_, theta_, window_;
  Real start_value_ = 0;  // g(0)
  Real start_noise_ = 0;
  std::vector<Exponential> exponentials_;
  std::vector<Special> specials_;
};

}  // namespace graze
