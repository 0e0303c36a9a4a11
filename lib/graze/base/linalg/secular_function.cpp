#include "graze/base/linalg/detail/secular_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "graze/base/linalg/detail/arithmetic.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/base/linalg/detail/products.hpp"

namespace graze {
namespace {

using Eigen::Index;
using RealPair = Eigen::Matrix2d;

// Roundings of an entry of a product of two by two.
constexpr double kRoundingsOfBlock = 4.0;

// Next to an eigenvalue at which the elimination meets an exact zero.
constexpr double kBeside = 1.0 + 0x1p-48;

RealPair block_of(const JumpAndFlow& factor, Index mode) {
  RealPair block;
  block << factor.qq[mode], factor.qv[mode], factor.vq[mode], factor.vv[mode];
  return block;
}

// The mode's rows of P or Q, 2 x r.
Eigen::Matrix<double, 2, Eigen::Dynamic> rows_of(const Matrix& matrix, Index mode) {
  Eigen::Matrix<double, 2, Eigen::Dynamic> rows(2, matrix.cols());
  rows << matrix.row(mode), matrix.row(matrix.rows() / 2 + mode);
  return rows;
}

// All flows from a factor on, on round the cycle up to the one before another one; of one to itself
// all of them.
RealPair flows_between(const std::vector<JumpAndFlow>& factors, std::size_t from, std::size_t to,
                       Index mode) {
  RealPair product = RealPair::Identity();
  std::size_t i = from;
  do {
    product = (block_of(factors[i], mode) * product).eval();
    i = (i + 1) % factors.size();
  } while (i != to);
  return product;
}

// The matrix less its mean, which is half its trace.
RealPair centred(const RealPair& block) {
  const double half = 0.5 * (block(0, 0) - block(1, 1));
  RealPair rest;
  rest << half, block(0, 1), block(1, 0), -half;
  return rest;
}

PolePair eigenvalues_of(const RealPair& block) {
  const double mean = 0.5 * (block(0, 0) + block(1, 1));
  const RealPair rest = centred(block);
  const double square = rest(0, 0) * rest(0, 0) + rest(0, 1) * rest(1, 0);
  const double root = std::sqrt(std::abs(square));
  if (square < 0.0) return {Complex(mean, root), Complex(mean, -root)};
  return {mean + root, mean - root};
}

// The inverse without the tests for infinite parts that std::complex makes.
Complex inverse_of(Complex z) {
  const double size = std::norm(z);
  return {z.real() / size, -z.imag() / size};
}

ComplexVector flown(const JumpAndFlow& factor, const ComplexVector& x) {
  const Index n = factor.qq.size();
  ComplexVector end(2 * n);
  end.head(n) = factor.qq.cast<Complex>().cwiseProduct(x.head(n)) +
                factor.qv.cast<Complex>().cwiseProduct(x.tail(n));
  end.tail(n) = factor.vq.cast<Complex>().cwiseProduct(x.head(n)) +
                factor.vv.cast<Complex>().cwiseProduct(x.tail(n));
  return end;
}

ComplexVector flown_transposed(const JumpAndFlow& factor, const ComplexVector& y) {
  const Index n = factor.qq.size();
  ComplexVector start(2 * n);
  start.head(n) = factor.qq.cast<Complex>().cwiseProduct(y.head(n)) +
                  factor.vq.cast<Complex>().cwiseProduct(y.tail(n));
  start.tail(n) = factor.qv.cast<Complex>().cwiseProduct(y.head(n)) +
                  factor.vv.cast<Complex>().cwiseProduct(y.tail(n));
  return start;
}

// The inverse of a matrix up to a factor: of a singular one too, where it is of two rows.
Eigen::MatrixXcd adjugate(const Eigen::MatrixXcd& g) {
  if (g.rows() != 2) return inverse(g);
  Eigen::MatrixXcd result(2, 2);
  result << g(1, 1), -g(0, 1), -g(1, 0), g(0, 0);
  return result;
}

// Adds to the entries [from, to) what a mode contributes: factors of its constant and linear parts,
// and of both in the slope.
void add(Eigen::Array<double, Eigen::Dynamic, 4>& sums, Index from, Index to,
         const double* constant, const double* linear, const std::array<Complex, 4>& factors) {
  const auto& [a, b, a_slope, b_slope] = factors;
  double* const re = sums.col(0).data();
  double* const im = sums.col(1).data();
  double* const slope_re = sums.col(2).data();
  double* const slope_im = sums.col(3).data();
  for (Index e = from; e < to; ++e) {
    re[e] += constant[e] * a.real() + linear[e] * b.real();
    im[e] += constant[e] * a.imag() + linear[e] * b.imag();
    slope_re[e] += constant[e] * a_slope.real() + linear[e] * b_slope.real();
    slope_im[e] += constant[e] * a_slope.imag() + linear[e] * b_slope.imag();
  }
}

}  // namespace

// |F + (F P) Q^T|^2 = |F|^2 + 2 tr F^T F P Q^T + tr (F P)^T F P Q^T Q.
double JumpAndFlow::norm() const {
  const Index n = qq.size();
  Matrix flown(from.rows(), from.cols());
  flown.topRows(n) = qq.asDiagonal() * from.topRows(n) + qv.asDiagonal() * from.bottomRows(n);
  flown.bottomRows(n) = vq.asDiagonal() * from.topRows(n) + vv.asDiagonal() * from.bottomRows(n);
  Matrix back(from.rows(), from.cols());
  back.topRows(n) = qq.asDiagonal() * flown.topRows(n) + vq.asDiagonal() * flown.bottomRows(n);
  back.bottomRows(n) = qv.asDiagonal() * flown.topRows(n) + vv.asDiagonal() * flown.bottomRows(n);
  const double square = qq.squaredNorm() + qv.squaredNorm() + vq.squaredNorm() + vv.squaredNorm() +
                        2.0 * back.cwiseProduct(to).sum() +
                        transposed_product<double>(flown, flown)
                            .cwiseProduct(transposed_product<double>(to, to))
                            .sum();
  return std::sqrt(std::max(square, 0.0));
}

SecularFunction::SecularFunction(const std::vector<JumpAndFlow>& factors) : factors_(factors) {
  const Index n = factors.front().qq.size();
  first_.push_back(0);
  for (const JumpAndFlow& factor : factors) first_.push_back(first_.back() + factor.from.cols());
  mean_.resize(n);
  flow_norm_.resize(n);
  centred_.assign(factors.size(), Matrix(4, n));
  for (Index m = 0; m < n; ++m)
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const RealPair all = flows_between(factors, i, i, m), rest = centred(all);
      centred_[i].col(m) << rest(0, 0), rest(0, 1), rest(1, 0), rest(1, 1);
      if (i > 0) continue;
      mean_[m] = 0.5 * (all(0, 0) + all(1, 1));
      flow_norm_[m] = all.norm();
      poles_.push_back(eigenvalues_of(all));
    }
  counted_.setOnes(n);
  const Index size = first_.back();
  constant_.resize(size * size, n);
  linear_.resize(size * size, n);
  for (const bool delayed : {false, true}) {
    direct_ = delayed ? static_cast<Index>(entries_.size()) : 0;
    for (std::size_t column = 0; column < factors.size(); ++column)
      for (std::size_t row = 0; row < factors.size(); ++row)
        if (delayed == (column < row)) add_entries(row, column);
  }
}

