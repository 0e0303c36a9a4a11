// A test function for the singularity of a square matrix A, from A bordered by a column b, a row
// c^T and a zero:
//
//   [ A   a b ] [v]   [0]          [ A^T  a c ] [w]   [0]
//   [ a c^T 0 ] [g] = [a],         [ a b^T 0  ] [g] = [a],
//
// with a number `a` of the size of the entries that A is made of.
//
// The bordered matrix stays regular where the rank of A drops by one, if b and c are not orthogonal
// to the left and right null vectors of A. There g = 0, w and v are these null vectors, and
// nowhere else is g zero. It is about -sigma/a, with the smallest singular value sigma of A, and
// changes by dg = -w^T dA v/a. See W. Govaerts, Numerical Methods for Bifurcations of Dynamical
// Equilibria (SIAM 2000), chapter 3.
//
// The borders are real although A may be complex: so g is a real analytic function of the real
// variables that A depends on, and takes conjugate values at conjugate ones.
#pragma once

#include <type_traits>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/base/vector.hpp"

namespace graze {

struct Borders {
  Vector left, right;  // b, c, unit, n
  double scale = 1.0;  // a
};

// Scalar: double or Complex.
template <class Scalar>
class BorderedMatrix {
 public:
  using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Square = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  BorderedMatrix(const Square& matrix, const Borders& borders);

  Scalar test() const { return test_; }  // g
  // For a real matrix: the sign of its determinant; times g it has the sign of det A, whatever the
  // borders.
  int side() const requires std::is_same_v<Scalar, double> { return factors_.determinant_sign(); }
  const Column& left() const { return left_; }  // w, n
  const Column& right() const { return right_; }
  double scale() const { return scale_; }
  bool finite() const { return left_.allFinite() && right_.allFinite(); }

  // s of [A, a b; a c^T, 0] (s, .) = (r, 0), n; and of the transposed equations.
  Column solve(const Column& r) const;
  Column solve_transposed(const Column& r) const;
  // Borders that suit A and matrices near it, of this scale: along w and v, or for complex vectors
  // along the longer axis of the ellipses that these make. Real ones are on the side of the borders
  // used.
  Borders renewed(double scale) const;

 private:
  using Factors = std::conditional_t<std::is_same_v<Scalar, double>, LuFactors, ComplexLuFactors>;

  Factors factors_;
  double scale_;
  Scalar test_{};
  Column left_, right_;
};

// Borders for a matrix that is nearly singular, made of entries of this size.
template <class Scalar>
Borders first_borders(const typename BorderedMatrix<Scalar>::Square& matrix, double scale);

}  // namespace graze

extern template class graze::BorderedMatrix<double>;
extern template class graze::BorderedMatrix<graze::Complex>;
