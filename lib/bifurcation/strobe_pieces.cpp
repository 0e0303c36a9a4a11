#include "graze/bifurcation/strobe_pieces.hpp"

#include <utility>

#include "graze/bifurcation/strobe_parts.hpp"
#include "graze/continuation/growing_branch.hpp"

namespace graze {
namespace {

// Contacts go round once or twice over a branch, each past every place of the section.
constexpr int kMostMoves = 200;

class PieceTracer {
 public:
  PieceTracer(const AtSection& at_section, const ContinuationOptions& options)
      : at_section_(at_section), options_(options) {}

  std::vector<StrobePiece> trace(PassageEquations& equations, const BranchPoint& start,
                                 Directions directions) {
    PassageEquations* first = &equations;
    BranchPoint from = start;
    if (const std::optional<double> clearer = equations.clearer_section(start)) {
      PassageEquations& other = at_section_(*clearer);
      if (const auto carried = equations.carried_to(other, options_, start)) {
        from = *carried;
        first = &other;
      }
    }
    pieces_.push_back({first, trace_one(*first, from, directions)});
    if (pieces_.front().branch.closed()) return std::move(pieces_);
    go_on(1, *first, from);
    if (directions == Directions::kBoth) go_on(0, *first, from);
    return std::move(pieces_);
  }

 private:
  Branch trace_one(const PassageEquations& equations, const BranchPoint& start,
                   Directions directions) const {
    ContinuationOptions range = options_;
    // The response that meets no stop is another matter.
    range.proceed = [&](const BranchPoint& previous, const BranchPoint& here) {
      return equations.judge(here).has_value() && !equations.passes_half(previous, here) &&
             !equations.clearer_section(here);
    };
    range.resolves = [&](const BranchPoint& from, const BranchPoint& to) {
      return resolves_contacts(equations, options_, from, to);
    };
    return trace_branch(equations.problem(), range, start, directions);
  }

  // Outwards from one side of what is traced.
  void go_on(std::size_t side, const PassageEquations& of_start, const BranchPoint& start) {
    for (int moves = 0; moves < kMostMoves; ++moves) {
      StrobePiece& outer = side == 0 ? pieces_.front() : pieces_.back();
      const std::optional<double> section = section_beyond(outer, side);
      if (!section) return;
      outer.branch.ends[side] = BranchEnd::kNotConverged;
      BranchPoint end = side == 0 ? outer.branch.points.front() : outer.branch.points.back();
      if (side == 0) end.turn_round();
      PassageEquations& next = at_section_(*section);
      const std::optional<BranchPoint> carried = outer.equations->carried_to(next, options_, end);
      if (!carried) return;
      Branch branch = trace_one(next, *carried, Directions::kForward);
      if (branch.points.size() < 2) return;
      const std::optional<BranchPoint> passed = of_start.carried_to(next, options_, start);
      if (passed && lies_on(next.problem(), options_, branch, *passed)) {
        branch.ends[1] = BranchEnd::kClosed;
        pieces_.front().branch.ends[0] = pieces_.back().branch.ends[1] = BranchEnd::kClosed;
      }
      if (side == 0)
        pieces_.insert(pieces_.begin(), {&next, backwards(branch)});
      else
        pieces_.push_back({&next, std::move(branch)});
    }
  }

  // Where the section moves from this end of a piece; nothing where the branch ends there.
  static std::optional<double> section_beyond(const StrobePiece& piece, std::size_t side) {
    const std::vector<BranchPoint>& points = piece.branch.points;
    if (piece.branch.ends[side] != BranchEnd::kHalted || points.size() < 2) return {};
    const BranchPoint& end = side == 0 ? points[0] : points.back();
    const BranchPoint& before = side == 0 ? points[1] : points[points.size() - 2];
    if (piece.equations->passes_half(before, end)) return {};
    return piece.equations->clearer_section(end);
  }

  static Branch backwards(const Branch& branch) {
    Branch start;
    start.points.push_back(branch.points.front());
    start.ends = {branch.ends[0], branch.ends[0]};
    Branch turned = joined(branch, start);
    turned.evaluations = branch.evaluations;
    return turned;
  }

  const AtSection& at_section_;
  const ContinuationOptions& options_;
  std::vector<StrobePiece> pieces_;
};

}  // namespace

std::vector<StrobePiece> trace_pieces(const AtSection& at_section, PassageEquations& equations,
                                      const ContinuationOptions& options, const BranchPoint& start,
                                      Directions directions) {
  return PieceTracer(at_section, options).trace(equations, start, directions);
}

}  // namespace graze
