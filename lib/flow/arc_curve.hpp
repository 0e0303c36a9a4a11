// A linear observable of the motion along an arc (the gap at a stop, a contact force),
//
//   c(s) = constant + displacement.q(s) + velocity.q'(s) + Re(harmonic e^{i theta(s)}),
//
// as a known sum of exponentials: values, derivatives, bounds that hold from s to the end of the
// arc's window, and the rounding error of each value. The free part of an oscillatory mode and the
// harmonic forcing are the same kind of term, Re(k e^{l s}).
//
// Values are formed as c(0) + sum Re(k (e^{l s} - 1)): an arc that starts on the stop starts with
// c(0) = 0 as an identity, and its departure carries a relative error of eps * speed, however slow.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "graze/flow/exact_flow.hpp"

namespace graze {

template <class Real>
struct Observable {
  Real constant = 0;
  RealVector<Real> displacement;  // weights of q, N
  RealVector<Real> velocity;      // weights of q', N; empty: none
  PlanarNumber<Real> harmonic;    // weight of e^{i theta}
};

// The gap at a stop as an observable: gap - row.q.
template <class Real>
Observable<Real> gap_observable(const RealVector<Real>& row, const Real& gap) {
  return {gap, -row, {}, {}};
}

// A derivative of the curve at one s: what a certified search needs.
template <class Real>
struct CurvePoint {
  Real value = 0;                                      // derivative m of the curve
  Real slope = 0;                                      // derivative m + 1
  Real bound = 0;                                      // |derivative m + 2| from s over `reach`
  Real noise = 0;                                      // rounding error of value
  Real reach = std::numeric_limits<Real>::infinity();  // s; infinite: to the end of the window
  Real curvature = 0;                                  // derivative m + 2
  Real third = std::numeric_limits<Real>::infinity();  // |derivative m + 3|, bounded like `bound`
  // The same of the slow terms alone. The quick ones together fall by at most `fall` from here on;
  // infinite where they are not told apart.
  struct Slow {
    Real slope = 0, curvature = 0, third = 0;
    Real fall = std::numeric_limits<Real>::infinity();
  };
  Slow slow{};

  // Of the curve's negative.
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

// The observable at forcing phase theta: value, and its rounding as noise (one eps for every
// product and every sum, of its size).
template <class Real>
CurvePoint<Real> observed(const Observable<Real>& observable, const Real& theta,
                          const RealVector<Real>& q, const RealVector<Real>& qdot);

template <class Real>
class ArcCurve {
 public:
  // What cannot be written in modes: adds derivative m of its part and m + 1, a bound and noise.
  // The rest of the curve is in the point already.
  using Part = std::function<void(const Real& s, int m, Reach reach, CurvePoint<Real>& point)>;

  // `window`: the arc is used for 0 <= s <= window. `from_zero`: c(0) = 0 as an identity.
  ArcCurve(const Arc<Real>& arc, const Observable<Real>& observable, const Real& window,
           bool from_zero) {
    restart(arc, observable, window, from_zero);
  }
  ArcCurve() = default;
  // Another one in the place of this one.
  void restart(const Arc<Real>& arc, const Observable<Real>& observable, const Real& window,
               bool from_zero);
  void set_window(const Real& window) { window_ = window; }
  // A curve of exponentials that are added one by one, starting at `start` known to `noise`.
  ArcCurve(const Real& start, const Real& noise, const Real& window);

  // Adds Re(k e^{(-decay + i frequency) s}) - Re(k). `formed_from`: size of the numbers whose
  // difference k is.
  void add_exponential(const PlanarNumber<Real>& k, const Real& decay, const Real& frequency,
                       const Real& formed_from);
  void set_part(Part part) { part_ = std::move(part); }

  // Derivative m = 0..3 of the curve with its slope and bound.
  CurvePoint<Real> at(const Real& s, int m, Reach reach = Reach::kWindow) const;
  const Real& window() const { return window_; }

 private:
  static constexpr std::size_t kOrders = 5;  // derivatives 0..4 are evaluated, 5 is bounded

  struct Exponential {
    Real decay = 0, frequency = 0;
    PlanarNumber<Real> coefficient, rate;  // k, l
    PlanarNumber<Real> first, second;      // k l, k l^2
    Real size = 0, rate_size = 0;          // |k|, |l|
    Real rounded = 0;                      // what k was rounded at: its size and its origin
  };
  // A mode that has no exponential form: near critical, or answering from rest.
  struct Special {
    const ModeFlow<Real>* mode;
    Real displacement, velocity;  // weights
    Real q, qdot;                 // free part at the start
    Real apart;                   // |P_j| + |offset|, from which the free part was told apart
  };

  using Bounds = std::array<Real, kOrders + 2>;  // of the derivatives from the second on
  // For `ahead` seconds from where the displacement has the derivatives d.
  Bounds special_bounds(const ModeFlow<Real>& mode, const std::array<Real, kOrders + 1>& d,
                        const Real& ahead) const;
  void add_special(const Special& special, const Real& s, int m, Reach reach,
                   CurvePoint<Real>& point) const;
  struct Share;
  void leave_out_quick(const Share* shares, CurvePoint<Real>& point) const;

  Real frequency_ = 0, theta_ = 0, window_ = 0;
  Real start_value_ = 0;  // c(0)
  Real start_noise_ = 0;
  // Up to so many are told apart into slow and quick ones.
  static constexpr std::size_t kMostShares = 64;
  std::vector<Exponential> exponentials_;
  std::size_t modes_end_ = 0;  // those of the modes come first, from slow to quick as a rule
  std::vector<Special> specials_;
  Part part_;
};

}  // namespace graze
