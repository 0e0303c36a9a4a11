#include "graze/continuation/special/detail/crossing_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "graze/continuation/branch/detail/locate.hpp"
#include "graze/continuation/special/detail/crossing_tests.hpp"

namespace graze {
namespace {

// Number of evenly spaced places within a piece at which it is checked.
constexpr int kSamples = 7;
// Bound on the fourth derivative within a piece, in multiples of the divided differences beside it.
constexpr double kVariation = 4.0;
// A step is divided into this many pieces at most, none shorter than 2^-30 of it: opposite
// crossings that are nearer to one another coincide within the resolution of arclength.
constexpr int kMostPieces = 200;
constexpr double kShortestPiece = 0x1p-30;
// A piece whose ends differ in sign holds one change if the cubic has one and its error is below
// this part of the larger end.
constexpr double kKnown = 0.5;

// Multipliers within a factor of kApart from the unit circle move by less than this over a piece:
// the points around a piece show the interaction of multipliers that are farther apart than that.
constexpr double kLargestMove = 0.15;
constexpr double kApart = 2.0;

// Largest distance of a multiplier from the nearest one that it may have come from.
double moved_from(const std::vector<Eigenvalue>& from, const std::vector<Eigenvalue>& to) {
  double most = 0.0;
  for (const Eigenvalue& m : from) {
    const double size = std::norm(m.value);
    if (m.value.imag() < 0.0 || size > kApart * kApart || size * kApart * kApart < 1.0) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigenvalue& other : to)
      nearest = std::min(nearest, std::norm(m.value - other.value));
    most = std::max(most, nearest);
  }
  return std::sqrt(most);
}

double moved(const SolutionPoint& a, const SolutionPoint& b) {
  return std::max(moved_from(a.multipliers, b.multipliers),
                  moved_from(b.multipliers, a.multipliers));
}

struct Node {
  double at = 0.0;  // arclength from the start of the branch
  const SolutionPoint* point = nullptr;
  CrossingTests tests;
  std::size_t step = 0;  // the step it lies in; for a point of the branch the step after it
};

// The values of one test near a piece: the nodes around it, counted from its start, and the values
// there relative to the largest.
struct SampledTest {
  std::vector<double> at, value;
  std::size_t first = 0;  // the piece lies between nodes first and first + 1
};

// Divided difference over nodes [from, from + count).
double divided_difference(const SampledTest& sampled, std::size_t from, std::size_t count) {
  std::vector<double> d(sampled.value.begin() + static_cast<std::ptrdiff_t>(from),
                        sampled.value.begin() + static_cast<std::ptrdiff_t>(from + count));
  for (std::size_t level = 1; level < count; ++level)
    for (std::size_t k = 0; k + level < count; ++k)
      d[k] = (d[k + 1] - d[k]) / (sampled.at[from + k + level] - sampled.at[from + k]);
  return d[0];
}

struct Estimate {
  double value = 0.0, error = 0.0;
};

// The cubic through four nodes around the piece and its error, at evenly spaced places.
class CubicInterpolant {
 public:
  explicit CubicInterpolant(const SampledTest& sampled) : sampled_(sampled) {
    const std::size_t count = sampled.at.size();
    start_ = std::min(sampled.first > 0 ? sampled.first - 1 : 0, count - 4);
    for (std::size_t order = 1; order <= 4; ++order)
      newton_[order - 1] = divided_difference(sampled, start_, order);
    for (const std::size_t from : {start_ > 0 ? start_ - 1 : start_, start_})
      if (from + 5 <= count)
        fourth_ = std::max(fourth_, std::abs(divided_difference(sampled, from, 5)));
  }

  // Beside a node, in direction `ahead` (1 or -1), the cubic's error grows linearly: the distance
  // at which the parabola there, bent towards zero by that error, is lowest. `sign`: of the value
  // there.
  double lowest_beside(std::size_t node, double ahead, double sign) const {
    const double s = sampled_.at[node];
    const double x = s - sampled_.at[start_], y = s - sampled_.at[start_ + 1],
                 z = s - sampled_.at[start_ + 2];
    double error_rate = kVariation * fourth_;
    for (std::size_t k = start_; k < start_ + 4; ++k)
      if (k != node) error_rate *= std::abs(s - sampled_.at[k]);
    const double slope = newton_[1] + newton_[2] * (x + y) + newton_[3] * (x * y + x * z + y * z);
    const double bend = 2.0 * newton_[2] + 2.0 * newton_[3] * (x + y + z);
    return (error_rate - ahead * sign * slope) / (sign * bend);
  }

