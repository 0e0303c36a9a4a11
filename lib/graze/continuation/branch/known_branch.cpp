#include "graze/continuation/branch/detail/known_branch.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "graze/continuation/branch/detail/locate.hpp"

namespace graze {
namespace {

// Segments in a box: about the square root of the points of a branch.
constexpr std::size_t kRun = 16;

}  // namespace

void KnownBranch::Box::add(const Vector& x, double margin) {
  if (low.size() == 0) {
    low = Vector::Constant(x.size(), std::numeric_limits<double>::infinity());
    high = -low;
  }
  low = low.cwiseMin((x.array() - margin).matrix());
  high = high.cwiseMax((x.array() + margin).matrix());
}

bool KnownBranch::Box::contains(const Vector& x) const {
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (!(x[i] >= low[i] && x[i] <= high[i])) return false;
  return true;
}

KnownBranch::KnownBranch(const Corrector& corrector, std::vector<SolutionPoint> points,
                         const Vector& wrap, double max_turn)
    : points_(std::move(points)), wrap_(wrap), max_turn_(max_turn) {
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const Vector a = corrector.pack(points_[i]), b = corrector.pack(points_[i + 1]);
    // A margin twice as wide covers the rounding of the sum of squares.
    const double margin = 2.0 * std::max(kOnePoint, 0.5 * max_turn_ * (b - a).norm());
    if (i % kRun == 0) runs_.emplace_back();
    for (Box* box : {&whole_, &runs_.back()}) {
      box->add(a, margin);
      box->add(b, margin);
    }
  }
  for (Eigen::Index i = 0; i < wrap_.size(); ++i) {
    if (wrap_[i] == 0.0) continue;
    const auto open = [i](Box& box) {
      if (box.low.size() == 0) return;
      box.low[i] = -std::numeric_limits<double>::infinity();
      box.high[i] = std::numeric_limits<double>::infinity();
    };
    open(whole_);
    for (Box& run : runs_) open(run);
  }
}

bool KnownBranch::has(Corrector& corrector, const SolutionPoint& point) const {
  if (runs_.empty()) return false;
  const Vector x = corrector.pack(point);
  if (!whole_.contains(x)) return false;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    if (!runs_[run].contains(x)) continue;
    const std::size_t end = std::min(points_.size() - 1, (run + 1) * kRun);
    for (std::size_t i = run * kRun; i < end; ++i)
      if (lies_between(corrector, points_[i], points_[i + 1], point, max_turn_)) return true;
  }
  return false;
}

}  // namespace graze
