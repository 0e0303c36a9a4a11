// Periodic motion whose segments are followed, as a system of equations between sections.
//
// Every section lies at one forcing phase theta, with the same stops C closed (none: a stroboscopic
// section), and x_i is the state on it (section_map.hpp). The unknowns are x_1, .., x_n,
//
//   P(x_i) - x_{i+1} = 0,   cyclic, P the motion over p/n forcing periods,
//
// so that no long product of slopes enters the equations. Where a stop is released at the section
// its phase is unknown too, u = (theta, x_1, ..), with the equation
//
//   force(theta, x_1) = 0,   the contact force of that stop falls to zero.
//
// Of a self-excited system (System::is_self_excited) the period is unknown as well, u = (log of the
// rate 2 pi/T, x_1, ..), with the equation that the first friction's place is at rest on the
// section: b.q' = 0.
//
// With as many stops closed as there are modes there are no x_i, and the force is the only
// equation.
//
// P stays continuous where a chatter no longer completes: the motion then comes near the stop
// instead of to rest on it. Such a solution is no orbit; it allows the end of a branch to be
// bracketed from both sides.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "graze/orbit/problem/detail/itinerary.hpp"
#include "graze/orbit/problem/detail/section_map.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

// Where the sections of a periodic motion lie.
struct SegmentLayout {
  int period = 1;                 // p
  int sections = 1;               // n, of which p is a multiple
  std::vector<int> closed{};      // C, in rising order
  std::optional<int> released{};  // of these, where theta is unknown
  double theta = 0.0;             // else, rad

  // Orbits of p forcing periods on stroboscopic sections, one in each.
  static SegmentLayout fixed_phase(int period, double theta = 0.0) {
    return {period, period, {}, {}, theta};
  }
  bool operator==(const SegmentLayout&) const = default;
};

// A product left^T A(multiplier) right of the equations' A(mu), without conjugation.
struct SegmentProduct {
  ComplexVector left, right;
  Complex multiplier;
};

// A contact of a segment, cut by the ends of the segment or not.
struct PassedContact {
  int stop = 0;
  bool from_start = false, to_end = false;
  double duration = 0.0;  // s
};

class SegmentShooting {
 public:
  // `reference`: see SectionMap.
  SegmentShooting(const System& reference, SegmentLayout layout, const SegmentOptions& options);

  const SegmentLayout& layout() const { return layout_; }
  const SectionMap& map() const { return map_; }
  // Orbits of another layout with the same stops closed, in the same coordinates.
  SegmentShooting over(SegmentLayout layout) const;
  SegmentShooting leaving_out(const LeftOut& one) const;

  Eigen::Index size() const { return head() + layout_.sections * map_.size(); }
  Eigen::Index head() const { return layout_.released || is_free() ? 1 : 0; }  // where x_1 begins
  bool is_free() const { return rate_ > 0.0; }  // the period is unknown
  // The system with the period of u.
  System timed(const System& system, const Vector& u) const;
  // The periods of the unknowns: 2 pi for the phase, else zero.
  Vector wrap() const;
  double theta_of(const Vector& u) const { return layout_.released ? u[0] : layout_.theta; }
  // x_i, i from 0.
  Vector at_section(const Vector& u, int i) const {
    return u.segment(head() + i * map_.size(), map_.size());
  }
  int periods_each() const { return layout_.period / layout_.sections; }
  Vector pack(const System& system, double theta, const std::vector<State>& states) const;
  Vector pack(const System& system, const std::vector<State>& states) const {
    return pack(system, layout_.theta, states);
  }
  std::vector<State> unpack(const System& system, const Vector& u) const;

  // All derivatives, also by the parameters that move the system along these tangents; nullopt when
  // a segment cannot be followed. `factors`: the slope of each segment at fixed phases.
  std::optional<ShootingLinearisation> linearise(const System& system, const Vector& u,
                                                 std::span<const System* const> tangents,
                                                 std::vector<Matrix>* factors = nullptr) const;
  // Multipliers of a solution: those of the product of the slopes, and 2m exact zeros, since the
  // held motion does not depend on what came before. Empty where a segment cannot be followed.
  std::vector<Eigenvalue> multipliers(const System& system, const Vector& u,
                                      ErrorBounds errors) const;
  std::vector<Eigenvalue> multipliers(const System& system, const std::vector<Matrix>& factors,
                                      ErrorBounds errors) const;
  // Values of the products, as far as they depend on the x_i of one section (and on theta and the
  // parameters), and the contacts of the motion from there.
  struct Products {
    ComplexVector sums;
    std::vector<PassedContact> contacts;
  };
  // Returns nullopt when a segment cannot be followed.
  std::optional<Products> products(const System& system, const Vector& u, int section,
                                   const std::vector<SegmentProduct>& products) const;

  // The segments from section to section; empty where one cannot be followed.
  std::vector<TrajectorySegment> follow(const System& system, const Vector& u,
                                        bool minima = false) const;
  // Quantities that must stay positive for the events to stay the same, in time order; `direction`:
  // rates of the unknowns, and of the parameter that moves the system along `tangent`.
  std::optional<std::vector<SegmentMargin>> margins(const System& system, const Vector& u,
                                                    const System& tangent, const Vector& direction,
                                                    double parameter_rate) const;

 private:
  // The force at the section and its derivatives.
  struct Force {
    double value = 0.0, by_theta = 0.0;
    Eigen::RowVectorXd by_x, by_parameters;
  };
  Force force(const System& system, const Vector& u, const SectionMap::Chart& chart,
              std::span<const System* const> tangents) const;

  std::optional<ShootingLinearisation> linearise_free(const System& system, const Vector& u,
                                                      std::span<const System* const> tangents,
                                                      std::vector<Matrix>* factors) const;

  SegmentLayout layout_;
  double rate_ = 0.0;  // rad/s, of which the logarithm counts; 0: the period is known
  SectionMap map_;
  double push_ = 1.0;  // unit of the force equation, m/s^2
};

}  // namespace graze
