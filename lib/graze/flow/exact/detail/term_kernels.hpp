// Exponentials of an arc several at a time, by the widest vector unit that the processor has
// (Google's Highway; chosen at run time). Results of different units differ by rounding.
//
// Columns hold one number per term and end at a multiple of kColumnStep; what lies behind the last
// term is zero.
#pragma once

#include <cstddef>

#include "graze/flow/exact/detail/vector_columns.hpp"

namespace graze {

// Up to here, in rad, half angles are reduced by multiples of pi/2 that are exact products; beyond,
// the standard library does it.
inline constexpr double kFarthestHalfAngle = 32768.0;

// Terms Re(k (e^{l s} - 1)), l = -decay + i frequency.
struct TermColumns {
  const double *decay, *half_frequency, *rate_size;  // 1/s, rad/s, |l|
  const double *re, *im, *size, *rounded;            // k, |k|, what k was rounded at
  std::size_t count;
  double quickest;  // largest half frequency
};

// Sums over all terms for derivative m.
struct TermSums {
  double value, slope, curvature, bound, third, rounding;
};

// The contribution of each term; null: not requested.
struct TermShareColumns {
  double *slope, *curvature, *third, *fall;
};

void sum_terms(const TermColumns& terms, double s, int m, TermSums& sums,
               const TermShareColumns& shares);

// e^{l s} - 1, in columns that may be as long as the terms' own.
void turn_terms(const double* decay, const double* half_frequency, std::size_t count,
                double quickest, double s, double* re_minus_one, double* im);

}  // namespace graze
