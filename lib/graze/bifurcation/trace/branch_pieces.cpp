#include "graze/bifurcation/trace/detail/branch_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/continuation/branch/detail/growing_branch.hpp"

namespace graze {
namespace {

// Largest number of moves: over a branch contacts go round the section once or twice.
constexpr int kMostMoves = 200;

// How far beyond a corner a solution is looked for, and how far it may lie from the last one, in
// parts of the size of the unknowns: a jump of the motion is no corner.
constexpr double kLeastBeyond = 1e-10, kMostBeyond = 1e-6;
constexpr double kSameCorner = 1e-3;

double range_of(const ContinuationOptions& options) { return std::abs(options.to - options.from); }

class PieceTracer {
 public:
  PieceTracer(const Clearer& clearer, const ContinuationOptions& options)
      : clearer_(clearer), options_(options) {}

  std::vector<BranchPiece> trace(LaidOrbits& orbits, const SolutionPoint& start,
                                 Directions directions) {
    LaidOrbits* first = &orbits;
    SolutionPoint from = start;
    if (LaidOrbits* other = clearer_(orbits, start))
      if (const auto carried = orbits->carried_to(*other->problem, options_, start)) {
        from = *carried;
        first = other;
      }
    pieces_.push_back({first, trace_one(*first, from, directions)});
    if (pieces_.front().branch.closed()) return std::move(pieces_);
    go_on(1, *first, from);
    if (directions == Directions::kBoth) go_on(0, *first, from);
    return std::move(pieces_);
  }

 private:
  Branch trace_one(const LaidOrbits& orbits, const SolutionPoint& start,
                   Directions directions) const {
    ContinuationOptions range = options_;
    range.proceed = [&](const SolutionPoint& previous, const SolutionPoint& here) {
      // Steps may shrink onto the very point.
      const bool reaches_half = orbits->is_half(here) && !orbits->is_half(previous);
      return !reaches_half && !orbits->passes_half(previous, here) &&
             orbits.boundaries->goes_on(previous, here) && !clearer_(orbits, here);
    };
    range.resolves = [&](const SolutionPoint& from, const SolutionPoint& to) {
      return orbits.boundaries->resolves(from, to);
    };
    return trace_branch(orbits->problem(), range, start, directions);
  }

  // Continues outwards from one side of the traced pieces.
  void go_on(std::size_t side, const LaidOrbits& of_start, const SolutionPoint& start) {
    for (int moves = 0; moves < kMostMoves; ++moves) {
      BranchPiece& outer = side == 0 ? pieces_.front() : pieces_.back();
      LaidOrbits* next = clearer_beyond(outer, side);
      SolutionPoint end = side == 0 ? outer.branch.points.front() : outer.branch.points.back();
      if (side == 0) end.turn_round();
      const std::optional<SolutionPoint> carried =
          next ? (*outer.orbits)->carried_to(*next->problem, options_, end)
               : beyond_corner(outer, side);
      if (!carried) return;
      const bool is_corner = !next;
      if (is_corner) next = outer.orbits;
      Branch branch = trace_one(*next, *carried, Directions::kForward);
      if (branch.points.size() < 2) return;
      outer.branch.ends[side] = BranchEnd::kNotConverged;
      if (is_corner) {
        branch.points.insert(branch.points.begin(), end);
        for (CriticalPoint& critical : branch.critical) ++critical.after;
      }
      const std::optional<SolutionPoint> passed =
          of_start->carried_to(*next->problem, options_, start);
      if (passed && lies_on((*next)->problem(), options_, branch, *passed)) {
        if (!goes_round(branch, *passed, side == 0 ? -1.0 : 1.0)) return;
        branch.ends[1] = BranchEnd::kClosed;
        pieces_.front().branch.ends[0] = pieces_.back().branch.ends[1] = BranchEnd::kClosed;
      }
      if (side == 0)
        pieces_.insert(pieces_.begin(), {next, backwards(branch)});
      else
        pieces_.push_back({next, std::move(branch)});
    }
  }

