// Definitions of constrained_structure.hpp; included by one translation unit per scalar.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/products.hpp"
#include "graze/flow/exact/detail/exact_flow_impl.hpp"
#include "graze/flow/held/detail/constrained_structure.hpp"
#include "graze/flow/held/detail/contact_share.hpp"

namespace graze {
namespace constrained_structure_detail {

// Roundings by which decay rates may miss alpha + beta w^2, a direction b/(b.b) and what one
// vector has along another, in parts of both norms.
inline constexpr int kRoundings = 16;

// Decay rates proportional to mass and stiffness: delta_j = alpha + beta w_j^2.
template <class Real>
struct ProportionalDamping {
  Real alpha = 0, beta = 0;
};

template <class Real>
std::optional<ProportionalDamping<Real>> proportional_damping(const LinearSystem<Real>& system) {
  using std::abs;
  if (system.coupling.size() > 0) return {};
  const Eigen::Index n = system.omega.size();
  const RealVector<Real> stiffness = system.omega.cwiseAbs2();
  Eigen::Index low = 0, high = 0;
  for (Eigen::Index j = 1; j < n; ++j) {
    if (stiffness[j] < stiffness[low]) low = j;
    if (stiffness[j] > stiffness[high]) high = j;
  }
  ProportionalDamping<Real> law;
  if (system.delta[high] != system.delta[low] && stiffness[high] > stiffness[low])
    law.beta = (system.delta[high] - system.delta[low]) / (stiffness[high] - stiffness[low]);
  law.alpha = system.delta[low] - law.beta * stiffness[low];
  for (Eigen::Index j = 0; j < n; ++j) {
    const Real miss = abs(system.delta[j] - law.alpha - law.beta * stiffness[j]);
    // The decay rates come in double precision, whatever the scalar.
    if (miss > kRoundings * std::numeric_limits<double>::epsilon() * system.delta[j]) return {};
  }
  return law;
}

template <class Real>
bool is_normal(const RealVector<Real>& row, const RealVector<Real>& direction) {
  const RealVector<Real> normal = row / row.squaredNorm();
  return (direction - normal).norm() <=
         kRoundings * std::numeric_limits<double>::epsilon() * normal.norm();
}

// What a load or a row has along a direction: nothing where that is rounding, whose sign would move
// what is at rest.
template <class Real>
Real along(const RealVector<Real>& direction, const RealVector<Real>& x) {
  using std::abs;
  const Real part = direction.dot(x);
  const Real rounding =
      kRoundings * std::numeric_limits<Real>::epsilon() * direction.norm() * x.norm();
  return abs(part) > rounding ? part : Real(0);
}

template <class Real>
RealVector<Real> along_each(const RealMatrix<Real>& directions, const RealVector<Real>& x) {
  RealVector<Real> parts(directions.cols());
  for (Eigen::Index j = 0; j < parts.size(); ++j) parts[j] = along<Real>(directions.col(j), x);
  return parts;
}

}  // namespace constrained_structure_detail

template <class Real>
ConstrainedStructure<Real>::ConstrainedStructure(const System& system, std::vector<int> list,
                                                 const std::vector<double>& places)
    : constrained(std::move(list)), whole(linear_system<Real>(system)) {
  if (!constrained.empty()) {
    reduce(system, places);
    has_real_modes = has_real_modes && whole.harmonics.empty() && drift.size() == 0;
    return;
  }
  reduced = whole;
  has_real_modes = whole.coupling.size() == 0 && whole.harmonics.empty();
  if (is_free()) return;
  basis = RealMatrix<Real>::Identity(whole.omega.size(), whole.omega.size());
  rest = RealVector<Real>::Zero(whole.omega.size());
}

// Coordinates in which the held structure has real modes: U = Q V, Q an orthonormal basis of what
// the rows leave free, V the right singular vectors of w Q. The singular values are the
// frequencies, with an error of eps times the largest one (of their squares it would be far worse).
template <class Real>
void ConstrainedStructure<Real>::reduce(const System& system, const std::vector<double>& places) {
  using namespace constrained_structure_detail;
  using std::abs;
  rows = rows_of(system, constrained).template cast<Real>();
  directions = directions_of(system, constrained).template cast<Real>();
  shares =
      product<Real>(rows, PivotedLu<Real>(transposed_product<Real>(directions, rows)).inverse());
  const Eigen::Index n = rows.rows(), k = rows.cols(), m = n - k;
  const RealMatrix<Real> all = orthonormal_columns<Real>(rows, n);
  // The shortest q with B^T q = a, and the slowest q' with B^T q' = the speeds of belts.
  const PivotedLu<Real> crossed(transposed_product<Real>(rows, rows));
  rest = image<Real>(rows, crossed.solve(held_at(system, places)));
  RealVector<Real> speeds = RealVector<Real>::Zero(k);
  for (Eigen::Index i = 0; i < k; ++i)
    if (const int at = constrained[static_cast<std::size_t>(i)]; system.is_friction(at))
      speeds[i] = Real(system.friction(at).speed);
  if (!speeds.isZero(0)) drift = image<Real>(rows, crossed.solve(speeds));
  basis = all.rightCols(m);
  reduced.omega.resize(m);
  stretched.resize(n, m);
  if (m > 0) {
    const RealMatrix<Real> root = whole.omega.asDiagonal() * basis;
    const SingularValues<Real> factors = singular_values<Real>(root);
    basis = product<Real>(basis, factors.right).rowwise().reverse();
    // Of columns of length 1: what does not move with others stays as it is, to the last digit.
    const Real rounding = kRoundings * std::numeric_limits<Real>::epsilon();
    for (Eigen::Index j = 0; j < m; ++j)
      for (Real& part : basis.col(j))
        if (abs(part) <= rounding) part = 0;
    reduced.omega = factors.values.reverse();
    // Within the error of the singular values, that of forming w U, a mode is free.
    const Real smallest = Real(static_cast<int>(n)) * std::numeric_limits<Real>::epsilon() *
                          whole.omega.maxCoeff();
    for (Real& w : reduced.omega)
      if (w <= smallest) w = 0;
    stretched = factors.left.rowwise().reverse() * reduced.omega.asDiagonal();
  }
  reduced.forced = whole.forced;
  reduced.repeats = whole.repeats;
  reduced.frequency = whole.frequency;
  reduced.phase = whole.phase;
  reduced.reach = whole.reach;

  for (Eigen::Index i = 0; i < k; ++i)
    is_normal =
        is_normal && constrained_structure_detail::is_normal<Real>(rows.col(i), directions.col(i));
  const std::optional<ProportionalDamping<Real>> damping = proportional_damping(whole);
  has_real_modes = m == 0 || (is_normal && (damping || m == 1));
  reduced.delta = RealVector<Real>::Zero(m);
  if (whole.forced) reduced.amplitude = RealVector<Real>::Zero(m);
  if (!has_real_modes) return;
  for (Eigen::Index j = 0; j < m; ++j) {
    reduced.delta[j] =
        damping ? Real(damping->alpha + damping->beta * reduced.omega[j] * reduced.omega[j])
                : Real(whole.delta.dot(basis.col(j).cwiseAbs2()));
    if (whole.coupling.size() > 0)
      reduced.delta[j] += basis.col(j).dot(image<Real>(whole.coupling, basis.col(j))) / 2;
  }
  if (whole.forced) reduced.amplitude = along_each<Real>(basis, whole.amplitude);
  reduced.load = balanced_load();
}

// a: the gaps of the stops and the places of the frictions, in the order of the rows.
template <class Real>
RealVector<Real> ConstrainedStructure<Real>::held_at(const System& system,
                                                     const std::vector<double>& places) const {
  RealVector<Real> at(rows.cols());
  std::size_t next = 0;
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    const int index = constrained[static_cast<std::size_t>(i)];
    at[i] = Real(system.is_friction(index) ? places[next++]
                                           : system.stops[static_cast<std::size_t>(index)].gap);
  }
  return at;
}

