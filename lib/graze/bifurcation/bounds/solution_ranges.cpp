#include "graze/bifurcation/bounds/detail/solution_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/interval/detail/isolated_zeros.hpp"
#include "graze/bifurcation/bounds/detail/one_impact_form.hpp"

namespace graze {
namespace {

// Most cells times modes in a survey: about a second's worth.
constexpr long long kMostRangeWork = 1LL << 20;

}  // namespace

SolutionRanges::SolutionRanges(const SystemFamily& family, int stop, int period, double lowest,
                               double highest)
    : interpolant_(family, lowest, highest),
      stop_(stop),
      period_(period),
      length_(highest - lowest) {
  bool ends_everywhere = false;  // intervals end at zeros, though there are solutions on both sides
  int sign = 0;                  // of F; 0 before the first piece and after a gap between pieces
  long long left = kMostRangeWork / family.scene().modes();
  auto pieces_left = static_cast<long long>(interpolant_.pieces().size());
  std::optional<Range> open;
  const auto close = [&](double at, bool folds) {
    if (!open) return;
    open->to = at;
    open->folds_at_end = folds;
    ranges_.push_back(*open);
    open.reset();
  };
  for (const SystemInterpolant::Piece& piece : interpolant_.pieces()) {
    const long long allowed = left / pieces_left--;
    if (!piece.exists()) {
      close(piece.low, false);
      sign = 0;
      continue;
    }
    const auto f = [&](double low, double high) -> std::optional<MeanValueForm> {
      const auto form = one_impact_form(interpolant_.over(piece, low, high), stop_, period_);
      if (!form) return {};
      ends_everywhere = form->free_speed;
      return form->fold_function();
    };
    const IsolatedZeros found = isolated_zeros(f, piece.low, piece.high, allowed);
    evaluations_ += found.evaluations;
    left = std::max(left - found.evaluations, 0LL);
    undecided_ += found.undecided + (piece.agrees ? 0 : 1);
    widest_ = std::max({widest_, found.widest, piece.agrees ? 0.0 : piece.high - piece.low});
    // A fold may lie on the very boundary of two pieces.
    const int before = std::exchange(sign, found.first_sign);
    if (open && sign < 0 && !ends_everywhere) close(piece.low, true);
    if (!open && (sign > 0 || ends_everywhere)) open = Range{piece.low, 0.0, before < 0, false};
    for (const double zero : found.zeros) {
      sign = -sign;
      if (open) close(zero, !ends_everywhere);
      if (sign > 0 || ends_everywhere) open = Range{zero, 0.0, !ends_everywhere, false};
    }
  }
  close(highest, false);
}

std::optional<SystemForms> SolutionRanges::system_over(double low, double high) const {
  const auto& pieces = interpolant_.pieces();
  const auto after =
      std::upper_bound(pieces.begin(), pieces.end(), low,
                       [](double value, const auto& piece) { return value < piece.low; });
  if (after == pieces.begin()) return {};
  const SystemInterpolant::Piece& piece = *std::prev(after);
  if (!piece.exists() || high > piece.high) return {};
  return interpolant_.over(piece, low, high);
}

std::optional<std::size_t> SolutionRanges::range_of(double value) const {
  // A solution next to a fold may lie beyond it by its rounding.
  const auto distance = [value](const Range& range) {
    return std::max({range.from - value, value - range.to, 0.0});
  };
  const auto nearest =
      std::min_element(ranges_.begin(), ranges_.end(),
                       [&](const Range& a, const Range& b) { return distance(a) < distance(b); });
  if (nearest == ranges_.end()) return {};
  const double half = std::sqrt(std::numeric_limits<double>::epsilon());
  if (distance(*nearest) > half * std::abs(value)) return {};
  return static_cast<std::size_t>(nearest - ranges_.begin());
}

int SolutionRanges::family(double value, double theta) const {
  const std::optional<SystemForms> system = system_over(value, value);
  return system ? family_of(*system, stop_, period_, theta) : 0;
}

std::optional<int> SolutionRanges::component(double value, double phase) const {
  const std::optional<std::size_t> range = range_of(value);
  if (!range) return {};
  const int name = 2 * static_cast<int>(*range);
  if (ranges_[*range].folds()) return name;
  return name + (family(value, phase) < 0 ? 1 : 0);
}

}  // namespace graze