  // Whether a piece passes the start on the way that it was left. Where solutions grow without
  // bound rounding may turn a trace back, and it comes the other way.
  static bool goes_round(const Branch& piece, const SolutionPoint& start, double way) {
    const auto distance = [&](const SolutionPoint& p) {
      return (p.u - start.u).norm() + std::abs(p.parameter - start.parameter);
    };
    const auto nearest = std::min_element(
        piece.points.begin(), piece.points.end(),
        [&](const SolutionPoint& a, const SolutionPoint& b) { return distance(a) < distance(b); });
    return way * nearest->rate() * start.rate() >= 0.0;
  }

  // The solution a little further on, where a trace did not get round a corner: along the tangent
  // of what follows there, to the side where it does.
  std::optional<SolutionPoint> beyond_corner(const BranchPiece& piece, std::size_t side) const {
    const std::vector<SolutionPoint>& points = piece.branch.points;
    if (piece.branch.ends[side] != BranchEnd::kNotConverged || points.size() < 2) return {};
    SolutionPoint end = side == 0 ? points[0] : points.back();
    if (side == 0) end.turn_round();
    const double size = 1.0 + end.u.norm(), range = range_of(options_);
    const auto moved = [&](const Vector& along, double step) {
      SolutionPoint there = end;
      there.u += step * size * along.head(end.u.size());
      there.parameter += step * size * range * along[end.u.size()];
      return there;
    };
    for (double step = kLeastBeyond; step <= kMostBeyond; step *= 10.0) {
      const SolutionPoint ahead = moved(end.tangent, step);
      if (!piece.orbits->boundaries->lie_across(end, ahead)) continue;
      const std::optional<Vector> tangent = tangent_at((*piece.orbits)->problem(), ahead);
      if (!tangent) continue;
      for (const double way : {1.0, -1.0}) {
        const Vector along = way * *tangent;
        const SolutionPoint guess = moved(along, step);
        std::optional<SolutionPoint> there =
            solve_near((*piece.orbits)->problem(), options_, guess.u, guess.parameter, along);
        if (!there || !((there->u - end.u).norm() <= kSameCorner * size) ||
            !piece.orbits->boundaries->lie_across(end, *there))
          continue;
        if (there->tangent.dot(along) < 0.0) there->turn_round();
        return there;
      }
    }
    return {};
  }

  // Of the solutions of the equations that hold at a point, which is none itself.
  std::optional<Vector> tangent_at(const ZeroProblem& problem, const SolutionPoint& point) const {
    const std::optional<ZeroEvaluation> at = problem.evaluate(point.u, point.parameters());
    if (!at || !at->jacobian.allFinite() || !at->by_parameters.allFinite()) return {};
    Matrix slope(point.u.size(), point.u.size() + 1);
    slope << at->jacobian, at->by_parameters * range_of(options_);
    return null_vector(slope);
  }

  // The equations for continuing beyond this end of a piece; null where the branch ends there.
  LaidOrbits* clearer_beyond(const BranchPiece& piece, std::size_t side) const {
    const std::vector<SolutionPoint>& points = piece.branch.points;
    if (piece.branch.ends[side] != BranchEnd::kHalted || points.size() < 2) return nullptr;
    const SolutionPoint& end = side == 0 ? points[0] : points.back();
    const SolutionPoint& before = side == 0 ? points[1] : points[points.size() - 2];
    if ((*piece.orbits)->passes_half(before, end)) return nullptr;
    return clearer_(*piece.orbits, end);
  }

  static Branch backwards(const Branch& branch) {
    Branch start;
    start.points.push_back(branch.points.front());
    start.ends = {branch.ends[0], branch.ends[0]};
    Branch turned = joined(branch, start);
    turned.evaluations = branch.evaluations;
    return turned;
  }

  const Clearer& clearer_;
  const ContinuationOptions& options_;
  std::vector<BranchPiece> pieces_;
};

}  // namespace

std::vector<BranchPiece> trace_pieces(const Clearer& clearer, LaidOrbits& orbits,
                                      const ContinuationOptions& options,
                                      const SolutionPoint& start, Directions directions) {
  return PieceTracer(clearer, options).trace(orbits, start, directions);
}

}  // namespace graze
