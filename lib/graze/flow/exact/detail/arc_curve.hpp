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
#include <vector>

#include "graze/flow/exact/detail/curve_terms.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"

namespace graze {

template <class Real>
struct Observable {
  Real constant = 0;
  RealVector<Real> displacement;  // weights of q, N
  RealVector<Real> velocity;      // weights of q', N; empty: none
  PlanarNumber<Real> harmonic;    // weight of e^{i theta}
};

template <class Real>
Observable<Real> times(const Real& factor, Observable<Real> one) {
  one.constant *= factor;
  one.displacement *= factor;
  one.velocity *= factor;
  one.harmonic = {factor * one.harmonic.re, factor * one.harmonic.im};
  return one;
}
template <class Real>
Observable<Real> operator+(Observable<Real> a, const Observable<Real>& b) {
  a.constant += b.constant;
  a.displacement += b.displacement;
  if (a.velocity.size() == 0)
    a.velocity = b.velocity;
  else if (b.velocity.size() > 0)
    a.velocity += b.velocity;
  a.harmonic = {a.harmonic.re + b.harmonic.re, a.harmonic.im + b.harmonic.im};
  return a;
}

// The gap at a stop as an observable: gap - row.q.
template <class Real>
Observable<Real> gap_observable(const RealVector<Real>& row, const Real& gap) {
  return {gap, -row, {}, {}};
}

// The observable at forcing phase theta: its value, and its rounding error as noise (one eps for
// every product and every sum, of its size).
template <class Real>
CurvePoint<Real> observed(const Observable<Real>& observable, const Real& theta,
                          const RealVector<Real>& q, const RealVector<Real>& qdot);

template <class Real>
class ArcCurve {
 public:
  // The part of the curve that has no modal form: adds its derivatives m and m + 1, a bound and
  // noise to the point, which holds the rest of the curve already.
  using Part = std::function<void(const Real& s, int m, Reach reach, CurvePoint<Real>& point)>;

  // `window`: the arc is used for 0 <= s <= window. `from_zero`: c(0) = 0 as an identity.
  ArcCurve(const Arc<Real>& arc, const Observable<Real>& observable, const Real& window,
           bool from_zero) {
    restart(arc, observable, window, from_zero);
  }
  ArcCurve() = default;
  // The same along another arc; `observable` must be the one given at construction.
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
  // Number of terms that an evaluation adds up.
  std::size_t terms() const { return terms_.size() + specials_.size(); }

 private:
  static constexpr std::size_t kOrders = 5;  // derivatives 0..4 are evaluated, 5 is bounded

  // Which of the two numbers of its mode's motion the coefficient of a term is formed from.
  enum class Takes { kBoth, kFirst, kSecond };
  struct Source {
    int mode;
    Takes takes;
    PlanarNumber<Real> weight;
    Real formed_from;
  };
  // A mode that has no exponential form: near critical damping, or with its response taken from
  // rest.
  struct Special {
    const ModeFlow<Real>* mode;
    int index;                    // of the mode
    Real displacement, velocity;  // weights
    Real apart;                   // P_j| + |offset|, which were subtracted to get the free part
    Real q = 0, qdot = 0;         // free part at the start
  };

  using Bounds = std::array<Real, kOrders + 2>;  // of the derivatives from the second on
  // Bounds for `ahead` seconds from where the displacement has the derivatives d.
  Bounds special_bounds(const ModeFlow<Real>& mode, const std::array<Real, kOrders + 1>& d,
                        const Real& ahead) const;
  void add_special(const Special& special, const Real& s, int m, Reach reach,
                   CurvePoint<Real>& point) const;
  void leave_out_quick(const TermShares<Real>& shares, CurvePoint<Real>& point) const;
  // Sets what all arcs of a flow share.
  void adopt(const ExactFlow<Real>& flow, const Observable<Real>& observable);

  Real frequency_ = 0, theta_ = 0, window_ = 0;
  Real start_value_ = 0;  // c(0)
  Real start_noise_ = 0;
  const ExactFlow<Real>* flow_ = nullptr;  // whose arcs it follows
  CurveTerms<Real> terms_;       // the modes' first, from slow to quick as a rule, then the forcing
  std::vector<Source> sources_;  // of the modes' terms
  PlanarNumber<Real> harmonic_{};  // weight of e^{i theta}, the forced response with it
  std::size_t modes_end_ = 0;
  std::vector<Special> specials_;
  Part part_;
};

}  // namespace graze
