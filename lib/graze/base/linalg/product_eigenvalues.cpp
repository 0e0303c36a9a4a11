#include "graze/base/linalg/detail/product_eigenvalues.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/detail/scaled.hpp"
#include "graze/base/linalg/detail/arithmetic.hpp"
#include "graze/base/linalg/detail/periodic_schur.hpp"
#include "graze/base/linalg/detail/triangular_factors.hpp"
#include "graze/base/stop_scope.hpp"

namespace graze {
namespace {

using Eigen::Index;
using Factors = TriangularFactors;

// Scales a matrix by a power of two to entries of at most 1; returns the exponent taken out.
int take_exponent(Matrix& matrix) {
  const double size = matrix.cwiseAbs().maxCoeff();
  if (!(size > 0.0)) return 0;
  const int exponent = std::ilogb(size) + 1;
  // In two halves: 2^1074 is out of range.
  matrix *= std::ldexp(1.0, -exponent / 2);
  matrix *= std::ldexp(1.0, -(exponent - exponent / 2));
  return exponent;
}

// First-order errors of the eigenvalues in units of 2^exponent (see the header).
std::vector<Scaled<double>> first_order_errors(const Factors& factors, double roundings,
                                               long exponent) {
  const Index n = factors[0].rows(), k = static_cast<Index>(factors.size());
  const double unit = std::numeric_limits<double>::epsilon() * roundings;
  const auto [right, left] = vector_norms(factors);
  std::vector<Scaled<double>> errors;
  for (Index j = 0; j < n; ++j) {
    // |l| without its zero factors, of which one may be left out.
    Scaled<double> product{1.0, exponent};
    Index zeros = 0;
    for (const Eigen::MatrixXcd& factor : factors) {
      const double t = std::abs(factor(j, j));
      if (t == 0.0)
        ++zeros;
      else
        product.times(t);
    }
    double sum = 0.0;
    for (Index i = 0; i < k; ++i) {
      const Eigen::MatrixXcd& factor = factors[static_cast<std::size_t>(i)];
      const double t = std::abs(factor(j, j));
      const bool only_zero = zeros == 1 && t == 0.0;
      if (zeros > 0 && !only_zero) continue;
      sum += factor.norm() * left((i + 1) % k, j) * right(i, j) / (only_zero ? 1.0 : t);
    }
    const bool defective = !std::isfinite(right.col(j).sum() + left.col(j).sum());
    product.times(defective ? kInfinity : unit * sum);
    errors.push_back(product);
  }
  return errors;
}

// Elsner's bound for the product, in units of 2^exponent; infinite where it was asked to stop.
Scaled<double> elsner_bound(const Factors& factors, double roundings, long exponent) {
  const Index n = factors[0].rows();
  const std::size_t k = factors.size();
  const double unit = std::numeric_limits<double>::epsilon() * roundings;
  // Norms of the products of the first i and the last k - i factors.
  const auto norms = [&](bool forwards) {
    std::vector<Scaled<double>> list{{1.0, 0}};
    Eigen::MatrixXcd product = Eigen::MatrixXcd::Identity(n, n);
    for (std::size_t i = 0; i < k; ++i) {
      product = forwards ? (factors[i] * product).eval() : (product * factors[k - 1 - i]).eval();
      const double size = product.norm();
      Scaled<double> norm = list.back();
      norm.times(size);
      list.push_back(norm);
      if (size > 0.0) product /= size;
      if (StopScope::is_over()) list.back().mantissa = kInfinity;
    }
    return list;
  };
  const std::vector<Scaled<double>> before = norms(true), after = norms(false);
  const double log2_norm = std::log2(before[k].mantissa) + static_cast<double>(before[k].exponent);
  double log2_error = -kInfinity;
  for (std::size_t i = 0; i < k; ++i) {
    Scaled<double> term = before[i];
    term.times(after[k - 1 - i].mantissa);
    term.exponent += after[k - 1 - i].exponent;
    term.times(unit * factors[i].norm() * static_cast<double>(k));
    log2_error =
        std::max(log2_error, std::log2(term.mantissa) + static_cast<double>(term.exponent));
  }
  if (!(log2_error > -kInfinity)) return {0.0, 0};
  // |M| + e is at most twice the larger.
  const double share = 1.0 / static_cast<double>(n);
  const double log2_bound =
      (1.0 - share) * (std::max(log2_norm, log2_error) + 1.0) + share * log2_error;
  const double whole = std::floor(log2_bound);
  return {std::exp2(log2_bound - whole), exponent + static_cast<long>(whole)};
}

// The eigenvalues along the diagonal, times 2^exponent.
std::vector<Eigenvalue> diagonal_products(const Factors& factors, long exponent) {
  std::vector<Eigenvalue> list;
  for (Index j = 0; j < factors[0].rows(); ++j) {
    Scaled<Complex> value{1.0, exponent};
    for (const Eigen::MatrixXcd& factor : factors) value.times(factor(j, j));
    list.push_back({value.value(), 0.0});
  }
  return list;
}

// Adds the errors of these eigenvalues.
void add_errors(const Factors& factors, double roundings, long exponent,
                std::vector<Eigenvalue>& list) {
  const std::vector<Scaled<double>> errors = first_order_errors(factors, roundings, exponent);
  std::optional<double> elsner;
  for (std::size_t j = 0; j < list.size(); ++j) list[j].error = errors[j].value();
  bound_together(factors, roundings, exponent, list);
  for (std::size_t j = 0; j < list.size(); ++j) {
    // Only an eigenvalue as sensitive as this can have an error above the other bound.
    if (list[j].error < 1e-3 * std::abs(list[j].value)) continue;
    if (!elsner) elsner = elsner_bound(factors, roundings, exponent).value();
    list[j].error = std::isnan(list[j].error) ? *elsner : std::min(list[j].error, *elsner);
  }
}

}  // namespace

std::vector<Eigenvalue> product_eigenvalues(const std::vector<Matrix>& factors, ErrorBounds errors,
                                            double uncertainty) {
  if (factors.empty() || factors.front().size() == 0) return {};
  for (const Matrix& factor : factors)
    if (!factor.allFinite()) return {};
  if (factors.size() == 1) return eigenvalues(factors.front(), errors, uncertainty);
  long exponent = 0;
  std::vector<Matrix> scaled = factors;
  for (Matrix& factor : scaled) exponent += take_exponent(factor);
  const std::optional<PeriodicSchurForm> form = periodic_schur(std::move(scaled));
  if (!form) return {};
  std::vector<Eigenvalue> list = diagonal_products(form->factors, exponent);
  if (errors == ErrorBounds::kGiven)
    add_errors(form->factors, static_cast<double>(factors.front().rows()) + uncertainty, exponent,
               list);
  for (std::size_t j = 0, pair = 0; j < list.size(); ++j) {
    if (pair == form->pairs.size() || form->pairs[pair] != static_cast<Index>(j)) {
      list[j].value = list[j].value.real();
      continue;
    }
    // Computed apart, they are conjugate up to their errors.
    const Complex first = list[j].value, second = std::conj(list[j + 1].value);
    list[j].value = 0.5 * (first + second);
    list[j + 1].value = std::conj(list[j].value);
    if (errors == ErrorBounds::kGiven)
      list[j].error = list[j + 1].error =
          std::max({list[j].error, list[j + 1].error, 0.5 * std::abs(first - second)});
    ++j, ++pair;
  }
  sort_eigenvalues(list);
  return list;
}

}  // namespace graze
