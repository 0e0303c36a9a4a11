#include "graze/base/linalg/detail/products.hpp"

namespace graze {

template <>
Matrix product(const Matrix& a, const Matrix& b) {
  return a * b;
}

template <>
Matrix transposed_product(const Matrix& a, const Matrix& b) {
  return a.transpose() * b;
}

template <>
Vector image(const Matrix& a, const Vector& x) {
  return a * x;
}

template <>
Vector transposed_image(const Matrix& a, const Vector& x) {
  return a.transpose() * x;
}

}  // namespace graze
