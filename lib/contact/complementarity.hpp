// The complementarity problem of several contacts at once,
//
//   p >= 0,   w = v - D p <= 0,   p_i w_i = 0,
//
// v: what would happen without them (approach speeds to be undone, accelerations into the stops,
// penetrations); D: how each of them acts on each (Delassus matrix). Solved by Murty's principal
// pivoting with least index, which ends for every P-matrix (all those of independent contacts).
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <optional>
#include <vector>

namespace graze {

// p, or nothing when the pivoting does not end. `rounding`: of v, per contact; a violation within
// it counts as none.
template <class Real>
std::optional<Eigen::Matrix<Real, Eigen::Dynamic, 1>> solve_contacts(
    const Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>& delassus,
    const Eigen::Matrix<Real, Eigen::Dynamic, 1>& v,
    const Eigen::Matrix<Real, Eigen::Dynamic, 1>& rounding) {
  using ResultVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  const Eigen::Index n = v.size();
  std::vector<Eigen::Index> active;
  // Every set of contacts is met at most once; beyond 2^12 of them something else is wrong.
  const int most = 1 << (n < 12 ? static_cast<int>(n) : 12);
  for (int pivots = 0; pivots <= most; ++pivots) {
    ResultVector p = ResultVector::Zero(n);
    if (!active.empty()) {
      const auto block = delassus(active, active).eval();
      const ResultVector part = block.partialPivLu().solve(v(active).eval());
      p(active) = part;
    }
    const ResultVector w = v - delassus * p;
    Eigen::Index wrong = n;
    for (Eigen::Index i = 0; i < n && wrong == n; ++i) {
      bool in = false;
      for (const Eigen::Index a : active) in = in || a == i;
      if (in ? p[i] * delassus(i, i) < -rounding[i] : w[i] > rounding[i]) wrong = i;
    }
    if (wrong == n) return p.cwiseMax(Real(0));
    std::vector<Eigen::Index> next;
    bool was_in = false;
    for (const Eigen::Index a : active) {
      if (a == wrong)
        was_in = true;
      else
        next.push_back(a);
    }
    if (!was_in) {
      auto at = next.begin();
      while (at != next.end() && *at < wrong) ++at;
      next.insert(at, wrong);
    }
    active = next;
  }
  return {};
}

}  // namespace graze
