// The complementarity problem of several contacts at once,
//
//   p >= 0,   w = v - D p <= 0,   p_i w_i = 0,
//
// v: what would happen without them (approach speeds to be undone, accelerations into the stops,
// penetrations); D: how each of them acts on each (Delassus matrix). The contacts that act are
// searched among all sets of them, in one order: few are ever touched at one instant, and contacts
// that depend on each other (two stops at one place) need no rule of their own.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <limits>
#include <optional>
#include <vector>

namespace graze {

// More contacts at one instant than this are not decided.
inline constexpr int kMostContacts = 12;

// Roundings of v - D p by the contacts' own action: the elimination, the products and the sum.
inline constexpr int kRoundingsOfAction = 8;

// What they leave of each contact.
template <class Real>
Eigen::Matrix<Real, Eigen::Dynamic, 1> rounding_of_action(
    const Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>& delassus,
    const Eigen::Matrix<Real, Eigen::Dynamic, 1>& p) {
  return kRoundingsOfAction * std::numeric_limits<Real>::epsilon() * delassus.cwiseAbs() *
         p.cwiseAbs();
}

// p, or nothing where no set of contacts fits (they contradict each other) or there are too many.
// `rounding`: of v, per contact; a violation within it and that of p counts as none.
template <class Real>
std::optional<Eigen::Matrix<Real, Eigen::Dynamic, 1>> solve_contacts(
    const Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>& delassus,
    const Eigen::Matrix<Real, Eigen::Dynamic, 1>& v,
    const Eigen::Matrix<Real, Eigen::Dynamic, 1>& rounding) {
  using ResultVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  const auto n = static_cast<int>(v.size());
  if (n > kMostContacts) return {};
  std::vector<Eigen::Index> active;
  for (int set = 0; set < 1 << n; ++set) {
    active.clear();
    for (int i = 0; i < n; ++i)
      if ((set >> i & 1) != 0) active.push_back(i);
    ResultVector p = ResultVector::Zero(n);
    if (!active.empty()) {
      const auto lu = delassus(active, active).eval().fullPivLu();
      if (!lu.isInvertible()) continue;
      p(active) = lu.solve(v(active).eval());
      // Once more for what is left: rows of different size come out with roundings of the largest.
      p(active) += lu.solve((v - delassus * p)(active).eval());
    }
    const ResultVector w = v - delassus * p;
    const ResultVector own = rounding_of_action(delassus, p);
    bool fits = true;
    for (int i = 0; i < n && fits; ++i)
      fits = (set >> i & 1) != 0 ? p[i] * delassus(i, i) >= -rounding[i]
                                 : w[i] <= rounding[i] + own[i];
    if (fits) return p.cwiseMax(Real(0));
  }
  return {};
}

}  // namespace graze