// The entries of a factor's rows and another one's columns: (mu - D)^-1 is (mu - mean + K) over the
// product of mu - l.
void SecularFunction::add_entries(std::size_t row, std::size_t column) {
  const auto at = static_cast<Index>(entries_.size());
  for (Index c = first_[column]; c < first_[column + 1]; ++c)
    for (Index r = first_[row]; r < first_[row + 1]; ++r) entries_.push_back(r + c * first_.back());
  for (Index m = 0; m < modes(); ++m) {
    const RealPair flow = flows_between(factors_, column, row, m);
    RealPair rest;
    rest << centred_[column](0, m), centred_[column](1, m), centred_[column](2, m),
        centred_[column](3, m);
    const Matrix left = rows_of(factors_[row].to, m).transpose() * flow;
    const Matrix right = rows_of(factors_[column].from, m);
    const Matrix linear = left * right;
    const Matrix constant = left * (rest * right) - mean_[m] * linear;
    linear_.col(m).segment(at, linear.size()) = linear.reshaped();
    constant_.col(m).segment(at, linear.size()) = constant.reshaped();
  }
}

void SecularFunction::leave_out(Index mode) { counted_[mode] = 0.0; }

PolePair SecularFunction::alone(Index mode) const {
  RealPair product = RealPair::Identity();
  for (const JumpAndFlow& factor : factors_) {
    const RealPair jump =
        RealPair::Identity() + rows_of(factor.from, mode) * rows_of(factor.to, mode).transpose();
    product = (block_of(factor, mode) * jump * product).eval();
  }
  return eigenvalues_of(product);
}