  Estimate at(double s) const {
    Estimate estimate{newton_[3], kVariation * fourth_};
    for (std::size_t k = 4; k-- > 0;) {
      const double offset = s - sampled_.at[start_ + k];
      if (k < 3) estimate.value = estimate.value * offset + newton_[k];
      estimate.error *= std::abs(offset);
    }
    return estimate;
  }

 private:
  const SampledTest& sampled_;
  std::size_t start_ = 0;
  std::array<double, 4> newton_{};
  double fourth_ = 0.0;
};

// Where a change of sign is suspected in a piece, and how strongly.
struct SuspectedChange {
  double ahead = 0.0, size = 0.0;  // from the start of the piece
};

// For the piece between node `first` and the next, whose ends have one sign: where the cubic comes
// nearest to the other sign within its error.
std::optional<SuspectedChange> suspected_return(const CubicInterpolant& cubic, std::size_t first,
                                                double length, double sign) {
  std::optional<SuspectedChange> worst;
  const auto ask = [&](double s) {
    if (!(s > 0.0 && s < length)) return;
    const Estimate here = cubic.at(s);
    const double size = here.error - sign * here.value;
    if (size >= 0.0 && (!worst || size > worst->size)) worst = SuspectedChange{s, size};
  };
  for (int k = 1; k <= kSamples; ++k) ask(length * k / (kSamples + 1));
  ask(cubic.lowest_beside(first, 1.0, sign));
  ask(length - cubic.lowest_beside(first + 1, -1.0, sign));
  return worst;
}

// For a piece whose ends differ in sign: whether the cubic is accurate enough to exclude more
// changes.
std::optional<SuspectedChange> suspected_change(const CubicInterpolant& cubic, double length,
                                                double start, double end) {
  const double allowed = kKnown * std::max(std::abs(start), std::abs(end));
  double before = start, error = 0.0;
  int changes = 0;
  for (int k = 1; k <= kSamples + 1; ++k) {
    const Estimate here = k > kSamples ? Estimate{end, 0.0} : cubic.at(length * k / (kSamples + 1));
    changes += here.value * before < 0.0 ? 1 : 0;
    before = here.value;
    error = std::max(error, here.error);
  }
  if (changes <= 1 && error <= allowed) return {};
  return SuspectedChange{0.5 * length, std::max(error, allowed)};
}

// Where a test may have changed sign and back within the piece; nullopt when it cannot have.
std::optional<SuspectedChange> suspected_sign_change(const SampledTest& sampled) {
  const double length = sampled.at[sampled.first + 1];
  if (sampled.at.size() < 5) return SuspectedChange{0.5 * length, 1.0};
  const double start = sampled.value[sampled.first], end = sampled.value[sampled.first + 1];
  const CubicInterpolant cubic(sampled);
  return start * end < 0.0
             ? suspected_change(cubic, length, start, end)
             : suspected_return(cubic, sampled.first, length, start > 0.0 ? 1.0 : -1.0);
}

class SampleSearch {
 public:
  SampleSearch(const Branch& branch, const ZeroProblem& problem, Corrector& corrector,
               const StopSignal& stop)
      : branch_(branch), problem_(problem), corrector_(corrector), stop_(stop) {}

  std::vector<std::vector<SolutionPoint>> run() {
    const std::vector<SolutionPoint>& points = branch_.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double at = i == 0 ? 0.0 : ahead_.back().at + length(points[i - 1], points[i]);
      ahead_.push_back({at, &points[i], crossing_tests(points[i].multipliers), i});
    }
    std::reverse(ahead_.begin(), ahead_.end());
    std::vector<std::vector<SolutionPoint>> samples(points.size());
    advance();
    int pieces = 1;
    while (!ahead_.empty()) {
      const bool divided = pieces < kMostPieces && !stop_.requested() && divide();
      pieces = divided ? pieces + 1 : pieces;
      if (divided) continue;
      advance();
      const Node& here = passed_.back();
      if (here.point == &points[here.step])
        pieces = 1;
      else
        samples[here.step].push_back(*here.point);
    }
    return samples;
  }

