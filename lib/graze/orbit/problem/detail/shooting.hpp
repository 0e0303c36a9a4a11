// Periodic impacting motion as a system of equations on the Poincare impact map.
//
// A (p, k) orbit repeats after p forcing periods with k impacts. Unknown per impact: the forcing
// phase theta_i and the state (q_i, q'_i) just before it. Equations per impact:
//
//   contact   row.q_i = gap                                        an equation, never searched for
//   matching  flow from (theta_i, J(q_i, q'_i)) to theta_{i+1} = (q_{i+1}, q'_{i+1}),
//
// cyclic with theta_k = theta_0 + 2 pi p. Nothing in them breaks at grazing, so that virtual orbits
// (that penetrate, or impact at negative speed) can be traced too. Derivatives are analytic. Of
// masses and springs the unknown states are those of the masses (impact_coordinates.hpp).
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/impact_pattern.hpp"
#include "graze/system/scale.hpp"

namespace graze {

// The residual and its derivatives. jacobian + (mu - 1) closing is singular exactly where mu is a
// multiplier of the orbit: a deviation that comes back mu times as large closes the equations.
struct ShootingLinearisation {
  Vector residual;
  Matrix jacobian;       // by x
  Matrix closing;        // the derivative of the last flight's end by the first impact
  Matrix by_parameters;  // a column for each tangent of the system
};

// Unknowns and residuals are scaled: phases by 1 rad, the others by MotionScale, gaps by its
// length.
class ShootingProblem {
 public:
  // Requires forcing and at least one impact in the pattern.
  ShootingProblem(ImpactPattern pattern, MotionScale scale)
      : pattern_(std::move(pattern)), scale_(std::move(scale)) {}

  const ImpactPattern& pattern() const { return pattern_; }
  const MotionScale& scale() const { return scale_; }
  // k (2N + 1)
  Eigen::Index size(const System& system) const;
  // The periods of the unknowns: 2 pi for each phase, else zero.
  Vector wrap() const;

  Vector pack(const System& system, const std::vector<ImpactPoint>& impacts) const;
  std::vector<ImpactPoint> unpack(const System& system, const Vector& x) const;

  // Residual at x (scaled), and on request its Jacobian by x.
  Vector residual(const System& system, const Vector& x, Matrix* jacobian = nullptr) const;

  // With all derivatives, for the parameters that move the system along these tangents.
  ShootingLinearisation linearise(const System& system, const Vector& x,
                                  std::span<const System* const> tangents) const;
  // The same for unknown states of the modes, whatever the structure.
  ShootingLinearisation modal_equations(const System& system, const Vector& y,
                                        std::span<const System* const> tangents) const;

  // The speed of an impact over that of the scale, and its derivatives.
  struct ImpactSpeed {
    double value = 0.0;
    Vector by_x, by_parameters;
  };
  ImpactSpeed speed_of(const System& system, const Vector& x, std::size_t impact,
                       std::span<const System* const> tangents) const;

 private:
  // The requested results of residual() and linearise(); null and empty where not requested.
  struct Wanted {
    Matrix* jacobian = nullptr;
    Matrix* closing = nullptr;
    std::span<const System* const> tangents{};
    Matrix* by_parameters = nullptr;  // a column of each
  };
  Vector evaluate(const System& system, const Vector& x, const Wanted& wanted) const;
  // The derivatives of the two matching equations of mode j from the impact whose unknowns begin at
  // `at`, by these, and by those of the next impact, which begin at `to`.
  void add_mode(const System& system, const Stop& stop, double jump_slope,
                const ModeTransition& arc, Eigen::Index j, Eigen::Index at, Matrix& jacobian) const;
  void add_end(const System& system, const ModeTransition& arc, Eigen::Index j, Eigen::Index at,
               Eigen::Index to, Matrix& jacobian) const;

  ImpactPattern pattern_;
  MotionScale scale_;
};

// The state just after the impact of `before` at a stop.
State after_impact(const Stop& stop, const State& before);

}  // namespace graze
