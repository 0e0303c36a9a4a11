// The dense vector and matrix types that all rooms share.
#pragma once

#include <Eigen/Core>
#include <complex>

namespace graze {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Complex = std::complex<double>;
using ComplexVector = Eigen::VectorXcd;
// Vectors of any scalar type that motions are computed in (double, or 50 digits).
template <class Real>
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
template <class Real>
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

}  // namespace graze
