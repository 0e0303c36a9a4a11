#include "graze/bifurcation/trace/detail/shown_curve.hpp"

#include <algorithm>
#include <cmath>
#include <list>
#include <utility>

#include "graze/continuation/branch/detail/locate.hpp"

namespace graze {
namespace {

// Length of a picture's axes in pixels. On a logarithmic axis, or one in decibels, which may show
// six decades, a pixel is some hundredth of the value.
constexpr double kPixels = 1000.0;
constexpr double kLogPixel = 0.01, kSmallest = 1e-6;
// Largest distance of a point from the chord of its neighbours, pixels: a parabola through the
// three is then within a pixel of both lines, one of which may be up to twice as long as the other.
constexpr double kBend = 2.0;
// A step as long as an axis is then a pixel long; the limit is for quantities that jump, or have
// fewer digits than a picture shows.
constexpr int kHalvings = 10;

class ShownCurve {
 public:
  ShownCurve(const LaidOrbits& orbits, const ContinuationOptions& options, const OrbitNumber& shown,
             Branch& branch)
      : orbits_(orbits),
        options_(options),
        shown_(shown),
        branch_(branch),
        corrector_(orbits->problem(), options) {}

  void resolve() {
    for (SolutionPoint& point : branch_.points) {
      if (options_.stop.requested()) return;
      nodes_.push_back(node_of(point));
      if (nodes_.back().shown) largest_ = std::max(largest_, std::abs(*nodes_.back().shown));
    }
    // Where `proceed` ended the trace its last step crosses the end.
    if (branch_.ends[0] == BranchEnd::kHalted) nodes_.front().is_final = true;
    if (branch_.ends[1] == BranchEnd::kHalted && nodes_.size() > 1)
      std::prev(nodes_.end(), 2)->is_final = true;
    const std::size_t before = nodes_.size();
    while (add_points()) {
    }
    branch_.evaluations += corrector_.evaluations();
    if (nodes_.size() > before) put_back();
  }

 private:
  struct Node {
    SolutionPoint point;
    std::optional<double> shown;
    bool is_listed = false;
    bool is_final = false;  // nothing is to be put behind it
    int halvings = 0;       // of the step from it
    bool is_new = false;
  };
  using Place = std::list<Node>::iterator;

  Node node_of(const SolutionPoint& point) const {
    Node node{point, {}};
    if (const std::optional<OrbitBranchPoint> at = orbits_->judge(point)) {
      if (const System* system = orbits_->system_at(point.parameters()))
        node.shown = shown_(orbits_->scene_at(point.parameters()), *system, at->orbit);
      node.is_listed = orbits_.boundaries->lists(point);
    }
    return node;
  }

  // Distance of b from the chord from a to c, pixels; 0 where it is not known.
  double bend(const Node& a, const Node& b, const Node& c) const {
    if (!a.shown || !b.shown || !c.shown) return 0.0;
    const double least = std::max(std::abs(*b.shown), kSmallest * largest_);
    const double pixel = std::min(largest_ / kPixels, kLogPixel * least);
    if (!(pixel > 0.0)) return 0.0;
    const auto across = [&](const Node& from, const Node& to) {
      return kPixels * (to.point.parameter - from.point.parameter) / corrector_.range();
    };
    const auto up = [&](const Node& from, const Node& to) {
      return (*to.shown - *from.shown) / pixel;
    };
    const double length = std::hypot(across(a, c), up(a, c));
    if (!(length > 0.0)) return std::hypot(across(a, b), up(a, b));
    return std::abs(across(a, c) * up(a, b) - up(a, c) * across(a, b)) / length;
  }

  // Adds points next to all points at which the curve bends; returns whether any were added.
  bool add_points() {
    std::vector<Place> bent;  // the first of two neighbours
    const auto mark = [&](Place first) {
      if (!first->is_final && (bent.empty() || bent.back() != first)) bent.push_back(first);
    };
    for (Place b = std::next(nodes_.begin()); nodes_.size() > 2 && std::next(b) != nodes_.end();
         ++b)
      if (bend(*std::prev(b), *b, *std::next(b)) > kBend) mark(std::prev(b)), mark(b);
    bool added = false;
    for (const Place& first : bent) {
      if (options_.stop.requested()) return false;
      added = add_behind(first) || added;
    }
    return added;
  }

  bool add_behind(Place first) {
    const Place next = std::next(first);
    if (first->halvings == kHalvings || (!first->is_listed && !next->is_listed)) return false;
    const SolutionPoint &a = first->point, &b = next->point;
    const std::optional<SolutionPoint> middle =
        point_between(corrector_, a, 0.5 * corrector_.ahead(a, b), a, b);
    // Next to a crossing a correction may lead onto the other branch.
    if (!middle || (middle->orientation != a.orientation && middle->orientation != b.orientation)) {
      first->is_final = true;
      return false;
    }
    Node node = node_of(*middle);
    node.is_new = true;
    node.halvings = ++first->halvings;
    if (orbits_->problem().multipliers)
      node.point.multipliers =
          orbits_->problem().multipliers(middle->u, middle->parameters(), ErrorBounds::kGiven);
    nodes_.insert(next, std::move(node));
    return true;
  }

  // Puts all points into the branch, with its critical points between the same neighbours.
  void put_back() {
    std::vector<std::size_t> places;  // of what was there before
    branch_.points.clear();
    for (Node& node : nodes_) {
      if (!node.is_new) places.push_back(branch_.points.size());
      branch_.points.push_back(std::move(node.point));
    }
    for (CriticalPoint& critical : branch_.critical) {
      const std::size_t from = places[critical.after];
      const std::size_t to = critical.after + 1 < places.size() ? places[critical.after + 1] : from;
      const SolutionPoint& a = branch_.points[from];
      critical.after = from;
      while (critical.after + 1 < to && corrector_.ahead(a, branch_.points[critical.after + 1]) <
                                            corrector_.ahead(a, critical.point))
        ++critical.after;
    }
  }

  const LaidOrbits& orbits_;
  const ContinuationOptions& options_;
  const OrbitNumber& shown_;
  Branch& branch_;
  Corrector corrector_;
  std::list<Node> nodes_;
  double largest_ = 0.0;  // of the sizes shown
};

}  // namespace

void resolve_shown(const LaidOrbits& orbits, const ContinuationOptions& options,
                   const OrbitNumber& shown, Branch& branch) {
  ShownCurve(orbits, options, shown, branch).resolve();
}

}  // namespace graze
