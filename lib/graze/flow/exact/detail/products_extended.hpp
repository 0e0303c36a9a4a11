// Products of small matrices of 50 digits (products.hpp), in loops: what Eigen makes of them in
// this scalar takes the compiler half a minute, for matrices of a few rows.
#pragma once

#include "graze/base/linalg/detail/products.hpp"
#include "graze/flow/exact/extended.hpp"

namespace graze {

template <>
RealMatrix<Extended> product(const RealMatrix<Extended>& a, const RealMatrix<Extended>& b);
template <>
RealMatrix<Extended> transposed_product(const RealMatrix<Extended>& a,
                                        const RealMatrix<Extended>& b);
template <>
RealVector<Extended> image(const RealMatrix<Extended>& a, const RealVector<Extended>& x);
template <>
RealVector<Extended> transposed_image(const RealMatrix<Extended>& a, const RealVector<Extended>& x);

}  // namespace graze
