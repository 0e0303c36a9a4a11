#include "graze/orbit/problem/detail/impact_coordinates.hpp"

#include "graze/base/linalg/detail/linear_equations.hpp"

namespace graze {

ImpactCoordinates::ImpactCoordinates(const Matrix& own, const MotionScale& scale)
    : unit_q_(scale.displacement / scale.length), unit_v_(scale.velocity / scale.speed) {
  const Matrix inverse = LuFactors(own).inverse();
  shape_q_ = own * unit_q_;
  shape_v_ = own * unit_v_.asDiagonal();
  inverse_q_ = inverse / unit_q_;
  inverse_v_ = unit_v_.cwiseInverse().asDiagonal() * inverse;
}

}  // namespace graze