 private:
  double length(const SolutionPoint& a, const SolutionPoint& b) const {
    return arclength(corrector_, a, b);
  }

  void advance() {
    if (!passed_.empty())
      rate_ = moved(*passed_.back().point, *ahead_.back().point) /
              (ahead_.back().at - passed_.back().at);
    passed_.push_back(ahead_.back());
    ahead_.pop_back();
  }

  // Puts a node into the piece between the last one passed and the next; false when the piece is
  // clear or cannot be divided.
  bool divide() {
    const Node &a = passed_.back(), &b = ahead_.back();
    const std::size_t step = a.step;
    std::optional<SuspectedChange> worst;
    // Where two multipliers exchange places, those at the ends look as if they had not moved; but
    // they go on at the rate of the last piece.
    const double move = std::max(moved(*a.point, *b.point), rate_ * (b.at - a.at));
    if (move > kLargestMove) worst = SuspectedChange{0.5 * (b.at - a.at), 1.0};
    for (std::size_t test = 0; test < kCrossingTests; ++test) {
      if (!a.tests[test].known || !b.tests[test].known) continue;
      const std::optional<SuspectedChange> suspected = suspected_sign_change(sampled(test));
      if (suspected && (!worst || suspected->size > worst->size)) worst = suspected;
    }
    const SolutionPoint &from = branch_.points[step], &to = branch_.points[step + 1];
    if (!worst || b.at - a.at <= kShortestPiece * length(from, to)) return false;
    const double part = worst->ahead / (b.at - a.at);
    std::optional<SolutionPoint> point = point_between(
        corrector_, *a.point, part * corrector_.ahead(*a.point, *b.point), *a.point, *b.point);
    if (!point) return false;
    point->multipliers = problem_.multipliers(point->u, point->parameters(), ErrorBounds::kLeftOut);
    if (point->multipliers.size() != from.multipliers.size()) return false;
    const double before = length(*a.point, *point), behind = length(*point, *b.point);
    Node node{a.at + (b.at - a.at) * before / (before + behind), nullptr,
              crossing_tests(point->multipliers), step};
    for (std::size_t test = 0; test < kCrossingTests; ++test)
      node.tests[test].known = a.tests[test].known && b.tests[test].known;
    found_.push_back(std::move(*point));
    node.point = &found_.back();
    ahead_.push_back(node);
    return true;
  }

  SampledTest sampled(std::size_t test) const {
    std::vector<const Node*> nodes;
    // Three on either side, where there are as many; five in any case.
    std::size_t before = std::min<std::size_t>(passed_.size(), 3),
                behind = std::min<std::size_t>(ahead_.size(), 3);
    behind = std::min(ahead_.size(), std::max(behind, 5 - before));
    before = std::min(passed_.size(), std::max(before, 5 - behind));
    for (std::size_t k = before; k > 0; --k) nodes.push_back(&passed_[passed_.size() - k]);
    for (std::size_t k = 1; k <= behind; ++k) nodes.push_back(&ahead_[ahead_.size() - k]);
    double largest = -std::numeric_limits<double>::infinity();
    for (const Node* node : nodes) largest = std::max(largest, node->tests[test].log_size);
    SampledTest result;
    result.first = before - 1;
    for (const Node* node : nodes) {
      result.at.push_back(node->at - passed_.back().at);
      result.value.push_back(node->tests[test].sign *
                             std::exp(node->tests[test].log_size - largest));
    }
    return result;
  }

  const Branch& branch_;
  const ZeroProblem& problem_;
  Corrector& corrector_;
  StopSignal stop_;
  std::vector<Node> passed_, ahead_;  // the latter backwards
  double rate_ = 0.0;                 // of the multipliers over the last piece
  std::deque<SolutionPoint> found_;   // references to them stay valid
};

}  // namespace

std::vector<std::vector<SolutionPoint>> crossing_samples(const Branch& branch,
                                                         const ZeroProblem& problem,
                                                         Corrector& corrector,
                                                         const StopSignal& stop) {
  return SampleSearch(branch, problem, corrector, stop).run();
}

}  // namespace graze