SecularFunction::Values SecularFunction::evaluate(Complex mu) const {
  const Index count = constant_.rows();
  // Real and imaginary parts of G and its slope.
  Eigen::Array<double, Eigen::Dynamic, 4> sums =
      Eigen::Array<double, Eigen::Dynamic, 4>::Zero(count, 4);
  Complex poles = 0.0;
  for (Index m = 0; m < modes(); ++m) {
    const PolePair& pole = poles_[static_cast<std::size_t>(m)];
    const Complex a = mu - pole.first, b = mu - pole.second;
    // 1/((mu - l1)(mu - l2)) and its derivative, and those of its products with powers of mu.
    const Complex h = times(inverse_of(a), inverse_of(b));
    const Complex both = times(a + b, h), fall = -times(both, h);
    const Complex once = times(mu, h), once_slope = h + times(mu, fall);
    poles += counted_[m] * both;
    const double* const constant = constant_.col(m).data();
    const double* const linear = linear_.col(m).data();
    add(sums, 0, direct_, constant, linear, {h, once, fall, once_slope});
    if (direct_ == count) continue;
    add(sums, direct_, count, constant, linear,
        {once, times(mu, once), once_slope, once + times(mu, once_slope)});
  }
  const Index size = first_.back();
  Values values{Eigen::MatrixXcd::Identity(size, size), Eigen::MatrixXcd(size, size), poles};
  for (Index e = 0; e < count; ++e) {
    const Index at = entries_[static_cast<std::size_t>(e)];
    values.g.data()[at] -= Complex(sums(e, 0), sums(e, 1));
    values.slope.data()[at] = -Complex(sums(e, 2), sums(e, 3));
  }
  return values;
}

Complex SecularFunction::logarithmic_slope(Complex mu) const {
  const auto [g, slope, poles] = evaluate(mu);
  if (g.rows() != 2) return poles + inverse(g).transpose().cwiseProduct(slope).sum();
  const Complex determinant = times(g(0, 0), g(1, 1)) - times(g(0, 1), g(1, 0));
  const Complex rate = times(slope(0, 0), g(1, 1)) + times(g(0, 0), slope(1, 1)) -
                       times(slope(0, 1), g(1, 0)) - times(g(0, 1), slope(1, 0));
  return poles + times(rate, inverse_of(determinant));
}

double SecularFunction::log_modulus(Complex mu) const {
  double sum = ComplexLuFactors(evaluate(mu).g).log_modulus();
  for (Index m = 0; m < modes(); ++m) {
    const PolePair& pole = poles_[static_cast<std::size_t>(m)];
    if (counted_[m] > 0.0)
      sum += std::log(std::abs(mu - pole.first)) + std::log(std::abs(mu - pole.second));
  }
  return sum;
}

// Far out G = G_0 + C/mu, and log det(mu - M) - log det(mu - D) = (tr D - tr M)/mu.
double SecularFunction::trace() const {
  const Index size = first_.back();
  Matrix far = Matrix::Identity(size, size), falling(size, size);
  for (Index e = 0; e < constant_.rows(); ++e) {
    const Index at = entries_[static_cast<std::size_t>(e)];
    const double all = linear_.row(e).sum();
    if (e < direct_) {
      falling.data()[at] = -all;
      continue;
    }
    far.data()[at] -= all;
    falling.data()[at] = -(constant_.row(e).sum() + 2.0 * linear_.row(e).dot(mean_));
  }
  return 2.0 * mean_.sum() - LuFactors(far).solve_columns(falling).trace();
}

