#include "graze/bifurcation/sticking_borders.hpp"

#include "graze/bifurcation/sticking_completion.hpp"
#include "graze/bifurcation/sticking_grazing.hpp"

namespace graze {
namespace {

// Changes of the itinerary within one step that are looked through. Beside CH the impacts of the
// chatter that does not complete any more vanish one after the other, some thirty in double
// precision.
constexpr int kMostChanges = 64;

// Solutions looked at between two with the same events.
constexpr int kMostLooks = 40;

// What was met beyond may be a prediction only; that is no solution, and does not return.
bool is_solved(const BranchPoint& point) { return point.tangent.size() > 0; }

}  // namespace

StickingBorders::StickingBorders(const PassageEquations& equations,
                                 const ContinuationOptions& options)
    : equations_(equations),
      options_(options),
      corrector_(equations.problem(), options_),
      hidden_(equations, corrector_) {}

bool StickingBorders::passes(const BranchPoint& a, const BranchPoint& b) {
  const std::optional<ReleaseReturn> before = equations_.follow(a), now = equations_.follow(b);
  if (!before || !now || !now->returns || now->holds != before->holds) return true;
  // Where the impacts are felt, between() knows.
  return equations_.see_impacts() && between(a, b).border;
}

StickingTip StickingBorders::between(const BranchPoint& a, const BranchPoint& b) {
  StickingTip first;
  if (equations_.see_impacts()) first = grazing_ahead(equations_, corrector_, options_, a, b);
  if (first.border) return first;
  walk(a, b, equations_.see_impacts(), [&](const StickingTip& tip) {
    first = tip;
    return true;
  });
  return first;
}

StickingTip StickingBorders::at_last(const std::vector<BranchPoint>& reached) {
  const BranchPoint& at = reached.back();
  const std::optional<ReleaseReturn> here = equations_.follow(at);
  // Where the equations are solved no further the trace has come as near as it gets.
  if (here && has_shrunk(*here, equations_.period_at(at)))
    return {OrbitBranchEnd::kChatterCompletes, at, false, false, at.parameter, {}};
  return grazing_at(equations_, corrector_, reached, false);
}

std::vector<StickingTip> StickingBorders::passed(const BranchPoint& a, const BranchPoint& b) {
  std::vector<StickingTip> list;
  if (equations_.see_impacts()) return list;
  walk(a, b, true, [&](const StickingTip& tip) {
    if (tip.border && tip.end == OrbitBranchEnd::kGrazing) list.push_back(tip);
    return false;
  });
  return list;
}

// From a to b along the changes of the events, and what is there at each, until that is enough.
// `impacts`: see has_same_events().
void StickingBorders::walk(const BranchPoint& a, const BranchPoint& b, bool impacts,
                           const std::function<bool(const StickingTip&)>& is_enough) {
  BranchPoint from = a;
  std::optional<ReleaseReturn> here = equations_.follow(a);
  const std::optional<ReleaseReturn> at_b = equations_.follow(b);
  int looks = kMostLooks;
  for (int change = 0; here && change < kMostChanges && !options_.stop.requested(); ++change) {
    BranchPoint target = b;
    // Changes that end nothing may be all there is up to `b`.
    if (at_b && has_same_events(*at_b, *here, impacts)) {
      const std::optional<BranchPoint> other = hidden_.between(from, b, *here, looks);
      if (!other) return;
      target = *other;
    }
    const StickingApproach there =
        approach_border(equations_, corrector_, options_.stop, from, target, *here, impacts);
    const bool solved = is_solved(there.at_beyond);
    const bool same_holds =
        there.beyond && (there.beyond->returns || !solved) && there.beyond->holds == here->holds;
    if (!same_holds) {
      is_enough(completion(equations_, there));
      return;
    }
    const StickingTip touch = grazing(there, *here);
    if (touch.border && is_enough(touch)) return;
    if (!solved) return;
    // Nothing ends here; go on from the other side.
    from = there.at_beyond;
    here = there.beyond;
  }
}

// The grazing at the border that was approached from `here`, across which the stuck phases are the
// same.
StickingTip StickingBorders::grazing(const StickingApproach& there, const ReleaseReturn& here) {
  const bool solved = is_solved(there.at_beyond);
  // The impact of a grazing is felt down to some speed; what it was before it impacted touches.
  const bool is_lost = solved &&
                       here.itinerary.events.size() > there.beyond->itinerary.events.size() &&
                       touches(equations_, there.at_beyond);
  StickingTip tip = grazing_at(equations_, corrector_, there.reached, is_lost);
  if (tip.border && solved) tip.beyond = there.at_beyond;
  return tip;
}

}  // namespace graze
