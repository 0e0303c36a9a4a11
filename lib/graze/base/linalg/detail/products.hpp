// Products of small matrices of either scalar of a motion, double and 50 digits. What Eigen makes
// of one takes a second or two of compile time in every file that forms it, so each scalar's are
// compiled once.
#pragma once

#include "graze/base/vector.hpp"

namespace graze {

template <class Real>
RealMatrix<Real> product(const RealMatrix<Real>& a, const RealMatrix<Real>& b);  // A B

template <class Real>
RealMatrix<Real> transposed_product(const RealMatrix<Real>& a, const RealMatrix<Real>& b);  // A^T B

template <class Real>
RealVector<Real> image(const RealMatrix<Real>& a, const RealVector<Real>& x);  // A x

template <class Real>
RealVector<Real> transposed_image(const RealMatrix<Real>& a, const RealVector<Real>& x);  // A^T x

}  // namespace graze