// |I + P Q^T|^2 = 2n + 2 tr P^T Q + tr P^T P Q^T Q.
double SecularFunction::jump_norm(std::size_t factor) const {
  const Matrix &p = factors_[factor].from, &q = factors_[factor].to;
  const double square =
      static_cast<double>(p.rows()) + 2.0 * p.cwiseProduct(q).sum() +
      transposed_product<double>(p, p).cwiseProduct(transposed_product<double>(q, q)).sum();
  return std::sqrt(std::max(square, 0.0));
}

// (mu - D_1)^-1 x, or of the transposed matrix.
ComplexVector SecularFunction::over_poles(Complex mu, const ComplexVector& x,
                                          bool transposed) const {
  const Index n = modes();
  const Matrix& k = centred_.front();
  const Index up = transposed ? 2 : 1, down = transposed ? 1 : 2;
  ComplexVector result(2 * n);
  for (Index m = 0; m < n; ++m) {
    const PolePair& pole = poles_[static_cast<std::size_t>(m)];
    const Complex h = times(inverse_of(mu - pole.first), inverse_of(mu - pole.second));
    const Complex shifted = mu - mean_[m];
    result[m] = h * ((shifted + k(0, m)) * x[m] + k(up, m) * x[n + m]);
    result[n + m] = h * (k(down, m) * x[m] + (shifted + k(3, m)) * x[n + m]);
  }
  return result;
}

double SecularFunction::first_order_error(Complex mu, double roundings) const {
  // Of a nearly singular G the inverse is the product of both null vectors.
  Eigen::MatrixXcd product = adjugate(evaluate(mu).g);
  if (!product.allFinite()) product = adjugate(evaluate(mu * kBeside).g);
  if (!product.allFinite()) return std::numeric_limits<double>::infinity();
  Index row = 0, column = 0;
  product.cwiseAbs().maxCoeff(&row, &column);
  const ComplexVector right = product.col(column) / product(row, column),
                      left = product.row(row).transpose() / product(row, column);
  // Since M x = mu x, what the jumps add to x flows round the cycle to its start; what they take
  // from y flows likewise backwards.
  const Index n = modes();
  const std::size_t k = factors_.size();
  ComplexVector x = ComplexVector::Zero(2 * n), y = x;
  for (std::size_t i = 0; i < k; ++i) {
    const JumpAndFlow& factor = factors_[i];
    x = flown(factor, x + factor.from * right.segment(first_[i], factor.from.cols()));
  }
  for (std::size_t i = k; i-- > 0;) {
    const JumpAndFlow& factor = factors_[i];
    y = flown_transposed(factor, y) + factor.to * left.segment(first_[i], factor.to.cols());
  }
  x = over_poles(mu, x, false);
  y = over_poles(mu, y, true);
  const double product_of_both = std::abs((x.transpose() * y).value());
  std::vector<ComplexVector> before{x};
  for (std::size_t i = 0; i + 1 < k; ++i)
    before.push_back(
        flown(factors_[i],
              before[i] + factors_[i].from * right.segment(first_[i], factors_[i].from.cols())));
  double sum = 0.0;
  for (std::size_t i = k; i-- > 0;) {
    const JumpAndFlow& factor = factors_[i];
    const ComplexVector after =
        before[i] + factor.from * right.segment(first_[i], factor.from.cols());
    const ComplexVector back = flown_transposed(factor, y);
    sum += roundings * jump_norm(i) * back.norm() * before[i].norm();
    for (Index m = 0; m < n; ++m) {
      const double size = block_of(factor, m).norm();
      sum += (factor.uncertainty[m] + kRoundingsOfBlock) * size *
             std::sqrt(std::norm(y[m]) + std::norm(y[n + m])) *
             std::sqrt(std::norm(after[m]) + std::norm(after[n + m]));
    }
    y = back + factor.to * left.segment(first_[i], factor.to.cols());
  }
  return std::numeric_limits<double>::epsilon() * sum / product_of_both;
}

}  // namespace graze
