#include "graze/flow/exact/detail/curve_terms.hpp"

#include <algorithm>

#include "graze/flow/exact/detail/curve_terms_impl.hpp"

namespace graze {

void CurveTerms<double>::reserve(std::size_t count) {
  const std::size_t stride = column_length(count);
  if (stride <= stride_) return;
  std::vector<double> columns(kColumns * stride, 0.0);
  for (std::size_t c = 0; c < kColumns; ++c)
    std::copy_n(columns_.begin() + static_cast<std::ptrdiff_t>(c * stride_), count_,
                columns.begin() + static_cast<std::ptrdiff_t>(c * stride));
  columns_ = std::move(columns);
  stride_ = stride;
}

void CurveTerms<double>::add(double decay, double frequency) {
  if (count_ == 0) {
    std::fill(columns_.begin(), columns_.end(), 0.0);
    quickest_ = 0.0;
  }
  if (count_ == stride_) reserve(2 * stride_ + 1);
  column(kDecay)[count_] = decay;
  column(kHalfFrequency)[count_] = 0.5 * frequency;
  column(kRateSize)[count_] = curve_terms_detail::rate_size_of(decay, frequency);
  quickest_ = std::max(quickest_, 0.5 * frequency);
  ++count_;
}

void CurveTerms<double>::set(std::size_t i, const PlanarNumber<double>& k, double formed_from) {
  const double size = curve_terms_detail::size_of(k);
  column(kRe)[i] = k.re;
  column(kIm)[i] = k.im;
  column(kSize)[i] = size;
  column(kRounded)[i] = size + formed_from;
}

void CurveTerms<double>::add_to(double s, int m, CurvePoint<double>& point,
                                TermShares<double>& shares) const {
  const TermColumns terms{column(kDecay), column(kHalfFrequency), column(kRateSize), column(kRe),
                          column(kIm),    column(kSize),          column(kRounded),  count_,
                          quickest_};
  const bool told_apart = count_ <= kMostShares;
  TermSums sums;
  sum_terms(terms, s, m, sums,
            told_apart ? TermShareColumns{shares.slope.data(), shares.curvature.data(),
                                          shares.third.data(), shares.fall.data()}
                       : TermShareColumns{});
  point.value += sums.value;
  point.slope += sums.slope;
  point.curvature += sums.curvature;
  point.bound += sums.bound;
  point.third += sums.third;
  point.noise += kTermRoundings * std::numeric_limits<double>::epsilon() * sums.rounding;
}

}  // namespace graze
