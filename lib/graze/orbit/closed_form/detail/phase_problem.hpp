// The (p, k) orbits of a linear structure, reduced to the forcing phases of their impacts: the
// closed form of one impact, extended to any number of them.
//
// With Y and G_j of periodic_response.hpp, impulses u_j = (1 + r_j) v_j at the phases theta_j make
//
//   y(theta) = Y(theta) - sum_j u_j G_j(s_j),       s_j in (0, pT] the time since impact j.
//
// The motion is linear in u, and v_i = b_i.q' just before impact i are k equations for the k
// speeds,
//
//   v_i + sum_j H_ij (1 + r_j(v_j)) v_j = b_i.Y'(theta_i),     H_ij = b_i.G_j'(s_ij),
//
// linear where the restitutions are constant, else solved by Newton's method from the speeds that
// constant ones give.
//
// What remains is contact, k equations in the k phases, whatever the number of modes:
//
//   c_i(theta) = b_i.Y(theta_i) - sum_j u_j b_i.G_j(s_ij) - a_i = 0.
//
// An impact's own speed may cancel from its own equation: for an undamped structure H_ii = -1/2, so
// that 1 + (1 + r) H_ii = (1 - r)/2. Where r = 1 as well, the matrix is antisymmetric and singular
// for every odd k, whatever the phases: speeds are free, and few phases are compatible with them.
// The equations are then solved in the other order. Contact gives the impulses,
//
//   sum_j b_i.G_j(s_ij) u_j = b_i.Y(theta_i) - a_i,     v_i = b_i.Y'(theta_i) - sum_j H_ij u_j,
//
// and the equations left are the laws of impact, in units of a length W^-1 (u_i - (1 + r_i(v_i))
// v_i) = 0.
//
// The phases live on a torus, each modulo 2 pi p; their order is that of the impacts. Two impacts
// of one stop at one instant solve the equations where a single impact of restitution -r^2 does:
// such points are no orbits.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/orbit/closed_form/detail/periodic_response.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

class PhaseProblem {
 public:
  // `stops`: one (index from 0) for each impact. `speed`, m/s: of the forced motion, at which r(v)
  // is taken first. Refers to the response.
  PhaseProblem(const PeriodicResponse& response, std::vector<int> stops, double speed);

  int impacts() const { return static_cast<int>(stops_.size()); }
  const std::vector<int>& stops() const { return stops_; }
  const PeriodicResponse& response() const { return *response_; }

  // Whether the equations left are contact; else they are the laws of impact.
  bool remains_contact() const { return !from_contact_; }

  // Residuals of the equations left at the phases (rad, k), m; on request with their Jacobian by
  // the phases, m/rad, and the approach speeds, m/s. Not finite where the linear equations have no
  // or many solutions, or the approach speeds are not found.
  Vector defect(const Vector& phases, Matrix* jacobian = nullptr, Vector* speeds = nullptr) const;

  // The impacts as points of the shooting equations, in the order of the phases given.
  std::vector<ImpactPoint> points(const Vector& phases) const;

 private:
  // Forcing and impulses along the rows, and their derivatives by time: row i, impulse j.
  struct Rows;
  // Impulses and speeds, with their derivatives by the phases on request.
  struct Impacts;

  const Stop& stop(Eigen::Index impact) const;
  Rows rows(const Vector& phases) const;
  Impacts impacts_from_rates(const Rows& rows, bool derivatives) const;
  Impacts impacts_from_contact(const Rows& rows, bool derivatives) const;
  // Approach speeds v for H and the forced rates, with the factorised derivative of their
  // equations; not finite where Newton's method does not settle.
  Vector approach_speeds(const Matrix& h, const Vector& forced_rate,
                         std::optional<LuFactors>& derivative) const;
  // (1 + r(v)) v of each impact, and its derivative by v.
  Vector impulses(const Vector& speeds) const;
  Vector impulse_slopes(const Vector& speeds) const;
  // Seconds from impact j to impact i, in (0, pT].
  double since(const Vector& phases, Eigen::Index i, Eigen::Index j) const;
  // Seconds from the first impact of the list to each, in [0, pT).
  Vector instants(const Vector& phases) const;

  const PeriodicResponse* response_;
  std::vector<int> stops_;
  double speed_;
  bool constant_ = true;       // whether all restitutions are
  bool from_contact_ = false;  // whether contact gives the impulses
  // An impact's own impulse, one orbit later.
  std::vector<RowMotion> own_;
};

}  // namespace graze
