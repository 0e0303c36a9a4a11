#include "support/product_reference.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>

#include "graze/base/linalg/detail/product_eigenvalues.hpp"

namespace graze::support {

Matrix random_matrix(Dice& dice, int n) {
  Matrix matrix(n, n);
  for (double& entry : matrix.reshaped()) entry = dice.uniform(-1.0, 1.0);
  return matrix;
}

Matrix random_rotation(Dice& dice, int n) {
  return Eigen::HouseholderQR<Matrix>(random_matrix(dice, n)).householderQ();
}

Extended ExtendedComplex::distance(Complex z) const {
  const Extended x = re - Extended(z.real()), y = im - Extended(z.imag());
  return sqrt(x * x + y * y);
}

Extended ExtendedComplex::modulus() const { return sqrt(re * re + im * im); }

std::vector<ExtendedComplex> extended_eigenvalues(const ExtendedMatrix& product) {
  const Eigen::Index n = product.rows();
  const Eigen::EigenSolver<ExtendedMatrix> solver(product, false);
  std::vector<ExtendedComplex> list;
  for (Eigen::Index i = 0; i < n; ++i)
    list.push_back({solver.eigenvalues()[i].real(), solver.eigenvalues()[i].imag()});
  return list;
}

std::vector<ExtendedComplex> extended_eigenvalues(const std::vector<Matrix>& factors) {
  const Eigen::Index n = factors[0].rows();
  ExtendedMatrix product = ExtendedMatrix::Identity(n, n);
  for (const Matrix& factor : factors) product = (factor.cast<Extended>() * product).eval();
  return extended_eigenvalues(product);
}

Comparison compare(const std::vector<Eigenvalue>& values, std::vector<ExtendedComplex> expected) {
  Comparison worst;
  EXPECT_EQ(values.size(), expected.size());
  if (values.size() != expected.size()) return worst;
  for (const Eigenvalue& value : values) {
    const auto nearest =
        std::min_element(expected.begin(), expected.end(), [&](const auto& a, const auto& b) {
          return a.distance(value.value) < b.distance(value.value);
        });
    const double error = static_cast<double>(nearest->distance(value.value));
    const double modulus = static_cast<double>(nearest->modulus());
    worst.of_value = std::max(worst.of_value, error / modulus);
    worst.of_error = std::max(worst.of_error, error / value.error);
    worst.given = std::max(worst.given, value.error / modulus);
    expected.erase(nearest);
  }
  return worst;
}

Comparison compare(const std::vector<Matrix>& factors) {
  return compare(product_eigenvalues(factors), extended_eigenvalues(factors));
}

}  // namespace graze::support