// Moves what is held to where its stiffness balances the load, so that nothing large has to cancel;
// returns the load that is left to modes too soft for it.
template <class Real>
RealVector<Real> ConstrainedStructure<Real>::balanced_load() {
  RealVector<Real> load = -transposed_image<Real>(stretched, whole.omega.cwiseProduct(rest));
  if (whole.load.size() > 0)
    load += constrained_structure_detail::along_each<Real>(basis, whole.load);
  for (Eigen::Index j = 0; j < load.size(); ++j) {
    const Real w = reduced.omega[j];
    if (!(w > 0 && exact_flow_detail::rests_within_reach(load[j], w, whole.reach))) continue;
    rest += basis.col(j) * (load[j] / (w * w));
    load[j] = 0;
  }
  return load;
}

template <class Real>
Eigen::Index ConstrainedStructure<Real>::column_of(int stop) const {
  return std::find(constrained.begin(), constrained.end(), stop) - constrained.begin();
}

// The contact force at a stop or friction that holds, from all coordinates.
template <class Real>
Observable<Real> ConstrainedStructure<Real>::held_force(Eigen::Index column) const {
  using constrained_structure_detail::along;
  const RealVector<Real> share = shares.col(column);
  const Real unit = Real(1) / rows.col(column).squaredNorm();
  Observable<Real> force;
  force.displacement = -unit * whole.omega.cwiseAbs2().cwiseProduct(share);
  force.velocity = -2 * unit * whole.delta.cwiseProduct(share);
  if (whole.coupling.size() > 0)
    force.velocity -= unit * transposed_image<Real>(whole.coupling, share);
  if (whole.load.size() > 0) force.constant = unit * along<Real>(share, whole.load);
  if (whole.forced) force.harmonic.re = unit * along<Real>(share, whole.amplitude);
  return force;
}

