// The equations of a locus: those of the orbits, and that A(mu) (zero_problem.hpp) is singular at
// the mu of the locus, by the test function g of bordering.hpp.
//
//   LP, PD   F(u, p, q) = 0, g(mu) = 0 with mu = 1, -1, in (u, p/range);
//   NS       F(u, p, q) = 0, Re g(mu) = 0, d = 0 with mu = e^{i angle}, in (u, p/range, angle),
//
//   d = (g(mu) - g(conj mu))/(mu - conj mu) = -w(mu)^T closing v(conj mu)/a,
//
// d is Im g/sin(angle), and at angles 0 and pi the derivative of g by mu, whereas Im g vanishes
// there for all solutions. So the equations are regular at resonances 1:1 and 1:2 too, where the
// pair becomes real; they are even functions of the angle there.
//
// Borders are those of the nearest known point of the locus. On LP and PD g is taken with the sign
// of det A: g passes zero between two loci that nearly cross, where borders that follow one of them
// fail, and would reverse the orientation once more. So a step from one to the other is detected.
// On NS a change of borders multiplies g by a complex number, which does not change the
// orientation.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "graze/continuation/branch/branch_values.hpp"
#include "graze/continuation/branch/detail/bordering.hpp"
#include "graze/continuation/branch/zero_problem.hpp"
#include "graze/continuation/locus/locus_values.hpp"

namespace graze {

class LocusEquations {
 public:
  // Refers to the problem, which must outlive it. The ranges are lengths.
  LocusEquations(const ZeroProblem& problem, LocusKind kind, double first_range,
                 double second_range)
      : problem_(problem), kind_(kind), range_(first_range), second_range_(second_range) {}

  // (u, p/range) or (u, p/range, angle).
  Vector pack(const Vector& u, double first, double angle) const;
  // n, for an unknown of the locus.
  Eigen::Index size_of(const Vector& y) const { return y.size() - (is_torus() ? 2 : 1); }
  double first_of(const Vector& y) const { return y[size_of(y)] * range_; }
  std::array<double, 2> parameters_of(const Vector& y, double second) const {
    return {first_of(y), second};
  }
  double angle_of(const Vector& y) const;
  Complex multiplier_of(const Vector& y) const;

  // Drops all borders but those that suit A(mu) there; false when that cannot be evaluated.
  bool start_at(const Vector& y, double second);
  // Drops all borders but those of a point, on the side of those that it was solved with.
  void start_at(const SolutionPoint& point);
  // Adds a point of the locus: its borders are used around it.
  void add(const SolutionPoint& point);
  // Angle by which the critical vectors of LP and PD turn from one point to a neighbour just solved
  // for, rad, the larger of both; 0 on NS, where they span planes.
  double turn(const SolutionPoint& from, const SolutionPoint& to) const;
  // Whether A(mu) is singular there, judged by borders of its own.
  bool is_on_locus(const SolutionPoint& point);
  // Returns nullopt when F cannot be evaluated.
  std::optional<ZeroEvaluation> evaluate(const Vector& y, double second);
  // The multipliers of the orbit except the critical ones.
  std::vector<Eigenvalue> other_multipliers(const Vector& y, double second,
                                            ErrorBounds errors) const;
  // w^T A_u v v and w^T closing v of LP and PD, w and v unit and on the side of the borders at
  // `from`. Returns nullopt when F cannot be evaluated.
  std::optional<std::array<double, 2>> degeneracies(const SolutionPoint& from,
                                                    const SolutionPoint& at);
  // Evaluations of F so far.
  long long evaluations() const { return evaluations_; }

 private:
  struct Anchor {
    Vector y;
    double second = 0.0;
    Borders borders;
  };
  // The box around neighbouring anchors, in the metric of the locus.
  struct Block {
    Vector low, high;
    double low_across = 0.0, high_across = 0.0;
    void add(const Vector& y, double across);
    double squared_distance(const Vector& y, double across) const;
  };
  struct TestRows {
    Vector value;     // 1 or 2
    Matrix slope;     // by (u, p, q), 1 or 2 x (n + 2)
    Vector by_angle;  // 1 or 2
  };

  bool is_torus() const { return kind_ == LocusKind::kTorus; }
  std::optional<ZeroEvaluation> evaluate_plane(const Vector& y, double second);
  const Borders& borders_near(const Vector& y, double second) const;
  void add_anchor(Anchor anchor);
  void forget_anchors();
  void remember(const Vector& y, double second, Borders borders);
  std::optional<TestRows> real_rows(const ZeroEvaluation& at, const Vector& y, double second);
  std::optional<TestRows> torus_rows(const ZeroEvaluation& at, const Vector& y, double second);

  const ZeroProblem& problem_;
  LocusKind kind_;
  double range_, second_range_;
  std::vector<Anchor> anchors_;
  std::vector<Block> blocks_;  // of the anchors, in their order
  // Borders at the latest evaluations of F: one of these becomes a point.
  std::vector<Anchor> recent_;
  std::size_t oldest_ = 0;
  long long evaluations_ = 0;
};

}  // namespace graze
