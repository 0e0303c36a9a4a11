// The complementarity problem of several contacts at once,
//
//   p >= 0,   w = v - D p <= 0,   p_i w_i = 0,
//
// v: what would happen without the contacts (approach speeds to be undone, accelerations into the
// stops, penetrations); D: how each contact acts on each (Delassus matrix). The set of acting
// contacts is found by letting the first one that contradicts itself change sides, which ends at
// the solution where all principal minors of D are positive, as those of independent contacts are
// (K. G. Murty, Opsearch 11, 1974, 123-130). Where contacts depend on each other (two stops at one
// place) all sets are tried, in one order. For more than kFewContacts contacts Lemke's method finds
// the set (lemke.hpp), and its solution is checked.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/vector.hpp"
#include "graze/contact/detail/lemke.hpp"

namespace graze {

// Up to so many contacts all sets may be tried; for more Lemke's method finds the set.
inline constexpr int kFewContacts = 12;

// Roundings of v - D p by the contacts' own action: the elimination, the products and the sum.
inline constexpr int kRoundingsOfAction = 8;

// The rounding error of v - D p for each contact.
template <class Real>
RealVector<Real> rounding_of_action(const RealMatrix<Real>& delassus, const RealVector<Real>& p) {
  return kRoundingsOfAction * std::numeric_limits<Real>::epsilon() * delassus.cwiseAbs() *
         p.cwiseAbs();
}

// What a contact does to itself; limits of friction (solve_with_friction) have no action of their
// own, and count as they are.
template <class Real>
Real own_action(const RealMatrix<Real>& delassus, const RealVector<Real>& p, Eigen::Index i) {
  return delassus(i, i) > 0 ? Real(p[i] * delassus(i, i)) : p[i];
}

// The result of letting a set of contacts act, bit i of `set` for contact i.
template <class Real>
struct ContactTrial {
  RealVector<Real> p;
  bool solvable = true;  // else the contacts of the set depend on each other
  int violated = -1;     // the first contact that pulls, or gives way without acting; -1: none does
};
template <class Real>
ContactTrial<Real> try_contacts(const RealMatrix<Real>& delassus, const RealVector<Real>& v,
                                const RealVector<Real>& rounding, int set) {
  const auto n = static_cast<int>(v.size());
  std::vector<Eigen::Index> active;
  for (int i = 0; i < n; ++i)
    if ((set >> i & 1) != 0) active.push_back(i);
  ContactTrial<Real> trial{RealVector<Real>::Zero(n)};
  RealVector<Real>& p = trial.p;
  if (!active.empty()) {
    const PivotedLu<Real> lu(delassus(active, active));
    trial.solvable = lu.is_invertible();
    if (!trial.solvable) return trial;
    p(active) = lu.solve(v(active));
    // One refinement: rows of different size come out with roundings of the largest.
    p(active) += lu.solve((v - delassus * p)(active));
  }
  const RealVector<Real> w = v - delassus * p;
  const RealVector<Real> own = rounding_of_action(delassus, p);
  for (int i = 0; i < n && trial.violated < 0; ++i) {
    const bool fits = (set >> i & 1) != 0 ? own_action(delassus, p, i) >= -rounding[i]
                                          : w[i] <= rounding[i] + own[i];
    if (!fits) trial.violated = i;
  }
  return trial;
}

// The set of contacts that Lemke's method finds, solved for p. Each of n products and sums rounds
// by one eps of |D||p|, and a solution that was refined once leaves as much in w = v - D p; within
// that, and the rounding of v, it is checked to be a solution.
template <class Real>
std::optional<RealVector<Real>> solve_many_contacts(const RealMatrix<Real>& delassus,
                                                    const RealVector<Real>& v,
                                                    const RealVector<Real>& rounding) {
  const Eigen::Index n = v.size();
  const std::optional<std::vector<Eigen::Index>> active = LemkeTableau<Real>(delassus, -v).solve();
  if (!active) return {};
  RealVector<Real> p = RealVector<Real>::Zero(n);
  std::vector<bool> acts(static_cast<std::size_t>(n), false);
  if (!active->empty()) {
    const PivotedLu<Real> lu(delassus(*active, *active));
    p(*active) = lu.solve(v(*active));
    p(*active) += lu.solve((v - delassus * p)(*active));
    for (const Eigen::Index i : *active) acts[static_cast<std::size_t>(i)] = true;
  }
  const RealVector<Real> w = v - delassus * p;
  const RealVector<Real> own = Real(2 * (static_cast<int>(n) + 2)) *
                               std::numeric_limits<Real>::epsilon() * delassus.cwiseAbs() *
                               p.cwiseAbs();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Real allowed = rounding[i] + own[i];
    const bool holds = acts[static_cast<std::size_t>(i)]
                           ? own_action(delassus, p, i) >= -allowed && w[i] >= -allowed
                           : true;
    if (!holds || !(w[i] <= allowed)) return {};
  }
  return p.cwiseMax(Real(0));
}

// Returns p, or nullopt when no set of contacts fits (they contradict each other). `rounding`: of
// v, per contact; a violation within it and that of p counts as none.
template <class Real>
std::optional<RealVector<Real>> solve_contacts(const RealMatrix<Real>& delassus,
                                               const RealVector<Real>& v,
                                               const RealVector<Real>& rounding) {
  const auto n = static_cast<int>(v.size());
  if (n > kFewContacts) return solve_many_contacts<Real>(delassus, v, rounding);
  const int sets = 1 << n;
  int set = 0;
  for (int tried = 0; tried < sets; ++tried) {
    const ContactTrial<Real> trial = try_contacts<Real>(delassus, v, rounding, set);
    if (!trial.solvable) break;
    if (trial.violated < 0) return trial.p.cwiseMax(Real(0));
    set ^= 1 << trial.violated;
  }
  for (set = 0; set < sets; ++set) {
    const ContactTrial<Real> trial = try_contacts<Real>(delassus, v, rounding, set);
    if (trial.solvable && trial.violated < 0) return trial.p.cwiseMax(Real(0));
  }
  return {};
}

// The same where the last limit.size() contacts are dry friction at rest, |p_i| <= limit_i:
//
//   w_i = 0 inside, w_i >= 0 at p_i = limit_i, w_i <= 0 at p_i = -limit_i,
//
// as contacts of twice the number, with p_i + limit_i and the positive part of w_i.
template <class Real>
std::optional<RealVector<Real>> solve_with_friction(const RealMatrix<Real>& delassus,
                                                    const RealVector<Real>& v,
                                                    const RealVector<Real>& rounding,
                                                    const RealVector<Real>& limit) {
  const Eigen::Index n = v.size(), s = limit.size();
  if (s == 0) return solve_contacts(delassus, v, rounding);
  RealMatrix<Real> acting = RealMatrix<Real>::Zero(n + s, n + s);
  acting.topLeftCorner(n, n) = delassus;
  acting.block(n - s, n, s, s).setIdentity();
  acting.block(n, n - s, s, s) = -RealMatrix<Real>::Identity(s, s);
  RealVector<Real> offset = RealVector<Real>::Zero(n), pushes(n + s), errors(n + s);
  offset.tail(s) = -limit;
  pushes << v - delassus * offset, -2 * limit;
  errors << rounding + rounding_of_action<Real>(delassus, offset),
      rounding.tail(s) + rounding_of_action<Real>(delassus, offset).tail(s);
  const std::optional<RealVector<Real>> solved = solve_contacts<Real>(acting, pushes, errors);
  if (!solved) return {};
  return RealVector<Real>(solved->head(n) + offset);
}

}  // namespace graze