template <class Real>
std::vector<Observable<Real>> ConstrainedStructure<Real>::observables(const System& system) const {
  using constrained_structure_detail::along, constrained_structure_detail::along_each;
  std::vector<Observable<Real>> list;
  const auto count = static_cast<int>(system.stops.size() + system.frictions.size());
  for (int i = 0; i < count; ++i) {
    const RealVector<Real> row = system.row(i).template cast<Real>();
    const Eigen::Index column = column_of(i);
    const bool holds = column < static_cast<Eigen::Index>(constrained.size());
    Observable<Real> seen;
    if (holds)
      seen = held_force(column);
    else if (system.is_friction(i))
      seen = {-Real(system.friction(i).speed), RealVector<Real>::Zero(row.size()), row, {}};
    else
      seen = gap_observable<Real>(row, Real(system.stops[static_cast<std::size_t>(i)].gap));
    if (!is_free()) {
      seen.constant += seen.displacement.dot(rest);
      seen.displacement = holds ? transposed_image<Real>(basis, seen.displacement)
                                : along_each<Real>(basis, seen.displacement);
      if (seen.velocity.size() > 0) seen.velocity = transposed_image<Real>(basis, seen.velocity);
    }
    for (std::size_t k = 0; k < whole.harmonics.size() && holds; ++k) {
      const Harmonic& one = whole.harmonics[k];
      const Real unit = row.squaredNorm() * units[k];
      seen.displacement[drive(k)] +=
          along<Real>(shares.col(column), one.cosine.template cast<Real>()) / unit;
      seen.velocity[drive(k)] -= along<Real>(shares.col(column), one.sine.template cast<Real>()) /
                                 (row.squaredNorm() * rate_unit(k));
    }
    list.push_back(std::move(seen));
  }
  return list;
}

}  // namespace graze
